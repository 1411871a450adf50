#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "workbench/recording/csv.hpp"
#include "workbench/recording/rows/row_scanner.hpp"

namespace workbench {
namespace {

bool says(const std::vector<std::string_view>& cells, bool behind_head = false,
          std::string_view first = "2026-03-17 08:15:00") {
  CsvLayout layout;
  for (const char* name : {"Time", "OP", "PV"}) {
    layout.columns.emplace_back().name = column_name(name);
  }
  layout.columns[1].name.unit = "%";
  layout.columns[2].name.unit = "m3/h";
  return is_remark(cells, first, layout, behind_head);
}

TEST(RemarkLine, SaysOneThingInWords) {
  EXPECT_TRUE(says({"--- shift change ---", "", ""}));
  EXPECT_TRUE(says({"ALARM FIC101 HI", "", ""}));
  EXPECT_TRUE(says({"# SP changed", "by the operator", ""}));
  EXPECT_TRUE(says({"*** Logging stopped 2026-03-17 ***", "", ""}));
}

TEST(RemarkLine, MayBeASummary) {
  for (const char* word : {"Average", "MAX", "Total:", "Mittelwert"}) {
    EXPECT_TRUE(says({word, "52.1", "110.2"})) << word;
  }
  EXPECT_FALSE(says({"Bad", "52.1", "110.2"})) << "a row whose time is damaged";
}

TEST(RemarkLine, IsNoRowThatIsDamaged) {
  EXPECT_FALSE(says({"2026-03-17 08:2", "", ""}));
  EXPECT_FALSE(says({"", "52.1", ""}));
  EXPECT_FALSE(says({"Bad", "Bad", "Bad"}));
  EXPECT_FALSE(says({"Mar 17 20", "", ""}, false, "Mar 17 2026 08:15:00"));
  EXPECT_TRUE(says({"--- shift change ---", "", ""}, false, "Mar 17 2026 08:15:00"));
}

TEST(RemarkLine, IsNoOtherHeader) {
  EXPECT_FALSE(says({"Time", "PV", "OP"}));
  EXPECT_FALSE(says({"#Time", "PV", "OP"}));
  EXPECT_FALSE(says({"Zeit", "TIC205.OP", "TIC205.PV"}));
  EXPECT_TRUE(says({"", "%", "m3/h"}, true)) << "units under the header once more";
  EXPECT_FALSE(says({"", "%", "l/min"}, true)) << "other units";
}

std::string table(const std::string& between, int every) {
  std::string text = "Time [s],FIC101.OP,FIC101.PV\n";
  for (int k = 0; k < 100; ++k) {
    if (k > 0 && k % every == 0) text += between;
    text += std::to_string(k) + ',' + std::to_string(40 + k % 7) + ',' +
            std::to_string(60 + k % 5) + '\n';
  }
  return text;
}

TEST(RemarkLine, BetweenRowsIsLeftOutAndCounted) {
  const Recording r = parse_csv(table("--- shift change ---\n", 30), "a.csv");
  EXPECT_EQ(r.size(), 100U);
  EXPECT_EQ(r.resampling.notes,
            std::vector<std::string>{"3 lines between the rows are no rows (first "
                                     "'--- shift change ---'): left out"});
  EXPECT_EQ(parse_csv(table("Report of shift\n\nPage 2\nAverage,1,2\n", 60), "a.csv")
                .resampling.notes.front(),
            "2 lines between the rows are no rows (first 'Report of shift'): left out");
}

TEST(RemarkLine, StandsSeldomBetweenRows) {
  EXPECT_THROW((void)parse_csv(table("--- tick ---\n", 5), "a.csv"), InputError);
  EXPECT_THROW((void)parse_csv(table("Time [s],FIC101.PV,FIC101.OP\n", 50), "a.csv"),
               InputError)
      << "the columns change places";
  CsvOptions counted;
  counted.ts = 1;
  EXPECT_THROW((void)parse_csv(table("--- off ---\n", 50), "a.csv", counted), InputError)
      << "it may stand for a row";
}

}  // namespace
}  // namespace workbench
