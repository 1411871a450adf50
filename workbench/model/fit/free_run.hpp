// The simulation of a set of effects, compiled for one recording: from values of the
// searched parameters to the output, with everything linear solved by least squares.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/effects/effect.hpp"
#include "workbench/model/base/blocks.hpp"
#include "workbench/model/base/least_squares.hpp"
#include "workbench/model/base/work.hpp"

namespace workbench {

/// True for what belongs to the recording it was found in, not to the plant: a load, a
/// drift. One that another recording holds, too (Description::recorded), does not.
[[nodiscard]] bool stays_behind(const Effect& effect);

/// Free simulation from u over the whole recording; the squared error is counted on the
/// estimation blocks. Gain, offset, loads and initial state are solved inside (variable
/// projection, Golub & Pereyra 1973), so a search sees only the nonlinear parameters. A
/// gain of another sign than Situation::gain_sign is solved as 0 (W11).
///
/// Each piece of a recording is simulated for itself, from an initial state (W4) of its
/// own, each recording but the first on a level of its own; the rest of the parameters
/// are those of all (W9). One that judges has part in none: its initial state is solved
/// on all of its samples, and what stays_behind() is left out.
///
/// Life: construct → run(p) → residual(), coefficients(). Buffers are allocated once. A
/// copy runs by itself, on another thread: what it says depends on `p` alone.
/// Cost of `run`: about 20 ns a sample and column.
class FreeRun {
 public:
  /// One searched parameter and who owns it.
  struct Slot {
    SearchedParameter parameter;
    const Effect* effect = nullptr;  ///< null: the process
    std::size_t piece = 0;           ///< of the recording; 0 for all but initial states
    bool judges = false;             ///< of a piece that nothing is fitted to
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
    std::size_t piece = 0;           ///< of the recording; 0 for what all share
    bool judges = false;             ///< of a piece that nothing is fitted to
  };

  /// True for the column whose coefficient is the gain of the process.
  [[nodiscard]] static bool is_gain(const Column& column) {
    return column.effect == nullptr && column.name == "gain";
  }

  /// `effects` in any order; all that is referred to must outlive this. Every run asks
  /// `work` first whether it may go on. `colour` as for weigh_by.
  FreeRun(const Situation& situation, const Blocks& blocks,
          std::vector<const Effect*> effects, const Work& work = Work::unlimited(),
          std::vector<double> colour = {});

  /// A parameter that is given and not estimated: searched or solved, by its name.
  struct Held {
    const Effect* effect = nullptr;  ///< null: the process
    std::string name;
    double value = 0;
  };
  /// From now on. What has no such parameter is ignored.
  void hold(std::span<const Held> held);

  /// The searched parameters: those of the process first, then effect by effect in the
  /// order of the chain.
  [[nodiscard]] const std::vector<Slot>& slots() const { return slots_; }
  /// Where the parameters of one effect begin; slots().size() when it has none.
  [[nodiscard]] std::size_t first_slot(const Effect& effect) const;
  [[nodiscard]] const std::vector<const Effect*>& effects() const { return effects_; }
  [[nodiscard]] bool integrating() const { return integrating_; }

  /// From now on errors are weighed: the residual is squared behind the filter of that
  /// noise colour (NoiseColour::a, noise.hpp), and what is solved makes that least.
  /// Empty: every sample as it is. The simulation stays free of y.
  void weigh_by(std::vector<double> colour);
  [[nodiscard]] const std::vector<double>& weight() const { return weight_; }

  /// Simulates and solves. Returns the sum of squared errors on the estimation blocks,
  /// infinity where the simulation is not finite. `p` as in slots(), within bounds.
  double run(std::span<const double> p);
  enum class Rows { kEstimation, kAll };
  /// The same with the plant's coefficients given; only the initial state is solved, on
  /// the given rows. `plant` as in columns(), entries of initial columns ignored.
  double run_with(std::span<const double> p, std::span<const double> plant, Rows rows);

  /// Of the last run, all samples: y minus the simulation; 0 where samples are left out.
  [[nodiscard]] std::span<const double> residual() const { return residual_; }
  /// Of the last run, what is squared: residual(), weighed.
  [[nodiscard]] std::span<const double> judged() const {
    return weight_.empty() ? residual_ : judged_;
  }
  /// Of the last run, column(i) as it enters judged().
  [[nodiscard]] std::vector<double> judged_column(std::size_t i) const;
  /// Of the last run, y minus the simulation of the samples that are left out.
  [[nodiscard]] std::span<const double> aside() const { return aside_; }
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
  [[nodiscard]] const Work& work() const { return *work_; }

