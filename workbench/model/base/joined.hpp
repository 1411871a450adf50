// Several recordings of one loop as one: its pieces, and which of them only judge.
#pragma once

#include <vector>

#include "workbench/recording/recording.hpp"

namespace workbench {

/// `fitted`, at least one, and then `judging`, in this order: one valve and one process
/// with an initial state for each piece (W9), (W10). A pause within a recording
/// (ResampleReport::gaps) begins a new piece: what was held in it is left out. A single
/// recording without pauses comes back as it is.
///
/// Recordings of different sample periods come down to the longest one (thinned.hpp). The
/// setpoint, the stem position and each load stay where all recordings have them; the
/// notes of all are in `resampling`.
///
/// Throws InputError as check_one_loop(), and naming two files whose sample periods are
/// no multiples of each other. What overlaps_of() them is in the notes.
[[nodiscard]] Recording joined(std::vector<Recording> fitted,
                               std::vector<Recording> judging = {});

/// Where a recording begins anew, and the samples that nothing is fitted to or judged by.
struct Parts {
  std::vector<Piece> pieces;          ///< all samples, one behind the other
  std::vector<SampleRange> left_out;  ///< ascending, apart
};

/// Those of `recording`; of one that says no pieces, one behind each of its pauses, in
/// which what is held is left out: what joined() cuts out, in its place.
[[nodiscard]] Parts parts_of(const Recording& recording);

/// All samples of both, ascending; where they meet or overlap as one range.
[[nodiscard]] std::vector<SampleRange> united(std::vector<SampleRange> ranges,
                                              const std::vector<SampleRange>& others);

/// Only the samples of `pieces`, in order, one piece behind the other.
[[nodiscard]] Recording cut_to(const Recording& recording, std::vector<Piece> pieces);

}  // namespace workbench
