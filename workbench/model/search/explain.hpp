// Which physical effect is missing: every effect that a model lacks is fitted, and
// accepted only if samples that had no part in the fit agree.
//
// A candidate is accepted when, on the validation blocks (blocks.hpp),
//  1. its free-run error is smaller, with a block-bootstrap interval of the ratio of
//     squared errors below 1;
//  2. the difference it makes is there beyond chance: a test with an effective sample
//     size for coloured residuals, corrected for the number of candidates (Holm);
//  3. its parameters lie inside their physical bounds, with intervals that exclude "off";
//  4. the recording excites it: it acted in enough independent events (Excitation);
//  5. if it is a stem, the identification does not exclude so wide a stick band, (W12).
// A stem that the identification finds beyond doubt needs neither 1. nor 2. (W12).
// What 2. shows beyond doubt needs neither the interval of 1. nor the events of 4. (W15)
// Of several that pass, the one that explains most is named, with those that the
// recording cannot tell from it as its group; the rest are left undecided until it is in
// the model.
//
// Cost: about 0.6 s for 1,500 samples on one core, more where pairs are tried.
// Deterministic.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/effects/catalogue.hpp"
#include "workbench/model/base/model.hpp"
#include "workbench/model/base/shortened.hpp"
#include "workbench/model/base/work.hpp"
#include "workbench/model/fit/fit.hpp"
#include "workbench/model/judge/quality.hpp"
#include "workbench/recording/recording.hpp"

namespace workbench {

class Identified;  // identified.hpp

enum class CandidateStatus {
  kAccepted,    ///< the data support it
  kRejected,    ///< they do not
  kNotExcited,  ///< this recording never exercised it
  kUndecided,   ///< it helps, but not beyond doubt, or another effect explains more
};
[[nodiscard]] std::string_view name_of(CandidateStatus status);

/// What one effect (or one pair) would do for the model. Errors in units of the output.
struct Candidate {
  std::string effect;               ///< code
  std::vector<std::string> with{};  ///< the partner, when only the pair helps
  CandidateStatus status = CandidateStatus::kRejected;
  double rmse_before = 0;  ///< all samples
  double rmse_after = 0;
  double rmse_validation_before = 0;
  double rmse_validation_after = 0;    ///< equals before where nothing was fitted
  double error_reduction_percent = 0;  ///< of the squared validation error
  double p_value = 1;                  ///< before the correction for many candidates
  std::optional<AheadErrors> ahead{};  ///< where only these tell it (W44)
  double nats_ahead = 0;               ///< by which it makes those samples likelier
  std::vector<std::string> indistinguishable_from{};
  std::optional<std::string>
      would_split{};                    ///< the measurement that would tell them apart
  std::string evidence{};               ///< one sentence
  std::vector<Parameter> parameters{};  ///< empty where nothing was fitted
  std::vector<EffectTerm> partners{};   ///< those of `with`, of the one named
  bool phenomenological = false;
  bool untold = false;  ///< of the one named, as in EffectTerm
  /// What to do, of the one named: a sentence or more for each of members_of().
  std::vector<std::string> cures{};
  bool harmless = false;  ///< of the one named: nothing is broken where it is this
  /// By its own values, or by the verdict on the valve: undecided for that reason.
  bool spoken_against = false;
};

/// Codes of the effect and of those that it comes with.
[[nodiscard]] std::vector<std::string> members_of(const Candidate& candidate);

/// Where a long recording was searched (W17); a ladder's fit is that of all of it.
struct Searched {
  std::size_t samples = 0;
  double period_s = 0;
  double from_s = 0;        ///< time of the first of them
  bool is_excerpt = false;  ///< the stretch, of each recording, where u moves most
};

struct ExplainResult {
  bool complete = true;    ///< false: the time limit ended it; the best so far
  bool explained = false;  ///< nothing accepted, and the residual is noise (noise.hpp)
  bool left_to_controller = false;    ///< (W31): what u does to y was not judged
  std::vector<Candidate> candidates;  ///< best first
  double rmse = 0;                    ///< of the model as it is, all samples
  double rmse_validation = 0;
  double noise_rmse = 0;  ///< of the part of the residual that no model could explain
  FitQuality quality{};   ///< of the model as it is
  std::optional<Searched> searched = std::nullopt;  ///< none: in all samples
  /// The model with best(), where there is one, and how it stands.
  std::optional<Model> with_best = std::nullopt;
  FitQuality with_best_quality{};

  /// The accepted candidate that explains most; null when there is none.
  [[nodiscard]] const Candidate* best() const;
  /// The undecided one that lowers the error most and has no rival that is named, one
  /// that its own values do not speak against if there is any; null when none does.
  [[nodiscard]] const Candidate* closest() const;
};

/// Called before each candidate: its code, its number from 1 on, how many there are. One
/// call at a time, from any thread of the work.
using ExplainProgress = std::function<void(std::string_view effect, int number, int of)>;

/// Of `fewer`, whose first piece is that of `quick`.
[[nodiscard]] Searched searched_in(const Shortened& fewer, const Fitter& quick);

/// Explains what `model`, fitted to this recording or to another one of the same loop,
/// leaves over. Only the initial state is re-estimated before. Throws InputError
/// when the recording lacks the output or is too short to be split into blocks.
/// Where pieces of the recording judge, effects that stay behind with their recording
/// (free_run.hpp) cannot be judged and are left undecided. `identified`: the
/// identification of the same recordings, where one is at hand; else one is made where a
/// stem is accepted.
[[nodiscard]] ExplainResult explain(const Recording& recording, const Model& model,
                                    const ExplainProgress& progress = {},
                                    const Catalogue& catalogue = standard_catalogue(),
                                    const Work& work = Work::unlimited(),
                                    Identified* identified = nullptr);

}  // namespace workbench
