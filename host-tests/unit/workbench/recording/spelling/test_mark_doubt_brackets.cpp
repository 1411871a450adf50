#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "workbench/recording/csv.hpp"
#include "workbench/recording/spelling/mark_doubt.hpp"

namespace workbench {
namespace {

TEST(BracketedNumber, IsNegative) {
  EXPECT_EQ(negative_of("(45.2)"), "-45.2");
  EXPECT_EQ(negative_of(" ( 1.285,24 ) "), "-1.285,24");
  for (const char* cell : {"45.2", "(-45.2)", "(m3/h)", "()", "(45.2", ""}) {
    EXPECT_FALSE(negative_of(cell)) << cell;
  }
}

TEST(BracketDoubt, ThroughZeroItIsASign) {
  BracketDoubt sign;
  for (int i = -20; i < 20; ++i) sign.add(i, i < 0);
  EXPECT_EQ(sign.total(), 20U);
  EXPECT_FALSE(sign.likely_marks());
}

TEST(BracketDoubt, FarFromZeroItIsAMark) {
  BracketDoubt mark;
  for (int i = 0; i < 20; ++i) mark.add(i == 7 ? -118 : 118 + i % 3, i == 7);
  EXPECT_TRUE(mark.likely_marks());
}

TEST(BracketDoubt, IsNotedOrRefused) {
  std::string text = "Time,A.OP,A.PV\n";
  for (int i = 0; i < 40; ++i) {
    const int y = std::abs(i % 16 - 8) - 4;
    const std::string cell = std::to_string(y < 0 ? -y : y);
    text += std::to_string(i) + ',' + std::to_string(40 + i % 7) + ',' +
            (y < 0 ? '(' + cell + ')' : cell) + '\n';
  }
  const Recording r = parse_csv(text, "a.csv");
  EXPECT_EQ(r.y[0], 4);
  EXPECT_EQ(r.y[8], -4);
  ASSERT_FALSE(r.resampling.notes.empty());
  EXPECT_EQ(r.resampling.notes.back(),
            "17 cells of 'A.PV' in brackets: taken as negative");
  EXPECT_THROW(static_cast<void>(parse_csv(
                   "Time,A.OP,A.PV\n0,1,118\n1,2,119\n2,3,(118)\n3,4,119\n", "a.csv")),
               std::exception);
}

}  // namespace
}  // namespace workbench
