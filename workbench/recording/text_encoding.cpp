#include "workbench/recording/text_encoding.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>

#include "workbench/recording/formats/json_table.hpp"
#include "workbench/recording/formats/labview_export.hpp"
#include "workbench/recording/formats/line_protocol.hpp"
#include "workbench/recording/formats/logfmt.hpp"
#include "workbench/recording/formats/record_blocks.hpp"
#include "workbench/recording/formats/ruled_table.hpp"
#include "workbench/recording/formats/scope_export.hpp"
#include "workbench/recording/formats/text_code.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/letters.hpp"
#include "workbench/recording/workbook.hpp"

namespace workbench {
namespace {

struct ForeignFormat {
  std::string_view begins;
  std::string_view name;
  std::string_view advice;
  bool binary = false;  // letters that a text may begin with, too
};

using namespace std::string_view_literals;

constexpr std::string_view kSaveSheet =
    "open it in Excel or LibreOffice and save the sheet as \"CSV UTF-8\"";

constexpr std::string_view kNoNumbers =
    "a picture of a trend holds no numbers: export the trend's values as CSV";

constexpr std::string_view kUnpack = "unpack it, and open the file in it";

constexpr std::string_view kConvertCan =
    "write it as a candump log, in Python: can_logconvert FILE loop.log, and give --dbc";

constexpr std::string_view kQuery = "write the result of a query on the table as CSV";

constexpr std::string_view kSaveCan = "save it there as a candump log, and give --dbc";

constexpr auto kForeignFormats = std::to_array<ForeignFormat>({
    {"\xD0\xCF\x11\xE0"sv, "an old Excel workbook (xls), or one with a password",
     kSaveSheet},
    {"PAR1"sv, "a Parquet file",
     "write it as CSV, in Python: pandas.read_parquet(FILE).to_csv(CSV)"},
    {"\x1F\x8B"sv, "a gzip archive", "unpack it: gunzip FILE"},
    {"%PDF"sv, "a PDF document", "export the numbers from the historian as CSV"},
    {"\x89PNG"sv, "a picture (PNG)", kNoNumbers},
    {"\xFF\xD8\xFF"sv, "a picture (JPEG)", kNoNumbers},
    {"GIF8"sv, "a picture (GIF)", kNoNumbers},
    {"\x89HDF"sv, "an HDF5 file", "write the loop's signals as CSV"},
    {"MATLAB 5.0"sv, "a MATLAB file", "write it as CSV: writetable(T, 'loop.csv')"},
    {"SQLite format 3"sv, "an SQLite database",
     "write the query as CSV: sqlite3 -header -csv FILE \"SELECT ...\""},
    {"LOGG\x90"sv, "a CAN log of Vector (BLF)", kConvertCan},
    {";$FILEVERSION="sv, "a CAN trace of PEAK (TRC)", kConvertCan},
    {"Time Stamp,ID,Extended"sv, "a CAN log of SavvyCAN (CSV)", kSaveCan},
    {"timestamp,arbitration_id,"sv, "a CAN log of python-can (CSV)", kConvertCan},
    {"INSERT INTO "sv, "SQL statements", kQuery},
    {"CREATE TABLE "sv, "SQL statements", kQuery},
    {"-- MySQL dump"sv, "SQL statements", kQuery},
    {"--\n-- PostgreSQL database dump"sv, "SQL statements", kQuery},
    {"***BUSMASTER"sv, "a CAN log of BUSMASTER", kSaveCan},
    {"MDF     "sv, "a measurement file (MDF)",
     "write the loop's signals as CSV, in Python: asammdf.MDF(FILE).export('csv')"},
    {"UnFinMF "sv, "a measurement file (MDF) that was not closed",
     "close the recording, and write the loop's signals as CSV"},
    {"TDSm"sv, "a LabVIEW file (TDMS)",
     "write it as CSV, in Python: nptdms.TdmsFile(FILE).as_dataframe().to_csv(CSV)"},
    {"{\\rtf"sv, "a rich text document", "save it as plain text"},
    {"7z\xBC\xAF\x27\x1C"sv, "a 7z archive", kUnpack},
    {"Rar!"sv, "a RAR archive", kUnpack},
    {"BZh"sv, "a bzip2 archive", kUnpack},
    {"\xFD\x37zXZ"sv, "an xz archive", kUnpack},
    {"\x28\xB5\x2F\xFD"sv, "a Zstandard archive", kUnpack},
    {"MATLAB 7.3"sv, "a MATLAB file", "write it as CSV: writetable(T, 'loop.csv')"},
    {"ARROW1"sv, "a Feather file",
     "write it as CSV, in Python: pandas.read_feather(FILE).to_csv(CSV)"},
    {"\x93NUMPY"sv, "a NumPy array",
     "write it as CSV, in Python: numpy.savetxt(CSV, numpy.load(FILE), delimiter=',', "
     "header='t,u,y', comments='')"},
    {"RDX"sv, "an R workspace",
     "write it as CSV: write.csv(T, 'loop.csv', row.names=FALSE)"},
    {std::string_view("\0\1\0\0Standard ", 13), "an Access database",
     "export the table as CSV"},
    {"BM"sv, "a picture (BMP)", kNoNumbers, true},
    {"RIFF"sv, "a picture (WebP) or a recording of sound", kNoNumbers, true},
});

std::string_view from_first(std::string_view text, std::size_t at) {
  return text.substr(std::min(text.find_first_not_of(" \t\r\n", at), text.size()));
}

// {"key" or [{ or [[: not the [heads] of a preamble.
bool is_json(std::string_view start) {
  if (start.empty()) return false;
  const std::string_view next = from_first(start, 1);
  if (next.empty()) return false;
  return start[0] == '{' ? next[0] == '"' || next[0] == '}'
                         : start[0] == '[' && (next[0] == '{' || next[0] == '[');
}

std::optional<std::string> rows_in_json(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  return is_json(from_first(bytes, 0).substr(0, 64)) ? json_text(bytes) : std::nullopt;
}

// A Vector log as text: its date, then the base of its numbers.
bool is_asc_log(std::string_view text) {
  const std::string_view head = text.substr(0, 200);
  return head.starts_with("date ") && head.find("\nbase ") != std::string_view::npos;
}

// data = [
bool is_matlab_matrix(std::string_view text) {
  const std::size_t name = text.find_first_of(" =\r\n");
  if (name == 0 || name == std::string_view::npos) return false;
  const std::string_view equals = from_first(text, name);
  return equals.starts_with('=') && from_first(equals, 1).starts_with('[');
}

enum class Utf16 { kNo, kLittle, kBig };

// Without a mark: ASCII in UTF-16 has a zero in every second byte.
Utf16 guessed_utf16(std::string_view bytes) {
  const std::size_t looked_at = std::min<std::size_t>(bytes.size(), 64) & ~std::size_t{1};
  if (looked_at < 8) return Utf16::kNo;
  std::array<std::size_t, 2> zeros{};
  for (std::size_t i = 0; i < looked_at; ++i) {
    if (bytes[i] == '\0') ++zeros[i % 2];
  }
  const std::size_t most = looked_at / 2 * 9 / 10;
  if (zeros[1] >= most && zeros[0] == 0) return Utf16::kLittle;
  if (zeros[0] >= most && zeros[1] == 0) return Utf16::kBig;
  return Utf16::kNo;
}

// Characters that no text holds, where it is not UTF-16; one or two may be damage to it.
bool is_binary(std::string_view text) {
  constexpr std::size_t kHead = 512;
  constexpr std::ptrdiff_t kFewest = 4;
  constexpr std::ptrdiff_t kSeldom = 50;  // one in so many
  const std::string_view head = text.substr(0, kHead);
  const std::ptrdiff_t zeros = std::ranges::count(head, '\0');
  const std::ptrdiff_t others = std::ranges::count_if(
      head, [](char c) { return (c > '\0' && c < '\t') || (c > '\r' && c < '\x1A'); });
  const auto length = static_cast<std::ptrdiff_t>(head.size());
  return (zeros >= kFewest || (others >= kFewest && kSeldom * others > length)) &&
         guessed_utf16(text) == Utf16::kNo && !head.starts_with("\xFF\xFE") &&
         !head.starts_with("\xFE\xFF");
}

void refuse_foreign(std::string_view text, const std::string& file) {
  const auto refuse = [&file](std::string_view name, std::string_view advice) {
    throw InputError(file, 1, 1, "a CSV text file", std::string(name),
                     std::string(advice));
  };
  const bool binary = is_binary(text);
  for (const ForeignFormat& format : kForeignFormats) {
    if (format.binary && !binary) continue;
    if (text.starts_with(format.begins)) refuse(format.name, format.advice);
  }
  if (binary) {
    refuse("a file that is no text",
           "export the recording as CSV from the program that wrote it");
  }
  if (is_asc_log(text)) refuse("a CAN log of Vector (ASC)", kConvertCan);
  const std::string_view start = from_first(text, 0).substr(0, 64);
  if (is_json(start)) {
    refuse("JSON without a table of samples, as of a model file",
           "write an array of objects, [{\"t\": 0, \"u\": 44.9, \"y\": 60.0}, ...], or "
           "CSV; a model is given with --model FILE");
  }
  if (is_matlab_matrix(start)) {
    refuse("a MATLAB matrix", "write it as CSV: writematrix(data, 'loop.csv')");
  }
  if (begins_with_one_of(lower_case(start), "<html|<!doctype|<table|<?xml|<workbook")) {
    refuse("a web page or XML table (some systems call it .xls)", kSaveSheet);
  }
}

void append_utf8(std::string& out, std::uint32_t code) {
  if (code < 0x80) {
    out += static_cast<char>(code);
    return;
  }
  const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;  // bytes behind the first
  out += static_cast<char>((0xFF00 >> (more + 1) & 0xFF) | code >> 6 * more);
  for (int left = more; left-- > 0;) {
    out += static_cast<char>(0x80 | (code >> 6 * left & 0x3F));
  }
}

constexpr std::uint32_t kReplacement = 0xFFFD;

void convert_utf16(std::string_view bytes, bool big_endian, std::string& out) {
  const auto unit = [&](std::size_t at) -> std::uint32_t {
    const auto first = static_cast<unsigned char>(bytes[at]);
    const auto second = static_cast<unsigned char>(bytes[at + 1]);
    return big_endian ? static_cast<std::uint32_t>(first) << 8 | second
                      : static_cast<std::uint32_t>(second) << 8 | first;
  };
  out.reserve(bytes.size() / 2 + 16);
  for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) {
    std::uint32_t code = unit(at);
    if (code >= 0xD800 && code < 0xE000) {
      const std::uint32_t low = at + 3 < bytes.size() ? unit(at + 2) : 0;
      const bool pair = code < 0xDC00 && low >= 0xDC00 && low < 0xE000;
      code = pair ? 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00) : kReplacement;
      if (pair) at += 2;
    }
    append_utf8(out, code);
  }
}

