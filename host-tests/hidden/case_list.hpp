// Which cases the hidden-effect benchmark runs.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "support/hidden/case.hpp"

namespace hidden {

inline constexpr std::array<double, 3> kRatios{40, 10, 4};

struct Seeds {
  std::uint64_t first = 1;
  int count = 5;
};

/// Every effect, under both excitations, at every signal-to-noise ratio.
[[nodiscard]] std::vector<CaseKey> one_effect(const Seeds& seeds);
/// Pairs that occur together in plants; excitations in turns.
[[nodiscard]] std::vector<CaseKey> two_effects(const Seeds& seeds);
/// `count` loops without any effect, excitations and ratios in turns.
[[nodiscard]] std::vector<CaseKey> clean(const Seeds& seeds, int count);
/// Effects that are there but idle: quiet recordings, limits out of reach. Without the
/// disturbances and the quantisation, which show themselves when nothing moves.
[[nodiscard]] std::vector<CaseKey> not_excited(const Seeds& seeds);

/// Reads "valve.stiction+process.dead_time" or "clean", "steps", "40", "7"; nothing
/// where a word is unknown.
[[nodiscard]] std::optional<CaseKey> parse_key(const std::string& effects,
                                               const std::string& excitation,
                                               const std::string& ratio,
                                               const std::string& seed);

}  // namespace hidden
