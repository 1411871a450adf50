#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "ident/evidence/evidence_pool.hpp"

namespace ident {
namespace {

constexpr double kSpan = 100;
constexpr int kRung = 30;

std::unique_ptr<Ladder<double>> ladder_of(double nats, int rung = kRung) {
  auto ladder = std::make_unique<Ladder<double>>();
  (*ladder)[static_cast<std::size_t>(rung)] = nats;
  return ladder;
}

TEST(EvidencePool, KnowsNothingBeforeTheFirstWindow) {
  const LadderFinding<double> found = EvidencePool().finding(kSpan);
  EXPECT_EQ(found.predicted, 0U);
  EXPECT_EQ(found.nats, 0);
  EXPECT_EQ(found.band, 0);
}

TEST(EvidencePool, AddsUpWhatWindowsSayOfOneBand) {
  EvidencePool pool;
  pool.add(*ladder_of(20), 500);
  pool.add(*ladder_of(30), 500);
  const LadderFinding<double> found = pool.finding(kSpan);
  EXPECT_NEAR(found.nats, 50 - std::log(1000), 0.2);
  EXPECT_DOUBLE_EQ(found.band, rung_band(kRung, kSpan));
  EXPECT_LT(found.low, found.band);
  EXPECT_GT(found.high, found.band);
  EXPECT_EQ(pool.windows(), 2);
}

// How far the stem slips is another question than how wide the band is.
TEST(EvidencePool, KnowsTheBandOfValvesThatSlipInOtherWays) {
  EvidencePool pool;
  auto ladder = ladder_of(20);
  (*ladder)[kRungs + kRung] = 19.5;
  pool.add(*ladder, 500);
  const LadderFinding<double> one = pool.finding(kSpan);
  EXPECT_NEAR(one.high / one.low, kRungRatio, 1e-9);
  (*ladder)[kRungs + kRung + 1] = (*ladder)[kRung - 2] = 19.5;
  EvidencePool wide;
  wide.add(*ladder, 500);
  const LadderFinding<double> some = wide.finding(kSpan);
  EXPECT_NEAR(some.high / one.high, kRungRatio, 1e-9);
  EXPECT_NEAR(one.low / some.low, kRungRatio * kRungRatio, 1e-9);
}

TEST(EvidencePool, CountsNoMoreSamplesThanFourBytesHold) {
  const EvidencePool::Memory memory{.windows = 1e7F, .predicted = 5e9F};
  const LadderFinding<float> found = EvidencePool(memory).finding(float{kSpan});
  EXPECT_EQ(found.predicted, std::size_t{1} << 31);
}

TEST(EvidencePool, IsTheSameAfterItsMemoryWasKept) {
  EvidencePool pool;
  pool.add(*ladder_of(20), 500, 0.5F);
  EvidencePool again(pool.memory());
  for (EvidencePool* each : {&pool, &again}) {
    each->fade(0.9F);
    each->add(*ladder_of(30), 500);
  }
  EXPECT_EQ(again.finding(kSpan).nats, pool.finding(kSpan).nats);
  EXPECT_EQ(again.finding(kSpan).predicted, pool.finding(kSpan).predicted);
  EXPECT_EQ(again.windows(), pool.windows());
}

TEST(EvidencePool, TakesWindowsThatWantDifferentBandsAgainstBoth) {
  EvidencePool pool;
  for (int window = 0; window < 4; ++window) {
    auto ladder = std::make_unique<Ladder<double>>();
    ladder->fill(-20);
    (*ladder)[static_cast<std::size_t>(20 + 5 * window)] = 30;
    pool.add(*ladder, 500);
  }
  EXPECT_LT(pool.finding(kSpan).nats, 0);
}

TEST(EvidencePool, CountsOverlappingWindowsByTheirNewSamples) {
  EvidencePool pool;
  for (int window = 0; window < 4; ++window) pool.add(*ladder_of(40), 500, 0.25F);
  EXPECT_NEAR(pool.finding(kSpan).nats, 40 - std::log(500), 0.2);
  EXPECT_NEAR(pool.windows(), 1, 1e-6);
}

TEST(EvidencePool, ForgetsWhatWasLongAgo) {
  EvidencePool pool;
  pool.add(*ladder_of(40), 500);
  pool.fade(0.5F);
  EXPECT_NEAR(pool.finding(kSpan).nats, 20 - std::log(250), 0.2);
  EXPECT_EQ(pool.windows(), 0.5F);
  pool.add(*ladder_of(0), 500);
  EXPECT_NEAR(pool.finding(kSpan).nats, 20 - std::log(750), 0.2);
}

TEST(EvidencePool, LeavesOutAWindowThatIsTooShort) {
  EvidencePool pool;
  pool.add(*ladder_of(40), 0);
  EXPECT_EQ(pool.windows(), 0);
  EXPECT_EQ(pool.finding(kSpan).predicted, 0U);
}

TEST(EvidencePool, FadesAtTheEndOfItsRange) {
  EvidencePool pool;
  for (int window = 0; window < 4; ++window) pool.add(*ladder_of(6000), 500);
  EXPECT_NEAR(pool.finding(kSpan).nats, 8191, 10);
  EXPECT_NEAR(pool.windows(), 4 * 8191.0 / 24000, 0.01);
}

TEST(EvidencePool, KnowsItsBandAtTheEndOfItsRange) {
  auto ladder = std::make_unique<Ladder<double>>();
  for (int rung = 0; rung < 5; ++rung) {
    (*ladder)[static_cast<std::size_t>(kRung - 2 + rung)] =
        3000 - 200 * std::abs(rung - 2);
  }
  EvidencePool pool;
  for (int window = 0; window < 9; ++window) pool.add(*ladder, 500);
  EXPECT_DOUBLE_EQ(pool.finding(kSpan).band, rung_band(kRung, kSpan));
}

}  // namespace
}  // namespace ident
