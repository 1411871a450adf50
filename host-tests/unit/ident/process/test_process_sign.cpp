// The guess where only u and y are known.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "ident/process/process_sign.hpp"
#include "support/ident/problems.hpp"

namespace ident {
namespace {

template <class Real>
int likelier_sign(const std::vector<Real>& u, const std::vector<Real>& y, Real period) {
  const auto guess = std::make_unique<LikelierSign<Real>>();
  std::vector<Real> scratch(y.size());
  guess->start(u, y, period, scratch);
  int pieces = 1;
  while (!guess->step()) {
    ++pieces;
  }
  EXPECT_EQ(pieces % 12, 0);  // twelve passes of the same length
  return guess->sign();
}

// A lag of 20 samples behind a square wave of 100, with noise.
template <class Real>
int guess(Real gain, Real noise, std::uint64_t seed) {
  test::Random random(seed);
  std::vector<Real> u, y;
  Real state = 0;
  for (int t = 0; t < 600; ++t) {
    u.push_back(t / 50 % 2 == 0 ? Real(0) : Real(1));
    state += (gain * u.back() - state) / Real(20);
    y.push_back(state - gain / Real(2) + noise * static_cast<Real>(test::normal(random)));
  }
  return likelier_sign<Real>(u, y, Real(100));
}

TEST(ProcessSign, FollowsTheProcess) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    EXPECT_EQ(guess<double>(2, 0.2, seed), 1);
    EXPECT_EQ(guess<double>(-2, 0.2, seed), -1);
  }
}

TEST(ProcessSign, IsTheSameInFloat) {
  EXPECT_EQ(guess<float>(2, 0.2f, 6), 1);
  EXPECT_EQ(guess<float>(-2, 0.2f, 6), -1);
}

// One or the other, never 0.
TEST(ProcessSign, AlwaysDecides) {
  const std::vector<double> still(100, 0.0);
  EXPECT_EQ(likelier_sign<double>(still, still, 20), 1);
}

// Processes that lag behind by shares of the period of u: without their pole a dead time
// of half a period explains y as well, with the other sign.
TEST(ProcessSign, KnowsSlowAndFastProcesses) {
  for (const double share : {0.03, 0.1, 0.3, 1.0, 3.0}) {
    for (const double gain : {1.0, -1.0}) {
      test::Random random(8);
      std::vector<double> u, y;
      const double keeps = std::exp(-1 / (share * 100));
      double state = 0;
      for (int t = 0; t < 1000; ++t) {
        u.push_back(t / 50 % 2 == 0 ? 1 : -1);
        state = keeps * state + (1 - keeps) * gain * u.back();
        y.push_back(state * (1 + share) + 0.01 * test::normal(random));
      }
      EXPECT_EQ(likelier_sign<double>(u, y, 100.0), gain > 0 ? 1 : -1) << share;
    }
  }
}

}  // namespace
}  // namespace ident
