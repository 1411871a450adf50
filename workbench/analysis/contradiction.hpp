// Where the recordings of one loop do not agree on its valve.
#pragma once

#include <string>
#include <vector>

#include "workbench/analysis/window_finding.hpp"

namespace workbench {

/// What several recordings say that cannot be true of one valve.
struct Contradiction {
  enum class Kind {
    kNone,
    kBands,     ///< all stick, with bands that exclude each other
    kRepaired,  ///< some stick, others show nothing of it
    kGains,     ///< all stick, but u moves y up in one and down in another
  };
  Kind kind = Kind::kNone;
  bool mostly_sticks = true;  ///< kRepaired: more of them do
  std::string note;           ///< which recording says what; "" where nothing is found
};

/// Of all windows, in the order of their recordings. Each recording is taken by the
/// majority of its windows and the medians of their bands; those that cannot tell have no
/// say.
[[nodiscard]] Contradiction contradiction_of(const std::vector<WindowFinding>& findings);

/// Of one recording: since when its windows, at least two, show nothing of the fault that
/// at least two before showed; "" where it lasts.
[[nodiscard]] std::string ended_note(const std::vector<WindowFinding>& findings);

}  // namespace workbench
