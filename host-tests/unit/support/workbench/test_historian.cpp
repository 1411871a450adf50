#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "support/workbench/historian.hpp"

namespace workbench::test {
namespace {

using Signal = std::vector<double>;

Signal wave(std::size_t samples) {
  Signal signal;
  for (std::size_t t = 0; t < samples; ++t) {
    signal.push_back(std::sin(0.1 * static_cast<double>(t)));
  }
  return signal;
}

TEST(Historian, BoxcarHoldsUntilAValueDiffersEnough) {
  EXPECT_EQ(boxcar({0, 0.5, 1, 1.5, 1.6, 0}, 1, 100), (Signal{0, 0, 0, 1.5, 1.5, 0}));
}

TEST(Historian, BoxcarStoresAtTheLatestAfterTheLongestTime) {
  EXPECT_EQ(boxcar({0, 1, 2, 3, 4}, 10, 2), (Signal{0, 0, 2, 2, 4}));
}

TEST(Historian, SwingingDoorKeepsALine) {
  const Signal line{0, 1, 2, 3, 4, 5};
  EXPECT_EQ(swinging_door(line, 0.1), line);
}

TEST(Historian, SwingingDoorStaysWithinItsDeviationOnFewStraightPieces) {
  const Signal signal = wave(500);
  const Signal stored = swinging_door(signal, 0.05);
  int corners = 0;
  for (std::size_t t = 1; t + 1 < signal.size(); ++t) {
    EXPECT_LE(std::abs(stored[t] - signal[t]), 0.05 + 1e-12);
    corners += std::abs(stored[t + 1] - 2 * stored[t] + stored[t - 1]) > 1e-9 ? 1 : 0;
  }
  EXPECT_GT(corners, 10);
  EXPECT_LT(corners, 100);
}

TEST(Historian, QuantiseRoundsToMultiples) {
  EXPECT_EQ(quantise({0.1, 0.3, -0.6}, 0.5), (Signal{0, 0.5, -0.5}));
}

TEST(Historian, EverySecondThinsAllSignalsAndKeepsTheTime) {
  SimulatedLoop loop;
  loop.period_s = 3;
  loop.t = {0, 3, 6, 9};
  loop.u = loop.y = loop.sp = loop.x = loop.y_clean = {1, 3, 5, 9};
  SimulatedLoop means = loop;
  every_second(loop, false);
  EXPECT_EQ(loop.t, (Signal{0, 6}));
  EXPECT_EQ(loop.x, (Signal{1, 5}));
  EXPECT_EQ(loop.period_s, 6);
  every_second(means, true);
  EXPECT_EQ(means.u, (Signal{2, 7}));
}

TEST(Historian, JitterOfAHeldSignalReadsAValueItHad) {
  Random random("jitter", 1);
  const Signal signal{1, 2, 3, 4, 5, 6};
  const Signal held = jitter(random, signal, 0.5, true);
  for (std::size_t t = 1; t < signal.size(); ++t) {
    EXPECT_TRUE(held[t] == signal[t] || held[t] == signal[t - 1]);
  }
  const Signal lines = jitter(random, signal, 0.5, false);
  for (std::size_t t = 1; t + 1 < signal.size(); ++t) {
    EXPECT_LE(std::abs(lines[t] - signal[t]), 0.5);
  }
}

TEST(Historian, LeavesTheTruthAsItIs) {
  SimulatedLoop loop;
  loop.t = loop.u = loop.y = loop.sp = loop.x = loop.y_clean = wave(300);
  for (const Historian historian : {Historian::kBoxcar, Historian::kSwingingDoor,
                                    Historian::kQuantised, Historian::kJitter}) {
    SimulatedLoop recorded = loop;
    Random random("record", 1);
    record(random, historian, recorded);
    EXPECT_EQ(recorded.x, loop.x) << name(historian);
    EXPECT_EQ(recorded.sp, loop.sp) << name(historian);
    EXPECT_NE(recorded.y, loop.y) << name(historian);
  }
}

}  // namespace
}  // namespace workbench::test
