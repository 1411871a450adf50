// What the residual of a simulation is made of: its colour, and how much of it a further
// effect could explain.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "workbench/model/base/blocks.hpp"

namespace workbench {

/// 95 % of a normal variable lie within so many standard deviations.
inline constexpr double kNormal95 = 1.96;

/// An autoregressive noise model: a[0] v(k) + a[1] v(k-1) + … = white, a[0] = 1.
struct NoiseColour {
  std::vector<double> a = {1.0};
  double variance = 0;  ///< of the white part
};

/// Fitted to `residual` less its mean by Levinson's recursion, order 0 … 12 by BIC.
[[nodiscard]] NoiseColour colour_of(std::span<const double> residual);

/// `signal` through the whitening filter; the first values assume 0 before.
[[nodiscard]] std::vector<double> whitened(const NoiseColour& colour,
                                           std::span<const double> signal);

/// Is the difference between two simulations really in the output, on samples that
/// neither was fitted to?
///
/// With e = y − ŷ_small and δ = ŷ_large − ŷ_small, both whitened by the colour of what
/// the larger model leaves, Σδe/(σ‖δ‖) is standard normal when the smaller model is
/// right, however the larger one was searched for: it was chosen on other samples. In a
/// closed loop δ depends on past noise only, so the sum is a martingale.
struct DifferenceTest {
  double z = 0;        ///< standard normal where the smaller model is right
  double slope = 0;    ///< share of δ found in the output: 1 where the larger is right
  double p_value = 1;  ///< one-sided
  /// The same with the spread of the slope between blocks where that is more than noise
  /// makes: of few moves of u one alone is no proof.
  double p_steady = 1;
};
[[nodiscard]] DifferenceTest test_difference(std::span<const double> residual_small,
                                             std::span<const double> residual_large,
                                             const Blocks& blocks);

/// The same question one sample ahead: does the difference foretell the next residual of
/// the smaller model beside the past of that residual and of `u`? A load of any colour is
/// in the past of the residual, and what a controller makes of it in the past of u, so
/// that under a load, in closed loop, too, the p-value is that of chance. For differences
/// that no linear process makes: those are in the past of u, too. On the validation
/// blocks; one-sided.
[[nodiscard]] DifferenceTest test_given_past(std::span<const double> residual_small,
                                             std::span<const double> residual_large,
                                             std::span<const double> u,
                                             const Blocks& blocks);

/// (W18) p-value of how much the difference between two simulations looks like what the
/// smaller model leaves, on the validation samples: noise of any colour is one random
/// direction in as many dimensions as there are stretches that it remembers over. 1 where
/// the larger model leaves no less.
[[nodiscard]] double likeness_by_chance(std::span<const double> residual_small,
                                        std::span<const double> residual_large,
                                        const Blocks& blocks);

/// 95 % block-bootstrap interval of the ratio of squared errors, large over small, on
/// the validation samples. Blocks are as long as `memory_samples` or longer; 400 draws;
/// deterministic.
struct RatioInterval {
  double low = 1;
  double high = 1;
};
[[nodiscard]] RatioInterval bootstrap_ratio(std::span<const double> residual_small,
                                            std::span<const double> residual_large,
                                            const Blocks& blocks, double memory_samples);

/// Whether what is left still follows u at lags 1 … 20: correlations of the whitened
/// residual with u, whitened for itself, whose squares add up to a chi-square; 0.5 %
/// level. Later values of u are left out: a controller reacts to the residual.
[[nodiscard]] bool follows_u(std::span<const double> residual, std::span<const double> u);

/// Share of the square of the whitened residual by which it follows u, above what chance
/// would show; 0 where it does not.
[[nodiscard]] double share_following_u(std::span<const double> residual,
                                       std::span<const double> u);

/// Ljung and Box (1978): true where the autocorrelations at lags 1 … 20 are those of
/// white noise, 1 % level.
[[nodiscard]] bool is_white(std::span<const double> residual);

/// Share of the squared residual that its mean and its own past predict: 0 for white
/// noise. The rest is the noise that no model can explain.
[[nodiscard]] double predictable_share(std::span<const double> residual);

/// The residual, cut to what the rest reaches where a hundredth of the samples or fewer
/// hold most of its squares: beside them nothing of the rest would be seen. O(n).
[[nodiscard]] std::vector<double> without_glitches(std::span<const double> residual);

/// (W7) What is left is consistent with noise: its predictable share is below
/// kPredictable, without glitches, too.
inline constexpr double kPredictable = 0.2;
[[nodiscard]] bool is_noise(std::span<const double> residual);

/// Random bits, the same for a state on every machine (SplitMix64); moves it on.
[[nodiscard]] std::uint64_t next_random(std::uint64_t& state);

/// Standard normal score of a chi-square with `degrees` of freedom (Wilson & Hilferty).
[[nodiscard]] double chi_square_score(double value, double degrees);

/// Upper tail of the standard normal.
[[nodiscard]] double normal_tail(double z);

/// Autocorrelations at lags 1 … lags.
[[nodiscard]] std::vector<double> autocorrelation(std::span<const double> residual,
                                                  std::size_t lags);

}  // namespace workbench
