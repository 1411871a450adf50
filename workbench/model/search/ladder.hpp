// The ladder: explain and add until nothing more is accepted.
//
//   Recording → start_model → explain → add_effect → explain → … → explained, or not
//
// Where nothing more is accepted, two effects or more are looked at again (revision.hpp):
// one that nobody misses goes, one that stood for another makes room for it.
//
// A recording may be one joined from several (joined.hpp): one valve and one process with
// an initial state for each piece.
//
// Throws InputError when the recording lacks u or the output, or is too short;
// std::invalid_argument for an unknown effect or one named twice. Cost: about 1 s for
// 2,000 samples and one effect on one core, ten for two, up to minutes where three or
// more are revised again and again. Deterministic; no global state.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "workbench/effects/catalogue.hpp"
#include "workbench/model/base/model.hpp"
#include "workbench/model/search/explain.hpp"
#include "workbench/model/search/one_step.hpp"
#include "workbench/recording/recording.hpp"

namespace workbench {

/// Called when a step is done: the model it led to, and what was found before it.
using LadderProgress =
    std::function<void(const Model& model, const ExplainResult& found)>;

struct LadderOptions {
  Column output = Column::y;
  std::vector<std::string> with;  ///< effects of the starting model
  int most_steps = 8;             ///< bound on the effects added
  ExplainProgress progress;
  LadderProgress stepped = {};
  const Catalogue* catalogue = &standard_catalogue();
  const Work* work = &Work::unlimited();  ///< must outlive the call
  Identified* identified = nullptr;       ///< as in explain()
};

struct LadderStep {
  std::string effect;    ///< "process" for the first
  bool removed = false;  ///< an earlier effect that a later one made superfluous
  /// Of an exchange or of several that only help together, which the steps after it
  /// complete.
  bool on_the_way = false;
  double rmse = 0;  ///< after the step, all samples
  double rmse_validation = 0;
  /// Group of the effect in the final model, or when it was chosen where it is not in
  /// that or the only one; empty where it stands alone.
  std::vector<std::string> indistinguishable_from;
  std::optional<AheadErrors> ahead{};  ///< where only these tell the effect (W44)
};

/// True where `next` takes out again what `step` added, and puts nothing in its place.
[[nodiscard]] bool takes_back(const LadderStep& next, const LadderStep& step);

struct LadderResult {
  Model model;
  std::vector<LadderStep> steps;  ///< the start, then one for each effect added
  ExplainResult last;             ///< what the final model leaves over
  FitQuality quality;
  bool explained = false;
  bool complete = true;  ///< false: the time limit ended it; the best so far
  std::optional<Searched> searched = std::nullopt;  ///< none: in all samples
};

[[nodiscard]] LadderResult run_ladder(const Recording& recording,
                                      const LadderOptions& options = {});

}  // namespace workbench
