#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "workbench/recording/column_choice.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/time_place.hpp"

namespace workbench {
namespace {

std::optional<TimePlace> place_of(const std::string& head, const std::string& first,
                                  const std::string& time = "") {
  std::string text = head + '\n';
  for (int k = 0; k < 9; ++k) text += first + std::to_string(k) + ",4,6\n";
  const CsvLayout layout = layout_of(text, "a.csv", {});
  const std::vector<NamedSignal> candidates = candidates_of(layout);
  const std::string file = "a.csv";
  ColumnNames names;
  names.time = time;
  return TimeFinder(layout, file, names, candidates).find();
}

using Columns = std::vector<std::size_t>;

TEST(TimePlace, TakesPartsWhereNoColumnIsAWholeTime) {
  const auto alone = place_of("Hour,Minute,Second,OP,PV", "14,30,1");
  ASSERT_TRUE(alone);
  EXPECT_EQ(alone->form, TimeForm::kClock);
  EXPECT_EQ(columns_of(*alone), (Columns{0, 1, 2}));
  const auto dated = place_of("Datum,Hour,Minute,Second,OP,PV", "13.05.2026,14,30,1");
  ASSERT_TRUE(dated);
  EXPECT_EQ(dated->form, TimeForm::kDate);
  EXPECT_EQ(columns_of(*dated), (Columns{0, 1, 2, 3}));
  const auto whole =
      place_of("Hour,Minute,Second,Time,OP,PV", "14,30,1,2026-05-13 14:30:1");
  ASSERT_TRUE(whole);
  EXPECT_EQ(columns_of(*whole), Columns{3});
}

TEST(TimePlace, TakesAllPartsWhereOneIsNamed) {
  const auto named = place_of("Hour,Minute,Second,OP,PV", "14,30,1", "Minute");
  ASSERT_TRUE(named);
  EXPECT_EQ(named->parts, (Columns{0, 1, 2}));
  const auto as_number = place_of("Hour,Minute,Second,OP,PV", "14,30,1", "Second [s]");
  ASSERT_TRUE(as_number);
  EXPECT_EQ(columns_of(*as_number), Columns{2});
}

TEST(TimePlace, AsksForTheRestOfADateBesideHours) {
  EXPECT_THROW((void)place_of("Day,Hour,Minute,Second,OP,PV", "13,14,30,1"), InputError);
  EXPECT_THROW((void)place_of("Month,Day,Hour,Minute,Second,OP,PV", "5,13,14,30,1"),
               InputError);
}

}  // namespace
}  // namespace workbench
