#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "workbench/recording/columns/long_format.hpp"

namespace workbench {
namespace {

CsvLayout long_layout(const std::string& text) {
  return layout_of(text, "f.csv", {{Column::t, Column::u, Column::y}, {}});
}

std::string columns(const std::string& text, const std::vector<std::size_t>& times) {
  const auto found = long_format(long_layout(text), times);
  if (!found) return "none";
  return std::to_string(found->tag) + std::to_string(found->value) +
         (found->quality ? std::to_string(*found->quality) : "");
}

std::string rows(const std::string& a, const std::string& b) {
  return a + '\n' + b + '\n' + a + '\n' + b + '\n' + a + '\n';
}

TEST(LongFormat, ByTheNamesOfItsColumns) {
  EXPECT_EQ(columns("RecordTime,FullName,ValueAsReal,QualityDesc\n" +
                        rows("2026-03-14 08:00:00,S.OP,4.5,Good",
                             "2026-03-14 08:00:00,S.PV,6.5,Good"),
                    {0}),
            "123");
}

TEST(LongFormat, TheOnlyNumbersAreTheValues) {
  EXPECT_EQ(
      columns("entity_id,state,last_changed\n" +
                  rows("s.out,4.5,2026-03-14 08:00:00", "s.pv,6.5,2026-03-14 08:00:00"),
              {2}),
      "01");
}

TEST(LongFormat, AColumnNamesTheUnit) {
  const CsvLayout layout =
      long_layout("Tag,Time,Value,UoM\n" + rows("A.OP,2026-03-14 08:00:00,4.5,%",
                                                "A.PV,2026-03-14 08:00:00,6.5,m3/h"));
  ASSERT_TRUE(long_format(layout, {1}));
  EXPECT_EQ(long_format(layout, {1})->unit, 3U);
}

TEST(LongFormat, OfSeveralNumbersTheAverage) {
  EXPECT_EQ(columns("Tag,Time,Minimum,Maximum,Average\n" +
                        rows("A.OP,2026-03-14 08:00:00,1,3,2",
                             "A.PV,2026-03-14 08:00:00,1,3,2"),
                    {1}),
            "04");
  EXPECT_EQ(columns("Tag,Time,Low,High\n" + rows("A.OP,2026-03-14 08:00:00,1,3",
                                                 "A.PV,2026-03-14 08:00:00,1,3"),
                    {1}),
            "none");
}

TEST(LongFormat, TagsMayBeNumbers) {
  EXPECT_EQ(columns("tagid,floatvalue,t_stamp\n" +
                        rows("14,4.5,1773475200000", "15,6.5,1773475200000"),
                    {2}),
            "01");
}

TEST(LongFormat, WholeNumbersMayHaveTheirOwnColumn) {
  const CsvLayout layout =
      long_layout("tagpath,intvalue,floatvalue,t_stamp\n" +
                  rows("A.OP,,4.5,1773475200000", "A.PV,6,,1773475200000"));
  const auto found = long_format(layout, {3});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->value, 2U);
  EXPECT_EQ(found->whole, 1U);
}

TEST(LongFormat, WithoutAHeaderTheTagsSaySo) {
  EXPECT_EQ(columns(rows("A.OP,2026-03-14 08:00:00,4.5,Good",
                         "A.PV,2026-03-14 08:00:00,6.5,Good"),
                    {1}),
            "023");
  EXPECT_EQ(
      columns(rows("x7,2026-03-14 08:00:00,4.5,1", "x8,2026-03-14 08:00:00,6.5,1"), {1}),
      "none");
}

TEST(LongFormat, WithoutAHeaderATextBesideTimeAndNumberAloneIsTheTag) {
  EXPECT_EQ(
      columns(rows("x7,2026-03-14 08:00:00,4.5", "x8,2026-03-14 08:00:00,6.5"), {1}),
      "02");
  EXPECT_EQ(columns(rows("1773475200,4.5,a/valve", "1773475200,6.5,a/flow"), {0}), "21");
  for (const std::string word : {"Good", "bar", "AUTO"}) {
    EXPECT_EQ(columns(rows(word + ",2026-03-14 08:00:00,4.5",
                           word + ",2026-03-14 08:00:00,6.5"),
                      {1}),
              "none")
        << word;
  }
}

TEST(LongFormat, QualitiesUnitsAndModesAreNoTags) {
  EXPECT_TRUE(may_name_tag("plant/valve"));
  EXPECT_TRUE(may_name_tag("x7"));
  for (const char* word : {"Good", "bad", "m3/h", "AUTO", "MAN"}) {
    EXPECT_FALSE(may_name_tag(word)) << word;
  }
}

TEST(LongFormat, NotBesideAnOutput) {
  EXPECT_EQ(columns("Time,Name,OP,PV\n" +
                        rows("2026-03-14 08:00:00,a,1,2", "2026-03-14 08:00:01,b,1,2"),
                    {0}),
            "none");
}

}  // namespace
}  // namespace workbench
