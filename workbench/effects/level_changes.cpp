#include "workbench/effects/level_changes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "workbench/effects/process_shape.hpp"

namespace workbench {
namespace {

constexpr double kLagsOfRecord[] = {0.002, 0.015, 0.1};  // of its duration
constexpr double kOfItsOwn = 1e-3;  // share that the answers to u must leave of a column

using Signal = std::vector<double>;

double product(const Signal& a, const Signal& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

// What the columns of `basis`, orthonormal, leave of `column`.
void take_out(const std::vector<Signal>& basis, Signal& column) {
  for (const Signal& one : basis) {
    const double share = product(one, column);
    for (std::size_t k = 0; k < column.size(); ++k) column[k] -= share * one[k];
  }
}

// Adds what is new in `column` on the estimation samples.
void extend(std::vector<Signal>& basis, Signal column, const Situation& s) {
  for (std::size_t k = 0; k < column.size(); ++k) column[k] *= s.estimation[k];
  const double before = product(column, column);
  take_out(basis, column);
  const double left = product(column, column);
  if (!(left > kOfItsOwn * before)) return;
  for (double& value : column) value /= std::sqrt(left);
  basis.push_back(std::move(column));
}

// Each piece starts at rest.
Signal lagged(const Situation& s, double lag_s) {
  Signal out(s.u.size());
  const auto add = [&](std::size_t first, std::size_t last) {
    const std::span<const double> u = s.u.subspan(first, last - first);
    lag(u, s.period_s, lag_s, u.front(), std::span(out).subspan(first, u.size()));
  };
  for (const Piece& piece : s.pieces) add(piece.first, piece.last);
  if (s.pieces.empty()) add(0, out.size());
  return out;
}

std::vector<Signal> answers_to_u(const Situation& s) {
  const std::size_t n = s.residual.size();
  std::vector<Signal> basis;
  extend(basis, Signal(n, 1.0), s);
  if (s.y.size() == n) {
    Signal simulated(n);
    for (std::size_t k = 0; k < n; ++k) simulated[k] = s.y[k] - s.residual[k];
    extend(basis, std::move(simulated), s);
  }
  if (s.u.size() != n) return basis;
  for (const double share : kLagsOfRecord) {
    extend(basis, lagged(s, share * s.duration_s()), s);
  }
  return basis;
}

}  // namespace

std::vector<std::size_t> level_changes(const Situation& s) {
  const std::size_t n = s.residual.size();
  const std::vector<Signal> basis = answers_to_u(s);
  Signal left(s.residual.begin(), s.residual.end());
  for (std::size_t k = 0; k < n; ++k) left[k] *= s.estimation[k];
  take_out(basis, left);
  // Of the step from k on: its square, and its products with `left` and the basis.
  std::vector<double> gain(n);
  std::vector<double> with_basis(basis.size());
  double with_left = 0;
  double square = 0;
  for (std::size_t k = n; k-- > 0;) {
    square += s.estimation[k];
    with_left += left[k];
    double of_its_own = square;
    for (std::size_t i = 0; i < basis.size(); ++i) {
      with_basis[i] += basis[i][k];
      of_its_own -= with_basis[i] * with_basis[i];
    }
    if (of_its_own > kOfItsOwn * square) gain[k] = with_left * with_left / of_its_own;
  }
  std::vector<std::size_t> changes;
  const std::size_t edge = n / 50 + 2;
  while (changes.size() < 3 && n > 2 * edge) {
    const auto best = std::max_element(gain.begin() + edge, gain.end() - edge);
    if (!(*best > 0)) break;
    const auto at = static_cast<std::size_t>(best - gain.begin());
    changes.push_back(at);
    const std::size_t from = at > n / 10 ? at - n / 10 : 0;
    std::fill(gain.begin() + from, gain.begin() + std::min(at + n / 10, n), 0.0);
  }
  return changes;
}

}  // namespace workbench
