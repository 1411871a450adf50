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

/// Together they reach one cycle back at kEvidencePerCycle samples a cycle (E10): what
/// repeats with the cycle is known from the past, not from a stem. Few enough for the
/// search of a stem, which weighs hundreds, too.
inline constexpr std::array<LagBin, 12> kCoarseLagBins = {{{1, 1},
                                                           {2, 2},
                                                           {3, 3},
                                                           {4, 4},
                                                           {5, 5},
                                                           {6, 6},
                                                           {7, 8},
                                                           {9, 11},
                                                           {12, 15},
                                                           {16, 22},
                                                           {23, 34},
                                                           {35, 60}}};
/// What decides: a cycle of up to 16 samples is known from the past in every detail. By
/// coarser means a stem foretells what repeats in so short a cycle though it does not
/// stick.
inline constexpr std::array<LagBin, 19> kFineLagBins = {{{1, 1},
                                                         {2, 2},
                                                         {3, 3},
                                                         {4, 4},
                                                         {5, 5},
                                                         {6, 6},
                                                         {7, 7},
                                                         {8, 8},
                                                         {9, 9},
                                                         {10, 10},
                                                         {11, 11},
                                                         {12, 12},
                                                         {13, 13},
                                                         {14, 14},
                                                         {15, 15},
                                                         {16, 16},
                                                         {17, 22},
                                                         {23, 34},
                                                         {35, 60}}};
/// Of the ladder, whose rungs coarse lags tell apart better: finer ones make up for a
/// part of what a wrong stem lacks.
inline constexpr std::span<const LagBin> kLadderLagBins =
    std::span<const LagBin>(kCoarseLagBins)
        .first(kSmallSizes ? 9 : kCoarseLagBins.size());
/// The small sizes look back less far, and where no stem is searched (limits.hpp) there
/// is no time for fine lags.
inline constexpr std::span<const LagBin> kLagBins =
    kStemSearch ? std::span<const LagBin>(kFineLagBins) : kLadderLagBins;

/// Samples a cycle to which a window is thinned out before it is predicted.
inline constexpr int kEvidencePerCycle = 60;

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
