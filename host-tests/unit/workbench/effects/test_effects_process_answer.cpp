// A process that goes the wrong way first, one that rings by itself, and one that bends.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/search/explain.hpp"
#include "workbench/model/search/ladder.hpp"

namespace workbench {
namespace {

// u moved by hand among random levels, y from a process that is stepped finely.
template <class Process>
Recording by_hand(double noise, double hold, Process process) {
  constexpr int kSubSteps = 50;
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal(0, noise);
  std::uniform_real_distribution<double> level(30, 70);
  Recording out = test::simulated({});
  double u = 50;
  for (std::size_t k = 0; k < out.size(); ++k) {
    if (std::fmod(static_cast<double>(k), hold) == 20) u = level(random);
    out.u[k] = u;
    out.y[k] = process.y() + normal(random);
    for (int i = 0; i < kSubSteps; ++i) process.advance(u - 50, 1.0 / kSubSteps);
  }
  out.sp.clear();
  return out;
}

struct WrongFirst {
  double slow = 0;
  double fast = 0;
  [[nodiscard]] double y() const { return slow - fast; }
  void advance(double v, double dt) {
    slow += dt * (1.6 * v - slow) / 25;
    fast += dt * (0.6 * v - fast) / 4;
  }
};

struct Ringing {
  double z = 0;
  double slope = 0;
  [[nodiscard]] double y() const { return z; }
  void advance(double v, double dt) {
    const double w = 2 * std::numbers::pi / 40;
    slope += dt * w * (w * (v - z) - 2 * 0.2 * slope);
    z += dt * slope;
  }
};

// A lag, and a pipe behind it whose flow is u: later where u is low.
struct PipeBehindLag {
  double z = 0;
  double passed = 0;
  std::vector<std::array<double, 2>> inside = {{-1000, 0}, {0, 0}};  // passed, z
  [[nodiscard]] double y() const {
    std::size_t k = inside.size() - 1;
    while (k > 0 && inside[k][0] > passed - 700) --k;
    return inside[k][1];
  }
  void advance(double v, double dt) {
    z += dt * (v - z) / 15;
    passed += dt * (v + 50);
    inside.push_back({passed, z});
  }
};

struct Lag {
  double z = 0;
  [[nodiscard]] double y() const { return z; }
  void advance(double v, double dt) { z += dt * (v - z) / 20; }
};

double value(const Candidate& candidate, std::string_view name) {
  for (const Parameter& parameter : candidate.parameters) {
    if (parameter.name == name) return parameter.value;
  }
  return -1;
}

TEST(ProcessAnswer, GoingTheWrongWayFirstIsNamedWithItsLag) {
  const Recording recording = by_hand(0.2, 90, WrongFirst{});
  const ExplainResult result =
      explain(recording, start_model(recording, Column::y).model);
  ASSERT_NE(result.best(), nullptr);
  EXPECT_EQ(result.best()->effect, "process.inverse_response");
  EXPECT_NEAR(value(*result.best(), "fast_lag"), 4, 0.5);
  // 1.6/(1 + 25 s) − 0.6/(1 + 4 s) has its zero at 1/8.6.
  EXPECT_NEAR(value(*result.best(), "opposite_time"), 8.6, 0.6);
}

TEST(ProcessAnswer, RingingByItselfIsNamedWithPeriodAndDamping) {
  const Recording recording = by_hand(0.2, 150, Ringing{});
  const ExplainResult result =
      explain(recording, start_model(recording, Column::y).model);
  ASSERT_NE(result.best(), nullptr);
  EXPECT_EQ(result.best()->effect, "process.oscillatory");
  EXPECT_NEAR(value(*result.best(), "period"), 40, 1);
  EXPECT_NEAR(value(*result.best(), "damping"), 0.2, 0.03);
}

// Friction answers a swing with its overtones, as a process that rings would.
TEST(ProcessAnswer, AnOvertoneOfASwingIsNoRinging) {
  const Effect& rings = effects::process_oscillatory();
  std::vector<double> u(600);
  std::vector<double> y(600);
  for (std::size_t k = 0; k < u.size(); ++k) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(k) / 120;
    u[k] = 50 + 20 * std::sin(turn);
    y[k] = std::sin(turn - 1) + 0.3 * std::sin(3 * turn);
  }
  const Situation swing = situation_of(u, y, 1);
  const std::vector<double> third = {40, 0.02};
  const std::vector<double> other = {47, 0.02};
  constexpr const char* kWhy = "u swings with a multiple of this period";
  EXPECT_NE(rings.objection(swing, third, {}).find(kWhy), std::string::npos);
  EXPECT_EQ(rings.objection(swing, other, {}).find(kWhy), std::string::npos);
  const Recording steps = by_hand(0.1, 80, Ringing());
  const Situation step = situation_of(steps.u, steps.y, 1);
  EXPECT_EQ(rings.objection(step, third, {}), "");
}

// A loop that swings under a load looks like a process that rings; u at rest closes none.
TEST(ProcessAnswer, RingingIsDoubtedOnlyWhereUDoesNotRest) {
  const Effect& rings = effects::process_oscillatory();
  std::mt19937_64 random(3);
  for (const std::size_t held : {std::size_t{5}, std::size_t{60}}) {
    std::vector<double> u(900);
    std::vector<double> y(900);
    for (std::size_t k = 1; k < u.size(); ++k) {
      u[k] = k % held == 0 ? static_cast<double>(random() % 100) : u[k - 1];
      y[k] = y[k - 1] + (u[k - 1] - y[k - 1]) / 20;
    }
    const std::string doubt =
        rings.objection(situation_of(u, y, 1), std::vector<double>{40, 0.1}, {});
    EXPECT_EQ(doubt.empty(), held == 60) << doubt;
  }
}

// A pair of poles that answers a pulse with one peak stands for a dead time and lags.
TEST(ProcessAnswer, RingingHasToSwing) {
  const Effect& rings = effects::process_oscillatory();
  const Recording steps = by_hand(0.1, 80, Ringing());
  Situation here = situation_of(steps.u, steps.y, 1);
  const auto is_smooth = [&](double lag_s, double damping) {
    here.first_lag_s = lag_s;
    const std::string why = rings.objection(here, std::vector<double>{40, damping}, {});
    return why.find("its output would not swing") != std::string::npos;
  };
  EXPECT_FALSE(is_smooth(0, 0.69));
  EXPECT_TRUE(is_smooth(0, 0.73));
  EXPECT_FALSE(is_smooth(20, 0.3));
  EXPECT_TRUE(is_smooth(20, 0.6));
  EXPECT_FALSE(is_smooth(1e5, 0.3));
  here.integrating = true;
  EXPECT_FALSE(is_smooth(20, 0.6));
  EXPECT_TRUE(is_smooth(20, 0.8));
}

// A pot on a hotplate, one step of the plate: neither storage settles.
TEST(ProcessAnswer, ASlowStartIsASecondStorageAndNoDrift) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal(0, 0.3);
  Recording recording = test::simulated({});
  recording.sp.clear();
  double plate = 0;
  double pot = 0;
  for (std::size_t k = 0; k < recording.size(); ++k) {
    recording.u[k] = k < 20 ? 0 : 40;
    recording.y[k] = 25 + pot + normal(random);
    const double length = static_cast<double>(recording.size());
    plate += (recording.u[k] - plate) / (0.5 * length);
    pot += (2 * plate - pot) / (0.7 * length);
  }
  const ExplainResult result =
      explain(recording, start_model(recording, Column::y).model);
  ASSERT_NE(result.best(), nullptr);
  EXPECT_EQ(result.best()->effect, "process.second_lag");
}

