#include "workbench/model/base/joined.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "workbench/model/base/blocks.hpp"
#include "workbench/model/base/one_loop.hpp"
#include "workbench/model/base/thinned.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/listed.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

constexpr std::size_t kMostPieces = 12;  // of one recording
constexpr std::size_t kFewestOfPiece = 20;

void append(std::vector<double>& to, const std::vector<double>& from, std::size_t first,
            std::size_t last) {
  if (from.empty()) return;
  to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(first),
            from.begin() + static_cast<std::ptrdiff_t>(last));
}

// Its longest gaps cut it.
std::vector<Piece> pieces_of(const Recording& recording) {
  std::vector<SampleRange> gaps = recording.resampling.gaps;
  if (gaps.size() >= kMostPieces) {
    std::ranges::stable_sort(gaps, [](const SampleRange& a, const SampleRange& b) {
      return a.last - a.first > b.last - b.first;
    });
    gaps.resize(kMostPieces - 1);
    std::ranges::sort(gaps, [](const SampleRange& a, const SampleRange& b) {
      return a.first < b.first;
    });
  }
  gaps.push_back({recording.size(), recording.size()});
  std::vector<Piece> pieces;
  std::size_t first = 0;
  for (const SampleRange& gap : gaps) {
    if (gap.first >= first + kFewestOfPiece) {
      pieces.push_back({first, gap.first, recording.name, recording.t[first], false});
    }
    first = gap.last;
  }
  if (pieces.empty()) {
    pieces.push_back({0, recording.size(), recording.name, recording.t[0], false});
  }
  pieces.front().at_rest = recording.begins_at_rest && pieces.front().first == 0;
  return pieces;
}

// The recording without what was held in its gaps.
Recording cut_up(const Recording& recording) {
  Recording out = cut_to(recording, pieces_of(recording));
  if (out.pieces.size() > 1) {
    out.resampling.notes.push_back(
        counted(out.pieces.size() - 1, "long gap is", "long gaps are") +
        " left out: each of the " + std::to_string(out.pieces.size()) +
        " pieces starts from a state of its own");
  }
  return out;
}

// How many samples of `recording` are one of the slowest.
std::size_t thinning_to(const Recording& slowest, const Recording& recording) {
  constexpr double kAlike = 0.01;
  const double ratio = slowest.period_s / recording.period_s;
  const double count = std::round(ratio);
  if (std::abs(ratio - count) > kAlike * count) {
    throw InputError(recording.name, 0, 0,
                     "a sample period that divides the " + number(slowest.period_s) +
                         " s of " + slowest.name,
                     number(recording.period_s) + " s",
                     "export both with the same sample period");
  }
  return static_cast<std::size_t>(count);
}

// At so long a period hardly anything of a recording may be left.
void refuse_few(const Recording& thinned, const Recording& recording,
                const Recording& slowest) {
  constexpr std::size_t kFewest = Blocks::kFewestSamples;
  if (thinned.size() >= kFewest || recording.size() < kFewest) return;
  throw CannotAnswer(recording.name, 0, 0,
                     std::to_string(kFewest) + " samples or more, one every " +
                         number(slowest.period_s) + " s as in " + slowest.name,
                     std::to_string(thinned.size()) + " (it has one every " +
                         number(recording.period_s) + " s)",
                     "give recordings whose sample periods are nearer to each other");
}

void append(Recording& to, Recording from) {
  const std::size_t start = to.u.size();
  for (const Column column : kLoopColumns) {
    if (!to.has(column) || !from.has(column)) {
      to.values(column).clear();
    } else {
      append(to.values(column), from.values(column), 0, from.size());
    }
  }
  std::erase_if(to.loads, [&](const Load& load) {
    return std::ranges::none_of(
        from.loads, [&](const Load& other) { return other.name == load.name; });
  });
  for (Load& load : to.loads) {
    for (const Load& other : from.loads) {
      if (other.name == load.name) append(load.values, other.values, 0, from.size());
    }
  }
  for (Piece& piece : from.pieces) {
    to.pieces.push_back(std::move(piece));
    to.pieces.back().first += start;
    to.pieces.back().last += start;
  }
  for (const SampleRange& range : from.left_out) {
    to.left_out.push_back({start + range.first, start + range.last});
  }
  to.resampling.missing += from.resampling.missing;
  to.resampling.notes.insert(to.resampling.notes.end(), from.resampling.notes.begin(),
                             from.resampling.notes.end());
}

}  // namespace

