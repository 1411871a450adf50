// What to know about a model before its numbers are used.
#include <gtest/gtest.h>

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

Model with_lag(double lag_s) {
  Parameter lag{.name = "first_lag", .unit = "s", .value = lag_s};
  lag.bound_low = 0.1;
  lag.bound_high = 500;
  Model model;
  model.process = {lag};
  return model;
}

TEST(Cautions, SaysNothingOfAFitInsideItsBounds) {
  EXPECT_TRUE(cautions(with_lag(120), 80).empty());
}

TEST(Cautions, ALagAsLongAsTheRecordingMayBeAnIntegrator) {
  EXPECT_TRUE(caution_says(cautions(with_lag(500), 80), "try process.integrating"));
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
  EXPECT_TRUE(caution_says(cautions(with_lag(120), -2.4), "a constant"));
  EXPECT_TRUE(caution_says(cautions(Model{}, 4.9), "a constant"));
  EXPECT_TRUE(cautions(Model{}, 5.1).empty());
}

}  // namespace
}  // namespace workbench
