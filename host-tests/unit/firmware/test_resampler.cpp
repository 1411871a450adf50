#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "firmware/resampler.hpp"

namespace firmware {
namespace {

constexpr std::int64_t kPeriod = 1'000'000;

// Deterministic jitter, −1 … 1.
double jitter(int k) {
  return std::sin(12.9898 * k) * 0.999;
}

// Feeds u and y with the number of their turn as value, `u_late` after y, and gives the
// samples that come out.
struct Sender {
  double u_late = 0.003;
  double spread = 0.001;   // periods, of the arrival
  double clock_error = 0;  // the sender's clock is slower by that share
  int turns = 400;
  std::vector<int> lost_u = {};

  std::vector<GridSample> run(Resampler& resampler) const {
    std::vector<GridSample> out;
    GridSample sample;
    const auto give = [&](Channel channel, double periods, int turn) {
      const std::int64_t t = 5'000'000 + std::llround(periods * (1 + clock_error) * 1e6);
      while (resampler.next(t - 1, sample)) out.push_back(sample);
      resampler.take(channel, t, turn);
    };
    for (int k = 0; k < turns; ++k) {
      give(Channel::kY, k + spread * jitter(k), k);
      bool lost = false;
      for (const int turn : lost_u) lost |= turn == k;
      if (!lost) give(Channel::kU, k + u_late + spread * jitter(k + 7), k);
    }
    return out;
  }
};

// Every turn comes out once, u and y of the same turn together.
void expect_pairs(const std::vector<GridSample>& samples, double shift = 0) {
  ASSERT_GT(samples.size(), 300U);
  for (std::size_t k = 1; k < samples.size(); ++k) {
    EXPECT_EQ(samples[k].y, samples[k - 1].y + 1) << k;
    EXPECT_EQ(samples[k].u, samples[k].y + shift) << k;
    EXPECT_FALSE(samples[k].held || samples[k].stale) << k;
  }
}

TEST(Resampler, KnowsHowOftenValuesComeThatComeEvenly) {
  Resampler even(kPeriod / 5, 5 * kPeriod);
  EXPECT_EQ(even.interval_us(Channel::kU), 0);
  (void)Sender{.spread = 0.05, .lost_u = {50, 51}}.run(even);
  EXPECT_NEAR(static_cast<double>(even.interval_us(Channel::kU)), kPeriod, kPeriod / 10);
  EXPECT_NEAR(static_cast<double>(even.interval_us(Channel::kY)), kPeriod, kPeriod / 10);
  EXPECT_EQ(even.interval_us(Channel::kSp), 0);
  Resampler uneven(kPeriod / 5, 5 * kPeriod);
  for (int k = 0; k < 40; ++k) {
    uneven.take(Channel::kU, (k * 3 + k % 2 * 2) * kPeriod, k);  // 5 s, 1 s, 5 s
  }
  EXPECT_EQ(uneven.interval_us(Channel::kU), 0) << "sent when it changes";
}

TEST(Resampler, JitterNeverDecidesToWhichInstantAValueBelongs) {
  for (const double spread : {0.0, 0.001, 0.05}) {
    Resampler resampler(kPeriod, 5 * kPeriod);
    expect_pairs(Sender{.u_late = 0.08, .spread = spread}.run(resampler));
  }
}

TEST(Resampler, FollowsASenderWhoseClockIsWrong) {
  for (const double error : {-2e-3, 2e-3}) {
    Resampler resampler(kPeriod, 5 * kPeriod);
    expect_pairs(Sender{.clock_error = error, .turns = 4000}.run(resampler));
  }
}

TEST(Resampler, SignalsHalfAPeriodApartAreBothKeptClearOf) {
  Resampler resampler(kPeriod, 5 * kPeriod);
  const auto samples = Sender{.u_late = 0.5, .spread = 0.02}.run(resampler);
  for (std::size_t k = 1; k < samples.size(); ++k) {
    EXPECT_EQ(samples[k].y, samples[k - 1].y + 1);
    EXPECT_EQ(samples[k].u, samples[k - 1].u + 1);
  }
}

TEST(Resampler, AMissedTurnIsHeldAndSaid) {
  Resampler resampler(kPeriod, 5 * kPeriod);
  const auto samples = Sender{.lost_u = {100}}.run(resampler);
  int held = 0;
  for (const GridSample& s : samples) {
    held += s.held;
    EXPECT_EQ(s.u, s.held ? s.y - 1 : s.y);
    EXPECT_FALSE(s.stale);
  }
  EXPECT_EQ(held, 1);
}

TEST(Resampler, ValuesThatAreTooOldAreVoid) {
  Resampler resampler(kPeriod, 3 * kPeriod);
  (void)Sender{.turns = 20}.run(resampler);
  GridSample sample;
  std::vector<bool> stale;
  while (resampler.next(5'000'000 + 30 * kPeriod, sample)) stale.push_back(sample.stale);
  ASSERT_GE(stale.size(), 10U);
  EXPECT_FALSE(stale[0]);
  EXPECT_FALSE(stale[1]);
  EXPECT_TRUE(stale[4]);
  EXPECT_TRUE(stale.back());
}

TEST(Resampler, AFasterSignalGivesItsNewestValue) {
  Resampler resampler(kPeriod, 5 * kPeriod);
  GridSample sample;
  int count = 0;
  for (int k = 0; k < 1000; ++k) {
    const std::int64_t t = k * kPeriod / 10;
    while (resampler.next(t - 1, sample)) {
      ++count;
      EXPECT_GE(sample.y * kPeriod / 10,
                static_cast<double>(sample.t_us - kPeriod / 10 - 1));
    }
    resampler.take(Channel::kY, t, k);
    if (k % 10 == 3) resampler.take(Channel::kU, t + 1, k);
  }
  EXPECT_GT(count, 90);
}

TEST(Resampler, ASlowSignalIsHeldWithoutComplaint) {
  Resampler resampler(kPeriod, 20 * kPeriod);
  GridSample sample;
  int held = 0;
  int count = 0;
  for (int k = 0; k < 200; ++k) {
    const std::int64_t t = k * kPeriod;
    while (resampler.next(t - 1, sample)) {
      ++count;
      held += sample.held;
    }
    resampler.take(Channel::kY, t, k);
    if (k % 10 == 0) resampler.take(Channel::kU, t + 1, k);
  }
  EXPECT_GT(count, 180);
  EXPECT_LT(held, 12) << "only until the interval of u is known";
}

TEST(Resampler, AGridThatWasKnownGoesOnWithTheFirstValues) {
  Resampler resampler(kPeriod, 5 * kPeriod);
  GridSample sample;
  resampler.resume(10 * kPeriod);
  EXPECT_FALSE(resampler.next(20 * kPeriod, sample)) << "no value yet";
  resampler.take(Channel::kU, 11 * kPeriod + kPeriod / 3, 1);
  resampler.take(Channel::kY, 11 * kPeriod + kPeriod / 2, 2);
  ASSERT_TRUE(resampler.next(12 * kPeriod, sample));
  EXPECT_EQ(sample.t_us, 12 * kPeriod);
  EXPECT_EQ(sample.y, 2);
}

TEST(Resampler, NothingComesBeforeBothAreThere) {
  Resampler resampler(kPeriod, 5 * kPeriod);
  GridSample sample;
  resampler.take(Channel::kU, 0, 1);
  EXPECT_FALSE(resampler.next(100 * kPeriod, sample));
  resampler.take(Channel::kY, 100 * kPeriod, 1);
  EXPECT_TRUE(resampler.next(101 * kPeriod, sample));
}

}  // namespace
}  // namespace firmware
