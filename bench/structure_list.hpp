// Steps 1 and 2 of the paper and equation (8) for a list of structures: the part of the
// search that the Octave peer also does.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "bench/example_window.hpp"
#include "ident/two_path/lagged_gram.hpp"
#include "ident/two_path/output_error.hpp"
#include "ident/two_path/two_path_iteration.hpp"
#include "ident/two_path/two_path_model.hpp"

namespace bench {

/// Equal segments over the range of u, kMaxSegments for each path.
template <class Real>
[[nodiscard]] ident::KnotGrid<Real> uniform_grid();

/// The sums of the window at those knots. The window must outlive their use.
template <class Real>
void sum_up(const ident::WindowView<Real>& window, ident::LaggedGram<Real>& gram);

/// One structure and how well it simulates.
template <class Real>
struct StructureFit {
  ident::Structure structure;
  bool known = false;    ///< solved and stable
  Real aic = 0;          ///< equation (8)
  Real fit_percent = 0;  ///< equation (23)
  ident::TwoPathModel<Real> model;
};

/// Evaluates structures on one window: sums once, then the iteration and a free
/// simulation for each.
template <class Real>
class StructureEvaluator {
 public:
  /// One pass for the sums. The window must outlive the evaluator's use.
  void start(const ScaledWindow<Real>& window);
  [[nodiscard]] StructureFit<Real> evaluate(const ident::Structure& structure);

 private:
  ident::WindowView<Real> window_;
  ident::LaggedGram<Real> gram_;
  ident::TwoPathIteration<Real> iteration_;
  std::vector<Real> simulated_;
};

/// What coordinate sweeps try, in their order: nk, then na and nb, then p_A, then p_D,
/// each around the best so far, until a sweep gains nothing.
[[nodiscard]] std::vector<StructureFit<double>> coordinate_sweep(
    const ScaledWindow<double>& window);

}  // namespace bench
