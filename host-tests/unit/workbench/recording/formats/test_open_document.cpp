#include <gtest/gtest.h>

#include "workbench/recording/formats/open_document.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/text_file.hpp"

namespace workbench {
namespace {

std::string bytes_of_file() {
  return read_text_file(STICKBAND_EXPORTS "/workbook.ods", std::size_t{1} << 20);
}

TEST(OpenDocument, HoldsItsSheetsAsTheyAreStored) {
  const std::string file = "f";
  const std::string bytes = bytes_of_file();
  const std::vector<SheetTable> sheets = sheets_of_open_document(ZipParts(bytes, file));
  ASSERT_EQ(sheets.size(), 2U);
  EXPECT_EQ(sheets[0].name, "Cover");
  EXPECT_EQ(sheets[0].text.text(), "Trend of FIC101\n");
  EXPECT_EQ(sheets[1].text.rows(), 41U);
  EXPECT_EQ(sheets[1].text.text().substr(0, 44),
            "Time\tFIC101.OP\tFIC101.PV\n2026-05-13T14:30:00");
}

TEST(OpenDocument, IsReadOrRefusedWithAnyByteChanged) {
  const std::string file = "f";
  const std::string whole = bytes_of_file();
  for (std::size_t at = 0; at < whole.size(); at += 13) {
    std::string other = whole;
    other[at] = static_cast<char>(other[at] ^ 0x55);
    try {
      (void)sheets_of_open_document(ZipParts(other, file));
    } catch (const InputError&) {
      SUCCEED();
    }
  }
}

}  // namespace
}  // namespace workbench
