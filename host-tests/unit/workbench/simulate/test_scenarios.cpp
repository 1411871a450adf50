#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "workbench/simulate/cycles.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace workbench {
namespace {

SimulatedLoop made(std::string_view scenario, std::uint64_t seed) {
  std::optional<SimulatedLoop> loop = simulate(scenario, seed);
  EXPECT_TRUE(loop.has_value()) << scenario;
  return std::move(*loop);
}

std::string expected_kind(std::string_view scenario) {
  if (scenario.starts_with("paper-example") || scenario.starts_with("stiction")) {
    return "stiction";
  }
  return scenario == "backlash" ? "backlash" : "no_stiction";
}

TEST(Simulate, PaperExampleHasThePaperPeriodAndCeiling) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const SimulatedLoop loop = made("paper-example-1", seed);
    EXPECT_EQ(loop.t.size(), 2800u);
    EXPECT_EQ(loop.period_s, 0.5);
    const Cycles cycles = measure_cycles(loop.y_clean);
    EXPECT_NEAR(cycles.period, 280, 10) << "seed " << seed;
    EXPECT_NEAR(loop.truth.oscillation_period_s, 140, 5) << "seed " << seed;
    EXPECT_GE(loop.truth.noise_ceiling_percent, 95.4) << "seed " << seed;
    EXPECT_LE(loop.truth.noise_ceiling_percent, 97.0) << "seed " << seed;
    EXPECT_EQ(loop.truth.stick_band_ascending, 5);
    EXPECT_EQ(loop.truth.stick_band_descending, 5);
    EXPECT_EQ(loop.truth.slip_jump_ascending, 5);
    EXPECT_EQ(loop.truth.slip_jump_descending, 5);
  }
}

TEST(Simulate, PaperExampleFollowsItsEquations) {
  const SimulatedLoop loop = made("paper-example-1", 3);
  // Controller and setpoint.
  for (std::size_t t = 1; t < loop.t.size(); ++t) {
    const double error = loop.sp[t] - loop.y[t];
    const double last = loop.sp[t - 1] - loop.y[t - 1];
    EXPECT_NEAR(loop.u[t] - loop.u[t - 1], 1.303 * (error - last + 0.05 * error), 1e-9);
  }
  // Process: y(t) = a y(t-1) + 1.25 (1 - a) x(t-5), a = e^{-0.5/80}.
  const double a = std::exp(-0.5 / 80);
  for (std::size_t t = 5; t < loop.t.size(); ++t) {
    EXPECT_NEAR(loop.y_clean[t], a * loop.y_clean[t - 1] + 1.25 * (1 - a) * loop.x[t - 5],
                1e-9);
  }
  // Valve.
  for (std::size_t t = 1; t < loop.t.size(); ++t) {
    const bool moves = std::abs(loop.u[t] - loop.x[t - 1]) > 5;
    EXPECT_EQ(loop.x[t], moves ? loop.u[t] : loop.x[t - 1]);
  }
  // Noise: v(t) = -0.5 v(t-1) + e(t), var e = 0.001.
  std::vector<double> innovation;
  for (std::size_t t = 1; t < loop.t.size(); ++t) {
    innovation.push_back(loop.y[t] - loop.y_clean[t] +
                         0.5 * (loop.y[t - 1] - loop.y_clean[t - 1]));
  }
  EXPECT_NEAR(std_of(innovation), std::sqrt(0.001), 0.002);
  EXPECT_NEAR(loop.truth.noise_std, 0.0365, 0.0001);
}

TEST(Simulate, PaperExampleMidwayIsTheOtherLimitCycle) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const SimulatedLoop loop = made("paper-example-1-midway", seed);
    EXPECT_NEAR(loop.truth.oscillation_period_s, 152, 5);
    EXPECT_LT(swing_of(loop.x), 6);
    EXPECT_GT(swing_of(made("paper-example-1", seed).x), 9);
  }
}

