// The verdict on the valve beside the model of the loop.
#include <gtest/gtest.h>

#include "workbench/model/tell/reconciled.hpp"

namespace workbench {
namespace {

using ident::Verdict;

class Reconciled : public ::testing::Test {
 protected:
  // A model with `effects`, of which explain() says that `missing` is missing.
  std::string said(Verdict verdict, const std::vector<std::string>& effects,
                   const std::string& missing) {
    model_.effects.clear();
    for (const std::string& effect : effects) model_.effects.push_back({effect, {}});
    Candidate candidate;
    candidate.effect = missing;
    return reconciled(verdict, model_, missing.empty() ? nullptr : &candidate);
  }

  Model model_;
};

TEST_F(Reconciled, SaysNothingWhereVerdictAndModelAgree) {
  for (const Verdict fault : {Verdict::kStiction, Verdict::kBacklash}) {
    EXPECT_EQ(said(fault, {"valve.backlash", "valve.stiction"}, ""), "");
  }
  EXPECT_EQ(said(Verdict::kStiction, {}, "valve.stiction"), "");
  EXPECT_EQ(said(Verdict::kBacklash, {}, "valve.backlash"), "");
  EXPECT_EQ(said(Verdict::kBacklash, {"valve.backlash"}, ""), "");
  EXPECT_EQ(said(Verdict::kStiction, {"valve.stiction"}, "process.dead_time"), "");
  for (const Verdict none : {Verdict::kNoStiction, Verdict::kUndecided}) {
    EXPECT_EQ(said(none, {}, "process.dead_time"), "");
    EXPECT_EQ(said(none, {"sensor.lag"}, ""), "");
  }
}

TEST_F(Reconciled, SaysHowBothAreMeantWhereTheyDisagree) {
  const std::vector<std::string> all = {said(Verdict::kStiction, {}, ""),
                                        said(Verdict::kStiction, {}, "process.dead_time"),
                                        said(Verdict::kNoStiction, {}, "valve.stiction"),
                                        said(Verdict::kUndecided, {"valve.stiction"}, ""),
                                        said(Verdict::kStiction, {"valve.backlash"}, "")};
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_FALSE(all[i].empty());
    for (std::size_t k = 0; k < i; ++k) EXPECT_NE(all[i], all[k]);
  }
  EXPECT_EQ(said(Verdict::kNoStiction, {"valve.backlash"}, ""), all[2]);
  EXPECT_EQ(said(Verdict::kBacklash, {"valve.stiction"}, ""), all[4]);
  EXPECT_EQ(said(Verdict::kBacklash, {}, "valve.stiction"), all[4]);
  EXPECT_EQ(said(Verdict::kStiction, {}, "valve.backlash"), all[4]);
}

TEST_F(Reconciled, SaysWhereBothFindAStemOfAnotherBand) {
  ident::Identification<double> found;
  found.verdict = Verdict::kStiction;
  found.stick_band.ascending = {true, 5, 4.1, 5.6};
  found.stick_band.descending = {true, 5, 4.1, 5.6};
  Candidate missing;
  missing.effect = "valve.stiction";
  missing.parameters = {{"stick_band_ascending", "u", 3.7, 3.5, 4.2},
                        {"stick_band_descending", "u", 3.7, 3.5, 4.2}};
  EXPECT_EQ(reconciled(found, model_, &missing), "");
  missing.parameters[1].high = 3.9;
  EXPECT_EQ(
      reconciled(found, model_, &missing),
      "The verdict puts the stick band at 4.1 to 5.6 in u, the model at 3.5 to 3.9: "
      "what the model still lacks bends one of them. Small steps of u in manual "
      "tell.");
  model_.effects = {{"valve.stiction", missing.parameters}};
  EXPECT_NE(reconciled(found, model_, nullptr), "");
}

TEST_F(Reconciled, KnowsWhereTheModelHasNoneOfTheVerdictsStems) {
  const auto lacks = [this](Verdict verdict, const std::vector<std::string>& effects,
                            const std::string& missing) {
    static_cast<void>(said(verdict, effects, missing));
    Candidate candidate;
    candidate.effect = missing;
    return lacks_stem(verdict, model_, missing.empty() ? nullptr : &candidate);
  };
  for (const Verdict fault : {Verdict::kStiction, Verdict::kBacklash}) {
    EXPECT_TRUE(lacks(fault, {}, ""));
    EXPECT_TRUE(lacks(fault, {"process.dead_time"}, "sensor.lag"));
    EXPECT_FALSE(lacks(fault, {"valve.backlash"}, ""));
    EXPECT_FALSE(lacks(fault, {}, "valve.stiction"));
  }
  EXPECT_FALSE(lacks(Verdict::kNoStiction, {}, ""));
  EXPECT_FALSE(lacks(Verdict::kUndecided, {"process.dead_time"}, ""));
}

TEST_F(Reconciled, SaysFirstThatTheRecordingMisleads) {
  ident::Identification<double> found;
  EXPECT_EQ(reconciled(found, model_, nullptr), "");
  found.reason = ident::Reason::kSeam;
  EXPECT_EQ(reconciled(found, model_, nullptr), ident::sentence(found.reason));
  found.reason = ident::Reason::kSignalsSwapped;
  EXPECT_EQ(reconciled(found, model_, nullptr), ident::sentence(found.reason));
}

TEST_F(Reconciled, DoesNotCountWhatDidNotLowerTheError) {
  model_.history = {{"valve.stiction", "a.csv", 1, 0.9, 1, 1.02}};
  EXPECT_NE(said(Verdict::kStiction, {"valve.backlash", "valve.stiction"}, ""), "");
  EXPECT_EQ(said(Verdict::kNoStiction, {"valve.stiction"}, ""), "");
}

}  // namespace
}  // namespace workbench
