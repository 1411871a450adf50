// The words and tables on a model.
#include <gtest/gtest.h>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/model/search/ladder.hpp"
#include "workbench/report/model_figures.hpp"
#include "workbench/report/model_parts.hpp"

namespace workbench {
namespace {

bool part_says(const std::string& text, std::string_view what) {
  return text.find(what) != std::string::npos;
}

Candidate candidate(const std::string& effect, CandidateStatus status) {
  Candidate c;
  c.effect = effect;
  c.status = status;
  c.evidence = "Because.";
  c.rmse_validation_before = 2;
  c.rmse_validation_after = 1;
  return c;
}

class ModelParts : public ::testing::Test {
 protected:
  ModelParts()
      : recording_(test::simulated({})),
        model_(start_model(recording_, Column::y).model) {}
  [[nodiscard]] ModelReport report(ExplainResult explanation) const {
    return {recording_, model_, compare(recording_, model_), std::move(explanation)};
  }

  Recording recording_;
  Model model_;
};

TEST_F(ModelParts, NameTheEffectsOfEachCandidateForScripts) {
  ExplainResult result;
  result.candidates = {candidate("valve.stiction", CandidateStatus::kAccepted),
                       candidate("sensor.lag", CandidateStatus::kRejected)};
  result.candidates[0].with = {"process.dead_time"};
  const std::string list = candidate_list(result);
  EXPECT_TRUE(part_says(list, "data-effects=\"valve.stiction\nprocess.dead_time\""));
  EXPECT_LT(list.find("valve.stiction"), list.find("<details>"));
  EXPECT_GT(list.find("sensor.lag"), list.find("<details>"));
}

TEST_F(ModelParts, SayWhatWouldTellAGroupApart) {
  ExplainResult result;
  result.candidates = {candidate("valve.backlash", CandidateStatus::kAccepted)};
  result.candidates[0].indistinguishable_from = {"valve.stiction"};
  result.candidates[0].would_split = "log the stem position";
  const std::string verdict = model_verdict(report(result));
  EXPECT_TRUE(part_says(verdict, "cannot tell it from stiction"));
  EXPECT_TRUE(part_says(verdict, "log the stem position"));
}

TEST_F(ModelParts, TellBothErrorsOfAStepThatALoadHides) {
  EXPECT_FALSE(part_says(step_table(model_), "one sample ahead"));
  Model model = model_;
  model.history.push_back({"process.dead_time", recording_.name, 2, 2.1, 2, 2.1});
  model.history.back().ahead = AheadErrors{1.5, 1.2};
  const std::string table = step_table(model);
  EXPECT_TRUE(part_says(table, "<th>one sample ahead</th>"));
  EXPECT_TRUE(part_says(table, "1.5 to 1.2, "));
  EXPECT_TRUE(part_says(table, "Running free, a load hides"));
}

TEST_F(ModelParts, SayWhyALargerEffectIsNotTheClosest) {
  ExplainResult result;
  result.candidates = {candidate("valve.stiction", CandidateStatus::kUndecided),
                       candidate("sensor.lag", CandidateStatus::kUndecided)};
  for (Candidate& c : result.candidates) c.error_reduction_percent = 10;
  EXPECT_FALSE(part_says(model_verdict(report(result)), "lowers the error more"));
  result.candidates[0].spoken_against = true;
  EXPECT_TRUE(part_says(model_verdict(report(result)),
                        "Stiction lowers the error more, but its own values speak"));
  result.candidates[0].spoken_against = false;
  result.candidates[0].indistinguishable_from = {"valve.backlash"};
  EXPECT_TRUE(part_says(model_verdict(report(result)), "cannot tell it from another"));
}

TEST_F(ModelParts, WriteOneMinusSign) {
  ModelReport bad = report({});
  bad.comparison.quality.fit_percent = -12.34;
  EXPECT_TRUE(part_says(model_tiles(bad), "−12.3 %"));
}

TEST_F(ModelParts, ShowTimesAndUnitsOfFailuresAsTheCharts) {
  EXPECT_TRUE(part_says(residual_panels(report({})), "speed of u, u/s"));
  recording_.start = "2026-03-04T14:30:00";
  recording_.units[static_cast<std::size_t>(Column::u)] = "%";
  const std::string panels = residual_panels(report({}));
  EXPECT_TRUE(part_says(panels, " from 2026-03-04 14:30<"));
  EXPECT_TRUE(part_says(panels, "speed of u, %/s"));
  EXPECT_FALSE(part_says(panels, ">t, s<"));
}

TEST_F(ModelParts, KnowNoNoiseBeforeItWasEstimatedNorAboveWhatAModelReaches) {
  EXPECT_EQ(noise_floor(report({})), 0);
  EXPECT_FALSE(part_says(model_tiles(report({})), "noise"));
  const double error = report({}).comparison.quality.rmse_validation;
  ExplainResult result;
  result.noise_rmse = 0.9 * error;
  EXPECT_EQ(noise_floor(report(result)), 0.9 * error);
  EXPECT_TRUE(part_says(model_tiles(report(result)), "noise about"));
  result.candidates = {candidate("valve.stiction", CandidateStatus::kAccepted)};
  result.candidates[0].rmse_validation_after = 0.5 * error;
  EXPECT_EQ(noise_floor(report(result)), 0);
  EXPECT_FALSE(part_says(ladder_figure(report(result)), "noise"));
}

TEST_F(ModelParts, CompareNoErrorsOfDifferentRecordings) {
  Model model = model_;
  model.history = {{"process", "monday.csv", NAN, 1, NAN, 1},
                   {"sensor.lag", "monday.csv", 1, 0.5, 1, 0.5}};
  const auto on = [&](const std::string& name) {
    Recording recording = recording_;
    recording.name = name;
    const ModelReport report{recording, model, compare(recording, model_), {}};
    return std::pair(ladder_figure(report), model_tiles(report));
  };
  EXPECT_FALSE(part_says(on("monday.csv").first, "tuesday.csv"));
  EXPECT_TRUE(part_says(on("monday.csv").second, "Since the start"));
  EXPECT_TRUE(part_says(on("tuesday.csv").first, "tuesday.csv"));
  EXPECT_FALSE(part_says(on("tuesday.csv").second, "Since the start"));
  EXPECT_TRUE(part_says(step_table(model), "−50\u00a0%"));
  model.history.push_back({"process.dead_time", "tuesday.csv", 4, 3, 4, 3});
  EXPECT_TRUE(part_says(step_table(model), "−25\u00a0%"));
}

TEST_F(ModelParts, ShowParametersWithIntervalAndUnit) {
  const std::string table = parameter_table(report({}));
  EXPECT_TRUE(part_says(table, "<td class=\"text\">y/u</td>"));
  recording_.units[static_cast<std::size_t>(Column::u)] = "%";
  recording_.units[static_cast<std::size_t>(Column::y)] = "m3/h";
  EXPECT_TRUE(part_says(parameter_table(report({})), "<td class=\"text\">(m3/h)/%</td>"));
  EXPECT_TRUE(part_says(parameter_table(report({})), "<td class=\"text\">m3/h</td>"));
  EXPECT_TRUE(part_says(table, "first lag"));
  Model cut_off = model_;
  cut_off.effects = {{"process.overflow", {{"spilling_storage", "1", 1, 1, 1}}}};
  const ModelReport of_cut_off{recording_, cut_off, compare(recording_, model_), {}};
  EXPECT_TRUE(part_says(parameter_table(of_cut_off),
                        "<td>what is cut off</td><td>the last storage</td>"));
  EXPECT_TRUE(part_says(table, " to "));
  EXPECT_TRUE(part_says(table, "<td class=\"text\">s</td>"));
  EXPECT_TRUE(part_says(step_table(model_), "first-order process"));
  Model bare = model_;
  bare.history.clear();
  EXPECT_TRUE(step_table(bare).empty());
}

}  // namespace
}  // namespace workbench
