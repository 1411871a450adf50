#include <gtest/gtest.h>

#include <string>

#include "workbench/recording/csv.hpp"
#include "workbench/recording/spelling/mark_doubt.hpp"

namespace workbench {
namespace {

TEST(UnitScale, OfOnePrefixToAnother) {
  EXPECT_EQ(unit_ratio("kW", "W"), 1e3);
  EXPECT_EQ(unit_ratio("mbar", "bar"), 1e-3);
  EXPECT_EQ(unit_ratio("MPa", "kPa"), 1e3);
  EXPECT_FALSE(unit_ratio("t/h", "kg/h"));
  EXPECT_FALSE(unit_ratio("m", "mm"));
  EXPECT_FALSE(unit_ratio("K", ""));
  EXPECT_FALSE(unit_ratio("%", "%"));
}

TEST(UnitScale, KOfThousandLeavesNoGap) {
  EXPECT_TRUE(says_thousand("K"));
  ScaledCells cells;
  EXPECT_TRUE(cells.add_thousand(1.0));
  EXPECT_FALSE(cells.add_thousand(1000.5));
  EXPECT_TRUE(cells.are_thousands({800, 995, 1005, 1200}));
  EXPECT_FALSE(cells.are_thousands({297, 298'000}));
}

std::string table_of(const std::string& low, const std::string& high,
                     const std::string& other) {
  std::string text = "Time,A.OP,A.PV\n";
  for (int i = 0; i < 40; ++i) {
    text += std::to_string(i) + ',' + std::to_string(40 + i % 7) + ',' +
            (i % 4 < 1   ? low
             : i % 4 < 3 ? high
                         : other) +
            '\n';
  }
  return text;
}

TEST(UnitScale, CellsOfAColumnAreBroughtToOneUnit) {
  const Recording thousands = parse_csv(table_of("995", "1.01 K", "700"), "a.csv");
  EXPECT_EQ(thousands.y[0], 995);
  EXPECT_EQ(thousands.y[2], 1010);
  EXPECT_EQ(thousands.resampling.notes.back(),
            "20 cells of 'A.PV' with a K: taken as thousands");
  const Recording first = parse_csv(table_of("1.01 K", "995", "700"), "a.csv");
  EXPECT_EQ(first.y[0], 1010);
  EXPECT_EQ(first.y[2], 995);
  const Recording prefixed =
      parse_csv(table_of("980 mbar", "1.25 bar", "970 mbar"), "a.csv");
  EXPECT_EQ(prefixed.y[2], 1250);
  EXPECT_EQ(prefixed.resampling.notes.back(),
            "20 cells of 'A.PV' in 'bar': brought to the unit of the others");
  EXPECT_THROW(static_cast<void>(parse_csv(table_of("297", "1.5 K", "250"), "a.csv")),
               std::exception);
  EXPECT_THROW(static_cast<void>(parse_csv(table_of("297", "298 K", "250"), "a.csv")),
               std::exception);
}

}  // namespace
}  // namespace workbench
