// What a technician does about what a model lacks.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "workbench/model/tell/what_to_do.hpp"

namespace workbench {
namespace {

Candidate second_lag() {
  Candidate out;
  out.effect = "process.second_lag";
  out.status = CandidateStatus::kAccepted;
  out.cures = {"Tune for both lags."};
  out.harmless = true;
  return out;
}

using Sentences = std::vector<std::string>;

TEST(WhatToDo, NothingIsBrokenWhereNoFaultLooksAlike) {
  EXPECT_EQ(what_to_do(second_lag(), false),
            (Sentences{"Nothing is broken.", "Tune for both lags."}));
}

TEST(WhatToDo, NothingIsSaidToBeWholeBesideAFaultOfTheValve) {
  EXPECT_EQ(what_to_do(second_lag(), true), Sentences{"Tune for both lags."});
  Candidate worn = second_lag();
  worn.harmless = false;
  EXPECT_EQ(what_to_do(worn, false), Sentences{"Tune for both lags."});
}

TEST(WhatToDo, WhatLooksAlikeIsToldApartFirst) {
  Candidate one_of_two = second_lag();
  one_of_two.indistinguishable_from = {"valve.positioner_lag"};
  one_of_two.would_split = "log the stem position";
  EXPECT_EQ(what_to_do(one_of_two, false),
            (Sentences{"First find out which it is: log the stem position. The "
                       "following is for a second process lag.",
                       "Tune for both lags."}));
  one_of_two.would_split = "does y settle?";
  one_of_two.with = {"process.dead_time"};
  one_of_two.cures.emplace_back("Look for transport.");
  EXPECT_EQ(what_to_do(one_of_two, false),
            (Sentences{"First find out which it is: does y settle? The following is "
                       "for the effects that are named first.",
                       "Tune for both lags.", "Look for transport."}));
}

}  // namespace
}  // namespace workbench
