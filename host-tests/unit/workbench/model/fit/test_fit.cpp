// Fits: start, extend, without, apply; and the searches and intervals below them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/base/joined.hpp"
#include "workbench/model/base/least_squares.hpp"
#include "workbench/model/base/work.hpp"
#include "workbench/model/fit/fit.hpp"
#include "workbench/model/fit/parameter_search.hpp"
#include "workbench/model/judge/fitted_model.hpp"
#include "workbench/model/judge/intervals.hpp"
#include "workbench/model/judge/off_profile.hpp"
#include "workbench/recording/input_error.hpp"

namespace workbench {
namespace {

using test::SetpointLoop;
using test::simulated;

TEST(Fitter, FindsTheTextbookProcess) {
  const Recording recording = simulated({});
  const Fitter fitter(recording, Column::y);
  const Fit fit = fitter.start({});
  EXPECT_NEAR(*fit.process_value("first_lag"), 20, 1);
  EXPECT_EQ(fit.columns[0].name, "gain");
  EXPECT_NEAR(fit.coefficients[0], 2, 0.05);
  EXPECT_NEAR(fitter.rmse(fit), 0.2, 0.02);
  EXPECT_NEAR(fitter.rmse_on(fit, false), 0.2, 0.02);
}

TEST(Fitter, AFitStaysUnderItsNoiseColour) {
  const Recording recording = simulated({});
  const Fitter fitter(recording, Column::y);
  Fit from = fitter.start({});
  EXPECT_EQ(from.judged().data(), from.residual.data());
  from.weight = {1, -0.5};
  const Fit fit = fitter.refine(from);
  EXPECT_EQ(fit.weight, from.weight);
  EXPECT_NEAR(*fit.process_value("first_lag"), 20, 1);
  EXPECT_NEAR(fit.judged()[500], fit.residual[500] - 0.5 * fit.residual[499], 1e-12);
  EXPECT_NEAR(fit.error, sum_of_squares(fit.judged(), fitter.blocks().blocks()),
              1e-9 * fit.error);
  EXPECT_EQ(model_of(fitter, fit).noise, from.weight);
}

// On the way up a lag as long as the recording, from a state far away, takes the shape of
// the curve, and u need have no part in it; where u falls back at the end it fails.
TEST(Fitter, TakesNoFreeBeginningForTheProcess) {
  Recording recording;
  recording.period_s = 1;
  double y = 0;
  for (int k = 0; k < 600; ++k) {
    const double u = k < 570 ? 1 + 30 * (k / 60) : 0;
    recording.t.push_back(k);
    recording.u.push_back(u);
    recording.y.push_back(y + 0.5 * std::sin(7.0 * k * k));
    y += 0.2 * (100 * std::sqrt(std::max(u - 40, 0.0)) - y);
  }
  const Fitter fitter(recording, Column::y);
  const Fit fit = fitter.start({});
  EXPECT_NEAR(*fit.process_value("first_lag"), 5, 2);
  EXPECT_NEAR(fit.coefficients[0], 6, 1);
}

// A load moves y, and u answers it at once: seen from u, y is the controller upside down.
TEST(Fitter, TakesNoControllerUpsideDownForTheProcess) {
  SetpointLoop loop;
  loop.setpoint_moves = false;
  loop.load = [](std::size_t k) { return 6 * std::sin(double(k) / 9); };
  const Recording recording = simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Fit fit = fitter.start({});
  EXPECT_GE(fit.coefficients[0], 0);
  EXPECT_GE(intervals_of(fitter, fit).solved[0].low, 0);
}

TEST(Fitter, ExtendsByDeadTimeAndGoesBack) {
  SetpointLoop loop;
  loop.delay = 6;
  const Recording recording = simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Fit start = fitter.start({});
  const auto longer =
      fitter.extend(start, effects::process_dead_time(), Effort::kThorough);
  ASSERT_TRUE(longer);
  EXPECT_LT(longer->error, 0.5 * start.error);
  EXPECT_NEAR(longer->searched_of(effects::process_dead_time())[0], 6, 0.3);
  const Fit back = fitter.without(*longer, effects::process_dead_time());
  EXPECT_NEAR(back.error, start.error, 0.02 * start.error);
}

TEST(Fitter, GoesOnFromWhatAScreeningSaw) {
  const Recording recording = simulated({});
  const Fitter fitter(recording, Column::y);
  const Fit start = fitter.start({});
  const auto extended = [&](Effort effort, ScreenedStarts* seen) {
    return fitter.extend(start, effects::valve_backlash(), effort, 1e300, seen)->error;
  };
  ScreenedStarts seen;
  (void)extended(Effort::kScreen, &seen);
  EXPECT_EQ(extended(Effort::kThorough, &seen), extended(Effort::kThorough, nullptr));
}

TEST(Fitter, IntervalsCoverTheTruthInAboutNineteenOfTwenty) {
  int covered = 0;
  constexpr int kLoops = 60;
  for (int i = 0; i < kLoops; ++i) {
    SetpointLoop loop;
    loop.seed = static_cast<std::uint64_t>(1000 + i);
    const Recording recording = simulated(loop);
    const Fitter fitter(recording, Column::y);
    const Fit fit = fitter.start({});
    const FitIntervals intervals = intervals_of(fitter, fit);
    covered += intervals.searched[1].low <= 20 && intervals.searched[1].high >= 20;
    covered += intervals.solved[0].low <= 2 && intervals.solved[0].high >= 2;
  }
  EXPECT_GE(covered, 2 * kLoops * 88 / 100);
}

TEST(Fitter, TakesAnEffectOutAndLeavesTheRestAsItIs) {
  SetpointLoop loop;
  loop.load = [](std::size_t k) { return k < 500 ? 0.0 : 4.0; };
  loop.delay = 6;
  const Recording recording = simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Effect& step = effects::disturbance_step();
  const Fit both = fitter.start({&effects::process_dead_time(), &step});
  const Fit rest = fitter.less(both, step);
  ASSERT_EQ(rest.effects.size(), 1u);
  EXPECT_EQ(rest.process_value("first_lag"), both.process_value("first_lag"));
  ASSERT_EQ(rest.columns[0].name, "gain");
  EXPECT_EQ(rest.coefficients[0], both.coefficients[0]);
  // What is left over is the step itself.
  EXPECT_NEAR(rest.residual[1000] - rest.residual[300], 4, 1);
  EXPECT_LT(fitter.without(both, step).error, rest.error);
}

TEST(Fitter, FindsTheSameInEitherOrder) {
  SetpointLoop loop;
  loop.valve = test::backlash(6);
  loop.load = [](std::size_t k) { return k < 500 ? 0.0 : 4.0; };
  const Recording recording = simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Effect& play = effects::valve_backlash();
  const Effect& step = effects::disturbance_step();
  const Fit one = fitter.start({&play, &step});
  const Fit other = fitter.start({&step, &play});
  EXPECT_NEAR(one.error / other.error, 1, 1e-3);
  EXPECT_EQ(one.effects, (std::vector<const Effect*>{&play, &step}));
  EXPECT_NEAR(one.searched_of(play)[0], 6, 0.6);
}

TEST(Fitter, SaysWhatIsWrongWithARecording) {
  Recording recording = simulated({});
  recording.x.clear();
  EXPECT_THROW(Fitter(recording, Column::x), InputError);
  Recording still = simulated({});
  std::fill(still.u.begin(), still.u.end(), 5.0);
  EXPECT_THROW(Fitter(still, Column::y), InputError);
  SetpointLoop loop;
  loop.samples = 30;
  const Recording brief = simulated(loop);
  EXPECT_THROW(Fitter(brief, Column::y), InputError);
}

TEST(Fitter, SeesALagAsLongAsTheFirst) {
  SetpointLoop loop;
  double level = 0;
  bool begun = false;
  loop.sensor = [&](double y) {
    level = begun ? y + std::exp(-1.0 / loop.lag_s) * (level - y) : y;
    begun = true;
    return level;
  };
  const Recording recording = simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Effect& lag = effects::process_second_lag();
  const Fit fit = fitter.start({&lag});
  EXPECT_TRUE(excludes_off(fitter, fit, intervals_of(fitter, fit), lag));
}

TEST(Search, NeverLeavesTheBoundsNorGetsWorse) {
  const Recording recording = simulated({});
  const Fitter fitter(recording, Column::y);
  const Fit fit = fitter.start({});
  const Situation situation = fitter.situation(fit);
  FreeRun run(situation, fitter.blocks(), {&effects::valve_stiction()});
  std::vector<double> p;
  for (const FreeRun::Slot& slot : run.slots()) p.push_back(slot.parameter.high * 2);
  const SearchPoint start = evaluate(run, p);
  for (const SearchPoint& point : {descend(run, start, 5), pattern(run, start, 50)}) {
    EXPECT_LE(point.error, start.error);
    for (std::size_t i = 0; i < p.size(); ++i) {
      const SearchedParameter& parameter = run.slots()[i].parameter;
      if (parameter.constant) continue;
      EXPECT_GE(point.p[i], parameter.low);
      EXPECT_LE(point.p[i], parameter.high * (1 + 1e-12));
    }
  }
  EXPECT_TRUE(has_jumpy(run));
}

TEST(Search, LooksAroundWithinTheBoundsBestFirst) {
  const Recording recording = simulated({});
  const Fitter fitter(recording, Column::y);
  const Situation situation = fitter.situation(fitter.start({}));
  FreeRun run(situation, fitter.blocks(), {&effects::valve_stiction()});
  ASSERT_TRUE(has_trades(run));
  std::vector<double> p;
  for (const FreeRun::Slot& slot : run.slots()) {
    p.push_back(std::lerp(slot.parameter.low, slot.parameter.high, 0.3));
  }
  const std::vector<SearchPoint> points = around(run, evaluate(run, p), 5);
  ASSERT_EQ(points.size(), 5u);
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (k > 0) {
      EXPECT_LE(points[k - 1].error, points[k].error);
    }
    for (std::size_t i = 0; i < p.size(); ++i) {
      const SearchedParameter& parameter = run.slots()[i].parameter;
      if (parameter.constant) continue;
      EXPECT_GE(points[k].p[i], parameter.low);
      EXPECT_LE(points[k].p[i], parameter.high * (1 + 1e-12));
    }
  }
  FreeRun plain(situation, fitter.blocks(), {&effects::valve_backlash()});
  EXPECT_FALSE(has_trades(plain));
}

TEST(FreeRun, SimulatesTheSameAgainWhateverRanBetween) {
  const Recording recording = simulated({});
  const Fitter fitter(recording, Column::y);
  const Fit fit = fitter.start({&effects::valve_backlash()});
  const Situation situation = fitter.situation(fit);
  FreeRun run(situation, fitter.blocks(), fit.effects);
  const double first = run.run(fit.p);
  std::vector<double> other = fit.p;
  other[run.first_slot(effects::valve_backlash())] *= 3;
  EXPECT_NE(run.run(other), first);
  EXPECT_EQ(run.run(fit.p), first);
  EXPECT_EQ(fit.error, first);
}

TEST(FreeRun, KnowsNotWhatWasUnderwayAtTheFirstSample) {
  SetpointLoop loop;
  loop.delay = 12;
  Recording recording = simulated(loop);
  constexpr std::ptrdiff_t kAfterAStep = 404;
  for (std::vector<double>* column : {&recording.t, &recording.u, &recording.y}) {
    column->erase(column->begin(), column->begin() + kAfterAStep);
  }
  const Fitter fitter(recording, Column::y);
  const Fit fit = fitter.start({&effects::process_dead_time()});
  EXPECT_NEAR(fit.searched_of(effects::process_dead_time())[0], 12, 0.3);
  EXPECT_NEAR(fitter.rmse(fit), loop.noise_std, 0.1 * loop.noise_std);
}

TEST(FreeRun, LeavesNothingOfTheGainBehindARounding) {
  SetpointLoop loop;
  loop.sensor = [](double y) { return 4 * std::round(y / 4); };
  const Recording recording = simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Fit fit = fitter.start({&effects::sensor_quantisation()});
  const Situation situation = fitter.situation(fit);
  FreeRun run(situation, fitter.blocks(), fit.effects);
  const double error = run.run(fit.p);
  double common = 0;
  double power = 0;
  for (std::size_t k = 0; k < fit.residual.size(); ++k) {
    if (!fitter.blocks().estimation()[k]) continue;
    common += run.residual()[k] * run.column(0)[k];
    power += run.column(0)[k] * run.column(0)[k];
  }
  EXPECT_LT(std::abs(common), 0.05 * std::sqrt(power * error));
}

TEST(FreeRun, CutsTheOutputOffAboveTheLevel) {
  SetpointLoop loop;
  loop.sensor = [](double y) { return std::min(y, 55.0); };
  const Recording recording = simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Fit fit = fitter.start({&effects::process_overflow()});
  for (std::size_t k = 0; k < fit.residual.size(); ++k) {
    EXPECT_LE(recording.y[k] - fit.residual[k],
              fit.searched_of(effects::process_overflow())[0] + 1e-9);
  }
  EXPECT_NEAR(fit.searched_of(effects::process_overflow())[0], 55, 0.3);
}

TEST(Fitter, GivesEachPieceAnInitialStateAndAllOneProcess) {
  SetpointLoop loop;
  loop.seed = 1;
  Recording first = simulated(loop);
  loop.seed = 2;
  Recording second = simulated(loop);
  // Cut where the process is far from where its u would hold it.
  for (Column column : {Column::t, Column::u, Column::y, Column::sp, Column::x}) {
    auto& values = second.values(column);
    values.erase(values.begin(), values.begin() + 217);
  }
  second.name = "second.csv";
  const Recording both = joined({first, second});
  const Fitter fitter(both, Column::y);
  const Fit fit = fitter.start({});
  EXPECT_NEAR(*fit.process_value("first_lag"), 20, 1);
  EXPECT_NEAR(fit.coefficients[0], 2, 0.05);
  EXPECT_NEAR(fitter.rmse(fit), 0.2, 0.02);
  const Model model = model_of(fitter, fit);
  ASSERT_EQ(model.initial_state.size(), 3U);
  EXPECT_EQ(model.initial_state[0].name, "first_lag_state");
  EXPECT_EQ(model.initial_state[1].name, "level_2");
  EXPECT_NEAR(model.initial_state[1].value, 0, 0.2);
  EXPECT_EQ(model.initial_state[2].name, "first_lag_state_2");
  EXPECT_TRUE(fitter.fitted_to_this(model));
  EXPECT_EQ(model.fitted.name, "loop.csv, second.csv");
  const Fit again = fitter.apply(model, standard_catalogue());
  EXPECT_NEAR(again.error, fit.error, 1e-6 * fit.error);
}

// A load that nobody recorded, another one each day.
TEST(Fitter, LetsEachRecordingStandOnALevelOfItsOwn) {
  SetpointLoop loop;
  const Recording first = simulated(loop);
  loop.seed = 2;
  Recording second = simulated(loop);
  for (double& y : second.y) y += 7;
  second.name = "second.csv";
  const Recording both = joined({first, second});
  const Fitter fitter(both, Column::y);
  const Fit fit = fitter.start({});
  EXPECT_NEAR(fitter.rmse(fit), 0.2, 0.02);
  EXPECT_NEAR(fit.coefficients[0], 2, 0.05);
  EXPECT_NEAR(model_of(fitter, fit).initial_state[1].value, 7, 0.2);
}

TEST(Fitter, FitsNothingToAPieceThatJudgesButItsInitialState) {
  SetpointLoop loop;
  const Recording alone = simulated(loop);
  loop.seed = 2;
  loop.lag_s = 40;
  loop.valve = test::backlash(3);
  Recording other = simulated(loop);
  other.name = "other.csv";
  const Recording judged = joined({alone}, {other});
  Recording unlike = other;
  for (double& y : unlike.y) y = 3 * y - 20;
  const Recording judged_otherwise = joined({alone}, {unlike});
  const Fitter fitter(judged, Column::y);
  const Fitter fitter_otherwise(judged_otherwise, Column::y);
  const Fit fit = fitter.start({&effects::process_dead_time()});
  const Fit otherwise = fitter_otherwise.start({&effects::process_dead_time()});
  EXPECT_TRUE(fitter.is_judged());
  EXPECT_EQ(fit.p, otherwise.p);
  EXPECT_EQ(fit.error, otherwise.error);
  EXPECT_LT(fitter.rmse(fit), 0.25);
  EXPECT_GT(fitter.rmse_on(fit, false), 0.5);
  EXPECT_EQ(model_of(fitter, fit).fitted.samples, alone.size());
}

TEST(Fitter, SpendsAShareOfSamplesThatDoesNotDependOnTheClock) {
  const Recording recording = simulated({});
  const Fitter fitter(recording, Column::y);
  const std::uint64_t all = fitter.samples_left();
  Work::spend(1000);
  EXPECT_EQ(fitter.samples_left(), all - 1000);
  EXPECT_TRUE(fitter.affordable());
  Work::spend(all);
  EXPECT_EQ(fitter.samples_left(), 0u);
  EXPECT_FALSE(fitter.affordable());
  EXPECT_EQ(Fitter(recording, Column::y).samples_left(), all) << "each has its own";
}

// After the first move no other one is wider than the gap: any width up to that explains.
TEST(OffEdges, APlayThatNoReversalCrossesDoesNotRestOnItsBound) {
  constexpr double kLevels[] = {50, 60, 53, 59, 55, 61, 54, 58};
  const Recording recording = test::stepped(kLevels, test::backlash(9));
  const Fitter fitter(recording, Column::y);
  const Effect& play = effects::valve_backlash();
  const auto fit = fitter.extend(fitter.start({}), play, Effort::kThorough);
  ASSERT_TRUE(fit);
  const Situation situation = fitter.situation(*fit);
  FreeRun run(situation, fitter.blocks(), fit->effects);
  std::vector<double> p = fit->p;
  const std::size_t deadband = run.first_slot(play);
  const SearchedParameter& parameter = run.slots()[deadband].parameter;
  p[deadband] = parameter.high;
  const SearchPoint edge = evaluate(run, p);
  const SearchPoint inside = off_edges(run, edge);
  EXPECT_EQ(edge_of(parameter, edge.p[deadband]), Edge::kHigh);
  EXPECT_EQ(edge_of(parameter, inside.p[deadband]), Edge::kNone);
  EXPECT_LT(inside.error, 1.01 * edge.error);
}

TEST(FreeRun, WhatWasRunLastIsNotSimulatedAgain) {
  const Recording recording = simulated({});
  const Fitter fitter(recording, Column::y);
  const Fit fit = fitter.start({});
  const Situation situation = fitter.situation(fit);
  FreeRun run(situation, fitter.blocks(), fit.effects);
  const double error = run.run(fit.p);
  const std::uint64_t before = Work::spent();
  EXPECT_EQ(run.run(fit.p), error);
  EXPECT_EQ(Work::spent(), before);
  const std::vector<double> none(run.columns().size(), 0.0);
  EXPECT_GT(run.run_with(fit.p, none, FreeRun::Rows::kEstimation), error);
  EXPECT_EQ(run.run(fit.p), error);
  EXPECT_GT(Work::spent(), before);
}

TEST(AtEdge, ATankThatRunsEmptyIsPhysicsACurveWithoutEndIsNot) {
  const Recording recording = simulated({});
  const Fitter fitter(recording, Column::y);
  const Effect& gain = effects::process_nonlinear_gain();
  Fit fit = fitter.start({&gain});
  const auto set = [&](std::string_view name, double value) {
    for (std::size_t i = 0; i < fit.p.size(); ++i) {
      if (fit.slots[i].parameter.name == name) fit.p[i] = value;
    }
  };
  constexpr double kCurve = 1;
  constexpr double kHead = 2;
  set("lag_follows_gain", kCurve);
  set("curvature", 3);
  EXPECT_FALSE(at_edge(fit, gain));
  set("curvature", 7);
  EXPECT_TRUE(at_edge(fit, gain));
  set("lag_follows_gain", kHead);
  EXPECT_FALSE(at_edge(fit, gain));
}

// One that followed the whole of u behind its stop would leave it late.
TEST(Fit, ASlowStemLeavesItsStopAtOnce) {
  const std::vector<double> levels = {50, 85, 50, 20, 55, 75, 40, 60, 25, 50};
  const Recording recording = test::stepped(levels, [x = 50.0](double u) mutable {
    x += std::clamp(std::clamp(u, 35.0, 65.0) - x, -0.5, 0.5);
    return x;
  });
  const Fitter fitter(recording, Column::y);
  const Effect& rate = effects::valve_rate_limit();
  const Fit fit = fitter.start({&effects::valve_saturation(), &rate});
  EXPECT_NEAR(fit.searched_of(rate)[0], 0.5, 0.02);
  EXPECT_NEAR(fit.searched_of(rate)[1], 0.5, 0.02);
  EXPECT_LT(fitter.rmse(fit), 0.15);
}

}  // namespace
}  // namespace workbench
