// Fits of effects to one recording: what start, add, explain and ladder are made of.
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "workbench/effects/catalogue.hpp"
#include "workbench/model/base/blocks.hpp"
#include "workbench/model/base/model.hpp"
#include "workbench/model/base/shortened.hpp"
#include "workbench/model/fit/free_run.hpp"
#include "workbench/model/fit/start_search.hpp"
#include "workbench/recording/recording.hpp"

namespace workbench {

[[nodiscard]] inline bool contains(const std::vector<const Effect*>& effects,
                                   const Effect& effect) {
  return std::find(effects.begin(), effects.end(), &effect) != effects.end();
}

/// A fitted set of effects, with what is needed to go on from it.
struct Fit {
  std::vector<const Effect*> effects;  ///< in the order in which they were added
  std::vector<FreeRun::Slot> slots;
  std::vector<double> p;  ///< as in slots
  std::vector<FreeRun::Column> columns;
  std::vector<double> coefficients;  ///< as in columns
  std::vector<double> residual;      ///< y minus simulation; 0 where left out
  std::vector<double> aside;         ///< y minus simulation of the samples left out
  double error = 0;                  ///< squared, summed over the estimation blocks
  std::vector<double> weight;        ///< FreeRun::weigh_by()
  std::vector<double> weighed;       ///< residual behind that; empty where there is none
  bool integrating = false;

  /// The residual as it was squared.
  [[nodiscard]] std::span<const double> judged() const {
    return weight.empty() ? residual : weighed;
  }
  /// Number of parameters that were estimated.
  [[nodiscard]] std::size_t parameters() const;
  /// Value of a searched parameter of the process; nothing where it has none.
  [[nodiscard]] std::optional<double> process_value(std::string_view name) const;
  /// Values of one effect: searched, and solved.
  [[nodiscard]] std::vector<double> searched_of(const Effect& effect) const;
  [[nodiscard]] std::vector<double> solved_of(const Effect& effect) const;
};

/// True where one of the effects is a load, or one that the recording holds.
[[nodiscard]] bool has_load(const std::vector<const Effect*>& effects);
[[nodiscard]] bool has_recorded_load(const std::vector<const Effect*>& effects);

/// True where a searched parameter of the effect lies at the edge of its bounds that is
/// not where the effect is off.
[[nodiscard]] bool at_edge(const Fit& fit, const Effect& effect);

/// The same fit with the same effects listed in another order.
[[nodiscard]] Fit in_order(Fit fit, const std::vector<const Effect*>& effects);

/// One recording, split into blocks, with the output that is modelled. It may be joined
/// from several (joined.hpp), some of which only judge.
///
/// An output y answers the u of the sample before: a controller computes u from y, so the
/// u of the same sample knows the noise in y. A stem x has no such loop and is compared
/// with the u of its own sample.
///
/// Throws InputError where u or the output is missing, where there are fewer than
/// Blocks::kFewestSamples samples, or where u or the output never changes. `recording`
/// and `work` must outlive it. Members may be called from several threads. Neither copied
/// nor moved.
class Fitter {
 public:
  Fitter(const Recording& recording, Column output, const Work& work = Work::unlimited());
  Fitter(const Fitter&) = delete;
  Fitter& operator=(const Fitter&) = delete;

  /// The process with the given effects, from scratch. Throws InputError naming an effect
  /// that has no start in this recording.
  [[nodiscard]] Fit start(const std::vector<const Effect*>& effects) const;
  /// The same; nothing where an effect has no start.
  [[nodiscard]] std::optional<Fit> start_if(
      const std::vector<const Effect*>& effects) const;
  /// `base` with one more effect; nothing where the effect has no start in this
  /// recording (no lattice, say).
  /// A search whose best start still leaves more than `hopeless_above` ends there. `seen`
  /// is what one of the same effect beside the same `base` has left, and gets what this
  /// one leaves.
  [[nodiscard]] std::optional<Fit> extend(
      const Fit& base, const Effect& effect, Effort effort,
      double hopeless_above = std::numeric_limits<double>::infinity(),
      ScreenedStarts* seen = nullptr) const;
  /// `base` with the same effects, searched further from where it is; what is `held`
  /// keeps its value.
  [[nodiscard]] Fit refine(const Fit& base,
                           std::span<const FreeRun::Held> held = {}) const;
  /// (W6) `base` with each of its effects but `last` taken out and searched for anew,
  /// where that lowers the error: what was found before the others were there may be
  /// wrong.
  [[nodiscard]] Fit reconsider(Fit base, const Effect* last) const;
  /// (W17) A fit to what `from` made of this recording, searched further on all of it.
  [[nodiscard]] Fit on_the_whole(const Fit& other, const Shortened& from) const;
  /// A fit to the recording that `to` was made of, searched further on what it made,
  /// which is the recording of this fitter.
  [[nodiscard]] Fit on_the_short(const Fit& other, const Shortened& to) const;
  /// `fit` with these searched values; what is solved follows.
  [[nodiscard]] Fit at(const Fit& fit, std::vector<double> p) const;
  /// `base` less one effect, all else as it is but the initial state.
  [[nodiscard]] Fit less(const Fit& base, const Effect& effect) const;
  /// `base` less one effect, fitted again.
  [[nodiscard]] Fit without(const Fit& base, const Effect& effect) const;
  /// What a model says about this recording: as it is where it was fitted to it, with
  /// the initial state estimated otherwise. Throws InputError naming the model.
  [[nodiscard]] Fit apply(const Model& model, const Catalogue& catalogue) const;
  /// True where the model was fitted to this recording, or to the pieces of it that do
  /// not judge.
  [[nodiscard]] bool fitted_to_this(const Model& model) const;

