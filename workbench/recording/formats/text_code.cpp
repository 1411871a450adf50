#include "workbench/recording/formats/text_code.hpp"

#include <iconv.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>

#include "workbench/recording/column_name.hpp"
#include "workbench/recording/letters.hpp"
#include "workbench/recording/spelling/quality_words.hpp"
#include "workbench/recording/text_encoding.hpp"
#include "workbench/recording/written_time.hpp"

namespace workbench {
namespace {

constexpr std::size_t kHead = std::size_t{64} << 10;
constexpr std::size_t kHeadLines = 64;

// As iconv names them; of those that make as many words, the first.
constexpr std::array kCodes = {"CP932", "EUC-JP", "GBK",       "UHC",
                               "BIG5",  "CP1251", "CP1250",    "CP1254",
                               "CP866", "KOI8-R", "ISO-8859-2"};

bool is_utf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_length(text, at);
    if (length == 0) return text.size() - at < 4 && text.size() >= kHead;
    at += length;
  }
  return true;
}

bool has_high(std::string_view text) {
  return std::ranges::any_of(
      text, [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
}

// What `code` makes of the bytes; what it does not know becomes U+FFFD, or, in a `strict`
// reading, nothing of the whole.
std::optional<std::string> decoded(std::string_view bytes, const char* code,
                                   bool strict) {
  const iconv_t converter = iconv_open("UTF-8", code);
  if (converter == reinterpret_cast<iconv_t>(-1)) return std::nullopt;
  std::string out;
  std::array<char, 4096> part{};
  std::string copy(bytes);
  char* in = copy.data();
  std::size_t left = copy.size();
  bool readable = true;
  while (left > 0 && readable) {
    char* to = part.data();
    std::size_t room = part.size();
    const std::size_t done = iconv(converter, &in, &left, &to, &room);
    out.append(part.data(), part.size() - room);
    if (done != static_cast<std::size_t>(-1) || errno == E2BIG) continue;
    readable = !strict;
    out += "\xEF\xBF\xBD";
    ++in;
    --left;
  }
  iconv_close(converter);
  return readable ? std::optional(std::move(out)) : std::nullopt;
}

// A word for a column or a quality, or a time with words in it (2026/3/17 上午 08:15).
bool is_known(std::string_view cell) {
  constexpr std::size_t kShortest = 4;  // of a quality, bytes
  const ColumnName name = column_name(cell);
  if (name.part != Part::kNone && !has_high(name.tag)) return true;
  if (written_time(cell)) return true;
  return cell.size() >= kShortest &&
         quality_word(lower_case(utf8_of(cell))) != QualityWord::kUnknown;
}

// Cells beyond ASCII that are known.
std::size_t words_in(std::string_view text) {
  std::size_t words = 0;
  std::size_t lines = 0;
  while (!text.empty() && lines < kHeadLines) {
    const std::size_t end = std::min(text.find_first_of(",;\t|\r\n"), text.size());
    const std::string_view cell = text.substr(0, end);
    if (end < text.size() && text[end] == '\n') ++lines;
    if (has_high(cell) && is_known(cell)) ++words;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

}  // namespace

std::optional<std::string> recoded_text(std::string_view bytes) {
  std::string_view head = bytes.substr(0, kHead);
  if (is_utf8(head)) return std::nullopt;
  if (head.size() == kHead) head = head.substr(0, head.rfind('\n') + 1);
  const char* best = nullptr;
  std::size_t most = words_in(head);
  for (const char* code : kCodes) {
    const std::optional<std::string> text = decoded(head, code, true);
    if (!text) continue;
    const std::size_t words = words_in(*text);
    if (words <= most) continue;
    most = words;
    best = code;
  }
  return best == nullptr ? std::nullopt : decoded(bytes, best, false);
}

}  // namespace workbench
