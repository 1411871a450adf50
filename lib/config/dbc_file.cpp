#include "config/dbc_file.hpp"

#include <algorithm>

namespace config {
namespace {

constexpr std::size_t kMaxMessages = 65536;
constexpr std::size_t kMaxSignals = 262144;
constexpr std::size_t kLongestList = 200;

std::size_t occurrences(std::string_view text, std::string_view word, std::size_t most) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string_view::npos && count < most;
       at = text.find(word, at + word.size())) {
    ++count;
  }
  return count;
}

std::string quoted(std::string_view text) {
  std::string out(text.substr(0, 40));
  std::replace_if(
      out.begin(), out.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return '"' + out + '"';
}

template <class List>
std::string names_of(const List& list) {
  std::string names;
  for (const auto& item : list) {
    if (names.size() < kLongestList)
      names += (names.empty() ? "" : ", ") + quoted(item.name);
  }
  return names.empty() ? "none" : names;
}

}  // namespace

DbcFile::DbcFile(std::string text, std::string name)
    : text_(std::move(text)),
      name_(std::move(name)),
      messages_(occurrences(text_, "BO_", kMaxMessages)),
      signals_(occurrences(text_, "SG_", kMaxSignals)),
      dbc_(messages_, signals_) {
  const wire::DbcStatus status = dbc_.parse(text_);
  if (!status.ok()) explain(status);
}

bool DbcFile::find(const std::string& reference, wire::FrameSignal& out) {
  const wire::DbcStatus status = dbc_.find(reference, out);
  if (!status.ok()) explain(status);
  return status.ok();
}

void DbcFile::explain(const wire::DbcStatus& status) {
  error_ = name_;
  if (status.line > 0) error_ += ':' + std::to_string(status.line);
  if (status.column > 0) error_ += ':' + std::to_string(status.column);
  if (status.error == wire::DbcError::kUnknownMessage) {
    error_ += ": expected a message " + quoted(status.found) + ", found " +
              names_of(dbc_.messages()) + "; name one of these";
    return;
  }
  if (status.error == wire::DbcError::kUnknownSignal) {
    error_ += ": expected a signal " + quoted(status.found) + ", found ";
    for (const wire::DbcMessage& message : dbc_.messages()) {
      if (message.line == status.line) error_ += names_of(dbc_.signals_of(message));
    }
    error_ += "; name one of these";
    return;
  }
  error_ += std::string(": expected ") + wire::expected_at(status.error) + ", found " +
            (status.found.empty() ? std::string("nothing") : quoted(status.found));
  if (status.error == wire::DbcError::kLayout) {
    error_ += std::string(", of which ") + wire::describe(status.layout);
  }
  error_ += "; repair the DBC file there";
}

}  // namespace config