// Windows-1252 differs from Latin-1 in 0x80 to 0x9F only.
constexpr std::array<std::uint16_t, 32> kWindows1252 = {
    0x20AC, 0xFFFD, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
    0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0xFFFD, 0x017D, 0xFFFD,
    0xFFFD, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
    0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0xFFFD, 0x017E, 0x0178};

constexpr std::size_t kLineEndsWithin = 4096;

// Lines of a program that ended them itself and had them ended once more: \r\r\n.
std::string with_single_ends(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.substr(i, 3) != "\r\r\n") out += text[i];
  }
  return out;
}

// What is text now; what a scope, LabVIEW or a database wrote as a table.
std::string_view tabular(std::string_view text, const std::string& file,
                         std::string& storage) {
  if (text.substr(0, kLineEndsWithin).find("\r\r\n") != std::string_view::npos) {
    storage = with_single_ends(text);
    text = storage;
  }
  std::optional<std::string> table = scope_text(text);
  if (!table) table = labview_text(text, file);
  if (!table) table = record_blocks_text(text);
  if (!table) table = line_protocol_text(text, file);
  if (!table) table = logfmt_text(text);
  if (!table) table = ruled_text(text);
  if (!table) table = fixed_width_text(text);
  if (!table) return text;
  storage = std::move(*table);
  return storage;
}

}  // namespace

