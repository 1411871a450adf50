// What `stickband identify` says about the recording that is open, for the page.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "workbench/analysis/analysis.hpp"
#include "workbench/recording/recording.hpp"

namespace workbench {

/// An identification with what the page draws of it. Moved, not copied.
struct ValveAnswer {
  Analysis analysis;
  Simulation simulation;
};

/// Identifies the recording, piece by piece where it is joined, what is left out of it
/// aside. What `progress` throws passes
/// through. Cost: as `stickband identify`, some 0.2 s for a window of 4096 samples, eight
/// windows at most.
[[nodiscard]] ValveAnswer valve_answer(const Recording& recording,
                                       const Progress& progress = {});

/// Whether valve_answer() looks at several windows, so that first_answer() comes early.
[[nodiscard]] bool takes_long(const Recording& recording);
/// The same from one window in the middle: what is thought until all have been seen.
[[nodiscard]] ValveAnswer first_answer(const Recording& recording,
                                       const Progress& progress = {});

/// "bad" where the valve is at fault, "good" where it is not, else "open".
[[nodiscard]] std::string_view mood_name(ident::Verdict verdict);

/// {"schema","verdict","mood","headline","reason","cause","advice","span",
/// "detectable_band","band","identification","picture"}: texts are plain English
/// sentences. "band" has for each stroke, null where it is not known, value, low, high,
/// and all three in percent of span. "identification" is as `stickband identify --json`.
/// "picture" has t (s), u, y and, where known, stem (the identified one, units of u) and
/// x of about four cycles from the middle; all of it, at most kMostPictureSamples, where
/// none were seen.
[[nodiscard]] nlohmann::ordered_json valve_json(const Recording& recording,
                                                const ValveAnswer& answer);
inline constexpr std::size_t kMostPictureSamples = 1500;

}  // namespace workbench
