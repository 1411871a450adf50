// explain and ladder on small loops with one thing wrong.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "support/workbench/serve_session.hpp"
#include "support/workbench/setpoint_loop.hpp"
#include "workbench/model/judge/compare.hpp"
#include "workbench/model/search/ladder.hpp"

namespace workbench {
namespace {

using test::SetpointLoop;
using test::simulated;

bool names(const ExplainResult& result, std::string_view effect) {
  const Candidate* best = result.best();
  if (best == nullptr) return false;
  if (best->effect == effect) return true;
  for (const std::string& other : best->indistinguishable_from) {
    if (other == effect) return true;
  }
  return false;
}

const Candidate& candidate(const ExplainResult& result, std::string_view effect) {
  for (const Candidate& c : result.candidates) {
    if (c.effect == effect) return c;
  }
  throw std::out_of_range("no such candidate");
}

ExplainResult explained(const SetpointLoop& loop) {
  const Recording recording = simulated(loop);
  return explain(recording, start_model(recording, Column::y).model);
}

TEST(Explain, AddsNothingToACleanLoop) {
  for (std::uint64_t seed = 1000; seed < 1010; ++seed) {
    SetpointLoop loop;
    loop.seed = seed;
    const ExplainResult result = explained(loop);
    EXPECT_EQ(result.best(), nullptr) << seed << ' ' << result.candidates[0].effect;
  }
}

TEST(Explain, NamesDeadTimeBacklashAndASinusoid) {
  SetpointLoop late;
  late.delay = 6;
  EXPECT_TRUE(names(explained(late), "process.dead_time"));
  SetpointLoop loose;
  loose.valve = test::backlash(3);
  EXPECT_TRUE(names(explained(loose), "valve.backlash"));
  SetpointLoop shaken;
  shaken.load = [](std::size_t k) {
    return 2 * std::sin(2 * std::numbers::pi * static_cast<double>(k) / 37);
  };
  EXPECT_TRUE(names(explained(shaken), "disturbance.sinusoid"));
}

TEST(Explain, SaysNotExcitedAtRest) {
  SetpointLoop loop;
  loop.setpoint_moves = false;
  const ExplainResult result = explained(loop);
  EXPECT_EQ(result.best(), nullptr);
  for (const char* effect : {"valve.stiction", "valve.backlash", "process.dead_time",
                             "process.second_lag", "valve.rate_limit"}) {
    EXPECT_EQ(candidate(result, effect).status, CandidateStatus::kNotExcited) << effect;
  }
}

TEST(Explain, ListsEveryMissingEffectOnceWithASentence) {
  const ExplainResult result = explained({});
  EXPECT_GE(result.candidates.size(), 17u);
  for (const Candidate& c : result.candidates) {
    EXPECT_FALSE(c.evidence.empty());
    EXPECT_GE(c.p_value, 0);
    EXPECT_LE(c.p_value, 1);
    EXPECT_EQ(c.would_split.has_value(), !c.indistinguishable_from.empty());
  }
}

TEST(Ladder, FindsTwoEffectsAndStops) {
  SetpointLoop loop;
  loop.delay = 6;
  loop.load = [](std::size_t k) { return k > 500 ? 4.0 : 0.0; };
  const LadderResult result = run_ladder(simulated(loop));
  EXPECT_TRUE(result.model.has("process.dead_time"));
  EXPECT_TRUE(result.model.has("disturbance.step"));
  EXPECT_EQ(result.model.effects.size(), 2u);
  EXPECT_NEAR(result.quality.rmse_validation, 0.2, 0.03);
  EXPECT_EQ(result.steps.front().effect, "process");
  EXPECT_LT(result.steps.back().rmse_validation, result.steps.front().rmse_validation);
  EXPECT_EQ(result.last.best(), nullptr);
  EXPECT_EQ(result.model.history.size(), result.steps.size());
}

TEST(Ladder, DatesALoadThatGoesAgain) {
  SetpointLoop loop;
  loop.load = [](std::size_t k) { return k >= 400 && k < 640 ? 4.0 : 0.0; };
  const LadderResult result = run_ladder(simulated(loop));
  ASSERT_EQ(result.model.effects.size(), 1u);
  const EffectTerm& step = result.model.effects[0];
  EXPECT_EQ(step.effect, "disturbance.step");
  EXPECT_NEAR(step.parameters[0].value, 400, 3);
  EXPECT_EQ(step.parameters[2].value, 1) << "passing";
  EXPECT_NEAR(step.parameters[3].value, 640, 3);
  EXPECT_NEAR(result.quality.rmse_validation, 0.2, 0.03);
}

TEST(Ladder, AsksAgainBesideALaterEffectAndTellsEachStepAsItIsDone) {
  LadderOptions options;
  std::vector<Model> reached;
  options.stepped = [&reached](const Model& model, const ExplainResult& found) {
    EXPECT_TRUE(model.has(found.best()->effect));
    reached.push_back(model);
  };
  const LadderResult result = run_ladder(test::drifting_and_coarse(), options);
  EXPECT_TRUE(result.model.has("disturbance.ramp"));
  EXPECT_TRUE(result.model.has("sensor.quantisation"));
  EXPECT_EQ(result.last.best(), nullptr);
  EXPECT_EQ(result.model.history.size(), result.steps.size());
  ASSERT_EQ(reached.size(), 2u);
  EXPECT_EQ(reached.front().effect_codes(), std::vector<std::string>{"disturbance.ramp"});
  EXPECT_EQ(reached.back().effect_codes(), result.model.effect_codes());
}

TEST(Ladder, IsTheSameAgain) {
  SetpointLoop loop;
  loop.delay = 4;
  const Recording recording = simulated(loop);
  const LadderResult a = run_ladder(recording);
  const LadderResult b = run_ladder(recording);
  EXPECT_EQ(a.quality.rmse, b.quality.rmse);
  EXPECT_EQ(a.model.effect_codes(), b.model.effect_codes());
}

TEST(Ladder, ModelsAMeasuredValvePosition) {
  SetpointLoop loop;
  loop.valve = test::backlash(3);
  const Recording recording = simulated(loop);
  LadderOptions options;
  options.output = Column::x;
  const LadderResult result = run_ladder(recording, options);
  EXPECT_EQ(result.model.output, Column::x);
  EXPECT_TRUE(result.model.has("valve.backlash"));
}

TEST(Ladder, JudgesAnotherRecordingByItsInitialStateAlone) {
  const Recording first = simulated({});
  SetpointLoop other;
  other.seed = 1001;
  const Recording second = simulated(other);
  const Model model = start_model(first, Column::y).model;
  EXPECT_NEAR(compare(second, model).quality.rmse, 0.2, 0.04);
}

TEST(Ladder, GivesTheSameAnswerWithAnyNumberOfThreads) {
  SetpointLoop loop;
  loop.delay = 4;
  const Recording recording = simulated(loop);
  const LadderResult one = run_ladder(recording);
  const Work many({.threads = 4});
  LadderOptions options;
  options.work = &many;
  const LadderResult four = run_ladder(recording, options);
  ASSERT_EQ(one.steps.size(), four.steps.size());
  for (std::size_t i = 0; i < one.steps.size(); ++i) {
    EXPECT_EQ(one.steps[i].effect, four.steps[i].effect);
    EXPECT_EQ(one.steps[i].rmse_validation, four.steps[i].rmse_validation);
  }
  EXPECT_EQ(one.quality.rmse, four.quality.rmse);
  EXPECT_TRUE(one.complete);
}

TEST(Explain, TellsOfTheModelItselfHoweverShortTheTime) {
  const Recording recording = simulated(SetpointLoop{});
  const Model model = start_model(recording, Column::y).model;
  const Work work({.seconds = 1e-6});
  const ExplainResult result = explain(recording, model, {}, standard_catalogue(), work);
  EXPECT_FALSE(result.complete);
  EXPECT_FALSE(result.explained);
  EXPECT_GT(result.rmse, 0);
}

TEST(Ladder, GivesTheBestSoFarWhenTheTimeIsUp) {
  const Recording recording = simulated(SetpointLoop{});
  const Work work({.seconds = 1e-6});
  LadderOptions options;
  options.work = &work;
  const LadderResult result = run_ladder(recording, options);
  EXPECT_FALSE(result.complete);
  EXPECT_FALSE(result.explained);
  EXPECT_EQ(result.steps.size(), 1U);
  EXPECT_GT(result.quality.rmse, 0);
}

TEST(Ladder, NamesAMeasuredLoad) {
  SetpointLoop loop;
  Recording recording = simulated(loop);
  std::vector<double> feed(recording.size());
  for (std::size_t k = 0; k < feed.size(); ++k) feed[k] = (k / 97) % 2 == 0 ? 3 : 7;
  for (std::size_t k = 0; k < feed.size(); ++k) recording.y[k] += 2 * (feed[k] - 3);
  recording.loads = {{"FI-201", "m3/h", feed}};
  const ExplainResult result =
      explain(recording, start_model(recording, Column::y).model);
  ASSERT_NE(result.best(), nullptr);
  EXPECT_EQ(result.best()->effect, "disturbance.measured:FI-201");
  EXPECT_NE(standard_catalogue().find("disturbance.measured:FI-201"), nullptr);
  EXPECT_EQ(standard_catalogue().find("disturbance.measured:"), nullptr);
}

// Asked of a load that never moves, no fit says anything.
TEST(Explain, AcceptsNoLoadThatNeverMoves) {
  SetpointLoop loop;
  Recording recording = simulated(loop);
  recording.loads = {{"TI-7", "K", std::vector<double>(recording.size(), 293.0)},
                     {"FI-201", "m3/h", recording.sp}};
  const ExplainResult result =
      explain(recording, start_model(recording, Column::y).model);
  EXPECT_NE(candidate(result, "disturbance.measured:TI-7").status,
            CandidateStatus::kAccepted);
}

// Two lags behind a first value, and where they have come to.
class TwoLags {
 public:
  TwoLags(double first, double second) : first_(first), second_(second) {}
  double operator()(double in) {
    y_ += (z_ - y_) / second_;
    z_ += (in - z_) / first_;
    return y_;
  }

