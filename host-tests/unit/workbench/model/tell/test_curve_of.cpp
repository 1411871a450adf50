// The curve that an effect of a model bends the signal of the valve along.
#include <gtest/gtest.h>

#include "workbench/model/tell/curve_of.hpp"

namespace workbench {
namespace {

EffectTerm characteristic(double free_shape) {
  EffectTerm term{"valve.characteristic", {}};
  const char* names[] = {"curvature", "from",   "to",     "free_shape", "bend_1",
                         "bend_2",    "bend_3", "bend_4", "bend_5"};
  const double values[] = {2, 20, 80, free_shape, 0, 0, 0, 0, 0};
  for (std::size_t i = 0; i < 9; ++i) {
    term.parameters.push_back({names[i], "1", values[i]});
  }
  return term;
}

TEST(CurveOf, ACharacteristicHasOneInWords) {
  const EffectTerm term = characteristic(0);
  const auto curve = curve_of(term.effect, term.parameters);
  ASSERT_TRUE(curve);
  EXPECT_NE(curve->words.find("equal-percentage"), std::string::npos);
  EXPECT_FALSE(curve_of("valve.saturation", term.parameters));
  EXPECT_FALSE(curve_of("no.such", term.parameters));
}

TEST(CurveOf, WhatTheCurveTellsBetterIsNotToldTwice) {
  const std::vector<Parameter> simple = told_parameters(characteristic(0));
  ASSERT_EQ(simple.size(), 3u);
  EXPECT_EQ(simple[0].name, "curvature");
  const std::vector<Parameter> free = told_parameters(characteristic(1));
  ASSERT_EQ(free.size(), 2u);
  EXPECT_EQ(free[0].name, "from");
  const EffectTerm other{"valve.saturation", {{"upper_limit", "u", 80}}};
  EXPECT_EQ(told_parameters(other).size(), 1u);
}

TEST(CurveOf, ALoadThatStaysHasNoEnd) {
  EffectTerm term{"disturbance.step", {{"time", "s", 5}, {"passing"}, {"end", "s", 9}}};
  EXPECT_EQ(told_parameters(term).size(), 2u);
  term.parameters[1].value = 1;
  EXPECT_EQ(told_parameters(term).size(), 3u);
}

TEST(CurveOf, ADeadTimeThatIsTheSameEverywhereIsToldAlone) {
  const EffectTerm term{
      "process.dead_time",
      {{"dead_time", "s", 5}, {"by_flow"}, {"flow_ratio", "1", 1}, {"flow_from", "u"}}};
  EXPECT_EQ(told_parameters(term).size(), 1u);
  EXPECT_FALSE(is_idle(term, "dead_time"));
  EXPECT_TRUE(is_idle(term, "flow_to"));
}

}  // namespace
}  // namespace workbench
