#include "support/ident/loop.hpp"

#include <cmath>

namespace test {

Window random_window(Random& random, std::size_t n) {
  Window w;
  bool up = true;
  double u = 0.5;
  while (w.u.size() < n) {
    const double target = up ? uniform(random, 0.6, 1.0) : uniform(random, 0.0, 0.4);
    const int steps = 5 + static_cast<int>(random() % 20);
    const double from = u;
    for (int k = 1; k <= steps && w.u.size() < n; ++k) {
      u = from + (target - from) * k / steps;
      w.u.push_back(u);
      w.ascending.push_back(up ? 1 : 0);
      w.y.push_back(normal(random));
    }
    up = !up;
  }
  return w;
}

template <class Real>
ident::KnotGrid<Real> uniform_grid(int segments_ascending, int segments_descending) {
  ident::KnotGrid<Real> grid;
  grid.ascending.segments = segments_ascending;
  grid.descending.segments = segments_descending;
  for (ident::Path<Real>* path : {&grid.ascending, &grid.descending}) {
    for (int i = 0; i <= path->segments; ++i) {
      path->knots[i] = static_cast<Real>(i) / static_cast<Real>(path->segments);
    }
  }
  return grid;
}
template ident::KnotGrid<float> uniform_grid<float>(int, int);
template ident::KnotGrid<double> uniform_grid<double>(int, int);

ident::KnotGrid<double> random_grid(Random& random, int segments_ascending,
                                    int segments_descending) {
  auto grid = uniform_grid<double>(segments_ascending, segments_descending);
  for (ident::Path<double>* path : {&grid.ascending, &grid.descending}) {
    for (int i = 0; i <= path->segments; ++i) {
      path->knots[i] =
          0.05 + 0.9 * (path->knots[i] + uniform(random, -0.3, 0.3) / path->segments);
    }
  }
  return grid;
}

double hat_value(const ident::KnotGrid<double>& grid, int hat, double u, bool ascending) {
  const int ascending_hats = grid.ascending.segments + 1;
  if ((hat < ascending_hats) != ascending) {
    return 0;
  }
  ident::Path<double> path = ascending ? grid.ascending : grid.descending;
  path.x.fill(0);
  path.x[ascending ? hat : hat - ascending_hats] = 1;
  return path.at(u);
}

ident::Process<double> random_process(Random& random, int na, int nb, int nk) {
  ident::Process<double> p;
  p.na = na;
  p.nb = nb;
  p.nk = nk;
  std::vector<double> polynomial{1};
  for (int i = 0; i < na; ++i) {
    const double pole = uniform(random, i == 0 ? 0.5 : -0.4, i == 0 ? 0.95 : 0.6);
    polynomial.push_back(0);
    for (std::size_t k = polynomial.size() - 1; k > 0; --k) {
      polynomial[k] -= pole * polynomial[k - 1];
    }
  }
  for (int i = 0; i < na; ++i) {
    p.a[i] = polynomial[i + 1];
  }
  double norm = 0;
  for (int j = 0; j < nb; ++j) {
    p.b[j] = uniform(random, 0.1, 1);
    norm += p.b[j] * p.b[j];
  }
  for (int j = 0; j < nb; ++j) {
    p.b[j] /= std::sqrt(norm);
  }
  p.d = uniform(random, -0.5, 0.5);
  return p;
}

ident::TwoPathModel<double> random_model(Random& random, int segments_ascending,
                                         int segments_descending,
                                         const ident::Process<double>& process) {
  const auto grid = uniform_grid<double>(segments_ascending, segments_descending);
  ident::TwoPathModel<double> model{process, grid.ascending, grid.descending};
  model.ascending.x[0] = uniform(random, -0.5, 0);
  model.descending.x[0] = 0;
  for (ident::Path<double>* path : {&model.ascending, &model.descending}) {
    for (int i = 0; i < path->segments; ++i) {
      path->x[i + 1] = path->x[i] + uniform(random, 0.1, 1) / path->segments;
    }
  }
  return model;
}

void simulate(const ident::TwoPathModel<double>& model, double noise, Random& random,
              Window& window) {
  std::vector<double> x(window.u.size());
  valve_positions<double>(model, window.u, window.ascending, x);
  free_run<double>(model.process, x, {}, window.y);
  for (double& y : window.y) {
    y += noise * normal(random);
  }
}

Window simulate_loop(const LoopSettings& settings, std::size_t n, Random& random) {
  Window w;
  const std::size_t settle = 1000;
  ident::StickSlipValve<double> valve(settings.friction, 0);
  std::vector<double> x(n + settle, 0.0);
  const double pole = std::exp(-1 / settings.time_constant);
  double process = 0;
  double integral = 0;
  for (std::size_t t = 0; t < n + settle; ++t) {
    const std::size_t lag = static_cast<std::size_t>(settings.dead_time) + 1;
    process = pole * process + (1 - pole) * settings.gain * (t >= lag ? x[t - lag] : 0.0);
    const double y = process + settings.noise * normal(random);
    const double error = 0.7 - y;  // a setpoint off the valve's rest point
    integral += settings.integral * error;
    const double u = settings.proportional * error + integral;
    x[t] = valve.step(u);
    if (t >= settle) {
      w.u.push_back(u);
      w.y.push_back(y);
      w.ascending.push_back(w.u.size() > 1 && u > w.u[w.u.size() - 2] ? 1 : 0);
    }
  }
  return w;
}

}  // namespace test
