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

// From the sample before each in its piece, 0 for the first.
std::vector<double> changes_of(std::span<const double> y, std::span<const Piece> pieces) {
  std::vector<double> out(y.size());
  for (const Piece& piece : pieces) {
    for (std::size_t k = piece.first + 1; k < piece.last; ++k) out[k] = y[k] - y[k - 1];
  }
  return out;
}

// Those that follow each sample; at the end of a piece the last one again.
std::vector<double> next_of(const std::vector<double>& changes,
                            std::span<const Piece> pieces) {
  std::vector<double> out = changes;
  for (const Piece& piece : pieces) {
    for (std::size_t k = piece.first + 1; k < piece.last; ++k) out[k - 1] = changes[k];
  }
  return out;
}

// Of all samples.
Signals signals_of(std::span<const double> u, std::span<const double> y,
                   std::span<const Piece> pieces) {
  Signals out(kTimes + pieces.size(), std::vector<double>(u.size()));
  out[kU].assign(u.begin(), u.end());
  out[kLevel].assign(y.begin(), y.end());
  out[kChange] = changes_of(y, pieces);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& piece = pieces[i];
    const double mean = mean_of(y.subspan(piece.first, piece.last - piece.first));
    double sum = 0;
    for (std::size_t k = piece.first; k < piece.last; ++k) {
      sum += y[k] - mean;
      out[kSum][k] = sum;
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

using Columns = std::vector<std::span<const double>>;

Columns columns_from(const Signals& s, std::size_t first) {
  return {s.begin() + static_cast<std::ptrdiff_t>(first), s.end()};
}

// u by columns of its law: their coefficients, and the squares that are left.
struct Made {
  std::vector<double> coefficients;
  double left = 0;
};

Made made_of(const std::vector<double>& u, const Columns& columns) {
  const std::vector<Block> rows = {{0, u.size(), true}};
  Made out{least_squares(columns, u, rows)};
  std::vector<double> left = u;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    for (std::size_t k = 0; k < left.size(); ++k) {
      left[k] -= out.coefficients[i] * columns[i][k];
    }
  }
  out.left = sum_of_squares(left, rows);
  return out;
}

Made made_of(const Signals& s, std::size_t first) {
  return made_of(s[kU], columns_from(s, first));
}

constexpr double kMuch = 1.5;  // times the squares that are left with a part of the law

// The squares that are left of u by all of the law but `part`.
double left_without(const Signals& s, Signal part) {
  Columns columns = columns_from(s, kSum);
  columns.erase(columns.begin() + (part - kSum));
  return made_of(s[kU], columns).left;
}

// u by y, where it is seen, and from sample to sample, too: else both follow something
// slow.
double slope_in(const Signals& s, const Made& by_law, const Made& by_change) {
  constexpr std::size_t kOfLevel = kLevel - kSum;
  const double slope = by_law.coefficients[kOfLevel];
  const bool seen = left_without(s, kLevel) > kMuch * by_law.left;
  return seen && slope * by_change.coefficients[kOfLevel] > 0 ? slope : 0;
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

double share_of(const Signals& s, const Made& by_law) {
  const double all = made_of(s, kTimes).left;
  return all > 0 ? 1 - by_law.left / all : 0;
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
  Signals all = signals_of(u, y, pieces);
  const Signals levels = levels_in(all, stretches);
  const Signals changes = changes_in(all, stretches);
  all[kChange] = next_of(all[kChange], pieces);
  const Signals ahead = changes_in(all, stretches);
  const Made level = made_of(levels, kSum);
  const Made change = made_of(changes, kSum);
  // The sum of y has its part in a controller that takes a load away for good, with the
  // sign that y has. What a process that is moved by hand makes of u has none, or one of
  // the other sign.
  const bool one_sign = level.coefficients[0] * level.coefficients[1] > 0;
  const double without_sum = one_sign ? left_without(levels, kSum) : 0;
  constexpr double kSome = 1.1;  // as kMuch, where y has its part, too
  constexpr double kFarLess = 0.5;
  const bool seen_beside_sum = without_sum > kSome * level.left;
  return {.of_level = share_of(levels, level),
          .of_changes = share_of(changes, change),
          .integrates = without_sum > kMuch * level.left,
          .switches = switches_in(changes[kU]),
          .leads = kFarLess * change.left > made_of(ahead, kSum).left,
          .slope = seen_beside_sum ? slope_in(levels, level, change) : 0};
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
