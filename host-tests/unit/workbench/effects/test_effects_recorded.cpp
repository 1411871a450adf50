// The effects of what is recorded: spikes, a sensor that sticks, compression. Each is
// named with its numbers where it is, and none where it is not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "support/workbench/historian.hpp"
#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/judge/compare.hpp"
#include "workbench/model/search/explain.hpp"
#include "workbench/model/search/ladder.hpp"

namespace workbench {
namespace {

test::SetpointLoop usual() {
  test::SetpointLoop loop;
  loop.noise_std = 0.3;
  return loop;
}

Candidate first_candidate(const Recording& recording) {
  const FittedModel model = start_model(recording, Column::y);
  const ExplainResult result = explain(recording, model.model);
  return result.best() != nullptr ? *result.best() : Candidate{};
}

double recorded_value(const Candidate& candidate, std::string_view name) {
  for (const Parameter& parameter : candidate.parameters) {
    if (parameter.name == name) return parameter.value;
  }
  return -1;
}

TEST(RecordedEffects, SpikesAreCountedAndLeftOut) {
  Recording recording = test::simulated(usual());
  for (const std::size_t k : {120U, 333U, 700U, 701U, 950U}) recording.y[k] += 15;
  const Candidate best = first_candidate(recording);
  EXPECT_EQ(best.effect, "sensor.spikes");
  EXPECT_EQ(recorded_value(best, "readings"), 5);
  EXPECT_NE(best.evidence.find("120 s, 333 s, 700 s, 950 s"), std::string::npos)
      << best.evidence;
  const FittedModel plain = start_model(test::simulated(usual()), Column::y);
  EXPECT_NEAR(best.rmse_after, plain.quality.rmse, 0.05 * plain.quality.rmse);
}

// The first reading after a gap is not "back at once" from the last one before it; a time
// behind the gap is that of the file.
TEST(RecordedEffects, AcrossAGapThereIsNoSpike) {
  Recording recording = test::simulated(usual());
  recording.y[600] += 15;
  const Effect& spikes = effects::sensor_spikes();
  Situation s = situation_of(recording.u, recording.y, 1);
  ASSERT_EQ(spikes.starts(s).size(), 1U);
  const std::vector<Piece> pieces = {{.first = 0, .last = 600},
                                     {.first = 600, .last = recording.size()}};
  s.pieces = pieces;
  EXPECT_TRUE(spikes.starts(s).empty());
  recording.y[600] -= 15;
  recording.y[700] += 15;
  std::vector<Piece> later = pieces;
  later[1].start_s = 5000;
  s.pieces = later;
  const std::vector<Values> found = spikes.starts(s);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(spikes.evidence(s, found[0], {}).find("(t = 5100 s)"), std::string::npos);
}

TEST(RecordedEffects, SpikesOnBothSidesOfAGapAreLeftOut) {
  Recording recording = test::simulated(usual());
  for (const std::size_t k : {120U, 333U, 700U, 950U}) recording.y[k] += 15;
  recording.pieces = {{.first = 0, .last = 600},
                      {.first = 600, .last = recording.size()}};
  const Model model =
      start_model(recording, Column::y, {std::string("sensor.spikes")}).model;
  const std::vector<double> residual = compare(recording, model).residual;
  for (const std::size_t k : {120U, 333U, 700U, 950U}) EXPECT_EQ(residual[k], 0) << k;
  EXPECT_NE(residual[350], 0);
}

TEST(RecordedEffects, SpikesAreSeenThatTheRangeOfTheReadingHides) {
  test::SetpointLoop loop = usual();
  loop.noise_std = 0.05;
  Recording recording = test::simulated(loop);
  const Effect& spikes = effects::sensor_spikes();
  const auto found = [&] {
    return spikes.starts(situation_of(recording.u, recording.y, 1));
  };
  EXPECT_TRUE(found().empty());
  for (const std::size_t k : {120U, 333U, 480U, 701U, 950U}) {
    recording.y[k] += k % 2 == 0 ? 1.4 : -1.6;
  }
  ASSERT_EQ(found().size(), 1U);
  EXPECT_EQ(found()[0][0], 5);
}

TEST(RecordedEffects, APeakBetweenStraightLinesIsNoSpike) {
  std::vector<double> u(600, 50.0);
  std::vector<double> y(600);
  for (std::size_t k = 0; k < y.size(); ++k) {
    const std::size_t at = k % 20;
    y[k] = static_cast<double>(std::min(at, 20 - at)) * (k / 20 % 2 == 0 ? 0.1 : -0.1);
    if (at == 10) y[k] *= 1.3;
  }
  EXPECT_TRUE(effects::sensor_spikes().starts(situation_of(u, y, 1)).empty());
}

TEST(RecordedEffects, AHeavyTailIsNoSpikes) {
  Recording recording = test::simulated(usual());
  std::mt19937_64 random(9);
  std::student_t_distribution<double> tail(3);
  for (double& y : recording.y) y += 0.4 * tail(random);
  EXPECT_NE(first_candidate(recording).effect, "sensor.spikes");
}

// At the end of each stroke of a relay a lag turns sharply.
TEST(RecordedEffects, ASharpTurnIsNoSpikeAndASpikeBesideItIs) {
  std::vector<double> u;
  std::vector<double> y;
  double level = 0;
  for (std::size_t k = 0; k < 400; ++k) {
    u.push_back(k / 20 % 2 == 0 ? 60 : 40);
    level += 0.05 * (u[k] - 50 - level);
    y.push_back(level);
  }
  const Effect& spikes = effects::sensor_spikes();
  EXPECT_TRUE(spikes.starts(situation_of(u, y, 1)).empty());
  for (const std::size_t k : {55U, 130U, 267U}) y[k] += 5;
  const std::vector<Values> found = spikes.starts(situation_of(u, y, 1));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0][0], 3);
}

