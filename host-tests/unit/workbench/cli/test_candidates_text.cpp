#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "workbench/cli/candidates_text.hpp"

namespace workbench::cli {
namespace {

Candidate candidate(std::string effect, CandidateStatus status, std::string evidence) {
  Candidate out;
  out.effect = std::move(effect);
  out.status = status;
  out.evidence = std::move(evidence);
  return out;
}

TEST(CandidatesText, ThoseTurnedDownByOneSentenceShareAParagraph) {
  const std::vector<Candidate> all = {
      candidate("sensor.lag", CandidateStatus::kRejected, "Nothing looks like it."),
      candidate("valve.stiction", CandidateStatus::kRejected, "It takes away 3 %."),
      candidate("sensor.spikes", CandidateStatus::kRejected, "Nothing looks like it."),
      candidate("valve.saturation", CandidateStatus::kNotExcited,
                "Nothing looks like it.")};
  EXPECT_EQ(candidates_text(all),
            "rejected     sensor.lag, sensor.spikes\n"
            "             Nothing looks like it.\n"
            "rejected     valve.stiction\n"
            "             It takes away 3 %.\n"
            "not_excited  valve.saturation\n"
            "             Nothing looks like it.\n");
}

TEST(CandidatesText, WhatHelpsStandsAlone) {
  const std::vector<Candidate> all = {
      candidate("sensor.lag", CandidateStatus::kUndecided, "It helps."),
      candidate("process.second_lag", CandidateStatus::kUndecided, "It helps.")};
  EXPECT_EQ(candidates_text(all),
            "undecided    sensor.lag\n             It helps.\n"
            "undecided    process.second_lag\n             It helps.\n");
}

TEST(CandidatesText, SaysWhatOneOfAPairMayAsWellBe) {
  std::vector<Candidate> all = {
      candidate("process.dead_time", CandidateStatus::kUndecided, "It helps.")};
  all[0].indistinguishable_from = {"sensor.lag"};
  EXPECT_NE(candidates_text(all).find("cannot tell it from sensor.lag."),
            std::string::npos);
  all[0].with = {"process.second_lag"};
  const std::string told = candidates_text(all);
  EXPECT_NE(told.find("One of them may as well be sensor.lag"), std::string::npos)
      << told;
}

TEST(CandidatesText, SaysWhatIsMissingWithWhatItMayBeInstead) {
  Candidate best = candidate("process.dead_time", CandidateStatus::kAccepted, "Late.");
  EXPECT_EQ(missing_in_words(best), "What is missing: dead time.");
  best.indistinguishable_from = {"process.second_lag"};
  EXPECT_EQ(missing_in_words(best),
            "What is missing: dead time, or in its place a second process lag: this "
            "recording cannot tell.");
  best.indistinguishable_from.assign(8, "sensor.lag");
  EXPECT_NE(missing_in_words(best).find("or one of 8 other effects"), std::string::npos);
}

TEST(CandidatesText, OneLagUnderTwoNamesIsOneBlock) {
  std::vector<Candidate> all = {
      candidate("process.second_lag", CandidateStatus::kAccepted, "Gently."),
      candidate("sensor.lag", CandidateStatus::kAccepted, "It trails.")};
  all[0].indistinguishable_from = {"sensor.lag"};
  all[1].indistinguishable_from = {"process.second_lag"};
  for (Candidate& one : all) {
    one.rmse_validation_before = 2;
    one.rmse_validation_after = 1;
    one.error_reduction_percent = 75;
    one.parameters = {{.name = "lag", .unit = "s", .value = 101.5}};
  }
  const std::string told = candidates_text(all);
  EXPECT_TRUE(told.starts_with("accepted     process.second_lag or sensor.lag\n"))
      << told;
  EXPECT_EQ(told.find("It trails"), std::string::npos) << told;
  all[1].parameters[0].value = 95;
  EXPECT_NE(candidates_text(all).find("It trails"), std::string::npos);
}

TEST(CandidatesText, AMillionthOfTheErrorIsNoneOfIt) {
  Candidate levels =
      candidate("sensor.quantisation", CandidateStatus::kAccepted, "Levels.");
  levels.rmse_validation_before = 1;
  levels.rmse_validation_after = 0.99999;
  levels.error_reduction_percent = 5.68e-6;
  EXPECT_NE(candidates_text({&levels, 1}).find("the readings show it, not"),
            std::string::npos);
}

TEST(CandidatesText, NamesWhatComesClosest) {
  ExplainResult result;
  result.candidates = {
      candidate("disturbance.ramp", CandidateStatus::kUndecided, "Too short."),
      candidate("valve.backlash", CandidateStatus::kUndecided, "It helps.")};
  SearchSoFar so_far{"stickband ladder 'a b.csv'", {"valve.stiction"}, {}, true};
  const auto told_of = [&result, &so_far] {
    return what_comes_closest("Left.", result, so_far);
  };
  EXPECT_NE(told_of().find("--load"), std::string::npos);
  so_far.has_further_columns = false;
  EXPECT_EQ(told_of().find("--load"), std::string::npos);
  result.candidates[1].error_reduction_percent = 12;
  result.candidates[1].with = {"process.second_lag"};
  const std::string told = told_of();
  EXPECT_TRUE(told.starts_with("Left. Closest comes ")) << told;
  EXPECT_TRUE(
      told.ends_with("\n  stickband ladder 'a b.csv' --with "
                     "valve.stiction,valve.backlash,process.second_lag"))
      << told;
  EXPECT_NE(told.find(" and "), std::string::npos) << told;
  EXPECT_EQ(told.find("--load"), std::string::npos) << told;
  so_far.begun_with = {"process.second_lag", "valve.stiction", "valve.backlash"};
  EXPECT_TRUE(told_of().ends_with("; this search began with it.")) << told_of();
}

TEST(CandidatesText, NamesWhatItsOwnValuesDoNotSpeakAgainst) {
  ExplainResult result;
  for (const char* effect : {"process.oscillatory", "process.second_lag"}) {
    result.candidates.push_back(
        candidate(effect, CandidateStatus::kUndecided, "It helps."));
    result.candidates.back().error_reduction_percent = 12;
  }
  EXPECT_EQ(result.closest(), &result.candidates[0]);
  result.candidates[0].spoken_against = true;
  EXPECT_EQ(result.closest(), &result.candidates[1]);
  result.candidates[1].spoken_against = true;
  EXPECT_EQ(result.closest(), &result.candidates[0]) << "better than none";
}

TEST(SearchOn, KeepsWhatTheModelHasAndEndsWhereItBegan) {
  SearchSoFar so_far{"stickband ladder a.csv", {"valve.backlash"}, {}, false};
  EXPECT_EQ(search_on(so_far), "stickband ladder a.csv --with valve.backlash");
  EXPECT_EQ(search_on(so_far, {"sensor.lag", "valve.backlash"}),
            "stickband ladder a.csv --with valve.backlash,sensor.lag");
  so_far.keep = "my m2.json";
  EXPECT_EQ(search_on(so_far),
            "stickband ladder a.csv --with valve.backlash -o \"my m2.json\"");
  so_far.begun_with = {"sensor.lag", "valve.backlash"};
  EXPECT_EQ(search_on(so_far), "");
  EXPECT_EQ(search_on(so_far, {"sensor.lag"}), "");
  EXPECT_EQ(search_on({"stickband ladder a.csv", {}, {}, false}), "");
}

}  // namespace
}  // namespace workbench::cli
