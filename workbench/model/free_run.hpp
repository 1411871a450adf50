// The simulation of a set of effects, compiled for one recording: from values of the
// searched parameters to the output, with everything linear solved by least squares.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "workbench/effects/effect.hpp"
#include "workbench/model/blocks.hpp"
#include "workbench/model/work.hpp"

namespace workbench {

/// Free simulation from u over the whole recording; the squared error is counted on the
/// estimation blocks. Gain, offset, loads and initial state are solved inside (variable
/// projection, Golub & Pereyra 1973), so a search sees only the nonlinear parameters.
///
/// Life: construct → run(p) → residual(), coefficients(). Buffers are allocated once.
/// Cost of `run`: about 20 ns a sample and column.
class FreeRun {
 public:
  /// One searched parameter and who owns it.
  struct Slot {
    SearchedParameter parameter;
    const Effect* effect = nullptr;  ///< null: the process
  };
  /// True where the search may move slot `i` of a point `p`: no constant, and not
  /// switched off by one.
  [[nodiscard]] static bool is_searched(std::span<const Slot> slots,
                                        std::span<const double> p, std::size_t i);

  /// One column and what its coefficient is.
  struct Column {
    std::string name;
    std::string unit;
    const Effect* effect = nullptr;  ///< null: the process
    bool initial = false;            ///< belongs to the recording, not to the plant
    bool strength = false;           ///< zero means that its effect is absent
  };

  /// `effects` in any order; all that is referred to must outlive this. Every run asks
  /// `work` first whether it may go on.
  FreeRun(const Situation& situation, const Blocks& blocks,
          std::vector<const Effect*> effects, const Work& work = Work::unlimited());

  /// The searched parameters: those of the process first, then effect by effect in the
  /// order of the chain.
  [[nodiscard]] const std::vector<Slot>& slots() const { return slots_; }
  /// Where the parameters of one effect begin; slots().size() when it has none.
  [[nodiscard]] std::size_t first_slot(const Effect& effect) const;
  [[nodiscard]] const std::vector<const Effect*>& effects() const { return effects_; }
  [[nodiscard]] bool integrating() const { return integrating_; }

  /// Simulates and solves. Returns the sum of squared errors on the estimation blocks,
  /// infinity where the simulation is not finite. `p` as in slots(), within bounds.
  double run(std::span<const double> p);
  enum class Rows { kEstimation, kAll };
  /// The same with the plant's coefficients given; only the initial state is solved, on
  /// the given rows. `plant` as in columns(), entries of initial columns ignored.
  double run_with(std::span<const double> p, std::span<const double> plant, Rows rows);

  /// Of the last run, all samples: y minus the simulation.
  [[nodiscard]] std::span<const double> residual() const { return residual_; }
  /// Of the last run.
  [[nodiscard]] const std::vector<Column>& columns() const { return columns_; }
  [[nodiscard]] std::span<const double> coefficients() const { return coefficients_; }
  /// Factor by which column `i` enters the output, cut-off and sensor included: the
  /// derivative of the simulation with respect to coefficient `i`.
  [[nodiscard]] std::span<const double> column(std::size_t i) const { return used_[i]; }
  /// v, the signal that leaves the valve, units of u.
  [[nodiscard]] std::span<const double> valve() const { return valve_; }
  [[nodiscard]] const Situation& situation() const { return *situation_; }
  [[nodiscard]] const Blocks& blocks() const { return *blocks_; }

 private:
  void simulate_valve(std::span<const double> p);
  void build_columns(std::span<const double> p);
  void finish(std::span<const double> p);
  void solve_behind_rounding(std::span<const double> p);
  void solve(bool initial_only, Rows where);
  void output();
  void cut_off();
  void cut_columns();
  [[nodiscard]] double memory() const;
  [[nodiscard]] std::span<const double> of(const Effect& effect,
                                           std::span<const double> p) const;
  std::span<double> next_column(std::string_view name, std::string_view unit,
                                const Effect* effect, bool initial, bool strength);

  const Situation* situation_;
  const Blocks* blocks_;
  const Work* work_;
  std::vector<const Effect*> effects_;
  std::vector<Slot> slots_;
  std::vector<std::size_t> first_;  // slot of each effect
  std::size_t process_slots_ = 0;
  std::size_t valve_slots_end_ = 0;
  bool integrating_ = false;

  std::vector<double> last_p_;
  std::vector<double> valve_;
  std::size_t at_rest_ = 0;
  double settling_s_ = 0;
  ProcessShape shape_;
  std::optional<Ceiling> ceiling_;
  std::vector<unsigned char> free_;  // 1 where the output is below the ceiling
  std::vector<double> z_;
  std::vector<double> scratch_;
  std::vector<std::vector<double>> raw_;   // before overflow and sensor
  std::vector<std::vector<double>> used_;  // behind them
  std::vector<Column> columns_;
  std::vector<double> coefficients_;
  std::vector<double> residual_;
};

}  // namespace workbench
