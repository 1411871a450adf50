#include "workbench/effects/level_changes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "workbench/effects/common.hpp"
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

// What a change of level explains: sums from each sample on, over the estimation samples,
// of what is left and of the answers to u.
class Changes {
 public:
  explicit Changes(const Situation& s)
      : basis_(answers_to_u(s)),
        left_(s.residual.begin(), s.residual.end()),
        square_(samples() + 1),
        with_left_(samples() + 1),
        with_basis_((samples() + 1) * basis_.size()) {
    for (std::size_t k = 0; k < samples(); ++k) left_[k] *= s.estimation[k];
    take_out(basis_, left_);
    const std::size_t width = basis_.size();
    for (std::size_t k = samples(); k-- > 0;) {
      square_[k] = square_[k + 1] + s.estimation[k];
      with_left_[k] = with_left_[k + 1] + left_[k];
      for (std::size_t i = 0; i < width; ++i) {
        with_basis_[k * width + i] = with_basis_[(k + 1) * width + i] + basis_[i][k];
      }
    }
  }

  [[nodiscard]] std::size_t samples() const { return left_.size(); }
  /// Squared error that another level in first … last - 1 takes away.
  [[nodiscard]] double gain(std::size_t first, std::size_t last) const {
    const double square = square_[first] - square_[last];
    const double of_its_own = own_square(first, last);
    if (!(of_its_own > kOfItsOwn * square)) return 0;
    const double sum = with_left_[first] - with_left_[last];
    return sum * sum / of_its_own;
  }
  /// The same of a change for good.
  [[nodiscard]] double gain(std::size_t first) const { return gain(first, samples()); }
  /// What stays with another level there.
  [[nodiscard]] Signal beside(const PassingLevel& level, const Situation& s) const {
    Signal column(samples());
    for (std::size_t k = level.first; k < level.last; ++k) column[k] = s.estimation[k];
    take_out(basis_, column);
    const double square = product(column, column);
    const double height = square > 0 ? product(column, left_) / square : 0;
    Signal out = left_;
    for (std::size_t k = 0; k < samples(); ++k) out[k] -= height * column[k];
    return out;
  }

 private:
  [[nodiscard]] double own_square(std::size_t first, std::size_t last) const {
    double own = square_[first] - square_[last];
    const std::size_t width = basis_.size();
    for (std::size_t i = 0; i < width; ++i) {
      const double with = with_basis_[first * width + i] - with_basis_[last * width + i];
      own -= with * with;
    }
    return own;
  }

  std::vector<Signal> basis_;  // before the sums: they are as wide as it
  Signal left_;
  std::vector<double> square_;
  std::vector<double> with_left_;
  std::vector<double> with_basis_;
};

std::size_t edge_of(std::size_t samples) {
  return samples / 50 + 2;
}

// Its ends moved to the best samples nearby, one after the other.
PassingLevel refined(const Changes& changes, PassingLevel level, std::size_t reach) {
  constexpr int kRounds = 2;
  const std::size_t edge = edge_of(changes.samples());
  for (int round = 0; round < kRounds; ++round) {
    PassingLevel best = level;
    for (std::size_t k = level.first - std::min(reach, level.first - edge);
         k <= std::min(level.first + reach, level.last - 1); ++k) {
      if (changes.gain(k, level.last) > changes.gain(best.first, level.last)) {
        best.first = k;
      }
    }
    const std::size_t from = std::max(best.first + 1, level.last - reach);
    const std::size_t to = std::min(level.last + reach, changes.samples() - edge);
    for (std::size_t k = from; k <= to; ++k) {
      if (changes.gain(best.first, k) > changes.gain(best.first, best.last)) {
        best.last = k;
      }
    }
    level = best;
  }
  return level;
}

// True where the second change of `level` is worth more than its place among all others
// by chance: each change costs three halves of the logarithm of the number of samples
// that speak for themselves (Zhang & Siegmund 2007).
bool is_worth_its_end(const Changes& changes, const PassingLevel& level,
                      const Situation& s, double gain_for_good) {
  constexpr double kCost = 3;
  constexpr double kFewest = 12;
  const Signal left = changes.beside(level, s);
  const double with = product(left, left);
  const double for_good = with + changes.gain(level.first, level.last) - gain_for_good;
  const double fitted = std::accumulate(s.estimation.begin(), s.estimation.end(), 0.0);
  const double speaking = fitted / effects::memory_of_noise(left);
  if (!(with > 0)) return for_good > 0;
  return speaking > kFewest &&
         speaking * std::log(for_good / with) > kCost * std::log(speaking);
}

// The best of the pairs of instants a grid apart, none of whose ends is within `apart` of
// those of `taken`.
PassingLevel best_pair(const Changes& changes, const std::vector<PassingLevel>& taken,
                       std::size_t apart) {
  constexpr std::size_t kInstants = 80;
  const std::size_t n = changes.samples();
  const std::size_t step = std::max<std::size_t>(1, n / kInstants);
  const auto is_taken = [&](std::size_t k) {
    return std::ranges::any_of(taken, [&](const PassingLevel& level) {
      return (k + apart > level.first && k < level.first + apart) ||
             (k + apart > level.last && k < level.last + apart);
    });
  };
  PassingLevel best;
  double most = 0;
  for (std::size_t first = edge_of(n); first + edge_of(n) < n; first += step) {
    if (is_taken(first)) continue;
    for (std::size_t last = first + step; last + edge_of(n) <= n; last += step) {
      const double gain = is_taken(last) ? 0 : changes.gain(first, last);
      if (gain > most) best = {first, last};
      most = std::max(most, gain);
    }
  }
  return best;
}

// `gain` of a change at each sample.
std::vector<std::size_t> best_changes(std::vector<double> gain) {
  const std::size_t n = gain.size();
  std::vector<std::size_t> changes;
  const std::size_t edge = edge_of(n);
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

// `for_good`: what the best change for good takes away.
std::vector<PassingLevel> best_passing(const Changes& changes, const Situation& s,
                                       double for_good) {
  constexpr std::size_t kMost = 2;
  const std::size_t n = changes.samples();
  std::vector<PassingLevel> out;
  while (out.size() < kMost) {
    const PassingLevel pair = best_pair(changes, out, n / 20);
    if (pair.last == 0) break;
    const PassingLevel level = refined(changes, pair, n / 40 + 1);
    if (!is_worth_its_end(changes, level, s, for_good)) break;
    out.push_back(level);
  }
  return out;
}

}  // namespace

LevelChanges level_changes(const Situation& s) {
  const Changes changes(s);
  std::vector<double> gain(changes.samples());
  for (std::size_t k = 0; k < gain.size(); ++k) gain[k] = changes.gain(k);
  LevelChanges out;
  out.for_good = best_changes(gain);
  const double most = out.for_good.empty() ? 0 : gain[out.for_good.front()];
  out.passing = best_passing(changes, s, most);
  return out;
}

}  // namespace workbench
