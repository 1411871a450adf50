// Non-negative least squares against a search over every subset of bounds.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "ident/base/nnls.hpp"
#include "support/ident/problems.hpp"

namespace ident {
namespace {

using test::normal;
using test::Random;
using test::uniform;

struct Problem {
  Eigen::MatrixXd q;
  Eigen::VectorXd c;
  UnknownSet constrained = 0;
  double energy = 0;  // Σ target², the scale of the objective
};

Problem problem_from(const Eigen::MatrixXd& columns, const Eigen::VectorXd& target,
                     UnknownSet constrained) {
  return {columns.transpose() * columns, columns.transpose() * target, constrained,
          target.squaredNorm()};
}

std::string describe(const Problem& p) {
  std::ostringstream text;
  for (Eigen::Index i = 0; i < p.q.rows(); ++i) {
    text << "\n" << ((p.constrained >> i & 1U) ? "z >= 0  " : "free    ");
    for (Eigen::Index j = 0; j < p.q.cols(); ++j) {
      text << p.q(i, j) << ' ';
    }
    text << "| " << p.c(i);
  }
  return text.str();
}

UnknownSet any_constraints(Random& random, Eigen::Index n) {
  const UnknownSet all = (UnknownSet{1} << n) - 1;
  return uniform(random, 0, 1) < 0.3 ? all : random() & all;
}

// How far the objective of the solution lies above the exhaustive one, over the energy;
// fails when the solution is not feasible.
template <class Real>
double excess(const Problem& p) {
  static NonNegativeLeastSquares<Real> nnls;
  Column<Real> z;
  const Square<Real> q = p.q.cast<Real>();
  const Column<Real> c = p.c.cast<Real>();
  EXPECT_TRUE(nnls.solve(q, c, p.constrained, z));
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    EXPECT_TRUE(std::isfinite(z(i)));
    if (p.constrained >> i & 1U) {
      EXPECT_GE(z(i), Real(0));
    }
  }
  const double found = test::objective(p.q, p.c, z.template cast<double>());
  return (found - test::exhaustive_minimum(p.q, p.c, p.constrained)) / p.energy;
}

Problem well_conditioned(Random& random) {
  const Eigen::Index n = 1 + static_cast<Eigen::Index>(random() % 8);
  const Eigen::MatrixXd columns =
      Eigen::MatrixXd::NullaryExpr(n + 12, n, [&] { return normal(random); });
  const Eigen::VectorXd target =
      Eigen::VectorXd::NullaryExpr(n + 12, [&] { return normal(random); });
  return problem_from(columns, target, any_constraints(random, n));
}

// Neighbouring columns alike, scales apart by up to 10⁴, as filtered step functions are.
Problem ill_conditioned(Random& random) {
  const Eigen::Index n = 2 + static_cast<Eigen::Index>(random() % 7);
  Eigen::MatrixXd columns(40, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double scale = std::pow(10.0, uniform(random, -2, 2));
    for (Eigen::Index r = 0; r < 40; ++r) {
      const double base = i > 0 && i % 2 == 1 ? columns(r, i - 1) : normal(random);
      columns(r, i) = i % 2 == 1
                          ? base + 0.02 * columns.col(i - 1).norm() / 6.3 * normal(random)
                          : scale * base;
    }
  }
  const Eigen::VectorXd target =
      Eigen::VectorXd::NullaryExpr(40, [&] { return normal(random); });
  return problem_from(columns, target, any_constraints(random, n));
}

// Whole numbers, so that ties, zeros and dependent columns occur exactly.
Problem whole_numbers(Random& random) {
  const Eigen::Index n = 2 + static_cast<Eigen::Index>(random() % 7);
  const Eigen::Index rows = 3 + static_cast<Eigen::Index>(random() % 6);
  const auto small = [&] { return static_cast<double>(random() % 5) - 1.0; };
  const Eigen::MatrixXd columns = Eigen::MatrixXd::NullaryExpr(rows, n, small);
  Eigen::VectorXd target = Eigen::VectorXd::NullaryExpr(rows, small);
  target(0) += 1;  // not all zero
  target(1) += target.squaredNorm() > 0 ? 0 : 1;
  return problem_from(columns, target, any_constraints(random, n));
}

// The loss from rounding c and Q is of the order of n·ε·(energy), amplified by the square
// root of the condition number at most: well conditioned 10 ε, ill conditioned 10⁴ ε.
// With exactly dependent columns it is the threshold of dependence, 16 ε of a squared
// column, that shows: 10⁻³ in float.
TEST(NnlsOracle, WellConditioned) {
  Random random(1);
  for (int k = 0; k < 2000; ++k) {
    const Problem p = well_conditioned(random);
    ASSERT_LT(excess<double>(p), 1e-13) << k;
    ASSERT_LT(excess<float>(p), 2e-6) << k;
  }
}

TEST(NnlsOracle, IllConditioned) {
  Random random(2);
  for (int k = 0; k < 2000; ++k) {
    const Problem p = ill_conditioned(random);
    ASSERT_LT(excess<double>(p), 1e-11) << k;
    ASSERT_LT(excess<float>(p), 3e-3) << k;
  }
}

TEST(NnlsOracle, WholeNumbersWithTiesAndDependentColumns) {
  Random random(3);
  for (int k = 0; k < 4000; ++k) {
    const Problem p = whole_numbers(random);
    ASSERT_LT(excess<double>(p), 1e-11) << k << describe(p);
  }
}

TEST(NnlsOracle, WholeNumbersInFloat) {
  Random random(4);
  for (int k = 0; k < 4000; ++k) {
    const Problem p = whole_numbers(random);
    ASSERT_LT(excess<float>(p), 1e-3) << k << describe(p);
  }
}

}  // namespace
}  // namespace ident
