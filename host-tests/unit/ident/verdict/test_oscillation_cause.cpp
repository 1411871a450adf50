// Crossovers worked by hand and checked on simulated loops; every threshold of the cause.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "ident/verdict/oscillation_cause.hpp"

namespace ident {
namespace {

using Signal = std::vector<double>;

// Gain and dead time alone.
LinearLoop<double> delay_loop(double proportional, int dead_time) {
  LinearLoop<double> loop;
  loop.proportional = proportional;
  loop.fit.gain_a = 1;
  loop.fit.delay = dead_time;
  loop.samples = 1000;
  return loop;
}

LinearLoop<double> lag_loop() {
  LinearLoop<double> loop;
  loop.proportional = 4;
  loop.integral = 0.1;
  loop.poles = {std::exp(-1 / 40.0), std::exp(-1 / 5.0)};
  loop.fit.gain_a = 0.9;
  loop.fit.gain_b = 0.3;
  loop.fit.delay = 3;
  loop.delay = 2;
  loop.samples = 1000;
  return loop;
}

LinearLoop<double> level_loop() {
  LinearLoop<double> loop = lag_loop();
  loop.poles = {1, 0.3};
  loop.proportional = 3;
  loop.integral = 0.03;
  loop.fit.gain_a = 3;
  loop.fit.gain_b = 0;
  return loop;
}

// u and y of the closed loop, sample by sample.
struct Run {
  Signal u;
  Signal y;
};

Run run(const LinearLoop<double>& loop, const Signal& sp) {
  const auto& poles = loop.poles;
  const double steady =
      (1 - poles.fast) * (poles.slow < 1 ? 1 - poles.slow : 16.0 / loop.samples);
  const std::size_t lag = static_cast<std::size_t>(loop.delay + loop.fit.delay);
  Run out;
  Signal lagged;
  double slow = 0, fast = 0, before = 0, u = 0;
  for (std::size_t t = 0; t < sp.size(); ++t) {
    const double near = t >= lag ? lagged[t - lag] : 0;
    const double far = t >= lag + 1 ? lagged[t - lag - 1] : 0;
    out.y.push_back(loop.fit.gain_a * near + loop.fit.gain_b * far);
    const double error = sp[t] - out.y.back();
    u += loop.proportional * (error - before) + loop.integral * error;
    before = error;
    out.u.push_back(u);
    slow = poles.slow * slow + u;
    fast = poles.fast * fast + slow;
    lagged.push_back(steady * fast);
  }
  return out;
}

// Half a circle is ω·dead time = π.
TEST(Crossover, OfADeadTimeIsAtTwiceItsLength) {
  const auto edge = crossover(delay_loop(0.7, 10), 25.0);
  ASSERT_TRUE(edge.known);
  EXPECT_NEAR(edge.period, 20, 0.3);
  EXPECT_NEAR(edge.gain, 0.7, 1e-9);
}

TEST(Crossover, LooksFromHalfToTwiceThePeriodOnly) {
  EXPECT_TRUE(crossover(delay_loop(1, 10), 10.5).known);
  EXPECT_TRUE(crossover(delay_loop(1, 10), 39.0).known);
  EXPECT_FALSE(crossover(delay_loop(1, 10), 9.0).known);
  EXPECT_FALSE(crossover(delay_loop(1, 10), 42.0).known);
}

// The gain at the crossover is what a loop may not exceed.
TEST(Crossover, SeparatesLoopsThatSettleFromThoseThatDoNot) {
  for (const LinearLoop<double>& plain : {lag_loop(), level_loop()}) {
    const auto edge = crossover(plain, 25.0);
    ASSERT_TRUE(edge.known);
    for (const double share : {0.93, 1.07}) {
      LinearLoop<double> loop = plain;
      loop.proportional *= share / edge.gain;
      loop.integral *= share / edge.gain;
      EXPECT_NEAR(crossover(loop, 25.0).gain, share, 0.02);
      const Signal y = run(loop, Signal(1500, 1)).y;
      double early = 0, late = 0;
      for (std::size_t t = 200; t < 400; ++t) {
        early = std::max(early, std::abs(y[t] - 1));
        late = std::max(late, std::abs(y[t + 1000] - 1));
      }
      EXPECT_EQ(late > early, share > 1) << share;
    }
  }
}

TEST(Crossover, IsUnknownWithoutFeedback) {
  EXPECT_FALSE(crossover(LinearLoop<double>{}, 20.0).known);
  EXPECT_TRUE(std::isfinite(crossover(level_loop(), 20.0).gain));
}

// A large wave, and beside it a small square wave of another period.
Signal wave_and_beside(double size) {
  Signal values;
  for (int t = 0; t < 1500; ++t) {
    values.push_back(3 * std::sin(2 * M_PI * t / 50) + (t / 37 % 2 == 0 ? size : -size));
  }
  return values;
}

TEST(GainBeside, LeavesTheOscillationItselfOut) {
  const Signal simulated = wave_and_beside(0.1);
  const auto gain = [&](double size) {
    return gain_beside<double>(wave_and_beside(size), simulated, 50);
  };
  EXPECT_NEAR(gain(0.1), 1, 1e-6);
  EXPECT_NEAR(gain(0.05), 0.5, 0.02);
  EXPECT_NEAR(gain(0), 0, 0.02);
}

// The lower end: what is not explained widens the interval.
TEST(GainBeside, DropsWithTheNoise) {
  const Signal simulated = wave_and_beside(0.1);
  Signal y = simulated;
  double before = 1;
  std::uint32_t state = 1;
  for (const double noise : {0.02, 0.2, 2.0}) {
    for (std::size_t t = 0; t < y.size(); ++t) {
      state = state * 1664525 + 1013904223;
      y[t] = simulated[t] + noise * (state / 4294967296.0 - 0.5);
    }
    const double now = gain_beside<double>(y, simulated, 50);
    EXPECT_LT(now, before) << noise;
    before = now;
  }
  EXPECT_LT(before, 0.5);
}

TEST(GainBeside, IsNothingWithoutASimulation) {
  EXPECT_EQ(gain_beside<double>(wave_and_beside(0.1), Signal(1500, 0), 50), 0);
  // Too short for the notches to settle.
  EXPECT_EQ(gain_beside<double>(Signal(100, 1), Signal(100, 1), 50), 0);
}

Signal steps() {
  Signal sp;
  for (int t = 0; t < 1000; ++t) {
    sp.push_back(5 + (t / 130 % 2 == 0 ? 0 : 1) + (t > 500 ? 0.5 : 0));
  }
  return sp;
}

double share(const LinearLoop<double>& loop, const Signal& u, const Signal& sp) {
  Signal scratch(u.size());
  return setpoint_share<double>(loop, u, sp, scratch);
}

TEST(SetpointShare, IsAllOfALoopThatOnlyTheSetpointMoves) {
  LinearLoop<double> loop = lag_loop();
  loop.proportional = 1.5;
  loop.integral = 0.04;
  Signal from_zero = steps();
  for (double& value : from_zero) {
    value -= 5;
  }
  Signal u = run(loop, from_zero).u;
  for (double& value : u) {
    value += 0.4;  // where it rests before the window does not matter
  }
  EXPECT_NEAR(share(loop, u, steps()), 1, 1e-9);
}

TEST(SetpointShare, IsNothingWhereSomethingElseMovesU) {
  LinearLoop<double> loop = lag_loop();
  loop.proportional = 1.5;
  loop.integral = 0.04;
  Signal u;
  for (int t = 0; t < 1000; ++t) {
    u.push_back(std::sin(0.17 * t));
  }
  EXPECT_LT(share(loop, u, steps()), 0.1);
  EXPECT_NEAR(share(loop, u, Signal(1000, 3)), 0, 1e-9);
}

TEST(SetpointShare, BearsALoopThatDiverges) {
  LinearLoop<double> loop = lag_loop();
  loop.proportional = 100;
  const Signal u = run(lag_loop(), steps()).u;
  EXPECT_EQ(share(loop, u, steps()), 0);
}

TEST(Cause, HasOneNameEach) {
  std::set<std::string> seen;
  for (int k = 1; k < kCauses; ++k) {
    EXPECT_TRUE(seen.insert(std::string(name(static_cast<Cause>(k)))).second);
  }
  EXPECT_EQ(name(Cause::kValve), "valve");
  EXPECT_EQ(name(Cause::kExternalPeriodic), "external_periodic");
  EXPECT_EQ(name(Cause::kTightTuning), "tight_tuning");
  EXPECT_EQ(name(Cause::kSetpoint), "setpoint");
  EXPECT_TRUE(name(Cause::kUnknown).empty());
}

TEST(Cause, HasASentenceWhereTheVerdictHasNone) {
  for (const Cause cause :
       {Cause::kExternalPeriodic, Cause::kTightTuning, Cause::kSetpoint}) {
    EXPECT_EQ(sentence(cause).back(), '.');
  }
  EXPECT_TRUE(sentence(Cause::kUnknown).empty());
  EXPECT_TRUE(sentence(Cause::kValve).empty());
}

LoopEvidence<double> external() {
  LoopEvidence<double> e;
  e.oscillates = true;
  e.regularity = 8;
  e.cycles = 12;
  e.kurtosis = 1.55;
  e.law_known = true;
  e.crossover_gain = 0.98;
  e.crossover_period = 1;
  e.fit_linear_percent = 85;
  return e;
}

LoopEvidence<double> tight() {
  LoopEvidence<double> e = external();
  e.gain_beside = 0.9;
  e.limit_share = 0.2;
  e.crossover_gain = 1.2;
  e.crossover_period = 1.08;
  return e;
}

template <class Change>
Cause changed(LoopEvidence<double> evidence, Change change,
              Verdict verdict = Verdict::kNoStiction) {
  change(evidence);
  return cause_of(evidence, verdict);
}

TEST(Cause, IsTheValveWhereTheVerdictSaysSo) {
  EXPECT_EQ(cause_of(external(), Verdict::kStiction), Cause::kValve);
  EXPECT_EQ(cause_of(tight(), Verdict::kBacklash), Cause::kValve);
}

TEST(Cause, IsTheSetpointWhereThatMovesU) {
  for (const Verdict verdict : {Verdict::kNoStiction, Verdict::kUndecided}) {
    EXPECT_EQ(
        changed(
            LoopEvidence<double>{}, [](auto& e) { e.setpoint_share = 0.71; }, verdict),
        Cause::kSetpoint);
  }
  EXPECT_EQ(changed(LoopEvidence<double>{}, [](auto& e) { e.setpoint_share = 0.69; }),
            Cause::kUnknown);
}

TEST(Cause, IsALoadFromOutsideIfRegularAndOfConstantSize) {
  const auto named = [](auto change) { return changed(external(), change); };
  EXPECT_EQ(named([](auto&) {}), Cause::kExternalPeriodic);
  EXPECT_EQ(named([](auto& e) { e.regularity = 3.9; }), Cause::kUnknown);
  EXPECT_EQ(named([](auto& e) { e.kurtosis = 1.9; }), Cause::kUnknown);
  EXPECT_EQ(named([](auto& e) { e.limit_share = 0.02; }), Cause::kUnknown);
  EXPECT_EQ(named([](auto& e) { e.cycles = 5.9; }), Cause::kUnknown);
}

TEST(Cause, IsTheTuningIfTheLoopIsUnstableBetweenItsLimits) {
  const auto named = [](auto change) { return changed(tight(), change); };
  EXPECT_EQ(named([](auto&) {}), Cause::kTightTuning);
  EXPECT_EQ(named([](auto& e) { e.crossover_gain = 1.04; }), Cause::kUnknown);
  EXPECT_EQ(named([](auto& e) { e.limit_share = 0.02; }), Cause::kUnknown);
  EXPECT_EQ(named([](auto& e) { e.crossover_period = 1.3; }), Cause::kUnknown);
  EXPECT_EQ(named([](auto& e) { e.crossover_period = 0.7; }), Cause::kUnknown);
  EXPECT_EQ(named([](auto& e) { e.fit_linear_percent = 50; }), Cause::kUnknown);
  EXPECT_EQ(named([](auto& e) { e.gain_beside = 0.39; }), Cause::kUnknown);
}

TEST(Cause, IsLeftOpenWhereLittleIsKnown) {
  for (const LoopEvidence<double>& plain : {external(), tight()}) {
    const auto named = [&](auto change) { return changed(plain, change); };
    EXPECT_EQ(named([](auto& e) { e.oscillates = false; }), Cause::kUnknown);
    EXPECT_EQ(named([](auto& e) { e.law_known = false; }), Cause::kUnknown);
    EXPECT_EQ(named([](auto& e) { e.u_step = 0.21; }), Cause::kUnknown);
    EXPECT_EQ(named([](auto& e) { e.y_step = 0.21; }), Cause::kUnknown);
    EXPECT_EQ(changed(
                  plain, [](auto&) {}, Verdict::kUndecided),
              Cause::kUnknown);
    EXPECT_EQ(changed(
                  plain, [](auto&) {}, Verdict::kBadData),
              Cause::kUnknown);
  }
  EXPECT_EQ(cause_of(LoopEvidence<float>{}, Verdict::kNoStiction), Cause::kUnknown);
}

TEST(OscillationCause, SaysWhetherTheSetpointMovesTheLoop) {
  LoopEvidence<float> evidence;
  EXPECT_FALSE(setpoint_moves(evidence));
  evidence.setpoint_share = 0.65F;
  EXPECT_FALSE(setpoint_moves(evidence));
  evidence.setpoint_share = 0.75F;
  EXPECT_TRUE(setpoint_moves(evidence));
  EXPECT_EQ(cause_of(evidence, Verdict::kUndecided), Cause::kSetpoint);
}

}  // namespace
}  // namespace ident
