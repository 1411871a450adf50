#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "ident/two_path/output_error.hpp"
#include "support/ident/all_at_once.hpp"
#include "support/ident/loop.hpp"
#include "support/ident/private.hpp"

using ErrorFit = ident::OutputErrorFit<double>;

namespace test {

struct AddSamples {
  using Member = void (ErrorFit::*)(std::ptrdiff_t);
  friend Member reach(AddSamples);
};
struct FinishPass {
  using Member = void (ErrorFit::*)();
  friend Member reach(FinishPass);
};
struct Hessian {
  using Member = ident::Square<double> ErrorFit::*;
  friend Member reach(Hessian);
};
struct Gradient {
  using Member = ident::Column<double> ErrorFit::*;
  friend Member reach(Gradient);
};
template struct Expose<AddSamples, &ErrorFit::add_samples>;
template struct Expose<FinishPass, &ErrorFit::finish_pass>;
template struct Expose<Hessian, &ErrorFit::hessian_>;
template struct Expose<Gradient, &ErrorFit::gradient_>;

}  // namespace test

namespace ident {
namespace {

using test::Random;

// The unknowns in the order of the normal equations, by name and by hand.
std::vector<double*> unknowns(TwoPathModel<double>& model,
                              InitialState<double>& initial) {
  std::vector<double*> out;
  for (int i = 0; i < model.process.na; ++i) {
    out.push_back(&model.process.a[i]);
  }
  for (int j = 0; j < model.process.nb; ++j) {
    out.push_back(&model.process.b[j]);
  }
  out.push_back(&model.process.d);
  for (int i = 0; i < model.process.na; ++i) {
    out.push_back(&initial[i]);
  }
  return out;
}

Eigen::VectorXd simulated(const test::Window& w, const std::vector<double>& x,
                          const TwoPathModel<double>& model,
                          const InitialState<double>& initial) {
  std::vector<double> y(w.u.size());
  simulate_paths<double>(w.view(), x, model, initial, y);
  return Eigen::Map<Eigen::VectorXd>(y.data(), static_cast<Eigen::Index>(y.size()));
}

// ∂ŷ/∂θ by central differences: process, initial state, κ, increments.
Eigen::MatrixXd jacobian(const test::Window& w, const std::vector<double>& x,
                         TwoPathModel<double> model, InitialState<double> initial) {
  const double step = 1e-5;
  std::vector<Eigen::VectorXd> columns;
  const auto difference = [&](const std::function<void(double)>& move) {
    move(step);
    const Eigen::VectorXd up = simulated(w, x, model, initial);
    move(-2 * step);
    const Eigen::VectorXd down = simulated(w, x, model, initial);
    move(step);
    columns.push_back((up - down) / (2 * step));
  };
  for (double* value : unknowns(model, initial)) {
    difference([&](double by) { *value += by; });
  }
  if (x.empty()) {
    const auto raise = [](Path<double>& path, int from, double by) {
      for (int i = from; i <= path.segments; ++i) {
        path.x[i] += by;
      }
    };
    for (int i = 0; i <= model.ascending.segments; ++i) {
      difference([&](double by) { raise(model.ascending, i, by); });
    }
    for (int i = 1; i <= model.descending.segments; ++i) {
      difference([&](double by) { raise(model.descending, i, by); });
    }
  }
  Eigen::MatrixXd out(w.u.size(), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k) {
    out.col(static_cast<Eigen::Index>(k)) = columns[k];
  }
  return out;
}

struct Case {
  test::Window window;
  TwoPathModel<double> model;
  InitialState<double> initial{};
  std::vector<double> x;
};

// With both paths of the model, or a valve position that is given.
Case any_case(Random& random, bool paths) {
  Case c;
  c.window = test::random_window(random, 80);
  const int na = 1 + static_cast<int>(random() % kMaxNa);
  const int nb = 1 + static_cast<int>(random() % kMaxNb);
  c.model = test::random_model(
      random, 1 + static_cast<int>(random() % 4), 1 + static_cast<int>(random() % 4),
      test::random_process(random, na, nb, static_cast<int>(random() % 6)));
  for (int i = 0; i < na; ++i) {
    c.initial[i] = test::normal(random);
  }
  for (const double u : c.window.u) {
    if (!paths) c.x.push_back(u * u);
  }
  return c;
}

class OutputError : public testing::TestWithParam<bool> {
 protected:
  ErrorFit fit_;
};

TEST_P(OutputError, NormalEquationsAreThoseOfFiniteDifferences) {
  Random random(23);
  for (int k = 0; k < 60; ++k) {
    SCOPED_TRACE(k);
    const Case c = any_case(random, GetParam());
    const Eigen::VectorXd y_model = simulated(c.window, c.x, c.model, c.initial);
    TwoPathModel<double> model = c.model;
    InitialState<double> initial = c.initial;
    std::vector<double> y(c.window.u.size());
    // Up to the equations of the first step, which start from no samples.
    ErrorFit fit;
    fit.start(c.window.view(), c.x, 1, model, initial, y);
    while (fit.step(), (fit.*reach(test::Hessian{})).size() == 0) {
    }
    const std::ptrdiff_t end = static_cast<std::ptrdiff_t>(y.size());
    for (std::ptrdiff_t some = 0; some < end; some += 7) {
      (fit.*reach(test::AddSamples{}))(std::min(some + 7, end));
    }
    (fit.*reach(test::FinishPass{}))();
    const Eigen::MatrixXd j = jacobian(c.window, c.x, c.model, c.initial);
    const Eigen::MatrixXd hessian = j.transpose() * j;
    const Eigen::VectorXd e =
        Eigen::Map<const Eigen::VectorXd>(c.window.y.data(), y_model.size()) - y_model;
    const Eigen::VectorXd gradient = j.transpose() * e;
    const auto& found = fit.*reach(test::Hessian{});
    const auto& found_gradient = fit.*reach(test::Gradient{});
    ASSERT_EQ(found.rows(), hessian.rows());
    for (Eigen::Index r = 0; r < hessian.rows(); ++r) {
      // Differences are good to step² and rounding/step, both 10⁻¹⁰ of the scale.
      const double scale = std::sqrt(hessian(r, r));
      EXPECT_NEAR(found_gradient(r), gradient(r), 1e-5 * scale * (1 + e.norm())) << r;
      for (Eigen::Index s = 0; s < hessian.rows(); ++s) {
        EXPECT_NEAR(found(r, s), hessian(r, s),
                    1e-5 * (1 + scale * std::sqrt(hessian(s, s))))
            << r << ' ' << s << " na " << c.model.process.na << " nb "
            << c.model.process.nb;
      }
    }
    if (HasFailure()) {
      return;
    }
  }
}

TEST_P(OutputError, RecoversAKnownModelFromNoiseFreeData) {
  Random random(24);
  int recovered = 0;
  for (int k = 0; k < 30; ++k) {
    Case c = any_case(random, GetParam());
    const Eigen::VectorXd y = simulated(c.window, c.x, c.model, c.initial);
    c.window.y.assign(y.data(), y.data() + y.size());
    TwoPathModel<double> model = c.model;
    InitialState<double> initial = c.initial;
    for (double* value : unknowns(model, initial)) {
      *value *= test::uniform(random, 0.97, 1.03);
    }
    for (int i = 1; GetParam() && i <= model.ascending.segments; ++i) {
      model.ascending.x[i] += 0.02 * i;
    }
    std::vector<double> scratch(c.window.u.size());
    double error = simulate_paths<double>(c.window.view(), c.x, model, initial, scratch);
    for (int round = 0; round < 5; ++round) {
      const double now =
          test::refine(fit_, c.window.view(), c.x, 40, model, initial, scratch);
      EXPECT_LE(now, error);
      error = now;
    }
    recovered += error < 1e-8 * y.squaredNorm() ? 1 : 0;
  }
  EXPECT_GE(recovered, 28);
}

TEST_P(OutputError, IsNeverUnstableNorWorseThanItsStart) {
  Random random(25);
  for (int k = 0; k < 100; ++k) {
    Case c = any_case(random, GetParam());
    if (k % 2 == 0) {
      // A slow pole and data that grow: the fit would like to leave the unit circle.
      c.model.process = test::random_process(random, 1, 1, 0);
      c.model.process.a[0] = -0.99;
      for (std::size_t t = 0; t < c.window.y.size(); ++t) {
        c.window.y[t] = std::exp(0.05 * static_cast<double>(t));
      }
    }
    std::vector<double> scratch(c.window.u.size());
    const double start =
        simulate_paths<double>(c.window.view(), c.x, c.model, c.initial, scratch);
    const double end =
        test::refine(fit_, c.window.view(), c.x, 15, c.model, c.initial, scratch);
    EXPECT_LE(end, start) << k;
    EXPECT_TRUE(is_stable(c.model.process)) << k;
    // The scratch holds the output of the model that came out.
    const Eigen::VectorXd y = simulated(c.window, c.x, c.model, c.initial);
    for (std::size_t t = 0; t < scratch.size(); ++t) {
      ASSERT_EQ(scratch[t], y(static_cast<Eigen::Index>(t)));
    }
    for (int i = 0; GetParam() && i < c.model.ascending.segments; ++i) {
      EXPECT_LE(c.model.ascending.x[i], c.model.ascending.x[i + 1]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Valves, OutputError, testing::Bool());

// The same refinement in both precisions from the same start: the error found in float is
// within 1 % of the one found in double (noise is a tenth of y; sums of 400 products).
TEST(OutputErrorFloat, ReachesTheErrorOfDouble) {
  Random random(26);
  static OutputErrorFit<float> fit_float;
  static OutputErrorFit<double> fit_double;
  for (int k = 0; k < 30; ++k) {
    test::Window w = test::random_window(random, 400);
    const auto truth =
        test::random_model(random, 3, 3, test::random_process(random, 2, 1, 2));
    test::simulate(truth, 0.1, random, w);
    TwoPathModel<double> model = truth;
    model.process.d += 0.05;
    model.process.a[0] *= 0.99;
    TwoPathModel<float> model_float;
    model_float.process.na = 2;
    model_float.process.nk = 2;
    model_float.process.d = static_cast<float>(model.process.d);
    model_float.ascending.segments = model_float.descending.segments = 3;
    for (int i = 0; i < kMaxNa; ++i) {
      model_float.process.a[i] = static_cast<float>(model.process.a[i]);
      model_float.process.b[i] = static_cast<float>(model.process.b[i]);
    }
    for (int i = 0; i < 4; ++i) {
      model_float.ascending.knots[i] = static_cast<float>(model.ascending.knots[i]);
      model_float.descending.knots[i] = static_cast<float>(model.descending.knots[i]);
      model_float.ascending.x[i] = static_cast<float>(model.ascending.x[i]);
      model_float.descending.x[i] = static_cast<float>(model.descending.x[i]);
    }
    const test::FloatWindow wf(w);
    InitialState<double> initial{};
    InitialState<float> initial_float{};
    std::vector<double> scratch(400);
    std::vector<float> scratch_float(400);
    const double error =
        test::refine(fit_double, w.view(), {}, 30, model, initial, scratch);
    const float error_float = test::refine(fit_float, wf.view(), {}, 30, model_float,
                                           initial_float, scratch_float);
    EXPECT_NEAR(static_cast<double>(error_float), error, 0.01 * error) << k;
  }
}

}  // namespace
}  // namespace ident
