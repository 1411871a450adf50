#include "workbench/analysis/longest_part.hpp"

#include <vector>

#include "ident/signal/seam.hpp"
#include "workbench/analysis/analysis.hpp"

namespace workbench {

UncutPart longest_part(const RecordingView& recording) {
  constexpr int kMostCuts = 10;
  UncutPart part{0, recording.size(), 0};
  for (int cut = 0; cut < kMostCuts; ++cut) {
    const RecordingView inside = recording.part(part.first, part.length);
    const ident::Seams seams = ident::find_seams(inside.u, inside.y, inside.sp);
    if (seams.count == 0 || seams.length < Identifier::kFewestSamples) break;
    if (part.seam_at == 0) part.seam_at = seams.at[0];
    part.first += seams.first;
    part.length = seams.length;
  }
  return part;
}

Recording cut_out(const Recording& recording, const UncutPart& part) {
  Recording out = recording;
  const auto cut = [&part](std::vector<double>& values) {
    if (values.empty()) return;
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(part.first);
    values = std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(part.length));
  };
  for (const Column column : kAllColumns) {
    cut(out.values(column));
  }
  for (Load& load : out.loads) cut(load.values);
  const SampleRange kept{part.first, part.first + part.length};
  out.left_out = clipped(recording.left_out, kept);
  out.manual = clipped(recording.manual, kept);
  out.resampling.gaps = clipped(recording.resampling.gaps, kept);
  out.begins_at_rest = recording.begins_at_rest && part.first == 0;
  return out;
}

}  // namespace workbench
