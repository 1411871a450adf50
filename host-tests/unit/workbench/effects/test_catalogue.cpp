// The registry, what every effect must hold to, and an effect that is not in it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/catalogue.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/search/ladder.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

TEST(Catalogue, HasTheEffectsOfTheContract) {
  std::set<std::string> codes;
  for (const Effect* effect : standard_catalogue().effects()) {
    codes.emplace(effect->code());
  }
  EXPECT_EQ(codes,
            (std::set<std::string>{"valve.stiction",          "valve.backlash",
                                   "valve.saturation",        "valve.characteristic",
                                   "valve.positioner_lag",    "valve.rate_limit",
                                   "process.dead_time",       "process.second_lag",
                                   "process.integrating",     "process.nonlinear_gain",
                                   "process.gain_drift",      "process.overflow",
                                   "disturbance.sinusoid",    "disturbance.step",
                                   "disturbance.ramp",        "sensor.lag",
                                   "sensor.quantisation",     "process.inverse_response",
                                   "process.oscillatory",     "sensor.sticking",
                                   "sensor.spikes",           "record.compression",
                                   "process.directional_lag", "process.slow_tail",
                                   "sensor.saturation"}));
  EXPECT_EQ(standard_catalogue().find("no.such"), nullptr);
  Catalogue catalogue = standard_catalogue();
  EXPECT_THROW(catalogue.add(effects::sensor_lag()), std::invalid_argument);
}

TEST(Catalogue, EveryEffectKeepsItsPromises) {
  const Recording recording = test::simulated({});
  Situation s = situation_of(recording.u, recording.y, recording.period_s);
  const std::vector<double> residual(recording.y.begin(), recording.y.end());
  const std::vector<unsigned char> all(residual.size(), 1);
  s.residual = residual;
  s.estimation = all;
  s.first_lag_s = 20;
  s.residual_std = 1;
  for (const Effect* effect : standard_catalogue().effects()) {
    SCOPED_TRACE(effect->code());
    const Description& d = effect->description();
    for (const std::string_view text : {d.title, d.signature, d.cure, d.split}) {
      EXPECT_FALSE(text.empty());
    }
    EXPECT_EQ(d.cure.back(), '.');
    const auto searched = effect->searched(s);
    const std::vector<double> c(effect->solved().size(), 1.0);
    for (const SearchedParameter& p : searched) {
      EXPECT_LE(p.low, p.high);
      EXPECT_TRUE(!p.logarithmic || p.low > 0);
    }
    for (const Values& start : effect->starts(s)) {
      ASSERT_EQ(start.size(), searched.size());
      for (std::size_t i = 0; i < start.size(); ++i) {
        EXPECT_GE(start[i], searched[i].low - 1e-9) << searched[i].name;
        EXPECT_LE(start[i], searched[i].high + 1e-9) << searched[i].name;
      }
      EXPECT_GE(effect->excitation(s, start).events, 0);
      const std::string evidence = effect->evidence(s, start, c);
      ASSERT_FALSE(evidence.empty());
      EXPECT_EQ(evidence.back(), '.');
    }
  }
}

constexpr Description kDescription{
    .code = "disturbance.surge",
    .title = "a load that swells",
    .place = Place::kLoad,
    .view = View::kTime,
    .signature = "rises for a while and falls again",
    .cure = "Look in the logs for what swelled and subsided.",
    .split = "record longer before and after",
    .needs_u = false,
};

// docs/adding-an-effect.md, step by step: a load that swells and subsides.
class Surge final : public Effect {
 public:
  Surge() : Effect(kDescription) {}
  [[nodiscard]] std::vector<SearchedParameter> searched(
      const Situation& s) const override {
    const double end = s.duration_s();
    return {{.name = "start",
             .unit = "s",
             .low = 0,
             .high = end,
             .jumpy = true,
             .instant = true},
            {.name = "length", .unit = "s", .low = 0, .high = end, .jumpy = true}};
  }
  [[nodiscard]] std::span<const SolvedParameter> solved() const override {
    static constexpr SolvedParameter kSolved[] = {{"amplitude", "y"}};
    return kSolved;
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    std::vector<Values> out;
    for (double start = 0; start < 0.9; start += 0.05) {
      for (const double length : {0.1, 0.2, 0.4}) {
        out.push_back({start * s.duration_s(), length * s.duration_s()});
      }
    }
    return out;
  }
  [[nodiscard]] Excitation excitation(const Situation& s,
                                      std::span<const double> p) const override {
    return {static_cast<int>(50 * p[1] / s.duration_s()), "fiftieths of the recording"};
  }
  [[nodiscard]] std::string evidence(const Situation&, std::span<const double> p,
                                     std::span<const double> c) const override {
    return "The output is off by up to " + number(c[0], 3) + " y for " + number(p[1], 3) +
           " s.";
  }
  void load(std::span<const double> p, const LoadSetting& setting,
            Columns columns) const override {
    for (std::size_t k = 0; k < columns[0].size(); ++k) {
      const double t = static_cast<double>(k) * setting.period_s;
      const double half = std::max(p[1] / 2, setting.period_s);
      columns[0][k] = std::max(0.0, 1 - std::abs(t - p[0] - half) / half);
    }
  }
};