TEST(Simulate, OneSidedVariantsStickInOneStrokeOnly) {
  const SimulatedLoop up = made("paper-example-1-ascending", 1);
  EXPECT_EQ(up.truth.stick_band_ascending, 5);
  EXPECT_EQ(up.truth.stick_band_descending, 0);
  for (std::size_t t = 0; t < up.t.size(); ++t) EXPECT_LE(up.x[t], up.u[t]);
  const SimulatedLoop down = made("paper-example-1-descending", 1);
  EXPECT_EQ(down.truth.stick_band_ascending, 0);
  EXPECT_EQ(down.truth.stick_band_descending, 5);
  for (std::size_t t = 0; t < down.t.size(); ++t) EXPECT_GE(down.x[t], down.u[t]);
  const SimulatedLoop mixed = made("paper-example-1-mixed", 1);
  EXPECT_EQ(mixed.truth.stick_band_ascending, 6);
  EXPECT_EQ(mixed.truth.stick_band_descending, 3);
  EXPECT_EQ(mixed.truth.slip_jump_ascending, 5);
  EXPECT_EQ(mixed.truth.slip_jump_descending, 2);
}

TEST(Simulate, UnknownScenarioIsNothing) {
  EXPECT_FALSE(simulate("no-such-scenario", 1).has_value());
  EXPECT_FALSE(simulate("", 1).has_value());
  EXPECT_FALSE(simulate("stictio", 1).has_value());
}

TEST(Simulate, NamesAreUniqueAndDescribed) {
  std::set<std::string_view> names;
  for (const ScenarioInfo& info : scenarios()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_FALSE(info.description.empty());
    EXPECT_EQ(info.description.find('\n'), std::string_view::npos);
  }
  EXPECT_TRUE(names.contains("paper-example-1"));
  EXPECT_GE(names.size(), 19u);
}

TEST(Simulate, SameSeedSameRecordingOtherSeedAnother) {
  for (const ScenarioInfo& info : scenarios()) {
    const SimulatedLoop first = made(info.name, 5);
    const SimulatedLoop again = made(info.name, 5);
    const SimulatedLoop other = made(info.name, 6);
    EXPECT_EQ(first.u, again.u) << info.name;
    EXPECT_EQ(first.y, again.y) << info.name;
    EXPECT_EQ(first.x, again.x) << info.name;
    EXPECT_EQ(truth_json(first.truth), truth_json(again.truth)) << info.name;
    EXPECT_NE(first.y, other.y) << info.name;
  }
}

TEST(Simulate, EveryScenarioKeepsItsWord) {
  const std::set<std::string> causes{"stiction",     "backlash", "external_sinusoid",
                                     "tight_tuning", "setpoint", "random_load",
                                     "healthy",      "quantised"};
  for (const ScenarioInfo& info : scenarios()) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      SCOPED_TRACE(std::string(info.name) + " " + std::to_string(seed));
      const SimulatedLoop loop = made(info.name, seed);
      const std::size_t samples = loop.t.size();
      EXPECT_GE(samples, info.name.ends_with("few-steps") ? 400u : 600u);
      EXPECT_LE(samples, 4000u);
      EXPECT_GT(loop.period_s, 0);
      for (const auto* signal :
           {&loop.t, &loop.u, &loop.y, &loop.sp, &loop.x, &loop.y_clean}) {
        ASSERT_EQ(signal->size(), samples);
        ASSERT_TRUE(
            std::ranges::all_of(*signal, [](double v) { return std::isfinite(v); }));
      }
      EXPECT_GT(swing_of(loop.u), 0);
      EXPECT_GT(swing_of(loop.y), 0);

      const LoopTruth& truth = loop.truth;
      EXPECT_EQ(truth.scenario, info.name);
      EXPECT_EQ(truth.seed, seed);
      EXPECT_EQ(truth.kind, expected_kind(info.name));
      EXPECT_TRUE(causes.contains(truth.cause)) << truth.cause;
      EXPECT_GT(truth.noise_std, 0);
      EXPECT_EQ(truth.process.gain > 0, truth.controller.gain > 0);
      const double swing = swing_of(loop.u);
      const double band =
          std::max(truth.stick_band_ascending, truth.stick_band_descending);
      if (truth.kind == "no_stiction") {
        EXPECT_LE(band, 0.02 * swing);
        EXPECT_EQ(truth.slip_jump_ascending, 0);
        EXPECT_EQ(truth.slip_jump_descending, 0);
      } else {
        const bool family = !info.name.starts_with("paper-example");
        EXPECT_GE(swing, (family ? 1.1 : 1.05) * band);
        EXPECT_GT(swing_of(loop.x), 0);
      }
      if (truth.kind == "backlash") {
        EXPECT_EQ(truth.slip_jump_ascending, 0);
        EXPECT_EQ(truth.stick_band_ascending, truth.stick_band_descending);
      }
      if (truth.kind == "stiction") {
        EXPECT_GT(std::max(truth.slip_jump_ascending, truth.slip_jump_descending),
                  0.2 * band);
        EXPECT_GE(swing_of(loop.y_clean) / 2, 3 * truth.noise_std);
        if (info.name != "stiction-setpoint" && !info.name.ends_with("few-steps")) {
          const double cycles =
              static_cast<double>(samples) * loop.period_s / truth.oscillation_period_s;
          EXPECT_GE(cycles, 4.99);
          EXPECT_LE(cycles, 40.01);
        }
      }
    }
  }
}

