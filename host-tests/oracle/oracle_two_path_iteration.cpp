// The paper's Steps 1 and 2 on dense regressors, row by row, with a search over every
// subset of bounds and QR in place of the Gram matrix.
#include <gtest/gtest.h>

#include <cmath>

#include "ident/two_path/two_path_iteration.hpp"
#include "support/ident/all_at_once.hpp"
#include "support/ident/loop.hpp"

namespace ident {
namespace {

using test::Random;

// min ‖A·z − y‖ with z ≥ 0 from column `first_bounded` on: every subset, by QR.
Eigen::VectorXd bounded_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& y,
                                      int first_bounded) {
  const int bounded = static_cast<int>(a.cols()) - first_bounded;
  double best_error = INFINITY;
  Eigen::VectorXd best;
  for (int subset = 0; subset < 1 << bounded; ++subset) {
    std::vector<Eigen::Index> index;
    for (int i = 0; i < a.cols(); ++i) {
      if (i < first_bounded || (subset >> (i - first_bounded) & 1)) {
        index.push_back(i);
      }
    }
    const Eigen::MatrixXd part = a(Eigen::all, index);
    const Eigen::VectorXd solved = part.colPivHouseholderQr().solve(y);
    Eigen::VectorXd z = Eigen::VectorXd::Zero(a.cols());
    z(index) = solved;
    if (bounded > 0 && z.tail(bounded).minCoeff() < -1e-12) {
      continue;
    }
    const double error = (a * z - y).squaredNorm();
    if (error < best_error) {
      best_error = error;
      best = z;
    }
  }
  return best;
}

struct DenseIteration {
  DenseIteration(const test::Window& w, const Structure& structure)
      : window(w),
        s(structure),
        grid(test::uniform_grid<double>(s.segments_ascending, s.segments_descending)),
        rows(static_cast<int>(w.u.size()) - first) {}

  [[nodiscard]] double y(int t) const { return window.y[static_cast<std::size_t>(t)]; }
  // κ and the increments at sample t: 1 on the ascending path; step functions over hats.
  [[nodiscard]] Eigen::RowVectorXd basis(int t) const {
    const double u = window.u[static_cast<std::size_t>(t)];
    const bool up = window.ascending[static_cast<std::size_t>(t)] != 0;
    const int ascending_hats = grid.ascending.segments + 1;
    Eigen::RowVectorXd row(1 + s.segments_ascending + s.segments_descending);
    row(0) = up ? 1 : 0;
    int column = 1;
    for (int k = 1; k <= grid.ascending.segments; ++k, ++column) {
      row(column) = 0;
      for (int h = k; h < ascending_hats; ++h) {
        row(column) += test::hat_value(grid, h, u, up);
      }
    }
    for (int k = 1; k <= grid.descending.segments; ++k, ++column) {
      row(column) = 0;
      for (int h = ascending_hats + k; h < grid.hats(); ++h) {
        row(column) += test::hat_value(grid, h, u, up);
      }
    }
    return row;
  }

  // First half: κ, d and the increments.
  [[nodiscard]] Eigen::VectorXd paths(const Process<double>& p) const {
    const int unknowns = 2 + s.segments_ascending + s.segments_descending;
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(rows, unknowns);
    Eigen::VectorXd target(rows);
    for (int r = 0; r < rows; ++r) {
      const int t = first + r;
      target(r) = y(t);
      for (int i = 0; i < p.na; ++i) {
        target(r) += p.a[i] * y(t - 1 - i);
      }
      a(r, 1) = 1;
      for (int j = 0; j < p.nb; ++j) {
        const Eigen::RowVectorXd row = basis(t - p.nk - 1 - j);
        a(r, 0) += p.b[j] * row(0);
        a.row(r).tail(unknowns - 2) += p.b[j] * row.tail(unknowns - 2);
      }
    }
    return bounded_least_squares(a, target, 2);
  }