std::vector<SampleRange> united(std::vector<SampleRange> ranges,
                                const std::vector<SampleRange>& others) {
  ranges.insert(ranges.end(), others.begin(), others.end());
  std::ranges::sort(ranges, [](const SampleRange& a, const SampleRange& b) {
    return a.first < b.first;
  });
  std::vector<SampleRange> out;
  for (const SampleRange& range : ranges) {
    if (!out.empty() && range.first <= out.back().last) {
      out.back().last = std::max(out.back().last, range.last);
    } else {
      out.push_back(range);
    }
  }
  return out;
}

Parts parts_of(const Recording& recording) {
  if (!recording.pieces.empty()) return {recording.pieces, recording.left_out};
  Parts out{pieces_of(recording), {}};
  std::size_t end = 0;
  for (Piece& piece : out.pieces) {
    if (piece.first > end) out.left_out.push_back({end, piece.first});
    end = piece.last;
  }
  if (end < recording.size()) out.left_out.push_back({end, recording.size()});
  out.left_out = united(std::move(out.left_out), recording.left_out);
  out.pieces.front().first = 0;
  for (std::size_t i = 0; i < out.pieces.size(); ++i) {
    out.pieces[i].last =
        i + 1 < out.pieces.size() ? out.pieces[i + 1].first : recording.size();
  }
  return out;
}

Recording cut_to(const Recording& recording, std::vector<Piece> pieces) {
  Recording out = recording;
  out.pieces = std::move(pieces);
  out.t.clear();
  out.left_out.clear();
  out.resampling.gaps.clear();
  out.manual.clear();
  for (Column column : kLoopColumns) out.values(column).clear();
  for (Load& load : out.loads) load.values.clear();
  for (Piece& piece : out.pieces) {
    const std::size_t start = out.u.size();
    const auto keep = [&](const std::vector<SampleRange>& from,
                          std::vector<SampleRange>& to) {
      for (const SampleRange& range : clipped(from, {piece.first, piece.last})) {
        to.push_back({start + range.first, start + range.last});
      }
    };
    keep(recording.left_out, out.left_out);
    keep(recording.resampling.gaps, out.resampling.gaps);
    keep(recording.manual, out.manual);
    append(out.t, recording.t, piece.first, piece.last);
    for (Column column : kLoopColumns) {
      append(out.values(column), recording.values(column), piece.first, piece.last);
    }
    for (std::size_t i = 0; i < out.loads.size(); ++i) {
      append(out.loads[i].values, recording.loads[i].values, piece.first, piece.last);
    }
    piece.last = start + piece.last - piece.first;
    piece.first = start;
  }
  return out;
}

Recording joined(std::vector<Recording> fitted, std::vector<Recording> judging) {
  if (fitted.size() == 1 && judging.empty() && fitted[0].resampling.gaps.empty()) {
    return std::move(fitted[0]);
  }
  const std::string name = listed(fitted, ", ", &Recording::name);
  const std::size_t first_judging = fitted.size();
  std::vector<Recording> all = std::move(fitted);
  for (Recording& one : judging) all.push_back(std::move(one));
  check_one_loop(all);
  const std::vector<std::string> overlaps = overlaps_of(all);
  const Recording& slowest = *std::ranges::max_element(
      all,
      [](const Recording& a, const Recording& b) { return a.period_s < b.period_s; });
  Recording out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::size_t thinning = thinning_to(slowest, all[i]);
    Recording next = cut_up(all[i]);
    if (thinning > 1) {
      next = thinned(next, thinning);
      if (i < first_judging) refuse_few(next, all[i], slowest);
      next.resampling.notes.push_back(all[i].name + ": each " + std::to_string(thinning) +
                                      " samples are one, as in " + slowest.name);
    }
    for (Piece& piece : next.pieces) piece.judges = i >= first_judging;
    if (i == 0) {
      out = std::move(next);
    } else {
      append(out, std::move(next));
    }
  }
  out.resampling.notes.insert(out.resampling.notes.end(), overlaps.begin(),
                              overlaps.end());
  out.name = name;
  out.period_s = slowest.period_s;
  out.resampling.gaps.clear();
  const double start = out.pieces.front().start_s;
  out.t.resize(out.u.size());
  for (std::size_t k = 0; k < out.t.size(); ++k) {
    out.t[k] = start + static_cast<double>(k) * out.period_s;
  }
  return out;
}

}  // namespace workbench
