// Tags of instruments by their letters: FT-211 measures the flow that FV-211 sets.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "workbench/recording/spelling/column_words.hpp"

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

/// The loop of the last instrument among pieces, as a key. Of "area1", "fic", "101",
/// "pida" that is area1f101: what stands before the instrument, its measured variable and
/// its number with what counts behind it; FT-101 is of the loop of FIC-101, FIC-101-B
/// not.
[[nodiscard]] std::optional<std::string> loop_of_instrument(
    std::span<const std::string> pieces);

/// The loop that the pieces of a tag name, as a key: that of their instrument; where
/// there is none, all pieces but the last that are words for a part of any loop (PIDA,
/// DACA, controller, sensor). "" only of no pieces.
[[nodiscard]] std::string loop_of_tag(std::span<const std::string> pieces);

}  // namespace workbench
