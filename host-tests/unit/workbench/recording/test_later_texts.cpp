#include <gtest/gtest.h>

#include <string>

#include "workbench/recording/later_texts.hpp"

namespace workbench {
namespace {

constexpr int kMoreThanFirstRows = 200;
const LayoutWish kWish{{Column::u, Column::y}, {}};

std::string rows_of_tag(const std::string& tag, const std::string& status) {
  std::string out;
  for (int i = 0; i < kMoreThanFirstRows; ++i) {
    out += tag + ',' + std::to_string(i) + ',' + std::to_string(i * i % 7) + ',' +
           status + '\n';
  }
  return out;
}

TEST(LaterTexts, NumbersOfPagesAreNoRows) {
  for (const char* line :
       {"Page 1 of 30,,,", "Seite 3/30", "\t\tPage 12", "- Page 4 -"}) {
    EXPECT_TRUE(heads_again(line, "")) << line;
  }
  for (const char* line : {"Page,1,2", "Side 1.5", "Page 1;2;3", "Pages", "Page", ""}) {
    EXPECT_FALSE(heads_again(line, "")) << line;
  }
}

TEST(LaterTexts, OnlyTagsMayChange) {
  const CsvLayout layout = layout_of(
      "Tag,Time,Value,Text\n" + rows_of_tag("A.OP", "x") + rows_of_tag("A.PV", "z"),
      "a.csv", kWish);
  EXPECT_TRUE(layout.columns[0].changes_later);
  EXPECT_FALSE(layout.columns[3].changes_later);
}

TEST(LaterTexts, WithoutAHeaderWhatNamesASignalMayChange) {
  const CsvLayout layout =
      layout_of(rows_of_tag("A.OP", "AUTO") + rows_of_tag("A.PV", "MAN"), "a.csv", kWish);
  EXPECT_TRUE(layout.columns[0].changes_later);
  EXPECT_FALSE(layout.columns[3].changes_later);
}

TEST(LaterTexts, WithoutAHeaderAnyTagBesideTimeAndNumberMayChange) {
  const auto three = [](const std::string& tag) {
    std::string out;
    for (int i = 0; i < kMoreThanFirstRows; ++i) {
      out += std::to_string(1773475200 + i) + ',' + std::to_string(i * i % 7) + ',' +
             tag + '\n';
    }
    return out;
  };
  EXPECT_TRUE(layout_of(three("a/valve") + three("a/flow"), "a.csv", kWish)
                  .columns[2]
                  .changes_later);
  EXPECT_FALSE(
      layout_of(three("AUTO") + three("MAN"), "a.csv", kWish).columns[2].changes_later);
}

TEST(LaterTexts, ComeInBlocksAndEndAtTheFirstChange) {
  const std::string file = "a.csv";
  CsvLayout layout =
      layout_of("Tag,Time,Value,Text\n" + rows_of_tag("A.OP", "x"), file, kWish);
  LaterTexts later(layout, file);
  EXPECT_TRUE(later.are_open());
  later.add(rows_of_tag("A.OP", "x"));
  later.add("Tag,Time,Value,Text\n200 rows\n");
  EXPECT_TRUE(later.are_open());
  later.add("A.PV,0,1,x\n");
  EXPECT_FALSE(later.are_open());
  later.settle(layout);
  EXPECT_TRUE(layout.columns[0].changes_later);
}

TEST(LaterTexts, HeadsComeAgainAboveFurtherTables) {
  EXPECT_TRUE(heads_again("Tag,Time ", "Tag,Time"));
  EXPECT_TRUE(heads_again("#datatype,string,long", ""));
  EXPECT_FALSE(heads_again("", ""));
  EXPECT_FALSE(heads_again("A.OP,0", "Tag,Time"));
}

}  // namespace
}  // namespace workbench
