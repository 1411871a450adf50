// One identification for whoever asks, by a thread of its own or by the one that asks.
#include <gtest/gtest.h>

#include <stop_token>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/model/search/identified.hpp"

namespace workbench {
namespace {

using test::SetpointLoop;
using test::simulated;

Recording recorded_play() {
  SetpointLoop loop;
  loop.samples = 2400;
  loop.valve = test::backlash(6);
  return simulated(loop);
}

TEST(Identified, SaysTheSameFromAThreadOfItsOwn) {
  const Recording recording = recorded_play();
  int told = 0;
  Identified asked({recording}, [&told](int, int) { ++told; });
  Identified begun({recording});
  begun.begin();
  const Identification& one = asked.result(Work::unlimited());
  const Identification& other = begun.result(Work::unlimited());
  EXPECT_EQ(one.verdict, other.verdict);
  EXPECT_EQ(one.detectable_band, other.detectable_band);
  EXPECT_GT(told, 0);
  EXPECT_EQ(&one, &asked.result(Work::unlimited())) << "identified twice";
}

TEST(Identified, EndsWhereAStopIsAskedForAndGoesOnFromTheBeginning) {
  const Recording recording = recorded_play();
  std::stop_source stop;
  stop.request_stop();
  const Work stopped({.stop = stop.get_token()});
  Identified asked({recording});
  EXPECT_THROW((void)asked.result(stopped), Stopped);
  EXPECT_NE(asked.result(Work::unlimited()).verdict, ident::Verdict::kUndecided);
  Identified begun({recording});
  begun.begin();
  EXPECT_THROW((void)begun.result(stopped), Stopped);
}

TEST(Identified, GivesUpWhatNobodyWaitsFor) {
  Identified begun({recorded_play()});
  begun.begin();
}

}  // namespace
}  // namespace workbench
