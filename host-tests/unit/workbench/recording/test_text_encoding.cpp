#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "workbench/recording/input_error.hpp"
#include "workbench/recording/text_encoding.hpp"

namespace workbench {
namespace {

using namespace std::string_literals;

std::string decoded(const std::string& bytes) {
  std::string storage;
  return std::string(text_of(bytes, "f", storage));
}

TEST(TextEncoding, ConvertsUtf16OfBothOrdersWithAndWithoutMark) {
  const std::string text = "t,u,y °C 😀\n";
  const std::u16string wide = u"t,u,y °C 😀\n";
  for (const bool big : {false, true}) {
    std::string bytes;
    for (const char16_t unit : wide) {
      const char low = static_cast<char>(unit & 0xFF);
      const char high = static_cast<char>(unit >> 8);
      bytes += big ? high : low;
      bytes += big ? low : high;
    }
    EXPECT_EQ(decoded((big ? "\xFE\xFF"s : "\xFF\xFE"s) + bytes), text);
  }
  EXPECT_EQ(decoded("t\0,\0u\0,\0y\0\n\0"s), "t,u,y\n");
  EXPECT_EQ(decoded("\xFF\xFE\x00\xD8"s), "\xEF\xBF\xBD");  // half a pair
}

TEST(TextEncoding, LeavesOtherTextAndTakesOffTheMark) {
  EXPECT_EQ(decoded("\xEF\xBB\xBFt,u\n"), "t,u\n");
  EXPECT_EQ(decoded("Grad \xB0\n"), "Grad \xB0\n");
  EXPECT_EQ(decoded(""), "");
}

// Bytes of every kind, as of an encrypted file; one or two that no text holds are damage.
TEST(TextEncoding, RefusesBytesThatAreNoText) {
  std::string bytes;
  std::uint32_t state = 1;
  for (int i = 0; i < 600; ++i) {
    state = 1664525 * state + 1013904223;
    bytes += static_cast<char>(state >> 24);
  }
  for (const std::size_t length : {200, 600}) {
    try {
      static_cast<void>(decoded(bytes.substr(0, length)));
      ADD_FAILURE() << length;
    } catch (const InputError& error) {
      EXPECT_EQ(error.found, "a file that is no text");
    }
  }
  const std::string damaged = "t,u,y\n0,1,2\n\x03\x01,2,3\n";
  EXPECT_EQ(decoded(damaged), damaged);
}

TEST(TextEncoding, ReadsNamesAsWindows1252WhereTheyAreNoUtf8) {
  EXPECT_EQ(utf8_of("m³/h °C"), "m³/h °C");
  EXPECT_EQ(utf8_of("m\xB3/h \xB0"
                    "C \x80"),
            "m³/h °C €");
  EXPECT_EQ(utf8_length("\xC0\x80", 0), 0U);      // overlong
  EXPECT_EQ(utf8_length("\xED\xA0\x80", 0), 0U);  // surrogate
  EXPECT_EQ(utf8_length("\xF0\x9F\x98\x80", 0), 4U);
}

TEST(TextEncoding, PreamblesAndNamesAreNoOtherFormat) {
  for (const std::string text : {"[Header]\n[1]\nt,u,y\n", "{trend}\n", "LOGGER 7\n",
                                 "date of export = 5\n", "t [s],u [%],y\n"}) {
    EXPECT_EQ(decoded(text), text);
  }
}

TEST(TextEncoding, RefusesOtherFormatsByName) {
  for (const auto& [bytes, name] : std::vector<std::pair<std::string, std::string>>{
           {"PK\x03\x04", "archive"},
           {"\xD0\xCF\x11\xE0", "xls"},
           {"PAR1", "Parquet"},
           {"\x1F\x8B", "gzip"},
           {"\xEF\xBB\xBF<!DOCTYPE html>", "web page"},
           {" \n<Table>", "web page"},
           {"\xFF\xFE<", "UTF-16"},
           {"LOGG\x90", "BLF"},
           {"MDF     4.10", "MDF"},
           {"TDSm", "TDMS"},
           {"date Wed May 13\nbase hex  timestamps absolute\n", "ASC"},
           {";$FILEVERSION=1.1\n", "TRC"},
           {"Time Stamp,ID,Extended,Bus,LEN,D1\n", "SavvyCAN"},
           {"timestamp,arbitration_id,extended,remote\n", "python-can"},
           {"***BUSMASTER Ver 2.4.0***\n", "BUSMASTER"},
           {"[{\"t\": 0}]", "JSON"},
           {"[\n {\n", "JSON"},
           {"{\"status\": 1}", "JSON"},
           {"data = [\n0 0 73.1\n", "MATLAB matrix"},
       }) {
    try {
      static_cast<void>(decoded(bytes));
      ADD_FAILURE() << name;
    } catch (const InputError& error) {
      EXPECT_NE(error.found.find(name), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace workbench
