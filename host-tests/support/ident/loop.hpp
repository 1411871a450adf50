// Windows of data and dense regressors: the slow way to what the identifier computes.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "ident/two_path/lagged_gram.hpp"
#include "ident/two_path/two_path_model.hpp"
#include "ident/valve/stick_slip_valve.hpp"
#include "support/ident/problems.hpp"
#include "support/ident/two_path_reference.hpp"

namespace test {

/// A window in double, with views in both precisions.
struct Window {
  std::vector<double> u;
  std::vector<double> y;
  std::vector<unsigned char> ascending;

  [[nodiscard]] ident::WindowView<double> view() const { return {u, y, ascending}; }
};

/// The same window in float.
struct FloatWindow {
  explicit FloatWindow(const Window& window)
      : u(as<float>(window.u)), y(as<float>(window.y)), ascending(window.ascending) {}
  [[nodiscard]] ident::WindowView<float> view() const { return {u, y, ascending}; }

  std::vector<float> u;
  std::vector<float> y;
  std::vector<unsigned char> ascending;
};

/// u: triangles of random length and height in 0 … 1, exact directions; y: noise.
Window random_window(Random& random, std::size_t n);

/// Knots at equal distances over 0 … 1, or at random ones.
template <class Real>
ident::KnotGrid<Real> uniform_grid(int segments_ascending, int segments_descending);
ident::KnotGrid<double> random_grid(Random& random, int segments_ascending,
                                    int segments_descending);

/// Value of hat function `hat` (ascending first) of one sample, from its definition: 1 at
/// its own knot, 0 at the others, straight between, constant outside.
double hat_value(const ident::KnotGrid<double>& grid, int hat, double u, bool ascending);

/// A stable process with random poles, `na` 1 … 4, unit ‖b‖, Σb > 0.
ident::Process<double> random_process(Random& random, int na, int nb, int nk);

/// Rising paths over the knots of a grid, x_D(first knot) = 0.
ident::TwoPathModel<double> random_model(Random& random, int segments_ascending,
                                         int segments_descending,
                                         const ident::Process<double>& process);

/// Sets y to the free simulation of the model from rest, plus white noise.
void simulate(const ident::TwoPathModel<double>& model, double noise, Random& random,
              Window& window);

/// A PI loop around a first-order process and a stick-slip valve, y with white noise.
struct LoopSettings {
  ident::ValveFriction<double> friction;
  double gain = 1.25;
  double time_constant = 80;  // samples
  int dead_time = 4;          // samples, beyond the first
  double proportional = 1.3;
  double integral = 0.065;  // per sample
  double noise = 0.02;
};
Window simulate_loop(const LoopSettings& settings, std::size_t n, Random& random);

}  // namespace test
