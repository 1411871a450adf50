// Which lags of a signal the one-step prediction looks at: near ones singly, far ones in
// means that grow with their age.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "ident/base/limits.hpp"

namespace ident {

/// A mean of the lags first … last, in samples.
struct LagBin {
  int first;
  int last;
};

/// Bins that end at these lags, each from where the one before ends; from lag 1.
template <std::size_t N>
[[nodiscard]] constexpr std::array<LagBin, N> bins_up_to(const int (&ends)[N]) {
  std::array<LagBin, N> bins{};
  for (std::size_t k = 0; k < N; ++k) {
    bins[k] = {k == 0 ? 1 : ends[k - 1] + 1, ends[k]};
  }
  return bins;
}

/// Together they reach half a cycle back at least (E10): what changes with the cycle is
/// known from the past, not from a stem. Few enough for the search of a stem, which
/// weighs hundreds, too.
inline constexpr std::array kCoarseLagBins =
    bins_up_to({1, 2, 3, 4, 5, 6, 8, 11, 15, 22, 34, 60});
/// What decides: a cycle of up to 16 samples is known from the past in every detail. By
/// coarser means a stem foretells what repeats in so short a cycle though it does not
/// stick.
inline constexpr std::array kFineLagBins =
    bins_up_to({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 22, 34, 60});
/// Of the ladder, whose rungs coarse lags tell apart better: finer ones make up for a
/// part of what a wrong stem lacks.
inline constexpr std::span<const LagBin> kLadderLagBins =
    std::span<const LagBin>(kCoarseLagBins)
        .first(kSmallSizes ? 9 : kCoarseLagBins.size());
/// The small sizes look back less far, and where no stem is searched (limits.hpp) there
/// is no time for fine lags.
inline constexpr std::span<const LagBin> kLagBins =
    kStemSearch ? std::span<const LagBin>(kFineLagBins) : kLadderLagBins;

/// Of a setpoint that moves, which stands beside every signal: what u answers, roughly.
inline constexpr std::array kSetpointLagBins = bins_up_to({1, 2, 4, 8, 20, 60});

/// (E25) So many of the newest lags of u may know of y what the recording lacks.
inline constexpr std::size_t kNewestBeside = 8;

/// Samples a cycle to which a window is thinned out before it is predicted. A mean of
/// many smears the slip of a stem; a bare board has no time for more.
inline constexpr int kEvidencePerCycle = kStemSearch ? 120 : 60;

/// Those of `bins` that a window of so many samples bears: an eighth of it may be the
/// past of its first prediction. At least 4.
[[nodiscard]] constexpr std::span<const LagBin> lag_bins_for(
    std::size_t samples, std::span<const LagBin> bins = kLagBins) {
  while (bins.size() > 4 &&
         static_cast<std::size_t>(bins.back().last) * 8 > samples + 8) {
    bins = bins.first(bins.size() - 1);
  }
  return bins;
}

}  // namespace ident