// A square wave in u: a limit cycle where it goes on, a few steps of the setpoint else.
TEST(Catalogue, ASinusoidInStepWithALimitCycleIsNoLoad) {
  constexpr std::size_t kSamples = 1200;
  const auto objection = [](std::size_t cycles) {
    const std::size_t period = kSamples / cycles;
    std::vector<double> u(kSamples);
    for (std::size_t t = 0; t < kSamples; ++t) {
      u[t] = t % period < period / 2 ? 0.0 : 1.0;
    }
    const Situation s = situation_of(u, u, 1.0);
    const Values at{static_cast<double>(period) / 3};
    return effects::disturbance_sinusoid().objection(s, at, {});
  };
  EXPECT_NE(objection(20), "");
  EXPECT_EQ(objection(6), "");
}

// A curve of six parameters goes through the levels that few moves lead to, whatever
// moved y there.
TEST(Catalogue, FewMovesAskForNoFreeCharacteristic) {
  const auto free_starts = [](std::size_t moves) {
    std::vector<double> u;
    for (std::size_t k = 0; k < 1200; ++k) u.push_back(k * moves / 1200 % 2 == 0 ? 0 : 1);
    const auto starts = effects::valve_characteristic().starts(situation_of(u, u, 1.0));
    constexpr std::size_t kFreeShape = 3;
    return std::count_if(starts.begin(), starts.end(),
                         [](const Values& start) { return start[kFreeShape] > 0.5; });
  };
  EXPECT_EQ(free_starts(6), 0);
  EXPECT_GT(free_starts(20), 0);
}

// A linear valve passes the edges of u on to y, one that sticks leaves them.
TEST(Catalogue, ASinusoidInStepWithEdgesThatTheOutputFollowsIsALoad) {
  constexpr std::size_t kSamples = 1200;
  std::vector<double> u(kSamples);
  std::vector<double> y(kSamples);
  std::vector<double> residual(kSamples);
  const auto objection = [&](double left) {
    for (std::size_t t = 0; t < kSamples; ++t) {
      u[t] = t % 60 < 30 ? 0.0 : 1.0;
      y[t] = (t > 0 ? 0.9 * y[t - 1] : 0.0) + 0.1 * u[t];
      residual[t] = left * (y[t] - 0.5);
    }
    Situation s = situation_of(u, y, 1.0);
    s.residual = residual;
    return effects::disturbance_sinusoid().objection(s, Values{60}, {});
  };
  EXPECT_EQ(objection(0.05), "");
  EXPECT_NE(objection(0.5), "");
}

// curvature, from, to, free_shape, five bends.
TEST(Catalogue, ACharacteristicSaysWhichKindOfCurveItIs) {
  const auto kind = [](const Values& p) {
    return std::string(effects::valve_characteristic().named_curve(p).value().kind);
  };
  EXPECT_EQ(kind({2, 20, 80, 0, 0, 0, 0, 0, 0}), "equal_percentage");
  EXPECT_EQ(kind({4, 20, 80, 0, 0, 0, 0, 0, 0}), "equal_percentage");  // 50 to 1
  EXPECT_EQ(kind({-2, 20, 80, 0, 0, 0, 0, 0, 0}), "quick_opening");
  EXPECT_EQ(kind({0.1, 20, 80, 0, 0, 0, 0, 0, 0}), "other");
  EXPECT_EQ(kind({0, 20, 80, 1, 0.5, 1, 1, 1, 0.5}), "s_shaped");
  EXPECT_EQ(kind({5, 20, 80, 1, 4.2, 3.3, 2.5, 1.7, 0.8}), "dead_at_seat");
  // Bends count only where the shape is free.
  EXPECT_EQ(kind({2, 20, 80, 0, 0.5, 9, 9, 9, 0.5}), "equal_percentage");
}

