#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "workbench/recording/spelling/cell_number.hpp"

namespace workbench {
namespace {

using Result = NumberReader::Result;

std::optional<double> read(const std::string& cell, char separator,
                           NumberStyle style = {}) {
  double value = 0;
  NumberReader reader(separator, false, style);
  if (reader.read(cell, value) != Result::kOk) return std::nullopt;
  return value;
}

TEST(CellNumber, ReadsThousandsWhereTheyAreUnambiguous) {
  EXPECT_EQ(read("1.234,5", ';'), 1234.5);
  EXPECT_EQ(read("1,234,567", ';'), 1234567);
  EXPECT_EQ(read("-12.345.678,25", ';'), -12345678.25);
  EXPECT_EQ(read("1,234.50", ','), 1234.5);
  EXPECT_EQ(read("1 234,5", ';'), 1234.5);
  EXPECT_EQ(read("1\xC2\xA0"
                 "234,5",
                 ';'),
            1234.5);
  EXPECT_EQ(read("1'234.5", ';'), 1234.5);
  EXPECT_EQ(read("1,5e3", ';'), 1500);
  EXPECT_EQ(read("1,23,456.7", ','), 123456.7);
  EXPECT_EQ(read("-1,23,456", ','), -123456);
  EXPECT_EQ(read("12,34,56,789", ';'), 123456789);
}

TEST(CellNumber, RefusesBadGroups) {
  for (const std::string cell :
       {"12..3", "1.2.3", "1,2,34,567", "1,23,45", "1.234.5", "1 2", "1,234,5",
        "1.234,5,6", ",", ".", "1.234 567", "12 34,5", "1e", ""}) {
    EXPECT_EQ(read(cell, ';'), std::nullopt) << cell;
  }
}

TEST(CellNumber, AloneACommaAndThreeDigitsAreDecimalsOrAsked) {
  EXPECT_EQ(read("1,234", ';'), 1.234);
  EXPECT_EQ(read("1,234", ','), std::nullopt);
  EXPECT_EQ(read("1,234", ',', {.decimal = '.'}), 1234);
  EXPECT_EQ(read("1,234", ',', {.decimal = ','}), 1.234);
  EXPECT_EQ(read("1.234", ';', {.decimal = ',', .grouped = true}), 1234);
  EXPECT_EQ(read("0.234", ';', {.decimal = '.'}), 0.234);
  const NumberStyle given{.decimal = ',', .given = true, .grouped = true};
  EXPECT_EQ(read("1.234", ';', given), 1234);
  EXPECT_EQ(read("1,234", ';', given), 1.234);
  EXPECT_FALSE(read("4.5", ';', given));
}

TEST(CellNumber, OneDecimalMarkInAFile) {
  NumberReader reader(';', false, {});
  double value = 0;
  EXPECT_EQ(reader.read("1.5", value), Result::kOk);
  EXPECT_EQ(reader.read("7", value), Result::kOk);
  EXPECT_EQ(reader.read("1,5", value), Result::kMixedMarks);
}

TEST(CellNumber, AStyleIsWhatTheCellsAgreeOn) {
  const auto style_of = [](const std::vector<std::string>& cells) {
    NumberEvidence evidence;
    for (const std::string& cell : cells) EXPECT_TRUE(evidence.add(cell)) << cell;
    return evidence.style();
  };
  EXPECT_EQ(style_of({"1", "2,5"}).decimal, ',');
  EXPECT_EQ(style_of({"1.25", "3"}).decimal, '.');
  EXPECT_EQ(style_of({"1.5", "2,5"}).decimal, 0);
  EXPECT_TRUE(style_of({"1.234,5"}).grouped);
  EXPECT_EQ(style_of({"1,234", "5,678"}).decimal, 0);
  NumberEvidence evidence;
  EXPECT_FALSE(evidence.add("FIC101"));
  EXPECT_FALSE(evidence.add("2026-05-03"));
}

}  // namespace
}  // namespace workbench
