// What to know about a model before its numbers are used.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "workbench/model/tell/cautions.hpp"

namespace workbench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Model with_lag(double lag_s) {
  Parameter lag{.name = "first_lag", .unit = "s", .value = lag_s};
  lag.bound_low = 0.1;
  lag.bound_high = 500;
  Model model;
  model.process = {lag};
  return model;
}

TEST(Cautions, SaysNothingOfAFitInsideItsBounds) {
  EXPECT_THAT(cautions(with_lag(120), 80), IsEmpty());
}

TEST(Cautions, ALagAsLongAsTheRecordingMayBeAnIntegrator) {
  EXPECT_THAT(cautions(with_lag(500), 80),
              ElementsAre(HasSubstr("try an integrating process")));
}

TEST(Cautions, AFitThatAConstantReachesIsSaid) {
  EXPECT_THAT(cautions(with_lag(120), -2.4), ElementsAre(HasSubstr("a constant")));
  EXPECT_THAT(cautions(Model{}, 4.9), ElementsAre(HasSubstr("a constant")));
  EXPECT_THAT(cautions(Model{}, 5.1), IsEmpty());
}

}  // namespace
}  // namespace workbench