TEST(Simulate, OneSidedFamilyHasOneFreeStroke) {
  int ascending = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const LoopTruth truth = made("stiction-one-sided", seed).truth;
    EXPECT_EQ(std::min(truth.stick_band_ascending, truth.stick_band_descending), 0);
    ascending += truth.stick_band_ascending > 0;
  }
  EXPECT_GE(ascending, 8);
  EXPECT_LE(ascending, 32);
}

TEST(Simulate, MixedFamilyHasTwoUnequalStrokes) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const LoopTruth truth = made("stiction-mixed", seed).truth;
    const double smaller =
        std::min(truth.stick_band_ascending, truth.stick_band_descending);
    const double larger =
        std::max(truth.stick_band_ascending, truth.stick_band_descending);
    EXPECT_GT(smaller, 0.3 * larger);
    EXPECT_LT(smaller, 0.85 * larger);
    EXPECT_GT(std::min(truth.slip_jump_ascending, truth.slip_jump_descending), 0);
  }
}

TEST(Simulate, FamiliesCoverWhatTheyAreMeantToCover) {
  int integrating = 0;
  int reverse = 0;
  int limited = 0;
  int fast = 0;
  int fractional_dead_time = 0;
  std::set<std::string> models;
  constexpr int kSeeds = 200;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const SimulatedLoop loop = made("stiction", seed);
    integrating += loop.truth.process.integrating;
    reverse += loop.truth.process.gain < 0;
    limited += loop.truth.u_limited;
    fast += !loop.truth.process.integrating &&
            loop.truth.process.lag_s <= 3.01 * loop.period_s;
    const double delay = loop.truth.process.dead_time_s / loop.period_s;
    fractional_dead_time += std::abs(delay - std::round(delay)) > 0.01;
    models.insert(loop.truth.valve.model);
  }
  EXPECT_GT(integrating, kSeeds / 10);
  EXPECT_GT(reverse, kSeeds / 5);
  EXPECT_GT(limited, kSeeds / 40);
  EXPECT_GT(fast, kSeeds / 3);
  EXPECT_GT(fractional_dead_time, kSeeds / 4);
  EXPECT_EQ(models, (std::set<std::string>{"he", "sliding"}));
}

TEST(Simulate, MovingSetpointStillShowsTheValve) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const SimulatedLoop loop = made("stiction-setpoint", seed);
    EXPECT_GT(swing_of(loop.sp), 0);
    int moves = 0;
    for (std::size_t t = 1; t < loop.x.size(); ++t) moves += loop.x[t] != loop.x[t - 1];
    EXPECT_GE(moves, 8) << "seed " << seed;
    EXPECT_LT(moves, static_cast<int>(loop.x.size()) * 3 / 4) << "seed " << seed;
  }
}

TEST(Simulate, BacklashFamilyCyclesByItselfInHalfOfTheLoops) {
  int cycling = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const SimulatedLoop loop = made("backlash", seed);
    if (loop.truth.oscillation_period_s > 0) {
      ++cycling;
      EXPECT_EQ(swing_of(loop.sp), 0);
    }
  }
  EXPECT_GE(cycling, 15);
  EXPECT_LE(cycling, 45);
}

TEST(Simulate, QuantisedRecordingsHaveFewLevels) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const SimulatedLoop loop = made("quantised", seed);
    const auto levels = [](const std::vector<double>& signal) {
      return std::set<double>(signal.begin(), signal.end()).size();
    };
    EXPECT_LE(std::min(levels(loop.y), levels(loop.u)), 80u);
  }
}

TEST(Simulate, TightTuningHasBothKinds) {
  int limited = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    limited += made("tight-tuning", seed).truth.u_limited;
  }
  EXPECT_GE(limited, 8);
  EXPECT_LE(limited, 32);
}

}  // namespace
}  // namespace workbench
