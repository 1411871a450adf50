// The effects of what is recorded: spikes, a sensor that sticks, compression. Each is
// named with its numbers where it is, and none where it is not.
#include <gtest/gtest.h>

#include <random>

#include "support/workbench/historian.hpp"
#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/search/explain.hpp"
#include "workbench/model/search/ladder.hpp"

namespace workbench {
namespace {

test::SetpointLoop usual() {
  test::SetpointLoop loop;
  loop.noise_std = 0.3;
  return loop;
}

Candidate first_of(const Recording& recording) {
  const FittedModel model = start_model(recording, Column::y);
  const ExplainResult result = explain(recording, model.model);
  return result.best() != nullptr ? *result.best() : Candidate{};
}

double value(const Candidate& candidate, std::string_view name) {
  for (const Parameter& parameter : candidate.parameters) {
    if (parameter.name == name) return parameter.value;
  }
  return -1;
}

TEST(RecordedEffects, SpikesAreCountedAndLeftOut) {
  Recording recording = test::simulated(usual());
  for (const std::size_t k : {120U, 333U, 700U, 701U, 950U}) recording.y[k] += 15;
  const Candidate best = first_of(recording);
  EXPECT_EQ(best.effect, "sensor.spikes");
  EXPECT_EQ(value(best, "readings"), 5);
  EXPECT_NE(best.evidence.find("120, 333, 700, 950"), std::string::npos) << best.evidence;
  const FittedModel plain = start_model(test::simulated(usual()), Column::y);
  EXPECT_NEAR(best.rmse_after, plain.quality.rmse, 0.05 * plain.quality.rmse);
}

TEST(RecordedEffects, AHeavyTailIsNoSpikes) {
  Recording recording = test::simulated(usual());
  std::mt19937_64 random(9);
  std::student_t_distribution<double> tail(3);
  for (double& y : recording.y) y += 0.4 * tail(random);
  EXPECT_NE(first_of(recording).effect, "sensor.spikes");
}

TEST(RecordedEffects, AStickingSensorIsNamedWithItsBand) {
  test::SetpointLoop loop = usual();
  loop.sensor = [reading = 0.0](double y) mutable {
    if (std::abs(y - reading) > 2) reading = y;
    return reading;
  };
  const Candidate best = first_of(test::simulated(loop));
  EXPECT_EQ(best.effect, "sensor.sticking");
  EXPECT_NEAR(value(best, "band"), 2, 0.2);
  EXPECT_TRUE(best.indistinguishable_from.empty());
}

TEST(RecordedEffects, CompressionIsNamedWithItsToleranceAndShare) {
  Recording recording = test::simulated(usual());
  recording.y = test::swinging_door(recording.y, 1.5);
  const Candidate best = first_of(recording);
  EXPECT_EQ(best.effect, "record.compression");
  EXPECT_GT(value(best, "tolerance"), 0.75);
  EXPECT_LT(value(best, "tolerance"), 3);
  EXPECT_LT(value(best, "stored_share"), 0.5);
}

TEST(RecordedEffects, WhereUSaysNothingBothWhoMayHoldAreNamed) {
  Recording recording = test::simulated(usual());
  std::vector<double> y(recording.size());
  double z = 0;
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal(0, 0.3);
  for (std::size_t k = 0; k < y.size(); ++k) {
    recording.u[k] = k / 150 % 2 == 0 ? 45 : 55;
    y[k] = 50 + z + normal(random);
    z += (2 * (recording.u[k] - 50) - z) / 20;
  }
  recording.y = test::boxcar(y, 1.2, 400);
  const Candidate best = first_of(recording);
  EXPECT_EQ(best.effect, "sensor.sticking");
  EXPECT_EQ(best.indistinguishable_from, std::vector<std::string>{"record.compression"});
  EXPECT_TRUE(best.would_split.has_value());
}

TEST(RecordedEffects, FewLevelsAreNamedWhateverElseIsThere) {
  test::SetpointLoop loop = usual();
  loop.load = [](std::size_t k) { return k > 600 ? 6.0 : 0.0; };
  Recording recording = test::simulated(loop);
  recording.y = test::quantise(recording.y, 4);
  EXPECT_EQ(first_of(recording).effect, "sensor.quantisation");
}

TEST(RecordedEffects, NothingOfTheKindWhereNothingIs) {
  const Recording recording = test::simulated(usual());
  const ExplainResult result =
      explain(recording, start_model(recording, Column::y).model);
  for (const Candidate& candidate : result.candidates) {
    EXPECT_NE(candidate.status, CandidateStatus::kAccepted) << candidate.effect;
  }
}

}  // namespace
}  // namespace workbench
