// What a load hides from the free run, and one sample ahead tells.
#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "support/workbench/wandering_load.hpp"
#include "workbench/model/search/ladder.hpp"
#include "workbench/model/search/told_ahead.hpp"
#include "workbench/model/tell/model_json.hpp"

namespace workbench {
namespace {

using test::WanderingLoad;

Recording without_column(const WanderingLoad& of) {
  Recording out = test::recorded_under(of);
  out.loads.clear();
  return out;
}

Recording late() {
  WanderingLoad of;
  of.delay = 6;
  return without_column(of);
}

double value_of(const Model& model, std::string_view effect, std::string_view name) {
  const auto term = std::ranges::find(model.effects, effect, &EffectTerm::effect);
  const Parameter* parameter =
      term != model.effects.end() ? find(term->parameters, name) : nullptr;
  return parameter != nullptr ? parameter->value : -1;
}

TEST(ToldAhead, NamesADeadTimeUnderALoadThatWanders) {
  const Recording recording = late();
  const ExplainResult found = explain(recording, start_model(recording, Column::y).model);
  ASSERT_NE(found.best(), nullptr);
  EXPECT_EQ(found.best()->effect, "process.dead_time");
  ASSERT_TRUE(found.best()->ahead);
  EXPECT_LT(found.best()->ahead->after, found.best()->ahead->before);
  EXPECT_GT(found.best()->nats_ahead, 8);
  EXPECT_NE(found.best()->evidence.find("one sample ahead"), std::string::npos);
}

TEST(ToldAhead, NamesNothingWhereNothingIsHidden) {
  for (const unsigned seed : {1U, 2U, 3U, 4U}) {
    WanderingLoad of;
    of.seed = seed;
    const Recording recording = without_column(of);
    const ExplainResult found =
        explain(recording, start_model(recording, Column::y).model);
    EXPECT_TRUE(found.best() == nullptr || !found.best()->ahead) << seed;
  }
}

TEST(ToldAhead, WhatIsAddedIsWhatWasExplained) {
  const Recording recording = late();
  const Model start = start_model(recording, Column::y).model;
  const FittedModel with = add_effect(recording, start, "process.dead_time");
  ASSERT_TRUE(with.model.history.back().ahead);
  EXPECT_NEAR(value_of(with.model, "process.dead_time", "dead_time"), 6, 0.5);
  EXPECT_FALSE(with.model.noise.empty());
}

TEST(ToldAhead, AFileKeepsTheModelAsItWasFound) {
  const Recording recording = late();
  const Model model =
      add_effect(recording, start_model(recording, Column::y).model, "process.dead_time")
          .model;
  const Model read = parse_model(model_json(model).dump(), "m.json");
  EXPECT_EQ(read.noise, model.noise);
  ASSERT_TRUE(read.history.back().ahead);
  EXPECT_EQ(read.history.back().ahead->after, model.history.back().ahead->after);
  const Fitter fitter(recording, Column::y);
  const Fit again = fitter.refine(fitter.apply(read, standard_catalogue()));
  EXPECT_NEAR(again.searched_of(*standard_catalogue().find("process.dead_time"))[0],
              value_of(model, "process.dead_time", "dead_time"), 0.1);
}

TEST(ToldAhead, ItIsTheLastStepOfALadder) {
  const LadderResult result = run_ladder(late());
  ASSERT_EQ(result.steps.size(), 2U);
  EXPECT_EQ(result.steps.back().effect, "process.dead_time");
  EXPECT_TRUE(result.steps.back().ahead);
  EXPECT_EQ(result.last.best(), nullptr);
}

TEST(ToldAhead, AColumnThatOnlyWandersAsTheLoadDoesIsNotNamed) {
  int named = 0;
  for (const unsigned seed : {1U, 2U, 3U, 4U}) {
    WanderingLoad of;
    of.seed = seed;
    const Recording recording = test::recorded_under(of);
    const ExplainResult found =
        explain(recording, start_model(recording, Column::y).model);
    named += found.best() != nullptr && found.best()->effect.ends_with(":column");
  }
  EXPECT_EQ(named, 0);
}

TEST(ToldAhead, AColumnThatMovesTheOutputIs) {
  WanderingLoad of;
  of.column_gain = 5;
  const Recording recording = test::recorded_under(of);
  const ExplainResult found = explain(recording, start_model(recording, Column::y).model);
  ASSERT_NE(found.best(), nullptr);
  EXPECT_EQ(found.best()->effect, "disturbance.measured:column");
}

}  // namespace
}  // namespace workbench
