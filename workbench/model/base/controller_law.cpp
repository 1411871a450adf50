#include "workbench/model/base/controller_law.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "workbench/model/base/least_squares.hpp"

namespace workbench {
namespace {

// Less the straight line that is closest to it.
void straighten(std::span<double> v) {
  const auto n = static_cast<double>(v.size());
  const double middle = (n - 1) / 2;
  double mean = 0;
  for (const double value : v) mean += value / n;
  double tilt = 0;
  double squares = 0;
  for (std::size_t k = 0; k < v.size(); ++k) {
    const double at = static_cast<double>(k) - middle;
    tilt += at * (v[k] - mean);
    squares += at * at;
  }
  const double slope = squares > 0 ? tilt / squares : 0;
  for (std::size_t k = 0; k < v.size(); ++k) {
    v[k] -= mean + slope * (static_cast<double>(k) - middle);
  }
}

// What u, y and the sums and changes of y are, piece after piece.
struct Signals {
  std::vector<double> u;
  std::vector<double> sums;
  std::vector<double> y;
  std::vector<double> changes;
};

double mean_of(std::span<const double> v) {
  double sum = 0;
  for (const double value : v) sum += value;
  return sum / static_cast<double>(v.size());
}

Signals levels_of(std::span<const double> u, std::span<const double> y,
                  std::span<const Piece> pieces) {
  Signals out{{u.begin(), u.end()},
              std::vector<double>(u.size()),
              {y.begin(), y.end()},
              std::vector<double>(u.size())};
  for (const Piece& piece : pieces) {
    const std::size_t length = piece.last - piece.first;
    const double mean = mean_of(y.subspan(piece.first, length));
    double sum = 0;
    for (std::size_t k = piece.first; k < piece.last; ++k) {
      sum += y[k] - mean;
      out.sums[k] = sum;
      out.changes[k] = k > piece.first ? y[k] - y[k - 1] : 0;
    }
    for (std::vector<double>* signal : {&out.u, &out.sums, &out.y, &out.changes}) {
      straighten(std::span(*signal).subspan(piece.first, length));
    }
  }
  return out;
}

// The changes of all, from the second sample of each piece on.
Signals changes_of(const Signals& levels, std::span<const Piece> pieces) {
  Signals out;
  for (const Piece& piece : pieces) {
    for (std::size_t k = piece.first + 1; k < piece.last; ++k) {
      out.u.push_back(levels.u[k] - levels.u[k - 1]);
      out.sums.push_back(levels.sums[k] - levels.sums[k - 1]);
      out.y.push_back(levels.y[k] - levels.y[k - 1]);
      out.changes.push_back(levels.changes[k] - levels.changes[k - 1]);
    }
  }
  return out;
}

double share_of(const Signals& s) {
  const std::vector<Block> rows = {{0, s.u.size(), true}};
  const double all = sum_of_squares(s.u, rows);
  if (!(all > 0)) return 0;
  const std::vector<std::span<const double>> columns = {s.sums, s.y, s.changes};
  const std::vector<double> c = least_squares(columns, s.u, rows);
  std::vector<double> left = s.u;
  for (std::size_t k = 0; k < left.size(); ++k) {
    left[k] -= c[0] * s.sums[k] + c[1] * s.y[k] + c[2] * s.changes[k];
  }
  return 1 - sum_of_squares(left, rows) / all;
}

}  // namespace

LawShare law_share(std::span<const double> u, std::span<const double> y,
                   std::span<const Piece> pieces) {
  const auto [least, most] = std::ranges::minmax(u);
  if (least == most) return {};
  const Signals levels = levels_of(u, y, pieces);
  return {share_of(levels), share_of(changes_of(levels, pieces))};
}

bool follows_law(const LawShare& share) {
  constexpr double kMost = 0.9;
  constexpr double kNearlyAll = 0.99;  // of the level, where u is rounded
  constexpr double kSome = 0.2;
  return (share.of_level > kMost && share.of_changes > kMost) ||
         (share.of_level > kNearlyAll && share.of_changes > kSome);
}

}  // namespace workbench