TEST(ProcessAnswer, NeitherIsNamedForALag) {
  const Recording recording = by_hand(0.2, 90, Lag{});
  const ExplainResult result =
      explain(recording, start_model(recording, Column::y).model);
  EXPECT_EQ(result.best(), nullptr);
}

// Behind a lag of a sample or two nothing tells a curve from one of the valve.
TEST(NonlinearGain, ObjectsToAProcessThatIsOverAtOnce) {
  const std::vector<double> u = {40, 60, 40};
  Situation here = situation_of(u, u, 1);
  const Effect& gain = effects::process_nonlinear_gain();
  const std::vector<double> behind = {2, 40, 60, 0, 0};
  const std::vector<double> of_storages = {2, 40, 60, 1, 0};
  here.first_lag_s = 1.2;
  EXPECT_FALSE(gain.objection(here, behind, {}).empty());
  EXPECT_TRUE(gain.objection(here, of_storages, {}).empty());
  here.first_lag_s = 20;
  EXPECT_TRUE(gain.objection(here, behind, {}).empty());
}

TEST(DeadTime, FollowsTheFlowThroughAPipe) {
  const LadderResult result = run_ladder(by_hand(0.2, 60, PipeBehindLag{}));
  ASSERT_EQ(result.model.effects.size(), 1u);
  const EffectTerm& term = result.model.effects[0];
  ASSERT_EQ(term.effect, "process.dead_time");
  EXPECT_EQ(term.parameters[1].value, 1) << "by flow";
  const double ratio = term.parameters[4].value / term.parameters[3].value;
  EXPECT_NEAR(term.parameters[2].value, ratio, 0.2 * ratio);
  const double halfway = (term.parameters[3].value + term.parameters[4].value) / 2;
  EXPECT_NEAR(term.parameters[0].value, 700 / halfway, 1.5);
}

TEST(DeadTime, SaysWhereARowIsLonger) {
  const std::vector<double> u = {40, 60, 40};
  const Situation here = situation_of(u, u, 2);
  const auto said = [&here](double dead_time_s) {
    const std::vector<double> p = {dead_time_s, 0, 1, 40, 60};
    return effects::process_dead_time().evidence(here, p, {});
  };
  EXPECT_NE(said(1.9).find("shorter than a row"), std::string::npos) << said(1.9);
  EXPECT_EQ(said(2.1).find("shorter"), std::string::npos) << said(2.1);
}

TEST(DeadTime, IsTheSameEverywhereWhereItIs) {
  test::SetpointLoop loop;
  loop.delay = 6;
  const LadderResult result = run_ladder(test::simulated(loop));
  ASSERT_EQ(result.model.effects.size(), 1u);
  EXPECT_EQ(result.model.effects[0].effect, "process.dead_time");
  EXPECT_EQ(result.model.effects[0].parameters[1].value, 0) << "by flow";
}

}  // namespace
}  // namespace workbench