TEST(RecordedEffects, AStickingSensorIsNamedWithItsBand) {
  test::SetpointLoop loop = usual();
  loop.sensor = [reading = 0.0](double y) mutable {
    if (std::abs(y - reading) > 2) reading = y;
    return reading;
  };
  const Candidate best = first_candidate(test::simulated(loop));
  EXPECT_EQ(best.effect, "sensor.sticking");
  EXPECT_NEAR(recorded_value(best, "band"), 2, 0.2);
  EXPECT_TRUE(best.indistinguishable_from.empty());
}

// A transmitter that passes on one value for a while; what is left out is no error.
TEST(RecordedEffects, AFrozenReadingIsNamedAndLeftOut) {
  test::SetpointLoop loop = usual();
  loop.sensor = [k = 0, reading = 0.0](double y) mutable {
    if (++k < 300 || k >= 420) reading = y;
    return reading;
  };
  const Recording recording = test::simulated(loop);
  const Candidate best = first_candidate(recording);
  EXPECT_EQ(best.effect, "sensor.sticking");
  EXPECT_EQ(recorded_value(best, "band"), 0);
  EXPECT_NEAR(recorded_value(best, "held_share"), 0.1, 0.01);
  const LadderResult result = run_ladder(recording);
  EXPECT_EQ(result.model.effect_codes(), std::vector<std::string>{"sensor.sticking"});
  EXPECT_LT(result.quality.rmse, 0.35);
}

// The model of what was not cut off is that of the whole reading.
TEST(RecordedEffects, AReadingAtTheEndsOfItsRangeIsNamedAndLeftOut) {
  Recording recording = test::simulated(usual());
  const double whole = start_model(recording, Column::y).quality.rmse;
  const auto [low, high] = std::ranges::minmax_element(recording.y);
  const double upper = *high - 0.15 * (*high - *low);
  const double lower = *low + 0.1 * (*high - *low);
  for (double& y : recording.y) y = std::min(y, upper);
  const Candidate one = first_candidate(recording);
  EXPECT_EQ(one.effect, "sensor.saturation");
  EXPECT_EQ(recorded_value(one, "upper_end"), upper);
  EXPECT_EQ(recorded_value(one, "lower_share"), 0);
  EXPECT_GT(recorded_value(one, "upper_share"), 0.02);
  EXPECT_NE(one.evidence.find("its highest value, to the last digit"), std::string::npos);
  for (double& y : recording.y) y = std::max(y, lower);
  const Candidate both = first_candidate(recording);
  EXPECT_EQ(both.effect, "sensor.saturation");
  EXPECT_EQ(recorded_value(both, "lower_end"), lower);
  EXPECT_GT(recorded_value(both, "lower_share"), 0.02);
  EXPECT_NE(both.evidence.find("its lowest, to the last digit"), std::string::npos);
  EXPECT_LT(both.rmse_after, 1.05 * whole);
  EXPECT_GT(both.rmse_before, 1.3 * whole);
}

