// Whole workbooks stand in host-tests/exports: test_csv_exports.cpp.
#include <gtest/gtest.h>

#include <string>

#include "workbench/recording/input_error.hpp"
#include "workbench/recording/text_file.hpp"
#include "workbench/recording/workbook.hpp"

namespace workbench {
namespace {

constexpr std::size_t kMost = std::size_t{1} << 20;

std::string bytes_of(const std::string& file) {
  return read_text_file(std::string(STICKBAND_EXPORTS) + '/' + file, kMost);
}

std::string text_of_book(const std::string& bytes, SheetChoice choice = {}) {
  return workbook_text(bytes, "f", choice);
}

TEST(Workbook, KeepsTheLinesOfTheSheet) {
  const std::string text = text_of_book(bytes_of("workbook.xlsx"));
  EXPECT_EQ(text.substr(0, text.find('4')),
            "Trend of FIC101\n\n\n"
            "Time\tFIC101.OP\tFIC101.PV\tFIC101.SP\n"
            "2026-05-13 1");
}

TEST(Workbook, WritesEmptyCells) {
  const std::string text = text_of_book(bytes_of("workbook-german.xlsx"));
  EXPECT_NE(text.find("2026-05-13\t14:30:09.000\t"), std::string::npos) << text;
  const std::size_t gap = text.find("2026-05-13\t14:30:10.000\t");
  ASSERT_NE(gap, std::string::npos);
  EXPECT_EQ(text[text.find('\n', gap) - 1], '\t');
}

TEST(Workbook, RefusesWhatIsCutAtAnyByte) {
  const std::string whole = bytes_of("workbook.xlsx");
  for (std::size_t size = 4; size < whole.size(); size += 97) {
    EXPECT_THROW((void)text_of_book(whole.substr(0, size)), InputError) << size;
  }
}

TEST(Workbook, IsReadOrRefusedWithAnyByteChanged) {
  const std::string whole = bytes_of("workbook.xlsx");
  for (std::size_t at = 0; at < whole.size(); at += 13) {
    std::string other = whole;
    other[at] = static_cast<char>(other[at] ^ 0x55);
    try {
      (void)text_of_book(other);
    } catch (const InputError&) {
      SUCCEED();
    }
  }
}

TEST(Workbook, TakesTheSheetThatIsNamedOrFits) {
  const std::string bytes = bytes_of("workbook-one-fits.xlsx");
  EXPECT_EQ(text_of_book(bytes, {"Alarms"}).substr(0, 5), "Alarm");
  const auto has_times = [](std::string_view text) {
    return text.find("Time\t") != std::string_view::npos;
  };
  EXPECT_TRUE(has_times(text_of_book(bytes, {"", has_times})));
  EXPECT_THROW((void)text_of_book(bytes), InputError);
  EXPECT_THROW((void)text_of_book(bytes, {"Alarm"}), InputError);
}

}  // namespace
}  // namespace workbench
