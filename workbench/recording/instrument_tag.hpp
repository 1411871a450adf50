// Tags of instruments by their letters: FT-211 measures the flow that FV-211 sets.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workbench/recording/column_words.hpp"

namespace workbench {

struct InstrumentTag {
  Part part = Part::kNone;  ///< kY of a transmitter or indicator, kU of a valve
  std::string tag;          ///< key of the loop, of pieces before it too: f211
  std::size_t piece = 0;    ///< the piece of the name in which the letters stand
};

/// What the last pieces of a name, "ft" and "211" or "ft211", say by the letters of
/// ISA-5.1: a measured variable (F, L, T, P, A, D), then T, IT or I, or V or CV. Nothing
/// where the letters are a part by themselves (PV, CV) or no number of at least two
/// digits follows.
[[nodiscard]] std::optional<InstrumentTag> instrument_tag(
    const std::vector<std::string>& pieces);

}  // namespace workbench
