#include "workbench/analysis/uncut_parts.hpp"

#include <algorithm>

#include "workbench/analysis/longest_part.hpp"

namespace workbench {

bool in_one_go(const Recording& recording) {
  return recording.left_out.empty() && recording.pieces.size() < 2;
}

std::vector<Recording> uncut_parts(const Recording& recording) {
  if (in_one_go(recording)) return {recording};
  constexpr std::size_t kShortest = 10;  // of the longest, times shorter
  std::vector<UncutPart> parts;
  std::size_t longest = 0;
  std::size_t from = 0;
  const auto add = [&](std::size_t to) {
    if (to > from) parts.push_back({from, to - from, 0});
    longest = std::max(longest, to > from ? to - from : 0);
  };
  const auto add_all = [&](SampleRange piece) {
    from = piece.first;
    for (const SampleRange& range : recording.left_out) {
      if (range.last <= piece.first || range.first >= piece.last) continue;
      add(range.first);
      from = range.last;
    }
    add(piece.last);
  };
  for (const Piece& piece : recording.pieces) add_all({piece.first, piece.last});
  if (recording.pieces.empty()) add_all({0, recording.size()});
  std::vector<Recording> out;
  for (const UncutPart& part : parts) {
    if (kShortest * part.length < longest) continue;
    out.push_back(cut_out(recording, part));
    out.back().pieces.clear();
  }
  return out;
}

}  // namespace workbench
