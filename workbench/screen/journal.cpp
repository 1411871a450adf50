#include "workbench/screen/journal.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "workbench/recording/parsed_json.hpp"

namespace workbench {
namespace {

using Json = nlohmann::json;

// Another version may judge otherwise.
constexpr int kFormat = 2;

// A path may be no text: JSON would not give it back.
std::string printable(const std::string& key) {
  std::string out;
  for (const char c : key) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7F && c != '%') {
      out += c;
    } else {
      constexpr const char* kDigits = "0123456789ABCDEF";
      out += {'%', kDigits[byte >> 4], kDigits[byte & 15]};
    }
  }
  return out;
}

}  // namespace

Journal::Journal(const std::string& path) : path_(path) {
  if (path.empty()) return;
  bool cut_off = false;
  if (std::ifstream in(path, std::ios::binary); in) {
    for (std::string line; std::getline(in, line);) {
      cut_off = in.eof();
      const Json json = parsed_json<Json>(line);
      try {
        if (json.at("version") != STICKBAND_VERSION || json.at("format") != kFormat) {
          continue;
        }
        lines_[json.at("key").get<std::string>()] = json.at("loop").dump();
      } catch (const Json::exception&) {  // no line of a journal
        continue;
      }
    }
  }
  file_ = std::fopen(path.c_str(), "ab");
  if (file_ == nullptr) {
    throw std::runtime_error("cannot write the journal " + path + ": " +
                             std::strerror(errno));
  }
  if (cut_off) std::fputc('\n', file_);
}

Journal::~Journal() {
  if (file_ != nullptr) std::fclose(file_);
}

std::optional<ScreenedLoop> Journal::find(const std::string& key) const {
  const auto at = lines_.find(printable(key));
  if (at == lines_.end()) return std::nullopt;
  try {
    return from_journal(Json::parse(at->second));
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

void Journal::add(const std::string& key, const ScreenedLoop& loop) {
  if (file_ == nullptr) return;
  const Json json{{"version", STICKBAND_VERSION},
                  {"format", kFormat},
                  {"key", printable(key)},
                  {"loop", journal_json(loop)}};
  const std::string line =
      json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
  const std::lock_guard lock(mutex_);
  if (std::fwrite(line.data(), 1, line.size(), file_) != line.size() ||
      std::fflush(file_) != 0) {
    throw std::runtime_error("cannot write the journal " + path_ + ": " +
                             std::strerror(errno));
  }
}

}  // namespace workbench