TEST(Catalogue, AMeasuredLoadIsFoundAsAUserWritesIt) {
  const Catalogue all = standard_catalogue().with(
      {{"d1 [bar]", "bar", {}}, {"Feed.flow", "", {}}, {"Feed.level", "", {}}});
  const auto code = [&](std::string_view asked) {
    return std::string(
        all.find_asked("disturbance.measured:" + std::string(asked))->code());
  };
  EXPECT_EQ(code("d1 [bar]"), "disturbance.measured:d1 [bar]");
  EXPECT_EQ(code("D1"), "disturbance.measured:d1 [bar]");
  EXPECT_EQ(code("flow"), "disturbance.measured:Feed.flow");
  EXPECT_EQ(code("feed"), "disturbance.measured:feed") << "two begin so";
  EXPECT_EQ(all.find_asked("no.such"), nullptr);
}

TEST(Catalogue, ACharacteristicInTwoPiecesSaysWhereItIsDead) {
  const auto curve = [](double slope, double dead) {
    const Values p{slope, 20, 80, 0, 0, 0, 0, 0, 0, 1, 50, dead};
    return effects::valve_characteristic().named_curve(p).value();
  };
  EXPECT_EQ(curve(0, 6).kind, "other");
  EXPECT_EQ(curve(0, 6).words, "Between 47 and 53 of u nothing changes.");
  EXPECT_EQ(curve(std::log(2.0), 0).words,
            "Above 50 of u the same move of u changes 2 times as much as below.");
  EXPECT_EQ(curve(0, 6).points[10][1], curve(0, 6).points[10][0]);
  for (const std::string_view name : curve(0, 6).inside) {
    EXPECT_TRUE(name != "parted_at" && name != "dead_width");
  }
}

TEST(Catalogue, TheCurveOfACharacteristicRisesFromEndToEnd) {
  const Values p{2, 20, 80, 0, 0, 0, 0, 0, 0};
  const auto points = effects::valve_characteristic().named_curve(p).value().points;
  ASSERT_GE(points.size(), 11u);
  EXPECT_NEAR(points.front()[0], 20, 1e-9);
  EXPECT_NEAR(points.front()[1], 20, 0.1);
  EXPECT_NEAR(points.back()[0], 80, 1e-9);
  EXPECT_NEAR(points.back()[1], 80, 1e-6);
  for (std::size_t i = 1; i < points.size(); ++i) {
    EXPECT_GT(points[i][1], points[i - 1][1]) << i;
  }
  EXPECT_FALSE(effects::valve_stiction().named_curve(Values{1, 2}).has_value());
}

TEST(Catalogue, AnEffectThatIsNotInItIsFoundOnceItIsAdded) {
  test::SetpointLoop loop;
  loop.load = [](std::size_t k) {
    const double way = std::abs(static_cast<double>(k) - 520) / 120;
    return 8 * std::max(0.0, 1 - way);
  };
  const Recording recording = test::simulated(loop);
  const Surge surge;
  Catalogue catalogue = standard_catalogue();
  catalogue.add(surge);
  LadderOptions options;
  options.catalogue = &catalogue;
  const LadderResult result = run_ladder(recording, options);
  ASSERT_TRUE(result.model.has("disturbance.surge"));
  for (const EffectTerm& term : result.model.effects) {
    if (term.effect != "disturbance.surge") continue;
    EXPECT_NEAR(term.parameters[0].value, 400, 5);
    EXPECT_NEAR(term.parameters[1].value, 240, 10);
    EXPECT_NEAR(term.parameters[2].value, 8, 0.4);
  }
}

// Nothing fouls within minutes, and no lag is tuned for that never shows its end.
TEST(Catalogue, ACureFitsTheLengthOfTheRecording) {
  const Effect& drift = *standard_catalogue().find("process.gain_drift");
  const std::vector<double> u(1000, 50.0);
  Situation here;
  here.u = u;
  here.period_s = 1;
  here.first_lag_s = 900;
  EXPECT_EQ(drift.cure(here, {}).find("catalyst"), std::string::npos);
  const Effect& lag = *standard_catalogue().find("process.second_lag");
  const double slow[] = {800};
  const double fast[] = {20};
  EXPECT_NE(lag.cure(here, slow).find("Record until"), std::string::npos);
  EXPECT_EQ(lag.cure(here, fast), lag.description().cure);
  here.period_s = 3600;
  EXPECT_EQ(drift.cure(here, {}), drift.description().cure);
}

TEST(Catalogue, WhatIsHarmlessNamesNothingToMend) {
  for (const Effect* effect : standard_catalogue().effects()) {
    const Description& d = effect->description();
    if (!d.harmless) continue;
    EXPECT_TRUE(d.place == Place::kProcess || d.place == Place::kCharacteristic)
        << d.code;
    EXPECT_EQ(d.cure.find("Check"), std::string_view::npos) << d.code;
  }
}

}  // namespace
}  // namespace workbench