  /// The blocks that judge the effects of `among` in `fit`: a stretch in which one of
  /// their instants was looked for (sudden_instant.hpp) counts as fitted.
  [[nodiscard]] Blocks judging(const Fit& fit,
                               const std::vector<const Effect*>& among) const;

  [[nodiscard]] Situation situation(const Fit& fit) const;
  [[nodiscard]] const Blocks& blocks() const { return blocks_; }
  /// Samples over which the output remembers, from its autocorrelation.
  [[nodiscard]] double memory_samples() const { return memory_samples_; }
  [[nodiscard]] const Recording& recording() const { return *recording_; }
  [[nodiscard]] Column output() const { return output_; }
  /// False where so much was simulated since this fitter was made that only what must be
  /// searched still is: the rest would take minutes. Does not depend on the clock.
  [[nodiscard]] bool affordable() const { return samples_left() > 0; }
  /// Samples that may be simulated yet.
  [[nodiscard]] std::uint64_t samples_left() const;
  [[nodiscard]] const Work& work() const { return *work_; }
  [[nodiscard]] std::span<const double> y() const { return base_.y; }

  /// Pieces of the recording, at least one.
  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }
  /// True where pieces of the recording judge what the others were fitted to.
  [[nodiscard]] bool is_judged() const { return pieces_.back().judges; }
  /// What the model is fitted to; its name is that of the recording.
  [[nodiscard]] FittedRecording fitted() const;

  /// Adds `factor` times what the loads of `fit` do to the output, or `only` one of them.
  void add_loads(const Fit& fit, double factor, std::span<double> signal,
                 const Effect* only = nullptr) const;
  /// y minus residual, the samples left out included.
  [[nodiscard]] std::vector<double> simulated(const Fit& fit) const;
  /// Over all samples but those left out and those of pieces that judge.
  [[nodiscard]] double rmse(const Fit& fit) const;
  [[nodiscard]] double rmse_on(const Fit& fit, bool estimation) const;

  /// What the identification has seen so far also stands for outputs that hardly differ
  /// from those that it looked at. Not while parts of a for_each() run: what is settled
  /// must not depend on which of them came first.
  void settle_stems() const;

 private:
  [[nodiscard]] Fit taken_over(Fit other, bool from_elsewhere,
                               const std::function<double(double)>& moved) const;
  // Leaves the effect that has no start in `missing`.
  [[nodiscard]] std::optional<Fit> built(const std::vector<const Effect*>& effects,
                                         const Effect*& missing) const;
  [[nodiscard]] std::optional<Fit> built_either_way(
      const std::vector<const Effect*>& effects, const Effect*& missing) const;
  [[nodiscard]] std::vector<double> lags_to_try(const FreeRun& run,
                                                const std::vector<double>& p,
                                                std::span<const SeenStem> stems) const;
  [[nodiscard]] std::vector<SearchPoint> judged_starts(const FreeRun& run,
                                                       const Fit& base,
                                                       const Effect& effect) const;
  [[nodiscard]] std::vector<SeenStem> stems_behind(const Fit& fit) const;
  [[nodiscard]] std::vector<SeenStem> stems_in_pieces(std::span<const double> y,
                                                      bool later_cycles) const;
  void find_start(FreeRun& run, std::vector<double>& p,
                  std::span<const double> plant) const;
  void find_judging_start(FreeRun& run, std::vector<double>& p) const;
  static void record(const FreeRun& run, double error, Fit& fit);
  [[nodiscard]] Fit taken(FreeRun& run, std::vector<const Effect*> effects,
                          std::vector<double> p) const;
  // What a search has found, its slowest lag the process's and its sudden instants
  // placed.
  [[nodiscard]] Fit found(FreeRun& run, std::vector<const Effect*> effects,
                          std::vector<double> p) const;

  struct StemsOf {
    std::vector<double> y;
    std::vector<SeenStem> stems;
    bool settled = false;
  };
  [[nodiscard]] const StemsOf* known_stems(const Fit& fit,
                                           const std::vector<double>& y) const;

  const Recording* recording_;
  const Work* work_;
  std::uint64_t spent_before_ = Work::spent();
  Column output_;
  std::vector<double> u_;
  std::vector<Piece> pieces_;
  Situation base_;
  double memory_samples_ = 1;
  Blocks blocks_;
  // What stems_behind() found.
  mutable std::mutex stems_mutex_;
  mutable std::vector<StemsOf> stems_;
};

}  // namespace workbench
