// Whole workbooks stand in host-tests/exports: test_csv_exports.cpp.
#include <gtest/gtest.h>

#include <string>

#include "workbench/recording/csv.hpp"
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

TEST(Workbook, MayHoldASignalASheet) {
  const std::string bytes = bytes_of("workbook-sheet-a-tag.xlsx");
  const Recording r = parse_csv(bytes, "a.xlsx");
  EXPECT_EQ(r.size(), 60U);
  EXPECT_EQ(r.tags, "u FIC101.OP, y FIC101.PV");
  EXPECT_EQ(r.resampling.notes.front(),
            "a signal a sheet, joined by their times: 'FIC101.OP', 'FIC101.PV'");
  CsvOptions options;
  options.names.u = "FIC101.PV";
  options.names.y = "FIC101.OP";
  EXPECT_EQ(parse_csv(bytes, "a.xlsx", options).u, r.y);
  options.names.u = "TIC205";
  EXPECT_THROW((void)parse_csv(bytes, "a.xlsx", options), std::invalid_argument);
}

TEST(Workbook, JoinsSheetsOnlyWhereNoneFits) {
  const std::string bytes = bytes_of("workbook-sheet-a-tag.xlsx");
  SheetChoice choice;
  choice.fits = [](std::string_view) { return false; };
  std::string names;
  choice.join = [&names](const std::vector<NamedSheet>& sheets) {
    for (const NamedSheet& sheet : sheets) names += sheet.name + ' ';
    return std::optional<std::string>("all");
  };
  EXPECT_EQ(workbook_text(bytes, "f", choice), "all");
  EXPECT_EQ(names, "FIC101.OP FIC101.PV ");
  EXPECT_TRUE(choice.joined);
  choice.fits = {};
  EXPECT_THROW((void)workbook_text(bytes, "f", choice), InputError) << "both do";
  choice.name = "FIC101.PV";
  EXPECT_NE(workbook_text(bytes, "f", choice), "all");
}

}  // namespace
}  // namespace workbench
