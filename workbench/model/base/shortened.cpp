#include "workbench/model/base/shortened.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "workbench/model/base/joined.hpp"
#include "workbench/model/base/thinned.hpp"

namespace workbench {
namespace {

constexpr std::size_t kEnough = 5000;
constexpr std::size_t kFewestOfPiece = 200;

// Half the mean square by which values `count` samples apart differ.
double half_square_apart(std::span<const double> values, std::size_t count) {
  double sum = 0;
  for (std::size_t k = count; k < values.size(); ++k) {
    sum += (values[k] - values[k - count]) * (values[k] - values[k - count]);
  }
  return sum / (2 * static_cast<double>(values.size() - count));
}

// So many samples, at most `most`, that no more than a hundredth of the variance lies
// within them, without that of neighbours, which is mostly noise.
std::size_t rests_for(std::span<const double> values, std::size_t most) {
  constexpr double kMostWithin = 0.01;
  const auto size = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / size;
  double variance = 0;
  for (const double value : values) variance += (value - mean) * (value - mean) / size;
  const double within = half_square_apart(values, 1) + kMostWithin * variance;
  std::size_t count = 1;
  while (count < most && half_square_apart(values, count + 1) <= within) ++count;
  return count;
}

std::size_t thinning_of(const Recording& recording, Column output) {
  const std::size_t most = (recording.size() + kEnough - 1) / kEnough;
  return rests_for(recording.values(output), rests_for(recording.u, most));
}

// The `count` neighbours among samples [first, last) of u whose variance is largest.
SampleRange liveliest(std::span<const double> u, SampleRange within, std::size_t count) {
  const std::size_t size = within.last - within.first;
  if (size <= count) return within;
  const double about = u[within.first];
  double sum = 0;
  double squares = 0;
  SampleRange best{within.first, within.first + count};
  double most = -1;
  for (std::size_t k = within.first; k < within.last; ++k) {
    const double value = u[k] - about;
    sum += value;
    squares += value * value;
    if (k + 1 < within.first + count) continue;
    const std::size_t first = k + 1 - count;
    const double variance = squares - sum * sum / static_cast<double>(count);
    if (variance > most) {
      most = variance;
      best = {first, k + 1};
    }
    const double oldest = u[first] - about;
    sum -= oldest;
    squares -= oldest * oldest;
  }
  return best;
}

}  // namespace

double Shortened::in_whole(double seconds) const {
  double later = later_s.front();
  for (std::size_t i = 1; i < later_s.size(); ++i) {
    // Between two samples: what begins there begins with the later one.
    const double begin =
        (static_cast<double>(recording.pieces[i].first) - 0.5) * recording.period_s;
    if (seconds > begin) later = later_s[i];
  }
  return seconds + later;
}

double Shortened::in_short(double seconds) const {
  const auto end_s = [this](std::size_t piece) {
    const std::size_t last =
        piece + 1 < later_s.size() ? recording.pieces[piece].last : recording.size();
    return static_cast<double>(last) * recording.period_s;
  };
  double begin_s = 0;
  for (std::size_t i = 0; i < later_s.size(); ++i) {
    const double here = std::max(seconds - later_s[i], begin_s);
    if (here <= end_s(i)) return here;
    begin_s = end_s(i);
  }
  return begin_s;
}

bool is_long(const Recording& recording) {
  return recording.size() > kEnough;
}

Shortened shortened(const Recording& recording, Column output) {
  Shortened out;
  out.count = thinning_of(recording, output);
  out.recording = out.count > 1 ? thinned(recording, out.count) : recording;
  const Recording& fewer = out.recording;
  const bool whole = fewer.pieces.empty();
  std::vector<Piece> pieces = fewer.pieces;
  if (whole) pieces.push_back({0, fewer.size(), fewer.name, 0, false});
  out.later_s.assign(pieces.size(), 0.0);
  out.is_excerpt = fewer.size() > kEnough;
  if (!out.is_excerpt) return out;
  const double share = static_cast<double>(kEnough) / static_cast<double>(fewer.size());
  std::size_t begin = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Piece& piece = pieces[i];
    const auto size = static_cast<double>(piece.last - piece.first);
    const std::size_t count =
        std::max(kFewestOfPiece, static_cast<std::size_t>(share * size));
    const SampleRange kept = liveliest(fewer.u, {piece.first, piece.last}, count);
    const auto cut = static_cast<double>(kept.first - piece.first);
    out.later_s[i] =
        fewer.period_s * (static_cast<double>(kept.first) - static_cast<double>(begin));
    piece.start_s += fewer.period_s * cut;
    piece.first = kept.first;
    piece.last = kept.last;
    begin += kept.last - kept.first;
  }
  out.recording = cut_to(fewer, std::move(pieces));
  if (whole) out.recording.pieces.clear();
  return out;
}

}  // namespace workbench
