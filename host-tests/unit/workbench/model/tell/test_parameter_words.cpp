// Parameters in words.
#include <gtest/gtest.h>

#include "workbench/model/tell/parameter_words.hpp"

namespace workbench {
namespace {

Parameter parameter(const char* name, double value) {
  Parameter out;
  out.name = name;
  out.value = value;
  return out;
}

TEST(ParameterWords, SayWhatAKeyMeans) {
  EXPECT_EQ(name_in_words("noise_before"), "noise before rounding");
  EXPECT_EQ(name_in_words("first_lag"), "first lag");
}

TEST(ParameterWords, SayWhatANumberStandsFor) {
  EXPECT_EQ(choice_in_words(parameter("spilling_storage", 1)), "the last storage");
  EXPECT_EQ(choice_in_words(parameter("keeps_sliding", 0)), "until u rests or turns");
  EXPECT_EQ(choice_in_words(parameter("noise_before", 1)), "");
  EXPECT_EQ(choice_in_words(parameter("first_lag", 1)), "");
  EXPECT_EQ(choice_in_words(parameter("spilling_storage", 7)), "");
}

TEST(ParameterWords, UnitsAreThoseOfTheRecordingWhereItNamesThem) {
  Recording recording;
  EXPECT_EQ(unit_in_words({"gain", "y/u", 1, 1, 1}, recording, Column::y), "y/u");
  EXPECT_EQ(unit_in_words({"gain", "y/u", 1, 1, 1}, recording, Column::x), "x/u");
  recording.units[static_cast<std::size_t>(Column::u)] = "%";
  recording.units[static_cast<std::size_t>(Column::y)] = "m3/h";
  EXPECT_EQ(unit_in_words({"gain", "y/u", 1, 1, 1}, recording, Column::y), "(m3/h)/%");
  EXPECT_EQ(unit_in_words({"offset", "y", 1, 1, 1}, recording, Column::y), "m3/h");
  EXPECT_EQ(unit_in_words({"spill_share", "1", 1, 1, 1}, recording, Column::y), "");
}

}  // namespace
}  // namespace workbench
