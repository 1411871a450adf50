#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/base/recordings.hpp"
#include "support/oracle/nats.hpp"
#include "support/real_loads/loads.hpp"
#include "support/real_loads/loop.hpp"
#include "workbench/recording/statistics.hpp"
#include "workbench/simulate/cycles.hpp"
#include "workbench/simulate/noise.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace workbench::test {
namespace {

// Stands for recordings where only the drawing of loops matters.
std::vector<RealLoad> made_up_loads() {
  std::vector<RealLoad> loads;
  for (int i = 0; i < 4; ++i) {
    Random random("load", static_cast<std::uint64_t>(i));
    const std::string name = "load-" + std::to_string(i);
    loads.push_back({name, name, coloured_noise(random, 800, 0.95, 3)});
  }
  return loads;
}

double nats_of(const SimulatedLoop& loop) {
  return oracle_nats(loop.y, loop.u, loop.x);
}

TEST(OracleNats, HighForASimulatedStickingLoopLowForAHealthyOne) {
  for (std::uint64_t seed = 1001; seed < 1006; ++seed) {
    EXPECT_GT(nats_of(*simulate("stiction", seed)), kLeastOracleNats) << seed;
    EXPECT_LT(nats_of(*simulate("healthy-positioner", seed)), kLeastOracleNats) << seed;
    EXPECT_EQ(nats_of(*simulate("random-load", seed)), 0) << seed;
  }
}

TEST(OracleNats, AConstantOutputTellsNothing) {
  const std::vector<double> flat(200, 1.0);
  const std::vector<double> moves = made_up_loads()[0].values;
  EXPECT_EQ(oracle_nats(flat, std::span(moves).first(200), flat), 0);
}

TEST(CutLoad, HasNoLineAndUnitSizeAtAnyStretch) {
  const RealLoad load = made_up_loads()[0];
  for (const double stretch : {0.3, 1.0, 4.0}) {
    Random random("cut", 7);
    const std::vector<double> cut = cut_load(random, load, 1500, stretch);
    ASSERT_EQ(cut.size(), 1500u);
    EXPECT_NEAR(mean_of(cut), 0, 1e-9);
    EXPECT_NEAR(std_of(cut), 1, 1e-9);
    double lean = 0;
    for (std::size_t t = 0; t < cut.size(); ++t) lean += static_cast<double>(t) * cut[t];
    EXPECT_NEAR(lean / 1500, 0, 1e-6);
  }
}

TEST(CutLoad, AStretchThatDoesNotMoveIsNoLoad) {
  Random random("cut", 7);
  EXPECT_TRUE(
      cut_load(random, {"flat", "flat", std::vector<double>(500, 3.0)}, 300, 1).empty());
}

TEST(RealLoadLoop, RefusesToDrawWithoutLoads) {
  EXPECT_THROW((void)real_load_loop(LoopKind::kSticking, 1, {}), std::invalid_argument);
}

TEST(RealLoadLoop, TheSameSeedGivesTheSameLoop) {
  const auto loads = made_up_loads();
  for (const LoopKind kind : {LoopKind::kSticking, LoopKind::kHealthy}) {
    const RealLoadLoop first = real_load_loop(kind, 1001, loads);
    const RealLoadLoop again = real_load_loop(kind, 1001, loads);
    EXPECT_EQ(first.recorded.u, again.recorded.u);
    EXPECT_EQ(first.recorded.y, again.recorded.y);
    EXPECT_EQ(truth_json(first), truth_json(again));
    EXPECT_NE(first.recorded.u, real_load_loop(kind, 1002, loads).recorded.u);
  }
}

TEST(RealLoadLoop, StickingLoopsAreWithinTheirRangesAndAnOracleIsSure) {
  const auto loads = made_up_loads();
  for (std::uint64_t seed = 1001; seed < 1009; ++seed) {
    const auto [recorded, truth] = real_load_loop(LoopKind::kSticking, seed, loads);
    EXPECT_GE(recorded.u.size(), 600u);
    EXPECT_LE(recorded.u.size(), 4000u);
    EXPECT_GE(truth.cycles, 5);
    EXPECT_LE(truth.cycles, 60);
    EXPECT_GE(truth.oracle_nats, kLeastOracleNats);
    EXPECT_GT(truth.band_over_swing, 0);
    EXPECT_NE(truth.motion, "none");
    EXPECT_GT(recorded.truth.stick_band_ascending + recorded.truth.stick_band_descending,
              0);
    for (const auto* signal : {&recorded.y, &recorded.sp, &recorded.x, &recorded.t}) {
      EXPECT_EQ(signal->size(), recorded.u.size());
    }
  }
}

TEST(RealLoadLoop, HealthyLoopsMoveAndTheOracleSeesNoStem) {
  const auto loads = made_up_loads();
  for (std::uint64_t seed = 1001; seed < 1009; ++seed) {
    const auto [recorded, truth] = real_load_loop(LoopKind::kHealthy, seed, loads);
    EXPECT_GT(swing_of(recorded.u), 0);
    EXPECT_LE(truth.oracle_nats, 1e-6);
    EXPECT_EQ(recorded.truth.kind, "no_stiction");
    EXPECT_EQ(recorded.truth.stick_band_ascending, 0);
  }
}

TEST(RealLoads, AreReadFromTheRecordings) {
  const std::string missing = ::test::why_unusable(
      std::filesystem::path(STICKBAND_RECORDINGS) / "isdb" / "CHEM13.csv");
  if (!missing.empty()) GTEST_SKIP() << missing;
  const auto loads = read_real_loads(STICKBAND_RECORDINGS);
  EXPECT_GT(loads.size(), 40u);
  bool chem13 = false;
  for (const RealLoad& load : loads) {
    chem13 = chem13 || load.name == "isdb/CHEM13";
    EXPECT_NE(load.name, "isdb/CHEM1");         // labelled as sticking
    EXPECT_NE(load.name, "oscillation/CHEM9");  // not oscillating, but known to stick
    EXPECT_GT(load.values.size(), 100u) << load.name;
  }
  EXPECT_TRUE(chem13);
  const RealLoadLoop loop = real_load_loop(LoopKind::kSticking, 1001, loads);
  EXPECT_GE(loop.truth.oracle_nats, kLeastOracleNats);
}

TEST(RealLoads, AreNoneWhereTheRecordingsAreAbsent) {
  EXPECT_TRUE(read_real_loads("/nonexistent").empty());
}

}  // namespace
}  // namespace workbench::test