TEST(RecordedEffects, CompressionIsNamedWithItsToleranceAndShare) {
  Recording recording = test::simulated(usual());
  recording.y = test::swinging_door(recording.y, 1.5);
  const Candidate best = first_candidate(recording);
  EXPECT_EQ(best.effect, "record.compression");
  EXPECT_GT(recorded_value(best, "tolerance"), 0.75);
  EXPECT_LT(recorded_value(best, "tolerance"), 3);
  EXPECT_LT(recorded_value(best, "stored_share"), 0.5);
}

// What is read coarsely while it moves slowly goes by the same few steps for a while.
TEST(RecordedEffects, CoarseReadingsOfASlowOutputAreNotCompressed) {
  Recording recording;
  recording.name = "incubator";
  recording.period_s = 3;
  for (std::size_t k = 0; k < 124; ++k) {
    const double t = static_cast<double>(k);
    recording.u.push_back(k % 40 < 10 ? 1 : 0);
    const double y = 23 + 12 * (1 - std::exp(-t / 60)) + 0.3 * std::sin(t / 9);
    recording.y.push_back(std::round(y * 16) / 16);
  }
  const Situation s = situation_of(recording.u, recording.y, recording.period_s);
  EXPECT_TRUE(effects::record_compression().starts(s).empty());
}

// A value is stored where it leaves the band, with the one before it.
std::vector<double> stored_by_exception(const std::vector<double>& y, double band) {
  std::vector<std::size_t> kept = {0};
  double last = y[0];
  for (std::size_t k = 1; k < y.size(); ++k) {
    if (!(std::abs(y[k] - last) > band)) continue;
    if (kept.back() + 1 < k) kept.push_back(k - 1);
    kept.push_back(k);
    last = y[k];
  }
  if (kept.back() + 1 < y.size()) kept.push_back(y.size() - 1);
  std::vector<double> out(y.size());
  for (std::size_t i = 1; i < kept.size(); ++i) {
    const double span = static_cast<double>(kept[i] - kept[i - 1]);
    for (std::size_t k = kept[i - 1]; k <= kept[i]; ++k) {
      const double share = static_cast<double>(k - kept[i - 1]) / span;
      out[k] = std::lerp(y[kept[i - 1]], y[kept[i]], share);
    }
  }
  return out;
}

TEST(RecordedEffects, AnExceptionDeadbandIsNamedWithItsBand) {
  Recording recording = test::simulated(usual());
  recording.y = stored_by_exception(recording.y, 1.5);
  const Candidate best = first_candidate(recording);
  EXPECT_EQ(best.effect, "record.compression");
  EXPECT_NEAR(recorded_value(best, "tolerance"), 1.5, 0.3);
  EXPECT_NE(best.evidence.find("exception deadband"), std::string::npos) << best.evidence;
}

// u moved by hand, and a y that is only recorded where it has changed enough.
Recording held_by_hand() {
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
  return recording;
}

TEST(RecordedEffects, WhereUSaysNothingBothWhoMayHoldAreNamed) {
  const Recording recording = held_by_hand();
  const Candidate best = first_candidate(recording);
  EXPECT_EQ(best.effect, "sensor.sticking");
  EXPECT_EQ(best.indistinguishable_from, std::vector<std::string>{"record.compression"});
  EXPECT_TRUE(best.would_split.has_value());
}

// Rows that come late are filled by holding: that is no sensor.
TEST(RecordedEffects, RepeatsThatTheReaderMadeAreNoSensorThatSticks) {
  Recording recording = held_by_hand();
  recording.resampling.missing = recording.size();
  EXPECT_EQ(first_candidate(recording).effect, "record.compression");
}

