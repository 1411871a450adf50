// Weights and shares against sums worked out in full.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "ident/gap/gap_fit.hpp"
#include "support/ident/loop.hpp"

namespace ident {
namespace {

using Gap = GapFit<double>;

constexpr int kFitSamples = 400;
constexpr int kBlock = 20;

struct FitProblem {
  Eigen::MatrixXd rows = Eigen::MatrixXd(kFitSamples, Gap::kUnknowns);
  Eigen::VectorXd e = Eigen::VectorXd(kFitSamples);
};

FitProblem problem(double of_column, double noise) {
  test::Random random(3);
  FitProblem out;
  for (int t = 0; t < kFitSamples; ++t) {
    out.rows.row(t) << 1, std::sin(0.3 * t), std::cos(0.11 * t), test::normal(random);
    out.e(t) = 0.4 + 0.2 * out.rows(t, 1) + of_column * out.rows(t, 2) +
               noise * test::normal(random);
  }
  return out;
}

int fold_of(int t) {
  return t / kBlock % 2;
}

Gap summed(const FitProblem& p) {
  Gap fit;
  for (int t = 0; t < kFitSamples; ++t) {
    Gap::Row row;
    for (int k = 0; k < Gap::kUnknowns; ++k)
      row[static_cast<std::size_t>(k)] = p.rows(t, k);
    fit.add(fold_of(t), row, p.e(t));
  }
  return fit;
}

// Error of each fold with weights from the other, by QR on the rows themselves.
double left(const FitProblem& p, int count) {
  double sum = 0;
  for (int fold = 0; fold < 2; ++fold) {
    Eigen::MatrixXd a(kFitSamples / 2, count);
    Eigen::VectorXd b(kFitSamples / 2);
    int n = 0;
    for (int t = 0; t < kFitSamples; ++t) {
      if (fold_of(t) != fold) {
        a.row(n) = p.rows.row(t).head(count);
        b(n++) = p.e(t);
      }
    }
    const Eigen::VectorXd z = a.colPivHouseholderQr().solve(b);
    for (int t = 0; t < kFitSamples; ++t) {
      if (fold_of(t) == fold) {
        sum += std::pow(p.e(t) - p.rows.row(t).head(count).dot(z), 2);
      }
    }
  }
  return sum;
}

TEST(GapFit, ShareIsThatOfTheOtherFoldsWeights) {
  const FitProblem p = problem(0.5, 0.3);
  const double plain = left(p, Gap::kNuisances);
  EXPECT_NEAR(summed(p).share(1), 1 - left(p, 3) / plain, 1e-9);
  EXPECT_NEAR(summed(p).share(2), 1 - left(p, 4) / plain, 1e-9);
  EXPECT_GT(summed(p).share(1), 0.4);
}

TEST(GapFit, AColumnThatOnlyFitsNoiseHasNoShare) {
  EXPECT_LT(summed(problem(0, 1)).share(2), 0.01);
}

TEST(GapFit, WeightsAreThoseOfLeastSquares) {
  const FitProblem p = problem(0.5, 0.3);
  const Eigen::VectorXd expected = p.rows.colPivHouseholderQr().solve(p.e);
  const Gap::Row weights = summed(p).weights();
  for (int k = 0; k < Gap::kUnknowns; ++k) {
    EXPECT_NEAR(weights[static_cast<std::size_t>(k)], expected(k), 1e-9);
  }
}

TEST(GapFit, NothingAndDependentColumnsDivideByNothing) {
  Gap fit;
  EXPECT_EQ(fit.share(2), 0);
  for (int t = 0; t < 50; ++t) {
    const double x = std::sin(t);
    fit.add(t % 2, {1, x, 2 * x, 0}, x);
  }
  EXPECT_EQ(fit.share(2), 0);
  const Gap::Row weights = fit.weights();
  EXPECT_NEAR(weights[1], 1, 1e-9);
  EXPECT_EQ(weights[2], 0);
  EXPECT_EQ(weights[3], 0);
  fit.clear();
  EXPECT_EQ(fit.weights()[1], 0);
}

}  // namespace
}  // namespace ident
