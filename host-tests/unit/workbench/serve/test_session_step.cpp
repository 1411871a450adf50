// Models on their way into a session.
#include <gtest/gtest.h>

#include "support/workbench/serve_session.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/serve/session_step.hpp"

namespace workbench {
namespace {

using test::late_recording;

Model started(const Recording& recording) {
  return start_model(recording, Column::y, {}, standard_catalogue()).model;
}

const Parameter& of_process(const Model& model, const std::string& name) {
  for (const Parameter& p : model.process) {
    if (p.name == name) return p;
  }
  throw std::out_of_range(name);
}

TEST(ServeSessionStep, RefusesARecordingThatNoModelFits) {
  Recording recording = late_recording();
  recording.x.clear();
  EXPECT_NO_THROW(check(recording, Column::y));
  EXPECT_THROW(check(recording, Column::x), InputError);
}

TEST(ServeSessionStep, JudgesAModelWhereItWasFittedAndElsewhere) {
  const Recording recording = late_recording();
  const Model model = started(recording);
  EXPECT_TRUE(step_of(recording, model).fitted_here);
  Recording other = recording;
  other.u.front() += 0.1;
  EXPECT_FALSE(shared_step(other, model)->fitted_here);
}

TEST(ServeSessionStep, AddsEffectsAndTellsOfEach) {
  const Recording recording = late_recording();
  std::string told;
  const Model model = with_effects(
      recording, started(recording), {"process.dead_time"},
      [&told](std::string_view effect, int number, int of) {
        told += std::string(effect) + std::to_string(number) + std::to_string(of);
      },
      Work::unlimited());
  EXPECT_EQ(told, "process.dead_time11");
  EXPECT_TRUE(model.has("process.dead_time"));
}

TEST(ServeSessionStep, TellsWhatValuesSetByHandCost) {
  const Recording recording = late_recording();
  const Model model = started(recording);
  EXPECT_FALSE(is_by_hand(model));
  Model moved = model;
  for (Parameter& p : moved.process) p.value *= p.name == "gain" ? 2 : 1;
  const Model kept = by_hand(recording, model, moved, kSetByHand);
  EXPECT_TRUE(is_by_hand(kept));
  const HistoryStep& step = kept.history.back();
  EXPECT_DOUBLE_EQ(step.rmse_validation_before,
                   compare(recording, model).quality.rmse_validation);
  EXPECT_GT(step.rmse_validation_after, step.rmse_validation_before);
  EXPECT_EQ(step.recording, "late.csv");
}

// A ladder that ended early has an explanation of the model before its last step.
TEST(ServeSessionStep, AnExplanationOfWhatIsInTheModelIsOfOneBefore) {
  ExplainResult found;
  found.candidates.emplace_back();
  found.candidates.back().effect = "process.dead_time";
  Model model;
  EXPECT_TRUE(speaks_of(found, model));
  model.effects.push_back({"sensor.lag", {}});
  EXPECT_TRUE(speaks_of(found, model));
  model.effects.push_back({"process.dead_time", {}});
  EXPECT_FALSE(speaks_of(found, model));
}

TEST(ServeSessionStep, FitsAgainAllButWhatIsHeld) {
  const Recording recording = late_recording();
  const Model model = started(recording);
  const double gain = of_process(model, "gain").value;
  const double lag = of_process(model, "first_lag").value;
  Model moved = model;
  for (Parameter& p : moved.process) {
    if (p.name == "gain") p.value = 1.3 * gain;
    if (p.name == "first_lag") p.value = 2 * lag;
  }
  const Model freed = refitted(recording, moved, {}, Work::unlimited());
  EXPECT_NEAR(of_process(freed, "gain").value, gain, 0.02 * std::abs(gain));
  const Model solved =
      refitted(recording, moved, {{"process", "gain"}}, Work::unlimited());
  EXPECT_DOUBLE_EQ(of_process(solved, "gain").value, 1.3 * gain);
  EXPECT_EQ(of_process(solved, "gain").low, of_process(solved, "gain").high);
  EXPECT_NE(of_process(solved, "first_lag").value, 2 * lag);
  const Model searched =
      refitted(recording, moved, {{"process", "first_lag"}}, Work::unlimited());
  EXPECT_DOUBLE_EQ(of_process(searched, "first_lag").value, 2 * lag);
  EXPECT_NO_THROW(static_cast<void>(
      refitted(recording, moved, {{"valve.stiction", "none"}}, Work::unlimited())));
}

}  // namespace
}  // namespace workbench
