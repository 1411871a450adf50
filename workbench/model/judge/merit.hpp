// How two fits of one recording compare.
#pragma once

#include <string>

#include "workbench/model/base/noise.hpp"
#include "workbench/model/fit/fit.hpp"

namespace workbench {

/// p-value of a DifferenceTest above which the smaller model is as good.
inline constexpr double kAsLikely = 0.01;
/// Share of the squared validation error that an effect beside others must take away.
inline constexpr double kLeastMissed = 0.02;
/// Of the score: what fits as well but is worse by this does so by its many parameters.
inline constexpr double kTooRich = 20;

/// Squared error over all samples.
[[nodiscard]] double total_error(const Fit& fit);

/// Schwarz's criterion over all samples, with one noise colour for all that are compared;
/// less is better.
[[nodiscard]] double score_of(const Fit& fit, const NoiseColour& colour);

/// Root mean square error one sample ahead on the validation samples: of what the
/// residual's own past, by the colour of all of it, does not foretell.
[[nodiscard]] double rmse_ahead(const Fitter& fitter, const Fit& fit);

/// True where the validation samples do not prefer `best` to `other`: what it makes
/// better is chance, or the two simulations differ by so little that data from `best`
/// would not tell them apart. What the data then see between them is what both models
/// simplify.
[[nodiscard]] bool as_good(const Fitter& fitter, const Fit& other, const Fit& best);

/// True where a difference is seen one sample ahead (noise.hpp), and as large as it is
/// simulated: data that want far more of it hold what it only resembles.
[[nodiscard]] bool is_seen(const DifferenceTest& ahead);

/// True where `more` lowers the error on the samples that were fitted by more than its
/// additional parameters would (Akaike 1974). What helps on the others alone is luck.
[[nodiscard]] bool earns_parameters(const Fitter& fitter, const Fit& less,
                                    const Fit& more);

/// True where `more` takes away at least kLeastMissed of the squared validation error of
/// `less`, not by chance, and earns its parameters.
[[nodiscard]] bool lowers_error(const Fitter& fitter, const Fit& less, const Fit& more);

/// (W20) True where `less`, which lacks an effect of `fit`, only stands for it: no
/// better, and with more parameters, it has an effect at the edge of its range that in
/// `fit` lies inside. It is no measure for `fit`.
[[nodiscard]] bool stands_in(const Fitter& fitter, const Fit& less, const Fit& fit);

/// Why `effect` cannot be what it looks like in `fit`, or nothing. A load that keeps step
/// with a limit cycle is no objection where the model has the valve that makes it.
[[nodiscard]] std::string objection_to(const Effect& effect, const Fit& fit,
                                       const Situation& here);

/// True where the readings themselves show `effect` as it is in `fit`, by its own test,
/// and the samples that judge lose no more by it than that test allows
/// (Description::least_share). `without` is the same fit less the effect. Nothing that
/// explains the error better makes such an effect superfluous.
[[nodiscard]] bool shows_itself(const Fitter& fitter, const Fit& fit, const Fit& without,
                                const Effect& effect);

/// p-value below which what has shown was excited, (W15): no event is counted.
inline constexpr double kBeyondDoubt = 1e-6;

/// True where `effect` would have shown: events enough, or it has shown beyond doubt with
/// `p_value`. A load comes once, so that its events count always.
[[nodiscard]] bool is_excited(const Effect& effect, const Excitation& seen,
                              double p_value);

/// True where the values found for `effect` are inside its physical range, the recording
/// exercises it (by its events, or by what it takes from `fit` without it), and it has no
/// objection of its own.
[[nodiscard]] bool is_possible(const Fitter& fitter, const Fit& fit,
                               const Effect& effect);

/// What u takes from the squared error on the validation samples, 1 at most.
[[nodiscard]] double share_of_u(const Fitter& fitter, const Fit& fit);

/// True where the simulation of `fit` explains the validation samples clearly better than
/// no u at all: effects that act on u can show.
[[nodiscard]] bool u_is_seen(const Fitter& fitter, const Fit& fit);

/// True where u explains most of what the loads of the fit leave of the output, beyond
/// doubt.
[[nodiscard]] bool follows_u(const Fitter& fitter, const Fit& fit);

}  // namespace workbench
