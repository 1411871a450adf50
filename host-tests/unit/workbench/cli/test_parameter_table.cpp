// The numbers of an effect, as a terminal shows them.
#include <gtest/gtest.h>

#include <string>

#include "workbench/cli/parameter_table.hpp"

namespace workbench::cli {
namespace {

bool holds(const std::string& text, const std::string& what) {
  return text.find(what) != std::string::npos;
}

// 655 s, of at most 690.
EffectTerm late(double high) {
  return {.effect = "process.dead_time",
          .parameters = {{.name = "dead_time",
                          .unit = "s",
                          .value = 655,
                          .low = 326,
                          .high = high,
                          .bound_low = 0,
                          .bound_high = 690}}};
}

TEST(ParameterTable, ATimeThatOnlyTheSearchBoundsIsOpenAbove) {
  const std::string open = effect_table(late(690), 2);
  EXPECT_TRUE(holds(open, "326 and above")) << open;
  EXPECT_TRUE(holds(open, "reaches the edge of its physical range")) << open;
  const std::string closed = effect_table(late(680), 2);
  EXPECT_TRUE(holds(closed, "326 to 680")) << closed;
  EXPECT_EQ(notes_on(late(680), 2), "");
}

TEST(ParameterTable, ALimitOrARateThatNothingReachesIsNotAValue) {
  const Parameter rate{.name = "opening_rate",
                       .unit = "u/s",
                       .value = 741,
                       .low = 17.6,
                       .high = 741,
                       .bound_low = 0.1,
                       .bound_high = 741};
  const std::string told = parameter_table({rate}, 2);
  EXPECT_TRUE(holds(told, "not reached")) << told;
  EXPECT_TRUE(holds(told, "above 17.6")) << told;
  EXPECT_FALSE(holds(told, "741")) << told;
}

TEST(ParameterTable, InstantsAreCountedFromTheStart) {
  const Parameter end{.name = "end", .unit = "s", .value = 1.84};
  EXPECT_TRUE(holds(parameter_table({end}, 2), "end_from_start"));
}

TEST(ParameterTable, WhatAnIntervalLeavesOpenIsSaid) {
  EffectTerm spills{.effect = "process.overflow",
                    .parameters = {{.name = "spill_share",
                                    .unit = "1",
                                    .value = 1,
                                    .low = 0,
                                    .high = 1,
                                    .bound_low = 0,
                                    .bound_high = 1}}};
  EXPECT_TRUE(holds(notes_on(spills, 2), "Not told: spill_share"));
  EffectTerm by_flow = late(680);
  by_flow.parameters.push_back({.name = "by_flow", .unit = "1", .value = 1});
  by_flow.parameters.push_back(
      {.name = "flow_ratio", .unit = "1", .value = 0.7, .low = 0.6, .high = 1.3});
  EXPECT_TRUE(holds(notes_on(by_flow, 2), "flow_ratio may as well be 1"));
  by_flow.parameters.back().high = 0.9;
  EXPECT_EQ(notes_on(by_flow, 2), "");
  by_flow.untold = true;
  EXPECT_TRUE(holds(notes_on(by_flow, 2), "Uncertain"));
}

}  // namespace
}  // namespace workbench::cli
