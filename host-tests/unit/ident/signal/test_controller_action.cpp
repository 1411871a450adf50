#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "ident/signal/controller_action.hpp"
#include "support/ident/problems.hpp"

namespace ident {
namespace {

using Signal = std::vector<double>;

// u(t) = u(t−1) + kc·(e(t) − e(t−1)) + ki·e(t), e = sp − y, from u = 50.
Signal pi_law(double kc, double ki, const Signal& y, const Signal& sp) {
  Signal u{50};
  for (std::size_t t = 1; t < y.size(); ++t) {
    const double e = sp[t] - y[t];
    u.push_back(u.back() + kc * (e - (sp[t - 1] - y[t - 1])) + ki * e);
  }
  return u;
}

Signal wave(std::size_t n, double period = 37) {
  Signal y;
  for (std::size_t t = 0; t < n; ++t) {
    y.push_back(std::sin(2 * M_PI * static_cast<double>(t) / period));
  }
  return y;
}

Signal noise(std::size_t n, std::uint64_t seed, double size = 1) {
  test::Random random(seed);
  Signal y;
  for (std::size_t t = 0; t < n; ++t) {
    y.push_back(size * test::normal(random));
  }
  return y;
}

// Six samples of e would do: the law is exact.
TEST(ControllerAction, RecoversThePiLawWithItsSign) {
  const Signal y = noise(200, 1);
  const Signal sp(200, 0.3);
  for (const double kc : {2.0, -2.0}) {
    for (const double ki : {0.1 * kc, 0.5 * kc}) {
      const auto action = controller_action<double>(pi_law(kc, ki, y, sp), y, sp);
      EXPECT_EQ(action.sign, kc > 0 ? 1 : -1);
      EXPECT_NEAR(action.proportional, kc, 1e-9);
      EXPECT_NEAR(action.integral, ki, 1e-9);
      EXPECT_NEAR(action.r_squared, 1, 1e-9);
    }
  }
}

TEST(ControllerAction, RecoversPureIntegralAction) {
  const Signal y = noise(200, 2);
  const Signal sp(200, 0);
  for (const double ki : {0.2, -0.2}) {
    const auto action = controller_action<double>(pi_law(0, ki, y, sp), y, sp);
    EXPECT_EQ(action.sign, ki > 0 ? 1 : -1);
    EXPECT_NEAR(action.integral, ki, 1e-9);
  }
}

// The constant takes an unknown setpoint up: the law is the same without it.
TEST(ControllerAction, NeedsNoSetpointThatStandsStill) {
  const Signal y = noise(200, 3);
  const Signal sp(200, 5);
  const auto action = controller_action<double>(pi_law(-1.5, -0.2, y, sp), y, {});
  EXPECT_EQ(action.sign, -1);
  EXPECT_NEAR(action.proportional, -1.5, 1e-9);
  EXPECT_NEAR(action.integral, -0.2, 1e-9);
}

TEST(ControllerAction, FollowsAMovingSetpoint) {
  const Signal y = noise(300, 4, 0.2);
  Signal sp;
  for (std::size_t t = 0; t < y.size(); ++t) {
    sp.push_back(t / 60 % 2 == 0 ? 1 : -1);
  }
  const Signal u = pi_law(2, 0.3, y, sp);
  const auto action = controller_action<double>(u, y, sp);
  EXPECT_EQ(action.sign, 1);
  EXPECT_NEAR(action.proportional, 2, 1e-9);
  EXPECT_NEAR(action.integral, 0.3, 1e-9);
  // Without it the jumps of u have no cause.
  EXPECT_LT(controller_action<double>(u, y, {}).r_squared, 0.9);
}

TEST(ControllerAction, HoldsUnderRoundingOfU) {
  const Signal y = noise(400, 5);
  const Signal sp(400, 0);
  Signal u = pi_law(2, 0.2, y, sp);
  for (double& value : u) {
    value = std::round(value * 10) / 10;
  }
  const auto action = controller_action<double>(u, y, sp);
  EXPECT_EQ(action.sign, 1);
  EXPECT_NEAR(action.proportional, 2, 0.05);
  EXPECT_NEAR(action.integral, 0.2, 0.05);
}

// At its limits the controller does not follow its law.
TEST(ControllerAction, LeavesOutTheSamplesAtALimit) {
  const Signal y = wave(600);
  Signal u;
  double now = 0;
  double before = 0;
  for (const double value : y) {
    now = std::clamp(now + 2 * (before - value) - 0.2 * value, -1.0, 1.5);
    before = value;
    u.push_back(now);
  }
  const auto action = controller_action<double>(u, y, {});
  EXPECT_EQ(action.sign, 1);
  EXPECT_NEAR(action.proportional, 2, 1e-6);
  EXPECT_NEAR(action.integral, 0.2, 1e-6);
  EXPECT_NEAR(action.r_squared, 1, 1e-9);
}

TEST(ControllerAction, GivesNoSignOnUnrelatedNoise) {
  for (std::uint64_t seed = 10; seed < 30; ++seed) {
    const auto action =
        controller_action<double>(noise(100, seed), noise(100, seed + 100), {});
    EXPECT_EQ(action.sign, 0) << seed;
    EXPECT_LT(action.r_squared, 0.5) << seed;
  }
}

TEST(ControllerAction, GivesNoSignOnConstants) {
  const Signal constant(100, 3);
  const Signal moving = noise(100, 6);
  for (const auto& [u, y] : {std::pair(constant, moving), std::pair(moving, constant),
                             std::pair(constant, constant)}) {
    const auto action = controller_action<double>(u, y, {});
    EXPECT_EQ(action.sign, 0);
    EXPECT_EQ(action.proportional, 0);
    EXPECT_EQ(action.integral, 0);
    EXPECT_EQ(action.r_squared, 0);
  }
}

TEST(ControllerAction, NeedsEightSamples) {
  const Signal y = noise(8, 7);
  const Signal sp(8, 0);
  const Signal u = pi_law(2, 0.2, y, sp);
  const std::span<const double> us(u);
  const std::span<const double> ys(y);
  EXPECT_EQ(controller_action<double>(us, ys, {}).sign, 1);
  EXPECT_EQ(controller_action<double>(us.first(7), ys.first(7), {}).sign, 0);
  EXPECT_EQ(controller_action<double>({}, {}, {}).sign, 0);
}

// What a plant does to a noisy u: y comes out smooth, and nothing in Δu follows from it.
TEST(ControllerAction, GivesNoSignOnALagInsteadOfALaw) {
  const Signal u = noise(400, 8);
  Signal y{0};
  for (std::size_t t = 1; t < u.size(); ++t) {
    y.push_back(0.9 * y.back() + 0.1 * u[t - 1]);
  }
  EXPECT_EQ(controller_action<double>(u, y, {}).sign, 0);
}

// The law three samples late: noise tells that it does not act on this error.
TEST(ControllerAction, GivesNoSignOnALateLaw) {
  const Signal y = noise(400, 9);
  const Signal u = pi_law(2, 0.2, y, Signal(400, 0));
  Signal late(3, 50);
  late.insert(late.end(), u.begin(), u.end() - 3);
  EXPECT_EQ(controller_action<double>(late, y, {}).sign, 0);
}

// A lag between law and recorded u leaves 0.8 … 0.95 of Δu at most, and as much a sample
// later: mere smoothness.
TEST(ControllerAction, GivesNoSignOnASmoothedLaw) {
  Signal y = wave(600);
  const Signal rough = noise(600, 11, 0.05);
  for (std::size_t t = 0; t < y.size(); ++t) {
    y[t] += rough[t];
  }
  const Signal u = pi_law(0.05, 0.2, y, Signal(600, 0));
  Signal smooth{u[0]};
  for (std::size_t t = 1; t < u.size(); ++t) {
    smooth.push_back(0.8 * smooth.back() + 0.2 * u[t]);
  }
  const auto action = controller_action<double>(smooth, y, {});
  EXPECT_LT(action.r_squared, 0.95);
  EXPECT_EQ(action.sign, 0);
}

// Parts of opposite sign make no controller with negative feedback.
TEST(ControllerAction, GivesNoSignWherePartsDisagree) {
  const Signal y = noise(300, 12);
  const auto action = controller_action<double>(pi_law(1, -1, y, Signal(300, 0)), y, {});
  EXPECT_NEAR(action.proportional, 1, 1e-9);
  EXPECT_NEAR(action.integral, -1, 1e-9);
  EXPECT_EQ(action.sign, 0);
}

TEST(ControllerAction, IsTheSameInFloat) {
  const Signal y = noise(200, 13);
  const Signal u = pi_law(-2, -0.2, y, Signal(200, 0));
  const auto action =
      controller_action<float>(test::as<float>(u), test::as<float>(y), {});
  EXPECT_EQ(action.sign, -1);
  EXPECT_NEAR(action.proportional, -2, 1e-3);
  EXPECT_NEAR(action.integral, -0.2, 1e-3);
}

// Of white e, Δu = kc·Δe + ki·e has the variance 2·kc² + ki² + 2·kc·ki; a part below a
// fiftieth of that may have the other sign, and then the larger part tells.
TEST(ControllerAction, AMinorPartMayDisagree) {
  const Signal y = noise(6000, 21);
  const Signal still(6000, 0);
  const auto sign = [&](double kc, double ki) {
    return controller_action<double>(pi_law(kc, ki, y, still), y, {}).sign;
  };
  EXPECT_EQ(sign(1, -0.15), 1) << "1.3 % are integral";
  EXPECT_EQ(sign(-1, 0.15), -1);
  EXPECT_EQ(sign(1, -0.215), 0) << "2.9 %";
  EXPECT_EQ(sign(-0.08, 1), 1) << "1.5 % are proportional";
  EXPECT_EQ(sign(0.08, -1), -1);
  EXPECT_EQ(sign(-0.105, 1), 0) << "2.7 %";
}

// Noise on u leaves nine tenths of Δu to the law. A sample later there is hardly a law
// left: it was one.
TEST(ControllerAction, ALawUnderNoiseIsOneIfItFitsNoLater) {
  const Signal y = noise(3000, 22);
  for (const double kc : {1.0, -1.0}) {
    Signal u = pi_law(kc, 0.2 * kc, y, Signal(3000, 0));
    const Signal rough = noise(3000, 23, 0.35);
    for (std::size_t t = 0; t < u.size(); ++t) u[t] += rough[t];
    const auto action = controller_action<double>(u, y, {});
    EXPECT_GT(action.r_squared, 0.82);
    EXPECT_LT(action.r_squared, 0.94);
    EXPECT_EQ(action.sign, kc > 0 ? 1 : -1);
  }
}

// The same under a slow wave: the law fits as well a sample later, so it is no proof.
TEST(ControllerAction, GivesNoSignWhereALawUnderNoiseFitsLater) {
  const Signal y = wave(3000, 60);
  Signal u = pi_law(1, 0.2, y, Signal(3000, 0));
  const Signal rough = noise(3000, 24, 0.03);
  for (std::size_t t = 0; t < u.size(); ++t) u[t] += rough[t];
  const auto action = controller_action<double>(u, y, {});
  EXPECT_GT(action.r_squared, 0.82);
  EXPECT_LT(action.r_squared, 0.95);
  EXPECT_EQ(action.sign, 0);
}

}  // namespace
}  // namespace ident
