// The verdict on the valve as the page gets it.
#include <gtest/gtest.h>

#include <sstream>

#include "workbench/recording/csv.hpp"
#include "workbench/serve/valve_answer.hpp"
#include "workbench/simulate/recording_csv.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace workbench {
namespace {

using nlohmann::json;

Recording recording_of(const char* scenario) {
  std::ostringstream csv;
  write_csv(*simulate(scenario, 2), csv);
  return parse_csv(csv.str(), scenario);
}

json answer_of(const Recording& recording) {
  return json::parse(valve_json(recording, valve_answer(recording)).dump());
}

TEST(ServeValveAnswer, TellsBandAndCureOfAValveThatSticks) {
  const Recording recording = recording_of("stiction");
  const json answer = answer_of(recording);
  EXPECT_EQ(answer["verdict"], "stiction");
  EXPECT_EQ(answer["mood"], "bad");
  for (const char* stroke : {"ascending", "descending"}) {
    const json band = answer["band"][stroke];
    EXPECT_LE(band["percent_low"], band["percent"]);
    EXPECT_LE(band["percent"], band["percent_high"]);
    EXPECT_GT(band["percent"], 0);
  }
  EXPECT_FALSE(answer["advice"].get<std::string>().empty());
  EXPECT_TRUE(answer["picture"].contains("stem"));
}

TEST(ServeValveAnswer, LeavesOutTheBandOfAValveThatDoesNot) {
  const json answer = answer_of(recording_of("setpoint"));
  EXPECT_NE(answer["mood"], "bad");
  EXPECT_TRUE(answer["band"]["ascending"].is_null());
}

TEST(ServeValveAnswer, DrawsAtMostWhatAPictureHolds) {
  const Recording recording = recording_of("load-and-noise");
  const json picture = answer_of(recording)["picture"];
  EXPECT_LE(picture["t"].size(), kMostPictureSamples);
  EXPECT_EQ(picture["u"].size(), picture["y"].size());
}

TEST(ServeValveAnswer, HasAMoodForEveryVerdict) {
  EXPECT_EQ(mood_name(ident::Verdict::kBacklash), "bad");
  EXPECT_EQ(mood_name(ident::Verdict::kNoStiction), "good");
  EXPECT_EQ(mood_name(ident::Verdict::kUndecided), "open");
  EXPECT_EQ(mood_name(ident::Verdict::kBadData), "open");
}

}  // namespace
}  // namespace workbench