 private:
  double first_;
  double second_;
  double z_ = 0;
  double y_ = 0;
};

// Four moves of each; what is fitted without the load takes part of it for lags.
TEST(Explain, NamesAMeasuredLoadThatMovesNearlyAsUDoes) {
  Recording recording;
  recording.name = "heater.csv";
  recording.period_s = 2;
  TwoLags own(60, 15);
  TwoLags beside(45, 25);
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal(0, 0.05);
  std::vector<double> q;
  for (std::size_t k = 0; k < 500; ++k) {
    recording.t.push_back(2 * static_cast<double>(k));
    recording.u.push_back(k < 10 ? 0 : k < 150 ? 80 : k < 300 ? 20 : k < 450 ? 70 : 50);
    q.push_back(k < 50 ? 0 : k < 150 ? 35 : k < 250 ? 95 : k < 350 ? 25 : 100);
    recording.y.push_back(20 + 0.5 * own(recording.u[k]) + 0.2 * beside(q[k]) +
                          normal(random));
  }
  recording.loads = {{"q2", "%", q}};
  const Model model = start_model(recording, Column::y, {"process.second_lag"}).model;
  const ExplainResult result = explain(recording, model);
  ASSERT_NE(result.best(), nullptr);
  EXPECT_EQ(result.best()->effect, "disturbance.measured:q2");
  EXPECT_TRUE(result.best()->with.empty());
  EXPECT_LT(result.best()->rmse_after, 0.06);
}

}  // namespace
}  // namespace workbench