std::string_view text_of(std::string_view bytes, const std::string& file,
                         std::string& storage) {
  SheetChoice sheet;
  return text_of(bytes, file, storage, sheet);
}

std::string_view text_of(std::string_view bytes, const std::string& file,
                         std::string& storage, SheetChoice& sheet) {
  if (is_zip(bytes)) {
    storage = workbook_text(bytes, file, sheet);
    return storage;
  }
  if (!sheet.name.empty()) {
    throw std::invalid_argument("--sheet is for Excel and OpenDocument workbooks, " +
                                file + " is none");
  }
  if (std::optional<std::string> rows = rows_in_json(bytes)) {
    storage = std::move(*rows);
    return storage;
  }
  refuse_foreign(bytes, file);
  if (bytes.starts_with("\xEF\xBB\xBF")) {
    bytes.remove_prefix(3);
    refuse_foreign(bytes, file);
    return tabular(bytes, file, storage);
  }
  Utf16 order = guessed_utf16(bytes);
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
    order = bytes[0] == '\xFF' ? Utf16::kLittle : Utf16::kBig;
    bytes.remove_prefix(2);
  }
  if (order == Utf16::kNo) {
    std::optional<std::string> recoded = recoded_text(bytes);
    if (!recoded) return tabular(bytes, file, storage);
    storage = std::move(*recoded);
    return tabular(storage, file, storage);
  }
  if (bytes.size() % 2 != 0) {
    throw InputError(file, 1, 1, "whole characters of two bytes",
                     "UTF-16 with an odd number of bytes",
                     "export the recording again, best as CSV UTF-8");
  }
  convert_utf16(bytes, order == Utf16::kBig, storage);
  refuse_foreign(storage, file);
  return tabular(storage, file, storage);
}

std::size_t utf8_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) -> unsigned {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
  };
  const unsigned first = byte(at);
  const std::size_t length = first < 0x80                    ? 1
                             : first >= 0xC2 && first < 0xE0 ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xC0) != 0x80) return 0;
  }
  const unsigned second = byte(at + 1);
  const bool overlong =
      (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool surrogate = first == 0xED && second >= 0xA0;
  return overlong || surrogate || (first == 0xF4 && second >= 0x90) ? 0 : length;
}

std::string utf8_of(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t length = utf8_length(text, at);
    if (length == 0) break;
    at += length;
  }
  if (at >= text.size()) return std::string(text);
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    append_utf8(out, byte >= 0x80 && byte < 0xA0 ? kWindows1252[byte - 0x80U] : byte);
  }
  return out;
}

}  // namespace workbench