 private:
  void simulate_valve(std::span<const double> p);
  void stop_at_limit(std::size_t piece, std::span<const double> p, ValveSignal& signal);
  void build_columns(std::span<const double> p);
  void build_piece(std::size_t piece, std::span<const double> p);
  void form_shape(std::size_t piece, std::span<const double> p);
  void add_response(std::size_t piece, std::span<const double> p);
  [[nodiscard]] bool begins_other_load(std::size_t piece) const;
  void add_level(std::size_t piece);
  void add_initial_states(std::size_t piece);
  void add_effects(std::size_t piece, std::span<const double> p);
  void add_decay(std::size_t piece, std::string_view name, double lag_s);
  std::span<double> shared_column(std::size_t piece, std::string_view name,
                                  std::string_view unit);
  std::span<double> initial_column(std::size_t piece, std::string_view name,
                                   double memory_s);
  [[nodiscard]] double memory_of_state(double lag_s) const;
  [[nodiscard]] double memory_of_process() const;
  void take_loads();
  void behind_sensor(std::span<const double> in, std::span<double> out) const;
  void finish(std::span<const double> p);
  void record_columns(std::span<const double> p);
  void lay_columns(std::span<const double> p);
  void solve_behind_rounding(std::span<const double> p);
  void set_aside();
  [[nodiscard]] const Held* held(const Column& column) const;
  void solve(bool initial_only, Rows where);
  [[nodiscard]] std::size_t gain_column() const;
  // What is underway at the first sample: u of all of the dead time before, or of half.
  static constexpr std::string_view kPipe = "initial_pipe";
  static constexpr std::string_view kFirstHalfOfPipe = "initial_pipe_first_half";

  [[nodiscard]] bool gain_runs_away() const;
  [[nodiscard]] bool drop_impossible_pipes(std::vector<std::size_t>& active);
  void solve(const std::vector<std::size_t>& active, std::span<const Block> rows);
  void improve(const std::vector<std::size_t>& active, std::span<const Block> rows);
  void weigh(std::span<const double> in, std::vector<double>& out) const;
  [[nodiscard]] double error_on(std::span<const Block> rows);
  void output();
  void cut_off();
  void cut_columns();
  struct Cut {
    std::size_t first;
    std::size_t last;
    std::size_t next;  // end of the free stretch from `last` on
  };
  [[nodiscard]] std::vector<Cut> cuts() const;
  [[nodiscard]] double memory() const;
  // Valid until the next call.
  [[nodiscard]] std::span<const double> of(const Effect& effect,
                                           std::span<const double> p, std::size_t piece);
  // What of a signal, and of the situation, lies in a piece.
  std::span<double> part(std::vector<double>& signal, std::size_t piece) const;
  [[nodiscard]] Situation in_piece(std::size_t piece) const;
  // The part of a column that lies in its piece.
  std::span<double> place(const Column& column, bool own);
  std::span<double> place(const Column& column, bool own, std::size_t count);

  const Situation* situation_;
  const Blocks* blocks_;
  const Work* work_;
  std::vector<const Effect*> effects_;
  std::vector<Slot> slots_;
  std::vector<std::size_t> first_;  // slot of each effect
  std::vector<std::size_t> count_;  // slots of each effect, those of later pieces apart
  struct Start {
    std::size_t slot;    // of a later piece
    std::size_t of_all;  // the one that it stands for there
    std::size_t piece;
  };
  std::vector<Start> starts_;
  std::vector<Piece> pieces_;
  std::vector<std::vector<Load>> loads_;  // of each piece
  std::size_t process_slots_ = 0;
  std::size_t valve_slots_end_ = 0;
  bool integrating_ = false;

  std::vector<double> last_p_;
  std::optional<double> solved_;  // what run(last_p_) said, where that was the last
  bool rounded_ = false;          // the record of a sum is not the sum of the records
  std::vector<double> valve_;
  bool weighed_ = false;              // the first lag had a part in valve_
  std::vector<std::size_t> at_rest_;  // of each piece
  double settling_s_ = 0;
  std::vector<double> own_;
  ProcessShape shape_;
  std::optional<Ceiling> ceiling_;
  std::vector<unsigned char> free_;  // 1 where the output is below the ceiling
  std::vector<double> left_;
  std::vector<double> z_;
  std::vector<double> scratch_;
  std::vector<std::vector<double>> raw_;   // before overflow and sensor
  std::vector<std::vector<double>> used_;  // behind them
  std::vector<Column> columns_;
  std::vector<SampleRange> extents_;
  std::vector<double> coefficients_;
  std::vector<double> residual_;
  std::vector<double> aside_;
  std::vector<double> weight_;
  std::vector<double> judged_;
  std::vector<Held> held_;
};

}  // namespace workbench
