// Lagged sums against the dense regressor matrix, row by row.
#include <gtest/gtest.h>

#include "ident/two_path/lagged_gram.hpp"
#include "support/ident/all_at_once.hpp"
#include "support/ident/loop.hpp"

namespace ident {
namespace {

using test::Random;

struct Dense {
  Dense(const KnotGrid<double>& grid, const test::Window& w)
      : hats(grid.hats()), window(&w), of_hat(w.u.size(), hats) {
    for (std::size_t t = 0; t < w.u.size(); ++t) {
      for (int h = 0; h < hats; ++h) {
        of_hat(t, h) = test::hat_value(grid, h, w.u[t], w.ascending[t] != 0);
      }
    }
  }
  [[nodiscard]] int rows() const { return static_cast<int>(of_hat.rows()) - first; }
  // H(t − p), one row for each predicted sample.
  [[nodiscard]] Eigen::MatrixXd lagged_hats(int p) const {
    return of_hat.middleRows(first - p, rows());
  }
  [[nodiscard]] Eigen::VectorXd lagged_y(int i) const {
    return Eigen::Map<const Eigen::VectorXd>(window->y.data() + first - i, rows());
  }
  static constexpr int first = LaggedGram<double>::kFirst;
  int hats;
  const test::Window* window;
  Eigen::MatrixXd of_hat;
};

struct Case {
  test::Window window;
  KnotGrid<double> grid;
  int nb = 1;
  int nk = 0;
  std::array<double, kMaxNb> b{};
};

Case any_case(Random& random, int k) {
  Case c;
  const std::size_t shortest = LaggedGram<double>::kFirst + 1;
  c.window = test::random_window(random, shortest + random() % (k % 2 == 0 ? 20 : 300));
  const int ascending = 1 + static_cast<int>(random() % kMaxSegments);
  const int descending = 1 + static_cast<int>(random() % kMaxSegments);
  c.grid = k % 3 == 0 ? test::uniform_grid<double>(ascending, descending)
                      : test::random_grid(random, ascending, descending);
  c.nb = 1 + static_cast<int>(random() % kMaxNb);
  c.nk = static_cast<int>(random() % (kMaxNk + 1));
  for (int j = 0; j < c.nb; ++j) {
    c.b[j] = test::normal(random);
  }
  return c;
}

KnotGrid<float> to_float(const KnotGrid<double>& grid) {
  KnotGrid<float> out;
  out.ascending.segments = grid.ascending.segments;
  out.descending.segments = grid.descending.segments;
  for (int i = 0; i < kMaxKnots; ++i) {
    out.ascending.knots[i] = static_cast<float>(grid.ascending.knots[i]);
    out.descending.knots[i] = static_cast<float>(grid.descending.knots[i]);
  }
  return out;
}

template <class Real>
void compare(const LaggedGram<Real>& gram, const Case& c, double tolerance) {
  const Dense dense(c.grid, c.window);
  ASSERT_EQ(gram.rows(), dense.rows());
  const auto near = [&](double found, double expected, const char* what) {
    ASSERT_NEAR(found, expected, tolerance) << what;
  };
  for (int i = 0; i <= kMaxNa; ++i) {
    near(static_cast<double>(gram.y_sum(i)), dense.lagged_y(i).sum(), "y");
    for (int j = 0; j <= kMaxNa; ++j) {
      near(static_cast<double>(gram.yy(i, j)), dense.lagged_y(i).dot(dense.lagged_y(j)),
           "yy");
    }
  }
  const int hats = dense.hats;
  Eigen::MatrixXd filtered = Eigen::MatrixXd::Zero(dense.rows(), hats);
  for (int j = 1; j <= c.nb; ++j) {
    filtered += c.b[j - 1] * dense.lagged_hats(c.nk + j);
  }
  std::array<Real, kMaxNb> b{};
  std::transform(c.b.begin(), c.b.end(), b.begin(),
                 [](double value) { return static_cast<Real>(value); });
  HatSquare<Real> square = HatSquare<Real>::Zero(hats, hats);
  gram.filtered(c.nk, c.nb, b, square);
  const Eigen::MatrixXd expected = filtered.transpose() * filtered;
  for (int r = 0; r < hats; ++r) {
    for (int s = 0; s < hats; ++s) {
      near(static_cast<double>(square(r, s)), expected(r, s), "filtered");
    }
  }
  HatColumn<Real> x(hats);
  Eigen::VectorXd x_double(hats);
  for (int h = 0; h < hats; ++h) {
    x(h) = static_cast<Real>(0.1 * h - 0.5);
    x_double(h) = static_cast<double>(x(h));
  }
  for (int p = c.nk + 1; p <= c.nk + c.nb; ++p) {
    HatColumn<Real> sum = HatColumn<Real>::Zero(hats);
    gram.add_hat_sum(p, Real(2), sum);
    const Eigen::VectorXd hat_sum = 2 * dense.lagged_hats(p).colwise().sum().transpose();
    for (int h = 0; h < hats; ++h) {
      near(static_cast<double>(sum(h)), hat_sum(h), "hat sum");
    }
    for (int i = 0; i <= kMaxNa; ++i) {
      HatColumn<Real> cross = HatColumn<Real>::Ones(hats);
      gram.add_y_hats(i, p, Real(-1), cross);
      const Eigen::VectorXd y_hats = dense.lagged_hats(p).transpose() * dense.lagged_y(i);
      for (int h = 0; h < hats; ++h) {
        near(static_cast<double>(cross(h)), 1 - y_hats(h), "y hats");
      }
    }
    for (int q = c.nk + 1; q <= c.nk + c.nb; ++q) {
      near(static_cast<double>(gram.xx(p, q, x)),
           (dense.lagged_hats(p) * x_double).dot(dense.lagged_hats(q) * x_double), "xx");
    }
  }
}

TEST(LaggedGramOracle, AgreesWithTheDenseRegressors) {
  Random random(11);
  static LaggedGram<double> gram;
  for (int k = 0; k < 300 && !testing::Test::HasFatalFailure(); ++k) {
    SCOPED_TRACE(k);
    const Case c = any_case(random, k);
    test::accumulate(gram, c.grid, c.window.view());
    compare(gram, c, 1e-9);
  }
}

// Sums of up to N = 320 products of order one, rounded one after another: N·ε·√N ≈ 3·10⁻⁴
// at most, times the weights b and x.
TEST(LaggedGramOracle, InFloat) {
  Random random(12);
  static LaggedGram<float> gram;
  for (int k = 0; k < 100 && !testing::Test::HasFatalFailure(); ++k) {
    SCOPED_TRACE(k);
    const Case c = any_case(random, k);
    const test::FloatWindow window(c.window);
    test::accumulate(gram, to_float(c.grid), window.view());
    compare(gram, c, 2e-3);
  }
}

}  // namespace
}  // namespace ident
