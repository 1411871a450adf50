#include "workbench/model/base/controller_law.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

#include "workbench/model/base/least_squares.hpp"
#include "workbench/recording/statistics.hpp"

namespace workbench {
namespace {

constexpr std::size_t kShortest = 8;  // samples of a stretch that is looked at

// u, and what it may be made of: from kTimes on a line in each piece, whose setpoint is
// not known.
using Signals = std::vector<std::vector<double>>;
enum Signal : std::size_t { kU, kSum, kLevel, kChange, kTimes };

// Of all samples; `ahead`: the change of y is the one that follows.
Signals signals_of(std::span<const double> u, std::span<const double> y,
                   std::span<const Piece> pieces, bool ahead = false) {
  Signals out(kTimes + pieces.size(), std::vector<double>(u.size()));
  out[kU].assign(u.begin(), u.end());
  out[kLevel].assign(y.begin(), y.end());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& piece = pieces[i];
    if (piece.last < piece.first + kShortest) continue;
    const double mean = mean_of(y.subspan(piece.first, piece.last - piece.first));
    const std::size_t last = piece.last - 1;
    double sum = 0;
    for (std::size_t k = piece.first; k < piece.last; ++k) {
      sum += y[k] - mean;
      out[kSum][k] = sum;
      const std::size_t to = ahead ? std::min(k + 1, last) : k;
      out[kChange][k] = to > piece.first ? y[to] - y[to - 1] : 0;
      out[kTimes + i][k] = static_cast<double>(k - piece.first);
    }
  }
  return out;
}

// Where u is between its ends.
std::vector<SampleRange> between_ends(std::span<const double> u,
                                      std::span<const Piece> pieces) {
  constexpr std::size_t kStays = 3;
  const auto [least, most] = std::ranges::minmax(u);
  std::vector<SampleRange> out;
  for (const Piece& piece : pieces) {
    std::size_t from = piece.first;
    for (std::size_t k = piece.first; k < piece.last;) {
      std::size_t end = k + 1;
      const bool at_end = u[k] == least || u[k] == most;
      while (at_end && end < piece.last && u[end] == u[k]) ++end;
      if (end - k >= kStays) {
        out.push_back({from, k});
        from = end;
      }
      k = end;
    }
    out.push_back({from, piece.last});
  }
  std::erase_if(
      out, [](const SampleRange& range) { return range.last < range.first + kShortest; });
  return out;
}

// Each stretch less its mean, one behind the other.
Signals levels_in(const Signals& all, std::span<const SampleRange> stretches) {
  Signals out(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const SampleRange& at : stretches) {
      const auto values = std::span(all[i]).subspan(at.first, at.last - at.first);
      std::ranges::copy(centred(values), std::back_inserter(out[i]));
    }
  }
  return out;
}

// From one sample of a stretch to the next.
Signals changes_in(const Signals& all, std::span<const SampleRange> stretches) {
  Signals out(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const SampleRange& at : stretches) {
      for (std::size_t k = at.first + 1; k < at.last; ++k) {
        out[i].push_back(all[i][k] - all[i][k - 1]);
      }
    }
  }
  return out;
}

// u by what stands from `first` on: its coefficients, and the squares that are left.
struct Made {
  std::vector<double> coefficients;
  double left = 0;
};

Made made_of(const Signals& s, std::size_t first) {
  const std::vector<Block> rows = {{0, s[kU].size(), true}};
  const std::vector<std::span<const double>> columns(
      s.begin() + static_cast<std::ptrdiff_t>(first), s.end());
  Made out{least_squares(columns, s[kU], rows)};
  std::vector<double> left = s[kU];
  for (std::size_t i = 0; i < columns.size(); ++i) {
    for (std::size_t k = 0; k < left.size(); ++k) {
      left[k] -= out.coefficients[i] * columns[i][k];
    }
  }
  out.left = sum_of_squares(left, rows);
  return out;
}

// Whether the sum of y has its part in u, as in a controller that takes a load away for
// good. What a process that is moved by hand makes of u has none, or one of the other
// sign.
bool integrates_in(const Signals& s) {
  constexpr double kMuch = 1.5;
  const Made with = made_of(s, kSum);
  const bool one_sign = with.coefficients[0] * with.coefficients[1] > 0;
  return one_sign && made_of(s, kLevel).left > kMuch * with.left;
}

// Whether u moves by a few amounts only, up to a hundredth of the largest.
bool switches_in(std::span<const double> changes) {
  constexpr std::size_t kMost = 4;  // amounts
  constexpr double kSame = 0.01;
  std::vector<double> amounts(changes.begin(), changes.end());
  std::erase(amounts, 0);
  if (amounts.empty()) return false;
  std::ranges::sort(amounts);
  const double same = kSame * std::max(-amounts.front(), amounts.back());
  std::size_t found = 1;
  double first = amounts.front();
  for (const double amount : amounts) {
    if (amount <= first + same) continue;
    first = amount;
    ++found;
  }
  return found <= kMost;
}

double share_of(const Signals& s) {
  const double all = made_of(s, kTimes).left;
  return all > 0 ? 1 - made_of(s, kSum).left / all : 0;
}

}  // namespace

LawShare law_share(std::span<const double> u, std::span<const double> y,
                   std::span<const Piece> pieces) {
  constexpr double kFewest = 0.25;  // of the samples
  const auto [least, most] = std::ranges::minmax(u);
  if (least == most) return {};
  const std::vector<SampleRange> stretches = between_ends(u, pieces);
  std::size_t samples = 0;
  for (const SampleRange& at : stretches) samples += at.last - at.first;
  if (static_cast<double>(samples) < kFewest * static_cast<double>(u.size())) return {};
  const Signals all = signals_of(u, y, pieces);
  const Signals levels = levels_in(all, stretches);
  const Signals changes = changes_in(all, stretches);
  const Signals ahead = changes_in(signals_of(u, y, pieces, true), stretches);
  constexpr double kFarLess = 0.5;
  return {share_of(levels), share_of(changes), integrates_in(levels),
          switches_in(changes[kU]),
          made_of(ahead, kSum).left < kFarLess * made_of(changes, kSum).left};
}

bool follows_law(const LawShare& share) {
  constexpr double kMost = 0.9;
  constexpr double kNearlyAll = 0.99;
  constexpr double kSome = 0.1;
  if (share.leads && !share.integrates) return false;
  if (share.of_changes > kMost && !share.switches) return share.of_level > kMost;
  return share.of_changes > kSome && share.integrates &&
         share.of_level > (share.switches ? kNearlyAll : kMost);
}

}  // namespace workbench