  // Second half: a, b, d.
  void process(const Eigen::VectorXd& g, Process<double>& p) const {
    Eigen::MatrixXd a(rows, p.na + p.nb + 1);
    Eigen::VectorXd target(rows);
    for (int r = 0; r < rows; ++r) {
      const int t = first + r;
      target(r) = y(t);
      for (int i = 0; i < p.na; ++i) {
        a(r, i) = -y(t - 1 - i);
      }
      for (int j = 0; j < p.nb; ++j) {
        a(r, p.na + j) = basis(t - p.nk - 1 - j).dot(g);
      }
      a(r, p.na + p.nb) = 1;
    }
    const Eigen::VectorXd z = a.colPivHouseholderQr().solve(target);
    for (int i = 0; i < p.na; ++i) {
      p.a[i] = z(i);
    }
    for (int j = 0; j < p.nb; ++j) {
      p.b[j] = z(p.na + j);
    }
    p.d = z(p.na + p.nb);
  }

  // x at the knots, ascending first.
  [[nodiscard]] Eigen::VectorXd positions(const Eigen::VectorXd& g) const {
    Eigen::VectorXd x(grid.hats());
    int column = 1;
    x(0) = g(0);
    for (int i = 1; i <= grid.ascending.segments; ++i, ++column) {
      x(i) = x(i - 1) + g(column);
    }
    const int descending = grid.ascending.segments + 1;
    x(descending) = 0;
    for (int i = 1; i <= grid.descending.segments; ++i, ++column) {
      x(descending + i) = x(descending + i - 1) + g(column);
    }
    return x;
  }

  // The iteration. Returns x at the knots.
  Eigen::VectorXd fit(Process<double>& p, int& iterations) const {
    p = {};
    p.na = s.na;
    p.nb = s.nb;
    p.nk = s.nk;
    p.b[0] = 1;
    Eigen::VectorXd x;
    for (iterations = 1; iterations <= TwoPathIteration<double>::kMaxIterations;
         ++iterations) {
      const Process<double> before = p;
      const Eigen::VectorXd x_before = x;
      const Eigen::VectorXd z = paths(p);
      Eigen::VectorXd g(z.size() - 1);
      g << z(0), z.tail(z.size() - 2);
      process(g, p);
      double norm = 0;
      double sum = 0;
      for (int j = 0; j < p.nb; ++j) {
        norm += p.b[j] * p.b[j];
        sum += p.b[j];
      }
      const double scale = std::copysign(std::sqrt(norm), sum);
      double change = (p.d - before.d) * (p.d - before.d);
      double size = p.d * p.d;
      for (int i = 0; i < p.na; ++i) {
        change += (p.a[i] - before.a[i]) * (p.a[i] - before.a[i]);
        size += p.a[i] * p.a[i];
      }
      for (int j = 0; j < p.nb; ++j) {
        p.b[j] /= scale;
        change += (p.b[j] - before.b[j]) * (p.b[j] - before.b[j]);
        size += p.b[j] * p.b[j];
      }
      x = scale * positions(g);
      if (iterations > 1) {
        const double tolerance = TwoPathIteration<double>::kTolerance;
        change += (x - x_before).squaredNorm();
        size += x.squaredNorm();
        if (change < tolerance * tolerance * size) {
          break;
        }
      }
    }
    return x;
  }

