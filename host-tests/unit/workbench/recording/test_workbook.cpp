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

TEST(Workbook, KeepsTheLinesOfTheSheet) {
  const std::string text = workbook_text(bytes_of("workbook.xlsx"), "f");
  EXPECT_EQ(text.substr(0, text.find('4')),
            "Trend of FIC101\n\n\n"
            "Time\tFIC101.OP\tFIC101.PV\tFIC101.SP\n"
            "2026-05-13 1");
}

TEST(Workbook, WritesEmptyCells) {
  const std::string text = workbook_text(bytes_of("workbook-german.xlsx"), "f");
  EXPECT_NE(text.find("2026-05-13\t14:30:09.000\t"), std::string::npos) << text;
  const std::size_t gap = text.find("2026-05-13\t14:30:10.000\t");
  ASSERT_NE(gap, std::string::npos);
  EXPECT_EQ(text[text.find('\n', gap) - 1], '\t');
}

TEST(Workbook, RefusesWhatIsCutAtAnyByte) {
  const std::string whole = bytes_of("workbook.xlsx");
  for (std::size_t size = 4; size < whole.size(); size += 97) {
    EXPECT_THROW((void)workbook_text(whole.substr(0, size), "f"), InputError) << size;
  }
}

TEST(Workbook, IsReadOrRefusedWithAnyByteChanged) {
  const std::string whole = bytes_of("workbook.xlsx");
  for (std::size_t at = 0; at < whole.size(); at += 13) {
    std::string other = whole;
    other[at] = static_cast<char>(other[at] ^ 0x55);
    try {
      (void)workbook_text(other, "f");
    } catch (const InputError&) {
      SUCCEED();
    }
  }
}

}  // namespace
}  // namespace workbench
