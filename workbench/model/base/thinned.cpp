#include "workbench/model/base/thinned.hpp"

#include <algorithm>

namespace workbench {
namespace {

// Begins of the groups of `count` samples; those of a piece end with it.
std::vector<std::size_t> groups_of(const Recording& recording, std::size_t count,
                                   std::vector<Piece>& pieces) {
  pieces = recording.pieces;
  std::vector<std::size_t> groups;
  const auto add = [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k + count <= last; k += count) groups.push_back(k);
  };
  if (pieces.empty()) add(0, recording.size());
  for (Piece& piece : pieces) {
    const std::size_t start = groups.size();
    add(piece.first, piece.last);
    piece.first = start;
    piece.last = groups.size();
  }
  return groups;
}

std::vector<double> first_of_each(const std::vector<double>& values,
                                  const std::vector<std::size_t>& groups) {
  std::vector<double> out;
  for (const std::size_t k : groups) {
    if (!values.empty()) out.push_back(values[k]);
  }
  return out;
}

std::vector<double> means_of(const std::vector<double>& values,
                             const std::vector<std::size_t>& groups, std::size_t count) {
  std::vector<double> out;
  for (const std::size_t k : groups) {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += values[k + i];
    out.push_back(sum / static_cast<double>(count));
  }
  return out;
}

// The groups that have a sample of the ranges.
std::vector<SampleRange> touched(const std::vector<SampleRange>& ranges,
                                 const std::vector<std::size_t>& groups,
                                 std::size_t count) {
  const auto begun = [&groups](std::size_t sample) {
    return static_cast<std::size_t>(std::ranges::lower_bound(groups, sample) -
                                    groups.begin());
  };
  std::vector<SampleRange> out;
  for (const SampleRange& range : ranges) {
    const std::size_t first = begun(range.first + 1 - std::min(count, range.first + 1));
    const std::size_t last = begun(range.last);
    if (last > first) out.push_back({first, last});
  }
  return out;
}

}  // namespace

Recording thinned(const Recording& recording, std::size_t count) {
  Recording out;
  out.name = recording.name;
  out.units = recording.units;
  out.tags = recording.tags;
  out.loop = recording.loop;
  out.start = recording.start;
  out.resampling = recording.resampling;
  out.resampling.missing /= count;
  out.period_s = recording.period_s * static_cast<double>(count);
  const std::vector<std::size_t> groups = groups_of(recording, count, out.pieces);
  for (const Column column : {Column::t, Column::y, Column::sp, Column::x}) {
    out.values(column) = first_of_each(recording.values(column), groups);
  }
  for (const Load& load : recording.loads) {
    out.loads.push_back({load.name, load.unit, means_of(load.values, groups, count)});
  }
  out.u = means_of(recording.u, groups, count);
  out.left_out = touched(recording.left_out, groups, count);
  out.manual = touched(recording.manual, groups, count);
  out.resampling.gaps = touched(recording.resampling.gaps, groups, count);
  out.begins_at_rest = recording.begins_at_rest;
  out.split = {recording.split.estimation_share,
               recording.split.pair_samples / static_cast<double>(count)};
  return out;
}

}  // namespace workbench
