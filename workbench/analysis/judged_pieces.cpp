#include "workbench/analysis/judged_pieces.hpp"

#include <algorithm>

#include "workbench/analysis/analysis.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

constexpr std::size_t kMostNamed = 5;

std::vector<SampleRange> between(const std::vector<SampleRange>& gaps, std::size_t size) {
  std::vector<SampleRange> out;
  std::size_t from = 0;
  for (const SampleRange& gap : gaps) {
    if (gap.first > from) out.push_back({from, gap.first});
    from = gap.last;
  }
  if (size > from) out.push_back({from, size});
  return out;
}

// "0 to 120 s, 300 to 610 s"
std::string times_of(const RecordingView& recording,
                     const std::vector<SampleRange>& ranges) {
  std::string text;
  for (std::size_t i = 0; i < std::min(ranges.size(), kMostNamed); ++i) {
    text += (i > 0 ? ", " : "") + number(recording.t[ranges[i].first]) + " to " +
            number(recording.t[ranges[i].last - 1]) + " s";
  }
  return text + (ranges.size() > kMostNamed ? ", …" : "");
}

}  // namespace

JudgedPieces judged_pieces(const RecordingView& recording) {
  constexpr std::size_t kShortest = 10;  // of the longest, times shorter
  if (recording.gaps.empty()) return {{recording}, {}};
  const auto length = [](const SampleRange& range) { return range.last - range.first; };
  std::vector<SampleRange> kept = between(recording.gaps, recording.size());
  if (kept.empty()) return {{recording}, {}};
  const auto by_length = [&length](const SampleRange& a, const SampleRange& b) {
    return length(a) < length(b);
  };
  const std::size_t longest = length(*std::ranges::max_element(kept, by_length));
  const std::size_t fewest =
      std::min(longest, std::max(longest / kShortest, Identifier::kFewestSamples));
  std::vector<SampleRange> dropped;
  for (const SampleRange& range : kept) {
    if (length(range) < fewest) dropped.push_back(range);
  }
  std::erase_if(kept, [&](const SampleRange& range) { return length(range) < fewest; });

  JudgedPieces out;
  for (const SampleRange& range : kept) {
    out.pieces.push_back(recording.part(range.first, length(range)));
  }
  out.notes.push_back("judged between the long gaps: " + times_of(recording, kept));
  if (!dropped.empty()) {
    out.notes.push_back(counted(samples_in(dropped), "sample", "samples") +
                        " between long gaps left out, too short to be judged: " +
                        times_of(recording, dropped));
  }
  return out;
}

}  // namespace workbench
