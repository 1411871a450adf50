#include <gtest/gtest.h>

#include "ident/base/nnls.hpp"

namespace ident {
namespace {

template <class Real>
class Nnls : public testing::Test {
 protected:
  Column<Real> solve(const Eigen::MatrixXd& q, const Eigen::VectorXd& c,
                     UnknownSet constrained) {
    Column<Real> z;
    const Square<Real> q_real = q.cast<Real>();
    const Column<Real> c_real = c.cast<Real>();
    EXPECT_TRUE(nnls_.solve(q_real, c_real, constrained, z));
    return z;
  }
  NonNegativeLeastSquares<Real> nnls_;
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(Nnls, Reals);

Eigen::Matrix2d square(double a, double b, double d) {
  return (Eigen::Matrix2d() << a, b, b, d).finished();
}

// Q = [2 1; 1 2], c = [3; 3]: z = [1; 1] is inside.
TYPED_TEST(Nnls, FindsTheFreeOptimumWhenItIsFeasible) {
  const auto z = this->solve(square(2, 1, 2), Eigen::Vector2d(3, 3), 3);
  EXPECT_NEAR(z(0), 1, 1e-6);
  EXPECT_NEAR(z(1), 1, 1e-6);
}

// Q = [2 1; 1 2], c = [4; −1]: unbounded z = [3; −2]. On the bound z = [2; 0], where the
// gradient −1 − 2 = −3 pushes outwards.
TYPED_TEST(Nnls, StopsOnTheBound) {
  const auto z = this->solve(square(2, 1, 2), Eigen::Vector2d(4, -1), 3);
  EXPECT_NEAR(z(0), 2, 1e-6);
  EXPECT_EQ(z(1), 0);
}

// The same with z₂ free: [3; −2].
TYPED_TEST(Nnls, LeavesFreeUnknownsAlone) {
  const auto z = this->solve(square(2, 1, 2), Eigen::Vector2d(4, -1), 1);
  EXPECT_NEAR(z(0), 3, 1e-6);
  EXPECT_NEAR(z(1), -2, 1e-6);
}

TYPED_TEST(Nnls, IsZeroWhenEveryGradientPushesOutwards) {
  const auto z = this->solve(square(2, 1, 2), Eigen::Vector2d(-1, -4), 3);
  EXPECT_EQ(z(0), 0);
  EXPECT_EQ(z(1), 0);
}

// Two equal columns: only the sum is determined, one of them takes it.
TYPED_TEST(Nnls, GivesOneOfTwoEqualColumnsEverything) {
  const auto z = this->solve(square(1, 1, 1), Eigen::Vector2d(2, 2), 3);
  EXPECT_NEAR(z(0) + z(1), 2, 1e-6);
  EXPECT_EQ(z(0) * z(1), 0);
  const auto free = this->solve(square(1, 1, 1), Eigen::Vector2d(2, 2), 0);
  EXPECT_NEAR(free(0) + free(1), 2, 1e-6);
}

TYPED_TEST(Nnls, LeavesAnEmptyColumnAtZero) {
  const auto z = this->solve(square(4, 0, 0), Eigen::Vector2d(2, 0), 0);
  EXPECT_NEAR(z(0), 0.5, 1e-6);
  EXPECT_EQ(z(1), 0);
}

TYPED_TEST(Nnls, DoesNotDependOnTheScaleOfAColumn) {
  const double k = 1000;
  const auto z = this->solve(square(2 * k * k, k, 2), Eigen::Vector2d(4 * k, -1), 3);
  EXPECT_NEAR(k * double(z(0)), 2, 1e-5);
  EXPECT_EQ(z(1), 0);
}

TYPED_TEST(Nnls, OfOneUnknown) {
  const Eigen::MatrixXd q = Eigen::MatrixXd::Constant(1, 1, 4);
  EXPECT_NEAR(this->solve(q, Eigen::VectorXd::Constant(1, 2), 1)(0), 0.5, 1e-6);
  EXPECT_EQ(this->solve(q, Eigen::VectorXd::Constant(1, -2), 1)(0), 0);
  EXPECT_NEAR(this->solve(q, Eigen::VectorXd::Constant(1, -2), 0)(0), -0.5, 1e-6);
}

// z₀ enters first (its gain is the largest), must leave again when the others have, and
// the optimum is z = [0; 1; 1].
TYPED_TEST(Nnls, LetsAnUnknownLeaveAgain) {
  // Columns [1 1], [1 0], [0 1] (by rows), target [1 1] + a little that only 1 and 2 fit.
  Eigen::MatrixXd columns(3, 3);
  columns << 1, 1, 0,  //
      1, 0, 1,         //
      1, 0.25, 0.25;
  const Eigen::Vector3d target(1, 1, 0.5);
  const Eigen::MatrixXd q = columns.transpose() * columns;
  const auto z = this->solve(q, columns.transpose() * target, 7);
  EXPECT_NEAR(z(0), 0, 1e-5);
  EXPECT_NEAR(z(1), 1, 1e-5);
  EXPECT_NEAR(z(2), 1, 1e-5);
}

TYPED_TEST(Nnls, TakesTheMostUnknowns) {
  const Eigen::MatrixXd q = Eigen::MatrixXd::Identity(kMaxUnknowns, kMaxUnknowns);
  Eigen::VectorXd c(kMaxUnknowns);
  for (int i = 0; i < kMaxUnknowns; ++i) {
    c(i) = i % 2 == 0 ? i + 1 : -i - 1;
  }
  const auto z = this->solve(q, c, (UnknownSet{1} << kMaxUnknowns) - 1);
  for (int i = 0; i < kMaxUnknowns; ++i) {
    EXPECT_NEAR(z(i), std::max(c(i), 0.0), 1e-5) << i;
  }
}

}  // namespace
}  // namespace ident
