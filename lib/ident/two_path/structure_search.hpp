// Which (na, nb, nk, pA, pD) and which knots: equation (8) and Remark 4 of the paper.
#pragma once

#include <array>
#include <span>
#include <variant>

#include "ident/two_path/lagged_gram.hpp"
#include "ident/two_path/output_error.hpp"
#include "ident/two_path/path_simulation.hpp"
#include "ident/two_path/two_path_iteration.hpp"
#include "ident/two_path/two_path_model.hpp"

namespace ident {

/// A model with its standing in the search.
template <class Real>
struct StructureCandidate {
  bool known = false;
  TwoPathModel<Real> model;
  InitialState<Real> initial{};
  Real error = 0;  ///< Σ(y − ŷ)² of the free simulation
  Real aic = 0;    ///< N·log(error) + 2·dim, equation (8)
};

/// (M8) True when the step response of the process never goes visibly the wrong way and
/// keeps most of what it reached: what u → y of a plant does and y → u of its controller,
/// read backwards, does not. In closed loop both fit; only one is a process.
template <class Real>
[[nodiscard]] bool is_process_like(const Process<Real>& process);

/// Searches the structures of the two-path model, or of a linear valve before the same
/// process forms, by AIC on the simulation error.
///
/// 1. Sweeps over one coordinate at a time (nk; na and nb; pA; pD) from one pass over the
///    data, each structure solved by the paper's iteration; the best for each na is kept.
/// 2. Those are refined on the simulation error; then neighbouring dead times are tried.
/// 3. Knots are added where a path jumps and dropped where it is flat (Remark 4).
/// It stops after any piece of these and resumes: `start`, `step` until `done`. Bounds:
/// about 180 structures, 4 + 6 refinements of kRefineSteps and kKnotRounds more.
/// Memory: the sweep and the refinement have one place in turn.
template <class Real>
class StructureSearch {
 public:
  static constexpr int kRefineSteps = 10;
  static constexpr int kKnotRounds = 6;

  enum class ValveKind : unsigned char { kTwoPath, kLinear };

  /// Starts on a scaled window: u in 0 … 1, y with zero mean and unit variance. `scratch`
  /// has the length of the window. All spans must outlive the search.
  void start(const WindowView<Real>& window, ValveKind kind, std::span<Real> scratch);
  /// Goes on by about `budget` units; true when done.
  bool step(int budget);
  [[nodiscard]] bool done() const { return stage_ == Stage::kDone; }
  /// The winner; `known` is false when no stable, process-like model was found.
  [[nodiscard]] const StructureCandidate<Real>& best() const { return best_; }

 private:
  enum class Stage : unsigned char { kSums, kSweep, kRefine, kDelay, kKnots, kDone };
  enum class Sweeping : unsigned char { kChoose, kSolve, kSimulate, kTake };

  struct Sweep {
    LaggedGram<Real> gram;
    TwoPathIteration<Real> iteration;
    PathSimulation<Real> simulation;
  };

  [[nodiscard]] Sweep& sweep() { return *std::get_if<Sweep>(&scratchpad_); }
  [[nodiscard]] OutputErrorFit<Real>& output_error() {
    return *std::get_if<OutputErrorFit<Real>>(&scratchpad_);
  }
  int piece();
  int sweep_piece();
  [[nodiscard]] bool sweep_structure(Structure& structure) const;
  void choose_structure();
  void begin_simulation();
  void take_structure();
  void end_axis();
  void start_plain();
  void begin_refine(const StructureCandidate<Real>& from);
  void next_refinement();
  void finish_refine();
  void begin_knots();
  [[nodiscard]] Real aic(const StructureCandidate<Real>& candidate) const;
  [[nodiscard]] bool linear() const { return kind_ == ValveKind::kLinear; }

  WindowView<Real> window_;
  std::span<Real> scratch_;
  ValveKind kind_ = ValveKind::kTwoPath;
  Stage stage_ = Stage::kDone;
  std::variant<Sweep, OutputErrorFit<Real>> scratchpad_;  // kSweep, and what follows
  std::array<StructureCandidate<Real>, kMaxNa> kept_;     // best for each na
  StructureCandidate<Real> trial_;
  StructureCandidate<Real> best_;
  Structure structure_;  // of the trial
  Structure centre_;     // the sweep's present winner
  Real centre_aic_ = 0;
  int round_ = 0;  // of the sweep
  int axis_ = 0;
  int swept_ = 0;  // axes, one after the other, through the present centre
  int index_ = 0;
  int delay_step_ = 1;
  Sweeping sweeping_ = Sweeping::kChoose;
  bool refining_ = false;
};

}  // namespace ident
