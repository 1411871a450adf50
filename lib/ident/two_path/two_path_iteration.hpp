// The paper's iteration, Section 3, Steps 1 and 2, on sums from one pass.
#pragma once

#include "ident/base/nnls.hpp"
#include "ident/two_path/lagged_gram.hpp"
#include "ident/two_path/two_path_model.hpp"

namespace ident {

/// What equation (8) searches over.
struct Structure {
  int na = 1;
  int nb = 1;
  int nk = 0;
  int segments_ascending = 1;   ///< p_A − 1
  int segments_descending = 1;  ///< p_D − 1

  [[nodiscard]] bool operator==(const Structure&) const = default;
};

/// Solves equation (5): alternates between the slopes of both paths (non-negative least
/// squares) and the process (a, b, d), until the relative change of all parameters,
/// equation (7), is below `kTolerance` or `kMaxIterations` is met.
///
/// What the paper leaves open (M3): the gauge x_D(first knot) = 0 (adding a constant to
/// both paths and taking it from d changes nothing), and d is solved in both halves.
/// Cost of one iteration: about 4·26² + n³/3 for n unknowns, nothing in N.
///
/// Life: new → start → step until done → solved.
template <class Real>
class TwoPathIteration {
 public:
  static constexpr int kMaxIterations = 30;
  static constexpr Real kTolerance = Real(0.003);

  /// Begins to fit a model of the given structure. The number of segments must divide the
  /// grid's (or equal it where knots are not uniform). `model` gets the grid's knots.
  /// `gram` and `model` must outlive the work.
  void start(const LaggedGram<Real>& gram, const Structure& structure,
             TwoPathModel<Real>& model);
  /// A piece of one half of an iteration, the paths or the process; true when done.
  bool step();
  /// Of the next step, thousands of instructions of a Cortex-M4F, most.
  [[nodiscard]] int cost_of_step() const;
  [[nodiscard]] bool done() const { return part_ == Part::kDone; }
  /// False when the sums gave no finite answer. After `done`.
  [[nodiscard]] bool solved() const { return solved_; }

  /// Begins the same process regression behind a linear valve x = u: one half step.
  void start_linear(const LaggedGram<Real>& gram, const Structure& structure,
                    TwoPathModel<Real>& model);

 private:
  enum class Part : unsigned char { kSums, kPaths, kInputs, kProcess, kDone };

  void begin(const LaggedGram<Real>& gram, const Structure& structure,
             TwoPathModel<Real>& model);
  bool normalise(Process<Real>& process);
  [[nodiscard]] bool settled(const Process<Real>& process) const;
  void finish();
  void begin_paths(const LaggedGram<Real>& gram, const Structure& s,
                   const Process<Real>& process);
  void lay_paths(const KnotGrid<Real>& grid, const Structure& s);
  void begin_process(const LaggedGram<Real>& gram, const Process<Real>& process);
  void add_input(const LaggedGram<Real>& gram, const Process<Real>& process, int j);
  bool solve_process(Process<Real>& process);
  void end_iteration();

  NonNegativeLeastSquares<Real, kMaxHats> nnls_;
  HatSquare<Real> hats_;    // filtered basis, hat coordinates
  HatSquare<Real> normal_;  // the problem being solved
  HatColumn<Real> hat_rhs_;
  HatColumn<Real> hat_sum_;
  HatColumn<Real> rhs_;
  HatColumn<Real> slopes_;  // solution for the paths: κ, d, the increments
  HatColumn<Real> solution_;
  HatColumn<Real> x_;  // values of both paths at the grid's knots

  const LaggedGram<Real>* gram_ = nullptr;
  TwoPathModel<Real>* model_ = nullptr;
  Structure structure_;
  Process<Real> previous_;  // and the paths, of the last iteration
  HatColumn<Real> previous_x_;
  int iteration_ = 0;
  int input_ = 0;  // lag of x whose sums are added next
  Part part_ = Part::kDone;
  bool linear_ = false;
  bool solved_ = false;
};

}  // namespace ident
