// What to know about a model before its numbers are used.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/model/tell/cautions.hpp"

namespace workbench {
namespace {

// The only one, and whether it says so.
bool caution_says(const std::vector<std::string>& cautions, std::string_view what) {
  return cautions.size() == 1 && cautions[0].find(what) != std::string::npos;
}

FitQuality fit_of(double percent, bool follows_u = false) {
  FitQuality out;
  out.fit_percent = percent;
  out.output_follows_u = follows_u;
  return out;
}

Model with_lag(double lag_s) {
  Parameter lag{.name = "first_lag", .unit = "s", .value = lag_s};
  lag.bound_low = 0.1;
  lag.bound_high = 500;
  Model model;
  model.process = {lag};
  return model;
}

TEST(Cautions, SaysNothingOfAFitInsideItsBounds) {
  EXPECT_TRUE(cautions(with_lag(120), {}, fit_of(80), false).empty());
}

TEST(Cautions, ALagAsLongAsTheRecordingMayBeAnIntegrator) {
  EXPECT_TRUE(caution_says(cautions(with_lag(500), {}, fit_of(80), false),
                           "never settle (process.integrating)"));
}

TEST(Cautions, AFactOfTheRecordMayBeBesideThePoint) {
  Candidate best{.effect = "sensor.quantisation"};
  best.error_reduction_percent = 0.1;
  EXPECT_TRUE(is_beside_the_point(best));
  best.error_reduction_percent = 40;
  EXPECT_FALSE(is_beside_the_point(best));
  best.effect = "process.dead_time";
  best.error_reduction_percent = 0.1;
  EXPECT_FALSE(is_beside_the_point(best)) << "it was accepted for what it explains";
}

TEST(Cautions, AFitThatAConstantReachesIsSaid) {
  EXPECT_TRUE(
      caution_says(cautions(with_lag(120), {}, fit_of(-2.4), false), "a constant"));
  EXPECT_TRUE(caution_says(cautions(Model{}, {}, fit_of(4.9), false), "a constant"));
  EXPECT_TRUE(cautions(Model{}, {}, fit_of(5.1), false).empty());
}

TEST(Cautions, AGainThatMayBeNoneIsSaid) {
  Model model = with_lag(120);
  model.process.push_back({.name = "gain", .value = 0.1, .low = -0.1, .high = 0.3});
  EXPECT_TRUE(may_lack_gain(model));
  EXPECT_TRUE(caution_says(cautions(model, {}, fit_of(80), false), "holds 0"));
  EXPECT_TRUE(tells_nothing(model, fit_of(80)));
  model.process.back().low = 0.05;
  EXPECT_FALSE(may_lack_gain(model));
  EXPECT_TRUE(cautions(model, {}, fit_of(80), false).empty());
}

// A lag that is longer than the recording may be told only together with its gain.
TEST(Cautions, AnOutputThatFollowsUIsNotSaidToFollowNothing) {
  Model model = with_lag(120);
  model.process.push_back({.name = "gain", .value = 0.1, .low = -0.1, .high = 0.3});
  EXPECT_FALSE(tells_nothing(model, fit_of(80, true)));
  const std::vector<std::string> said = cautions(model, {}, fit_of(80, true), false);
  EXPECT_TRUE(caution_says(said, "although the output follows u"));
  EXPECT_FALSE(caution_says(said, "if at all"));
  EXPECT_TRUE(tells_nothing(model, fit_of(2, true)));
}

TEST(Cautions, AModelOfALoopThatOnlyItsControllerMovesMayBeThatOfTheController) {
  Recording recording;
  double sum = 0;
  for (std::size_t k = 0; k < 400; ++k) {
    const double y = std::sin(0.1 * static_cast<double>(k)) > 0 ? 2 : -1;
    sum += y;
    recording.t.push_back(static_cast<double>(k));
    recording.y.push_back(50 + y);
    recording.u.push_back(40 - 0.5 * y - 0.02 * sum);
  }
  EXPECT_TRUE(is_left_to_controller(Model{}, recording));
  Model with_stem;
  with_stem.effects = {{.effect = "valve.stiction"}};
  EXPECT_FALSE(is_left_to_controller(with_stem, recording));
  for (std::size_t k = 200; k < 400; ++k) recording.u[k] += 5;
  EXPECT_FALSE(is_left_to_controller(Model{}, recording)) << "something else moves u";
  EXPECT_TRUE(
      caution_says(cautions(Model{}, {}, fit_of(97), true), "change the setpoint"));
}

TEST(Cautions, AGainWithWhichTheLoopWouldRunAwayIsSaid) {
  Recording recording;
  double sum = 0;
  for (std::size_t k = 0; k < 400; ++k) {
    const auto t = static_cast<double>(k);
    const double y = std::sin(0.1 * t) + std::sin(0.37 * t);
    sum += y;
    recording.t.push_back(t);
    recording.y.push_back(50 + y);
    recording.u.push_back(40 - 0.5 * y - 0.05 * sum + 0.2 * std::sin(1.7 * t));
  }
  Model turned;
  turned.process = {{.name = "gain", .value = -2, .low = -2.2, .high = -1.8}};
  EXPECT_FALSE(would_run_away(turned, recording)) << "no setpoint is known";
  recording.sp.assign(400, 50);
  EXPECT_TRUE(would_run_away(turned, recording));
  EXPECT_TRUE(
      caution_says(cautions(turned, recording, fit_of(60), false), "gain of this sign"));
  turned.process = {{.name = "gain", .value = 2, .low = 1.8, .high = 2.2}};
  EXPECT_FALSE(would_run_away(turned, recording));
  recording.sp.back() = 51;
  turned.process = {{.name = "gain", .value = -2, .low = -2.2, .high = -1.8}};
  EXPECT_FALSE(would_run_away(turned, recording)) << "the setpoint moves";
}

}  // namespace
}  // namespace workbench