// A loop that reads when it can: each value is fresh, and small moves are among them.
TEST(RecordedEffects, RowsThatWereNotReadAreNotCompressed) {
  Recording recording = test::simulated(usual());
  std::mt19937_64 random(5);
  std::size_t filled = 0;
  for (std::size_t k = 1; k < recording.size(); ++k) {
    if (random() % 5 < 2) continue;
    recording.y[k] = recording.y[k - 1];
    ++filled;
  }
  EXPECT_EQ(first_candidate(recording).effect, "record.compression");
  recording.resampling.missing = filled;
  EXPECT_NE(first_candidate(recording).effect, "record.compression");
}

TEST(RecordedEffects, OneHoldIsNotNamedTwice) {
  const LadderResult result = run_ladder(held_by_hand());
  const auto is_hold = [](const LadderStep& step) {
    return step.effect == "sensor.sticking" || step.effect == "record.compression";
  };
  EXPECT_EQ(std::count_if(result.steps.begin(), result.steps.end(), is_hold), 1);
  for (const Candidate& candidate : result.last.candidates) {
    if (candidate.effect != "record.compression") continue;
    EXPECT_EQ(candidate.status, CandidateStatus::kRejected);
    EXPECT_NE(candidate.evidence.find("sensor.sticking"), std::string::npos);
  }
}

TEST(RecordedEffects, FewLevelsAreNamedWhateverElseIsThere) {
  test::SetpointLoop loop = usual();
  loop.load = [](std::size_t k) { return k > 600 ? 6.0 : 0.0; };
  Recording recording = test::simulated(loop);
  recording.y = test::quantise(recording.y, 4);
  const FittedModel model = start_model(recording, Column::y);
  const ExplainResult result = explain(recording, model.model);
  const auto is_named = [](const Candidate& candidate) {
    return candidate.effect == "sensor.quantisation" &&
           candidate.status == CandidateStatus::kAccepted;
  };
  EXPECT_TRUE(std::ranges::any_of(result.candidates, is_named));
}

// A heating curve rises through its levels and turns nowhere.
TEST(RecordedEffects, LevelsPassedOneAfterTheOtherCount) {
  std::vector<double> y(400);
  for (std::size_t k = 0; k < y.size(); ++k)
    y[k] = std::floor(static_cast<double>(k) / 8);
  const std::vector<double> u(y.size(), 1.0);
  const std::vector<double> p = {1, 0, 0.1};
  const Excitation seen =
      effects::sensor_quantisation().excitation(situation_of(u, y, 1), p);
  EXPECT_EQ(seen.events, 49);
}

TEST(RecordedEffects, NothingOfTheKindWhereNothingIs) {
  const Recording recording = test::simulated(usual());
  const ExplainResult result =
      explain(recording, start_model(recording, Column::y).model);
  for (const Candidate& candidate : result.candidates) {
    EXPECT_NE(candidate.status, CandidateStatus::kAccepted) << candidate.effect;
  }
}

// The mean level of value + noise, rounded: a step of each edge's own probability.
TEST(RecordedEffects, ARoundingIsTheMeanOverTheNoiseBeforeIt) {
  constexpr double kStep = 0.5;
  constexpr double kOrigin = 10;
  for (const double noise : {0.02, 0.05, 0.1, 0.15, 0.6, 1.5}) {
    std::vector<double> values;
    std::vector<double> expected;
    for (double y = 8.03; y < 12; y += 0.017) {
      const double place = (y - kOrigin) / kStep;
      double level = -40;
      for (double edge = -39.5; edge < 40; ++edge) {
        level += std::erfc((edge - place) / (noise / kStep * std::sqrt(2.0))) / 2;
      }
      values.push_back(y);
      expected.push_back(kOrigin + kStep * level);
    }
    const double p[] = {kStep, kOrigin, noise};
    effects::sensor_quantisation().record(p, {}, values);
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_NEAR(values[i], expected[i], 2e-8) << noise << " at " << i;
    }
  }
}

}  // namespace
}  // namespace workbench
