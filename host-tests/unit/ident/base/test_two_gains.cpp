#include <gtest/gtest.h>

#include "ident/base/two_gains.hpp"
#include "support/ident/problems.hpp"

namespace ident {
namespace {

TEST(TwoGains, OfAnInnerOptimum) {
  // 2a + b = 4, a + 2b = 5.
  const auto gains = non_negative_gains<double>({2, 4, 0}, {2, 5, 0}, 1);
  EXPECT_NEAR(gains.a, 1, 1e-12);
  EXPECT_NEAR(gains.b, 2, 1e-12);
}

TEST(TwoGains, StayAtTheBound) {
  // The free optimum is a = 3, b = −1.
  const auto gains = non_negative_gains<double>({2, 5, 0}, {2, 1, 0}, 1);
  EXPECT_NEAR(gains.a, 2.5, 1e-12);
  EXPECT_EQ(gains.b, 0);
  const auto none = non_negative_gains<double>({2, -1, 0}, {2, -3, 0}, 1);
  EXPECT_EQ(none.a, 0);
  EXPECT_EQ(none.b, 0);
}

TEST(TwoGains, TakeOneOfTwoEqualTaps) {
  const auto gains = non_negative_gains<double>({2, 4, 0}, {2, 4, 0}, 2);
  EXPECT_EQ(gains.a, 2);
  EXPECT_EQ(gains.b, 0);
}

TEST(TwoGains, IgnoreATapThatIsExplainedAlready) {
  const auto gains = non_negative_gains<double>({0, 4, 0}, {2, 4, 0}, 0);
  EXPECT_EQ(gains.a, 0);
  EXPECT_EQ(gains.b, 2);
}

TEST(TwoGains, IgnoreWhatIsNoise) {
  const auto gains = non_negative_gains<double>({2, 0.5, 1}, {2, 0.4, 1}, 0);
  EXPECT_EQ(gains.a, 0);
  EXPECT_EQ(gains.b, 0);
}

// Random columns: free ones out first, then the gains, against every subset of bounds.
TEST(TwoGains, BehindAnEliminationAgreeWithAllSubsets) {
  test::Random random(41);
  for (int k = 0; k < 400; ++k) {
    Eigen::MatrixXd columns(9, 5);
    for (double& value : columns.reshaped()) {
      value = test::normal(random);
    }
    Eigen::VectorXd y(9);
    for (double& value : y) {
      value = test::normal(random);
    }
    if (k % 4 == 0) {
      columns.col(4) = columns.col(2) - columns.col(3);  // dependent: left out
    }
    const Eigen::MatrixXd q = columns.transpose() * columns;
    const Eigen::VectorXd c = columns.transpose() * y;
    std::array<std::array<double, 3>, 3> free{};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j <= i; ++j) {
        free[i][j] = q(2 + i, 2 + j);
      }
    }
    const Elimination<double, 3> elimination(free);
    const auto of_a = elimination.shares({q(0, 2), q(0, 3), q(0, 4)});
    const auto of_b = elimination.shares({q(1, 2), q(1, 3), q(1, 4)});
    const auto of_y = elimination.shares({c(2), c(3), c(4)});
    const double ca = c(0) - inner(of_a, of_y);
    const double cb = c(1) - inner(of_b, of_y);
    const auto gains = non_negative_gains<double>({q(0, 0) - inner(of_a, of_a), ca, 0},
                                                  {q(1, 1) - inner(of_b, of_b), cb, 0},
                                                  q(0, 1) - inner(of_a, of_b));
    auto left = of_y;
    for (int i = 0; i < 3; ++i) {
      left[i] -= gains.a * of_a[i] + gains.b * of_b[i];
    }
    const auto weights = elimination.weights(left);
    Eigen::VectorXd z(5);
    z << gains.a, gains.b, weights[0], weights[1], weights[2];
    ASSERT_GE(z.head(2).minCoeff(), 0);
    const double found = 0.5 * z.dot(q * z) - c.dot(z);
    ASSERT_NEAR(found, test::exhaustive_minimum(q, c, 3), 1e-9) << k;
  }
}

}  // namespace
}  // namespace ident
