// Columns that say how good the values of another one are.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "workbench/recording/columns/quality_columns.hpp"
#include "workbench/recording/csv_layout.hpp"

namespace workbench {
namespace {

// The tag of the last column where it is one of qualities, else "-".
std::string quality_of(const std::string& names, const std::vector<std::string>& cells) {
  std::string text = "Time," + names + '\n';
  for (int i = 0; i < 20; ++i) {
    text += "2026-03-17 08:15:" + std::to_string(10 + i) + ",4" + std::to_string(i) +
            ".5," + cells[static_cast<std::size_t>(i) % cells.size()] + '\n';
  }
  const CsvLayout layout = layout_of(text, "f.csv", {{Column::t, Column::y}, {}});
  const ColumnName& name = layout.columns.at(2).name;
  return name.part == Part::kQuality ? name.tag : "-";
}

TEST(QualityColumns, AreNamedAsTheirSignal) {
  EXPECT_EQ(quality_of("FIC101.OP,FIC101.OPquality", {"Good", "Bad"}), "fic101op");
  EXPECT_EQ(quality_of("FIC101.OP,FIC101.OP_ST", {"0"}), "fic101op");
  EXPECT_EQ(quality_of("OP,OPQ", {"192", "0"}), "op");
}

TEST(QualityColumns, StandRightBehindIt) {
  EXPECT_EQ(quality_of("FIC101.OP,Q1", {"G", "B"}), "fic101op");
  EXPECT_EQ(quality_of("FIC101.OP,Val1Q", {"G", "G", "U"}), "fic101op");
  EXPECT_EQ(quality_of("FIC101.PV,PVQ", {"192", "192", "0"}), "fic101pv");
}

TEST(QualityColumns, OthersAreSignalsOfTheirOwn) {
  EXPECT_EQ(quality_of("T1,Q1", {"0", "100"}), "-");
  EXPECT_EQ(quality_of("FIC101.OP,FIC101.OP_ST", {"0", "1"}), "-");
  EXPECT_EQ(quality_of("FIC101.OP,AirQuality", {"412", "407"}), "-");
  EXPECT_EQ(quality_of("FIC101.OP,Q", {"41.5", "42"}), "-");
  EXPECT_EQ(quality_of("FIC101.OP,Q1", {"red", "green"}), "-");
}

}  // namespace
}  // namespace workbench
