#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "ident/window_survey.hpp"
#include "support/ident/pi_loop.hpp"

namespace ident {
namespace {

constexpr std::size_t kSurveySamples = 1200;
constexpr double kTwoPi = 6.283185307179586;

/// A PI controller (Kc 0.8, Ki 0.05 a sample) around a lag, moved by a load of 60
/// samples' period; gain +1 or −1. With `steps` of the setpoint, which is known then.
struct SurveyLoop {
  explicit SurveyLoop(double gain, double steps = 0) {
    double state = 0;
    double law = 0;
    for (std::size_t t = 0; t < kSurveySamples; ++t) {
      const double load = std::sin(kTwoPi * static_cast<double>(t) / 60);
      const double wanted = t / 85 % 2 == 0 ? 0 : steps;
      if (steps > 0) sp.push_back(20 + wanted);
      const double measured = state + load - wanted;
      law -= 0.05 * measured / gain;
      u.push_back(50 + law - 0.8 * measured / gain);
      y.push_back(20 + measured + wanted);
      state += (gain * (u.back() - 50) - state) / 15;
    }
  }
  std::vector<double> u, y, sp;
};

struct Survey {
  explicit Survey(SurveyLoop of, int told = 0) : loop(std::move(of)) {
    const auto survey = std::make_unique<WindowSurvey<double>>();
    std::vector<double> scratch(loop.u.size());
    ascending.resize(scratch.size());
    survey->start({loop.u, loop.y, loop.sp, ascending, scratch, told});
    while (!survey->step(result)) {
      ++pieces;
    }
    refusal = survey->refusal();
    of_u = survey->of_u();
    of_y = survey->of_y();
    movement = survey->movement();
  }
  SurveyLoop loop;
  std::vector<unsigned char> ascending;
  Identification<double> result;
  Reason refusal = Reason::kNone;
  SignalScale<double> of_u, of_y;
  Movement<double> movement;
  int pieces = 0;
};

TEST(WindowSurvey, MeasuresRhythmScaleAndMovement) {
  const Survey survey{SurveyLoop(1)};
  EXPECT_EQ(survey.refusal, Reason::kNone);
  EXPECT_TRUE(survey.result.oscillation.detected);
  EXPECT_NEAR(survey.movement.period, 60, 1);
  EXPECT_NEAR(survey.result.cycles, 20, 1);
  const auto [low, high] =
      std::minmax_element(survey.loop.u.begin(), survey.loop.u.end());
  EXPECT_DOUBLE_EQ(*low, 0);
  EXPECT_DOUBLE_EQ(*high, 1);
}

TEST(WindowSurvey, LeadsBackToTheSamples) {
  for (const double gain : {1.0, -1.0}) {
    const SurveyLoop before(gain);
    const Survey survey{before};
    for (std::size_t t = 0; t < kSurveySamples; ++t) {
      ASSERT_NEAR(survey.of_u.back(survey.loop.u[t]), before.u[t], 1e-9);
      ASSERT_NEAR(survey.of_y.back(survey.loop.y[t]), before.y[t], 1e-9);
    }
  }
}

// u acts one sample later: what follows it at once can only be itself.
TEST(WindowSurvey, RefusesAnOutputThatIsTheControllers) {
  for (const double noise : {0.0, 0.001, 0.1}) {
    SurveyLoop copied(1);
    for (std::size_t t = 0; t < kSurveySamples; ++t) {
      copied.y[t] = copied.u[t] + (t % 2 == 0 ? noise : -noise);
    }
    EXPECT_EQ(Survey{copied}.refusal,
              noise < 0.1 ? Reason::kSignalsSwapped : Reason::kNone);
  }
  SurveyLoop late(1);
  std::copy(late.u.begin(), late.u.end() - 1, late.y.begin() + 1);
  late.y[0] = late.u[0];
  EXPECT_EQ(Survey{late}.refusal, Reason::kNone);
}

TEST(WindowSurvey, RefusesWhatTheControllerNeverSaw) {
  SurveyLoop exchanged(1);
  std::swap(exchanged.u, exchanged.y);
  const Survey swapped{exchanged};
  EXPECT_TRUE(swapped.result.health.swapped);
  EXPECT_EQ(swapped.refusal, Reason::kSignalsSwapped);

  SurveyLoop joined(1);
  for (std::size_t t = kSurveySamples / 2; t < kSurveySamples; ++t) {
    joined.u[t] += 50;
    joined.y[t] += 50;
  }
  const Survey seam{joined};
  EXPECT_EQ(seam.result.health.seam_at, kSurveySamples / 2);
  EXPECT_EQ(seam.refusal, Reason::kSeam);

  test::PiLoop loop;
  loop.sensor = test::sticking(0.5);
  const test::LoopRecord record = test::run(loop, kSurveySamples, 1);
  SurveyLoop held(1);
  held.u = record.u;
  held.y = record.y;
  const Survey sensor{held};
  EXPECT_EQ(sensor.refusal, Reason::kSensorSticks);
  EXPECT_EQ(sensor.result.cause, Cause::kSensor);
}

TEST(WindowSurvey, ReadsTheSignFromTheControllersLaw) {
  const Survey direct{SurveyLoop(1)};
  EXPECT_EQ(direct.result.gain_sign, 1);
  EXPECT_NEAR(direct.result.controller.proportional, 0.8, 0.05);
  EXPECT_NEAR(direct.result.controller.integral, 0.05, 0.01);
  const Survey reverse{SurveyLoop(-1)};
  EXPECT_EQ(reverse.result.gain_sign, -1);
  EXPECT_LT(reverse.of_y.factor, 0);
}

// It answers the error, in which a setpoint that moves is the larger part here.
TEST(WindowSurvey, ReadsTheLawOfALoopWhoseSetpointMoves) {
  const SurveyLoop moved(1, 5);
  const Survey survey{moved};
  EXPECT_NEAR(survey.result.controller.proportional, 0.8, 0.05);
  EXPECT_NEAR(survey.result.controller.integral, 0.05, 0.01);
  EXPECT_TRUE(survey.result.loop.law_known);
}

// Steps by hand tell no law: the sign is that with which u explains y.
TEST(WindowSurvey, FindsTheSignOfALoopInManual) {
  for (const double gain : {2.0, -2.0}) {
    test::Random random(3);
    SurveyLoop manual(1);
    double state = 0;
    for (std::size_t t = 0; t < kSurveySamples; ++t) {
      manual.u[t] = t / 70 % 2 == 0 ? 40 : 44;
      state += (gain * manual.u[t] - state) / 15;
      manual.y[t] = state + 0.2 * test::normal(random);
    }
    const Survey survey{manual};
    EXPECT_FALSE(survey.result.loop.law_known);
    EXPECT_EQ(survey.result.gain_sign, gain > 0 ? 1 : -1);
    EXPECT_EQ(survey.of_y.factor > 0, gain > 0);
    EXPECT_TRUE(survey.result.evidence.by_hand);
  }
  EXPECT_FALSE(Survey{SurveyLoop(1)}.result.evidence.by_hand);
}

TEST(WindowSurvey, MarksTheDirectionOfU) {
  const SurveyLoop loop(1);
  const Survey survey{loop};
  std::size_t right = 0;
  for (std::size_t t = 1; t < kSurveySamples; ++t) {
    right += (survey.ascending[t] == 1) == (loop.u[t] > loop.u[t - 1]);
  }
  EXPECT_GT(right, kSurveySamples * 95 / 100);
  EXPECT_NEAR(survey.result.evidence.reversals, 2 * survey.result.cycles, 2);
}

TEST(WindowSurvey, LooksAtTheShapeOfU) {
  const SurveyLoop loop(1);
  const Survey survey{loop};
  EXPECT_TRUE(survey.result.loop.oscillates);
  EXPECT_EQ(survey.result.loop.regularity, survey.result.oscillation.regularity);
  EXPECT_EQ(survey.result.loop.cycles, survey.result.cycles);
  EXPECT_NEAR(survey.result.loop.kurtosis, 1.5, 0.05);
}

// At a limit for long, or with its crests alone.
TEST(WindowSurvey, MeasuresHowLongUIsAtItsLimits) {
  test::Random random(4);
  SurveyLoop loop(1);
  for (double& u : loop.u) u += 0.01 * test::normal(random);
  EXPECT_EQ(Survey{loop}.result.loop.limit_share, 0);
  const double crest = *std::max_element(loop.u.end() - 60, loop.u.end());
  for (const double limit : {crest - 0.3, crest - 0.015}) {
    SurveyLoop limited = loop;
    std::size_t resting = 0;
    for (double& u : limited.u) {
      resting += u >= limit;
      u = std::min(u, limit);
    }
    EXPECT_NEAR(Survey{limited}.result.loop.limit_share,
                static_cast<double>(resting) / kSurveySamples, 1e-9);
  }
}

// Swings of irregular length on a wave four times as high; they are no drift without it.
TEST(WindowSurvey, KnowsSwingsOnADrift) {
  for (const double wave : {0.0, 16.0}) {
    test::Random random(5);
    SurveyLoop drifting(1);
    double state = 0;
    double side = 4;
    std::size_t turn = 0;
    for (std::size_t t = 0; t < kSurveySamples; ++t) {
      if (t == turn) {
        side = -side;
        turn += static_cast<std::size_t>(test::uniform(random, 10, 90));
      }
      state += (side - state) / 5;
      drifting.u[t] = 50 + state + wave * std::sin(kTwoPi * static_cast<double>(t) / 900);
      drifting.y[t] = drifting.u[t] + test::normal(random);
    }
    const Survey survey{drifting};
    if (wave > 0) {
      EXPECT_FALSE(survey.result.oscillation.detected);
    }
    EXPECT_EQ(survey.result.evidence.drifts, wave > 0) << survey.movement.swing;
  }
}

TEST(WindowSurvey, ToldIsToldWhateverTheLaw) {
  EXPECT_EQ(Survey(SurveyLoop(1), -1).result.gain_sign, -1);
}

TEST(WindowSurvey, RefusesWhatDoesNotMove) {
  SurveyLoop still(1);
  std::fill(still.u.begin(), still.u.end(), 3.0);
  const Survey constant{still};
  EXPECT_EQ(constant.refusal, Reason::kConstant);
  EXPECT_EQ(constant.of_y.factor, 1);
  EXPECT_EQ(constant.loop.y, still.y);
}

TEST(WindowSurvey, RefusesOneStroke) {
  SurveyLoop stroke(1);
  for (std::size_t t = 0; t < kSurveySamples; ++t) {
    stroke.u[t] = static_cast<double>(t);
    stroke.y[t] = std::sqrt(static_cast<double>(t));
  }
  EXPECT_EQ(Survey(stroke).refusal, Reason::kOneStroke);
}

TEST(WindowSurvey, MeasuresTheStepsOfARecordedLattice) {
  SurveyLoop rounded(1);
  for (double& u : rounded.u) u = 0.05 * std::round(u / 0.05);
  for (double& y : rounded.y) y = 0.08 * std::round(y / 0.08);
  const Survey survey{rounded};
  ASSERT_EQ(survey.refusal, Reason::kNone);
  const LoopEvidence<double>& loop = survey.result.loop;
  EXPECT_NEAR(loop.u_step * survey.movement.swing, 0.05 / survey.of_u.factor, 1e-9);
  EXPECT_NEAR(loop.y_step * kSwingOfUnit<double>, 0.08 / survey.of_y.factor, 1e-9);
  const Survey fine{SurveyLoop(1)};
  EXPECT_LT(fine.result.loop.u_step, 1e-4);
  EXPECT_LT(fine.result.loop.y_step, 1e-4);
}

}  // namespace
}  // namespace ident