  static constexpr int first = LaggedGram<double>::kFirst;
  const test::Window& window;
  Structure s;
  KnotGrid<double> grid;
  int rows;
};

struct Case {
  test::Window window;
  Structure structure;
};

Case any_case(Random& random) {
  Case c;
  c.window = test::random_window(random, 120 + random() % 200);
  c.structure = {1 + static_cast<int>(random() % kMaxNa),
                 1 + static_cast<int>(random() % 3), static_cast<int>(random() % 6),
                 1 + static_cast<int>(random() % 3), 1 + static_cast<int>(random() % 3)};
  const auto truth = test::random_model(
      random, 4, 4, test::random_process(random, 2, 2, c.structure.nk));
  test::simulate(truth, 0.05, random, c.window);
  return c;
}

template <class Real>
void compare(const TwoPathModel<Real>& model, const Process<double>& p,
             const Eigen::VectorXd& x, double tolerance) {
  const auto near = [&](Real found, double expected) {
    ASSERT_NEAR(static_cast<double>(found), expected, tolerance);
  };
  for (int i = 0; i < p.na; ++i) {
    near(model.process.a[i], p.a[i]);
  }
  for (int j = 0; j < p.nb; ++j) {
    near(model.process.b[j], p.b[j]);
  }
  near(model.process.d, p.d);
  for (int i = 0; i <= model.ascending.segments; ++i) {
    near(model.ascending.x[i], x(i));
  }
  for (int i = 0; i <= model.descending.segments; ++i) {
    near(model.descending.x[i], x(model.ascending.segments + 1 + i));
  }
}

TEST(TwoPathIterationOracle, AgreesWithTheDenseIteration) {
  Random random(19);
  static LaggedGram<double> gram;
  static TwoPathIteration<double> iteration;
  int total = 0;
  for (int k = 0; k < 60 && !testing::Test::HasFatalFailure(); ++k) {
    SCOPED_TRACE(k);
    const Case c = any_case(random);
    const DenseIteration dense(c.window, c.structure);
    Process<double> p;
    int iterations = 0;
    const Eigen::VectorXd x = dense.fit(p, iterations);
    test::accumulate(gram, dense.grid, c.window.view());
    TwoPathModel<double> model;
    ASSERT_TRUE(test::fit(iteration, gram, c.structure, model));
    compare(model, p, x, 1e-6 * std::max(1.0, x.cwiseAbs().maxCoeff()));
    total += iterations;
  }
  EXPECT_GT(total, 3 * 60);
}

// One structure of every na, nb in float. Normal equations square the condition number
// (10² … 10³ here), so 10⁻⁷ becomes up to 10⁻² of the largest parameter; the stop rule
// leaves as much.
TEST(TwoPathIterationOracle, InFloat) {
  Random random(20);
  static LaggedGram<float> gram;
  static TwoPathIteration<float> iteration;
  for (int k = 0; k < 40 && !testing::Test::HasFatalFailure(); ++k) {
    SCOPED_TRACE(k);
    const Case c = any_case(random);
    const DenseIteration dense(c.window, c.structure);
    Process<double> p;
    int iterations = 0;
    const Eigen::VectorXd x = dense.fit(p, iterations);
    const test::FloatWindow window(c.window);
    test::accumulate(gram,
                     test::uniform_grid<float>(c.structure.segments_ascending,
                                               c.structure.segments_descending),
                     window.view());
    TwoPathModel<float> model;
    ASSERT_TRUE(test::fit(iteration, gram, c.structure, model));
    compare(model, p, x, 0.03 * std::max(1.0, x.cwiseAbs().maxCoeff()));
  }
}

TEST(TwoPathIterationOracle, LinearHalfStepAgreesWithLeastSquares) {
  Random random(21);
  static LaggedGram<double> gram;
  static TwoPathIteration<double> iteration;
  for (int k = 0; k < 60 && !testing::Test::HasFatalFailure(); ++k) {
    SCOPED_TRACE(k);
    const Case c = any_case(random);
    const DenseIteration dense(c.window, c.structure);
    Process<double> p;
    p.na = c.structure.na;
    p.nb = c.structure.nb;
    p.nk = c.structure.nk;
    // x = u on both paths: no offset, increments of one n-th each.
    Eigen::VectorXd g(1 + c.structure.segments_ascending +
                      c.structure.segments_descending);
    g(0) = 0;
    g.segment(1, c.structure.segments_ascending)
        .setConstant(1.0 / c.structure.segments_ascending);
    g.tail(c.structure.segments_descending)
        .setConstant(1.0 / c.structure.segments_descending);
    dense.process(g, p);
    test::accumulate(gram, dense.grid, c.window.view());
    TwoPathModel<double> model;
    ASSERT_TRUE(test::fit_linear(iteration, gram, c.structure, model));
    compare(model, p, dense.positions(g), 1e-7);
  }
}

}  // namespace
}  // namespace ident
