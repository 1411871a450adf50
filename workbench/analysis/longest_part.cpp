#include "workbench/analysis/longest_part.hpp"

#include <algorithm>
#include <vector>

#include "ident/signal/seam.hpp"
#include "workbench/analysis/analysis.hpp"

namespace workbench {

Part longest_part(const RecordingView& recording) {
  constexpr int kMostCuts = 10;
  Part part{0, recording.size(), 0};
  for (int cut = 0; cut < kMostCuts; ++cut) {
    const RecordingView inside = recording.part(part.first, part.length);
    const ident::Seams<double> seams =
        ident::find_seams<double>(inside.u, inside.y, inside.sp);
    if (seams.count == 0 || seams.length < Identifier::kFewestSamples) break;
    if (part.seam_at == 0) part.seam_at = seams.at[0];
    part.first += seams.first;
    part.length = seams.length;
  }
  return part;
}

Recording cut_out(const Recording& recording, const Part& part) {
  Recording out = recording;
  const auto cut = [&part](std::vector<double>& values) {
    if (values.empty()) return;
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(part.first);
    values = std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(part.length));
  };
  for (const Column column : {Column::t, Column::u, Column::y, Column::sp, Column::x}) {
    cut(out.values(column));
  }
  for (Load& load : out.loads) cut(load.values);
  out.left_out.clear();
  for (const SampleRange& stretch : recording.left_out) {
    const std::size_t first = std::max(stretch.first, part.first);
    const std::size_t last = std::min(stretch.last, part.first + part.length);
    if (first < last) out.left_out.push_back({first - part.first, last - part.first});
  }
  out.resampling.gaps.clear();
  for (const Gap& gap : recording.resampling.gaps) {
    const std::size_t first = std::max(gap.first, part.first);
    const std::size_t last = std::min(gap.last, part.first + part.length);
    if (first < last)
      out.resampling.gaps.push_back({first - part.first, last - part.first});
  }
  return out;
}

}  // namespace workbench
