// One effect, or two or three together, on trial: its fit, its tests and what they come
// to.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workbench/model/base/noise.hpp"
#include "workbench/model/fit/fit.hpp"
#include "workbench/model/search/explain.hpp"

namespace workbench {

/// Level of the whole family of candidates.
inline constexpr double kSignificance = 0.005;

/// One effect (or a pair, or three) with its fit and what was found out about it.
struct Trial {
  const Effect* effect = nullptr;
  const Effect* partner = nullptr;
  const Effect* third = nullptr;  // of a pair that needs one
  std::optional<Fit> fit;
  DifferenceTest test;
  double p_ahead = 1;  // of the stem of three: one sample ahead, beside the other two
  double p_free_running = 1;  // where `test` is the one that looks one sample ahead
  RatioInterval ratio;
  Excitation excitation;
  double p_family = 1;   // after Holm
  bool untried = false;  // the time was up
  bool visible = true;
  bool left_to_controller = false;  // (W31), and so not fitted
  std::string objection;            // why it cannot be this effect
  bool own = false;                 // shown by the effect's own test, not by the error
  bool on = false;                  // an interval excludes "off"
  bool edge = false;
  bool too_few = false;      // it shows, but its events are too few
  bool identified = false;   // the valve that the identification found
  bool unconfirmed = false;  // a stem of which the identification knows nothing
  double score = 0;          // the smaller, the better; comparable between trials
  Candidate candidate;
};

/// One to three, in the order of the trial.
[[nodiscard]] std::vector<const Effect*> members_of(const Trial& trial);

/// Leaves a trial undecided, though it lowers the error, and says why.
void leave_in_doubt(Trial& trial, const std::string& but);
/// "12.3 %" of a share.
[[nodiscard]] std::string percent(double share);
extern const char* const kUntold;  ///< why, of values that may be none

/// What `trial` leaves of the squared error of `of` on the samples that judge.
[[nodiscard]] double share_left(const Fitter& fitter, const Trial& trial,
                                const Trial& of);

/// One of those that `whole`, of two or more, is made of.
[[nodiscard]] bool is_member(const Trial& trial, const Trial& whole);

/// True where `a` leaves less over all samples. Both have a fit.
[[nodiscard]] bool fits_better(const Trial* a, const Trial* b);

/// True for what no linear process makes of u.
[[nodiscard]] bool is_bent(const Description& effect);

/// True for what stands between the valve and the output's record.
[[nodiscard]] bool is_in_process(const Trial& trial);

/// True where chance among all candidates does not do as much.
[[nodiscard]] bool is_significant(const Trial& trial);

/// True where the data support it.
[[nodiscard]] bool accepted(const Trial& trial);

/// Tests the fit of a trial against the model without it.
void examine(const Fitter& fitter, const Fit& base, Trial& trial);

/// Holm's step-down procedure over all trials that were fitted.
void correct_for_many(std::vector<Trial>& trials);

/// Of a significant trial: its parameters with intervals, and whether those exclude
/// "off".
void check_intervals(const Fitter& fitter, Trial& trial);

/// The status, and the one sentence, from what was found.
void conclude(const Fitter& fitter, const Fit& base, Trial& trial);

/// (W8) What has many small valleys, as the instant of a load, is told from none by the
/// walk over all parameters: beside one that is fixed the others look surer than they
/// are. Each of several together has to be told, as it is in a model of them. The verdict
/// is asked of a stem alone: a slip that is missed widens what the walk tells.
void leave_untold_values_open(const Fitter& fitter, std::vector<Trial>& trials);

}  // namespace workbench
