#include "config/dbc_storage.hpp"

namespace config {
namespace {

constexpr std::size_t kMaxMessages = 65536;
constexpr std::size_t kMaxSignals = 262144;

std::size_t occurrences(std::string_view text, std::string_view word, std::size_t most) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string_view::npos && count < most;
       at = text.find(word, at + word.size())) {
    ++count;
  }
  return count;
}

}  // namespace

DbcStorage::DbcStorage(std::string_view text)
    : messages_(occurrences(text, "BO_", kMaxMessages)),
      signals_(occurrences(text, "SG_", kMaxSignals)),
      dbc_(messages_, signals_),
      status_(dbc_.parse(text)) {}

}  // namespace config
