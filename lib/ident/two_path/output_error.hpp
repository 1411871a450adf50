// Refinement on the simulation error: what least squares leaves biased.
#pragma once

#include <array>
#include <span>

#include "ident/base/nnls.hpp"
#include "ident/two_path/lagged_gram.hpp"
#include "ident/two_path/path_simulation.hpp"
#include "ident/two_path/two_path_model.hpp"

namespace ident {

/// Minimises the squared error of the free simulation over the process, the initial
/// state and, if asked, both valve paths, by Levenberg–Marquardt steps in which the
/// slopes stay non-negative (M7). The equation-error estimate of the iteration is biased
/// when noise enters at y, as it does in a real loop; this one is not.
///
/// Only stable processes are accepted, so the result is never worse than the start
/// and never unstable. It ends where a step gains less than 10⁻⁴ of the error.
///
/// Life: new → start → step until done → error; or `refine`, all at once. Cost of one
/// Levenberg–Marquardt step: one pass with n(n+1)/2 + n·na multiplications a sample, n
/// the number of unknowns, at most na + nb + na + 2 + 2·kMaxSegments; then for each
/// damping that is tried (≤ 14) a least-squares problem of n unknowns and a plain
/// simulation.
template <class Real>
class OutputErrorFit {
 public:
  /// Begins to refine `model` and `initial` on the window, in at most `max_steps` steps.
  /// Where the valve position `x` is given (length N) the model's paths are not touched;
  /// where it is empty they are estimated, too. `scratch` has length N. Everything must
  /// outlive the work.
  void start(const WindowView<Real>& window, std::span<const Real> x, int max_steps,
             TwoPathModel<Real>& model, InitialState<Real>& initial,
             std::span<Real> scratch);
  /// A part of a simulation or of the equations, or one least-squares problem. Returns
  /// its cost, as StructureSearch counts it.
  int step();
  [[nodiscard]] bool done() const { return stage_ == Stage::kDone; }
  /// Σ(y − ŷ)² of the model as it stands; `scratch` holds ŷ when done.
  [[nodiscard]] Real error() const { return error_; }

 private:
  enum class Stage : unsigned char {
    kSimulate,
    kEquations,
    kSolve,
    kTry,
    kRestore,
    kDone
  };
  static constexpr int kRows = 4;  // added to the sums together
  static constexpr int kRing = 8;  // a power of two > kMaxNa

  /// A signal's last values, the newest where the pass stands.
  using Memory = std::array<Real, kRing>;

  /// Where the pass over the samples stands. Every sensitivity is a signal through 1/A:
  /// of ŷ, of x, of 1, of an impulse, of each hat.
  struct Pass {
    std::ptrdiff_t next = 0;  // sample
    unsigned now = 0;         // place of the newest of each memory
    int filled = 0;           // rows that wait for add_rows
    bool remembers = true;    // the impulse is not over yet
    Memory of_y{};
    Memory of_one{};
    Memory impulse{};
    std::array<Memory, kMaxNb> of_x{};
    PathFollower<Real> valve;
    PastValues<Real> x;
    PastValues<HatPair<Real>> pair;
  };

  void begin_pass();
  void add_samples(std::ptrdiff_t end);
  void add_paths(std::array<Real, kMaxUnknowns>& row);
  [[nodiscard]] unsigned back(int lag) const {
    return (pass_.now + kRing - static_cast<unsigned>(lag)) % kRing;
  }
  void finish_pass();
  void begin_step();
  int add_piece();
  void begin_simulation(Stage stage, const TwoPathModel<Real>& model,
                        const InitialState<Real>& initial);
  void begin_solution();
  [[nodiscard]] bool take_solution();
  void damp();
  void take_trial(Real error);
  void add_rows();
  [[nodiscard]] Real position(std::ptrdiff_t t);
  [[nodiscard]] HatPair<Real> pair_at(std::ptrdiff_t t) const;
  void read();
  void write_trial();
  [[nodiscard]] bool with_paths() const { return x_.empty(); }

  WindowView<Real> window_;
  std::span<const Real> x_;
  std::span<Real> scratch_;
  TwoPathModel<Real>* model_ = nullptr;
  InitialState<Real>* initial_ = nullptr;
  TwoPathModel<Real> trial_;
  InitialState<Real> trial_initial_{};
  Stage stage_ = Stage::kDone;
  int steps_left_ = 0;
  Real damping_ = 0;
  Real error_ = 0;

  NonNegativeLeastSquares<Real> nnls_;
  UnknownSet constrained_ = 0;
  PathSimulation<Real> simulation_;
  Pass pass_;
  // Sensitivities of ŷ to the unknowns, and y − ŷ, at kRows samples.
  std::array<std::array<Real, kMaxUnknowns>, kRows> rows_;
  std::array<Real, kRows> errors_;
  // Of the hats through 1/A, the last samples.
  std::array<std::array<Real, kMaxHats>, kRing> of_hat_;
  Square<Real> hessian_;
  Column<Real> diagonal_;  // of the Hessian, while its own is damped
  Column<Real> gradient_;
  Column<Real> now_;
  Column<Real> next_;
  Column<Real> rhs_;
};

}  // namespace ident
