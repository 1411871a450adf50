#include "workbench/model/base/noise.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "workbench/effects/common.hpp"
#include "workbench/effects/situation.hpp"
#include "workbench/model/base/least_squares.hpp"
#include "workbench/recording/statistics.hpp"

namespace workbench {
namespace {

constexpr std::size_t kMostOrder = 12;
constexpr std::size_t kLags = 20;

}  // namespace

std::uint64_t next_random(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9E3779B97F4A7C15U);
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31U);
}

NoiseColour colour_of(std::span<const double> residual) {
  const std::vector<double> v = centred(residual);
  const std::size_t n = v.size();
  const std::size_t most = std::min(kMostOrder, n / 20);
  std::vector<double> r(most + 1);
  for (std::size_t k = 0; k <= most; ++k) {
    r[k] =
        dot(std::span(v).first(n - k), std::span(v).subspan(k)) / static_cast<double>(n);
  }
  NoiseColour best{{1.0}, r[0]};
  if (!(r[0] > 0)) return best;
  double least = static_cast<double>(n) * std::log(r[0]);
  std::vector<double> a = {1.0};
  double variance = r[0];
  for (std::size_t order = 1; order <= most; ++order) {
    double sum = 0;
    for (std::size_t j = 0; j < order; ++j) sum += a[j] * r[order - j];
    const double reflection = -sum / variance;
    std::vector<double> next(order + 1, 0.0);
    for (std::size_t j = 0; j <= order; ++j) {
      next[j] = (j < order ? a[j] : 0) + reflection * (j > 0 ? a[order - j] : 0);
    }
    a = std::move(next);
    variance *= 1 - reflection * reflection;
    if (!(variance > 1e-12 * r[0])) break;
    const double criterion =
        static_cast<double>(n) * std::log(variance) +
        static_cast<double>(order) * std::log(static_cast<double>(n));
    if (criterion < least) {
      least = criterion;
      best = {a, variance};
    }
  }
  return best;
}

std::vector<double> whitened(const NoiseColour& colour, std::span<const double> signal) {
  std::vector<double> out(signal.begin(), signal.end());
  for (std::size_t j = 1; j < colour.a.size(); ++j) {
    for (std::size_t k = j; k < out.size(); ++k) out[k] += colour.a[j] * signal[k - j];
  }
  return out;
}

namespace {

// Of one block: sums of products of what a difference foretells and what is there.
struct Products {
  double de = 0;
  double dd = 0;
};

// Variance of the slope from how far the blocks differ in it, each block's share in the
// slope allowed for (Bell & McCaffrey 2002): where few moves of u tell all that is told,
// they have to tell the same.
double variance_between(const std::vector<Products>& blocks, double slope, double dd) {
  constexpr double kAlone = 1e-6;  // of the sum beside the block that has it all
  double squares = 0;
  for (const Products& block : blocks) {
    const double left = block.de - slope * block.dd;
    squares += left * left / std::max(1 - block.dd / dd, kAlone);
  }
  return squares / (dd * dd);
}

Products sum_of(const std::vector<Products>& blocks) {
  Products all;
  for (const Products& block : blocks) {
    all.de += block.de;
    all.dd += block.dd;
  }
  return all;
}

// The test from its sums; `noise` the variance of what is foretold, were it only noise.
DifferenceTest tested(const std::vector<Products>& blocks, const Products& all,
                      double noise) {
  DifferenceTest test;
  test.slope = all.de / all.dd;
  const double variance = noise / all.dd;
  const auto tail = [&test](double of) {
    return normal_tail(test.slope / std::sqrt(of));
  };
  test.z = test.slope / std::sqrt(variance);
  test.p_value = tail(variance);
  test.p_steady = tail(std::max(variance, variance_between(blocks, test.slope, all.dd)));
  return test;
}

}  // namespace

double normal_tail(double z) {
  return 0.5 * std::erfc(z / std::sqrt(2.0));
}

DifferenceTest test_difference(std::span<const double> residual_small,
                               std::span<const double> residual_large,
                               const Blocks& blocks) {
  const NoiseColour colour = colour_of(residual_large);
  std::vector<double> difference(residual_small.size());
  for (std::size_t k = 0; k < difference.size(); ++k) {
    difference[k] = residual_small[k] - residual_large[k];
  }
  const std::vector<double> e = whitened(colour, residual_small);
  const std::vector<double> d = whitened(colour, difference);
  const std::vector<double> large = whitened(colour, residual_large);
  std::vector<Products> products;
  double noise = 0;
  double count = 0;
  for (const Block& block : blocks.blocks()) {
    if (block.estimation) continue;
    const std::size_t first = std::max(block.first, block.piece + colour.a.size());
    Products& here = products.emplace_back();
    for (std::size_t k = first; k < block.last; ++k) {
      here.de += d[k] * e[k];
      here.dd += d[k] * d[k];
      noise += large[k] * large[k];
    }
    count += block.last > first ? static_cast<double>(block.last - first) : 0;
  }
  const Products all = sum_of(products);
  if (!(all.dd > 0) || !(noise > 0) || count < 10) return {};
  return tested(products, all, noise / count);
}

namespace {

// Mean of what was, older samples counting less; of the samples of the piece before each.
std::vector<double> past_mean(std::span<const double> signal, const Blocks& blocks,
                              double samples) {
  const double keep = std::exp(-1 / samples);
  std::vector<double> out(signal.size());
  double mean = 0;
  for (const Block& block : blocks.blocks()) {
    if (block.first == block.piece) mean = signal[block.first];
    for (std::size_t k = block.first; k < block.last; ++k) {
      out[k] = mean;
      mean = keep * mean + (1 - keep) * signal[k];
    }
  }
  return out;
}

std::vector<double> delayed(std::span<const double> signal, std::size_t lag) {
  std::vector<double> out(signal.size(), signal.empty() ? 0 : signal[0]);
  std::copy(signal.begin(), signal.end() - static_cast<std::ptrdiff_t>(lag),
            out.begin() + static_cast<std::ptrdiff_t>(lag));
  return out;
}

}  // namespace

DifferenceTest test_given_past(std::span<const double> residual_small,
                               std::span<const double> residual_large,
                               std::span<const double> u, const Blocks& blocks) {
  constexpr std::size_t kPastResiduals = 12;
  constexpr std::size_t kPastInputs = 8;
  const std::size_t n = residual_small.size();
  if (n < 2 * (kPastResiduals + kPastInputs)) return {};
  std::vector<std::vector<double>> past = {std::vector<double>(n, 1.0)};
  for (std::size_t lag = 1; lag <= kPastResiduals; ++lag) {
    past.push_back(delayed(residual_small, lag));
  }
  for (std::size_t lag = 1; lag <= kPastInputs; ++lag) past.push_back(delayed(u, lag));
  for (const double samples : {16.0, 64.0, 256.0}) {
    past.push_back(past_mean(residual_small, blocks, samples));
    past.push_back(past_mean(u, blocks, samples));
  }
  std::vector<double> difference(n);
  for (std::size_t k = 0; k < n; ++k) {
    difference[k] = residual_small[k] - residual_large[k];
  }
  std::vector<Block> rows;  // what least_squares() is to look at
  for (const Block& block : blocks.blocks()) {
    const std::size_t first = std::max(block.first, block.piece + kPastResiduals);
    if (!block.estimation && first < block.last)
      rows.push_back({first, block.last, true});
  }
  const std::vector<std::span<const double>> columns(past.begin(), past.end());
  // What the past does not know of a signal, on those rows.
  const auto news = [&](std::span<const double> signal) {
    const std::vector<double> c = least_squares(columns, signal, rows);
    std::vector<double> out(signal.begin(), signal.end());
    for (std::size_t i = 0; i < c.size(); ++i) {
      for (std::size_t k = 0; k < n; ++k) out[k] -= c[i] * columns[i][k];
    }
    return out;
  };
  const std::vector<double> d = news(whitened(colour_of(residual_large), difference));
  const std::vector<double> e = news(residual_small);
  std::vector<Products> products;
  double ee = 0;
  double count = -static_cast<double>(columns.size()) - 1;
  for (const Block& row : rows) {
    const auto length = row.last - row.first;
    const auto left = std::span(d).subspan(row.first, length);
    const auto right = std::span(e).subspan(row.first, length);
    products.emplace_back(dot(left, right), dot(left, left));
    ee += dot(right, right);
    count += static_cast<double>(length);
  }
  const Products all = sum_of(products);
  if (!(all.dd > 0) || !(ee > 0) || count < 10) return {};
  const double left = std::max(ee - all.de * all.de / all.dd, 1e-12 * ee);
  return tested(products, all, left / count);
}

double likeness_by_chance(std::span<const double> residual_small,
                          std::span<const double> residual_large, const Blocks& blocks) {
  double small = 0;
  double large = 0;
  std::size_t samples = 0;
  for (const Block& block : blocks.blocks()) {
    if (block.estimation) continue;
    const std::size_t length = block.last - block.first;
    const auto before = residual_small.subspan(block.first, length);
    const auto after = residual_large.subspan(block.first, length);
    small += dot(before, before);
    large += dot(after, after);
    samples += length;
  }
  const double stretches =
      std::floor(static_cast<double>(samples) / effects::memory_of_noise(residual_small));
  if (!(large < small) || stretches < 1) return 1;
  const double left = std::max(large / small, 1e-12);
  return effects::student_tail(std::sqrt((1 - left) / left * stretches), stretches);
}

RatioInterval bootstrap_ratio(std::span<const double> residual_small,
                              std::span<const double> residual_large,
                              const Blocks& blocks, double memory_samples) {
  struct Sums {
    double small = 0;
    double large = 0;
  };
  std::vector<Sums> pieces;
  for (const Block& block : blocks.blocks()) {
    if (block.estimation) continue;
    const std::size_t length = block.last - block.first;
    const auto count =
        std::clamp<std::size_t>(static_cast<std::size_t>(static_cast<double>(length) /
                                                         std::max(memory_samples, 5.0)),
                                1, 4);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t first = block.first + i * length / count;
      const std::size_t size = block.first + (i + 1) * length / count - first;
      const auto small = residual_small.subspan(first, size);
      const auto large = residual_large.subspan(first, size);
      pieces.push_back({dot(small, small), dot(large, large)});
    }
  }
  if (pieces.empty()) return {};
  constexpr int kDraws = 400;
  std::vector<double> ratios;
  std::uint64_t state = 1;
  for (int draw = 0; draw < kDraws; ++draw) {
    Sums sums;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const Sums& piece = pieces[next_random(state) % pieces.size()];
      sums.small += piece.small;
      sums.large += piece.large;
    }
    ratios.push_back(sums.small > 0 ? sums.large / sums.small : 1);
  }
  return {quantile(ratios, 0.025), quantile(ratios, 0.975)};
}

double chi_square_score(double value, double degrees) {
  const double spread = 2 / (9 * degrees);
  return (std::cbrt(value / degrees) - (1 - spread)) / std::sqrt(spread);
}

double share_following_u(std::span<const double> residual, std::span<const double> u) {
  const std::vector<double> e = whitened(colour_of(residual), centred(residual));
  const std::vector<double> w = whitened(colour_of(u), centred(u));
  const double ee = dot(e, e);
  const double ww = dot(w, w);
  if (!(ee > 0) || !(ww > 0) || e.size() <= kLags) return 0;
  const auto lagged = [](std::span<const double> v, std::span<const double> earlier,
                         std::size_t lag) {
    return dot(v.subspan(lag), earlier.first(earlier.size() - lag));
  };
  std::vector<double> with_u;
  double sum = 0;
  for (std::size_t lag = 1; lag <= kLags; ++lag) {
    with_u.push_back(lagged(e, w, lag));
    sum += with_u.back() * with_u.back() / (ee * ww) * static_cast<double>(e.size());
  }
  const auto chance = static_cast<double>(kLags);
  if (!(chi_square_score(sum, chance) > 2.58)) return 0;
  // Where whitening leaves u a swing, its lags say the same more than once.
  std::vector<double> of_u;
  for (std::size_t lag = 0; lag < kLags; ++lag) of_u.push_back(lagged(w, w, lag));
  std::vector<double> products;
  for (std::size_t i = 0; i < kLags; ++i) {
    for (std::size_t j = 0; j < kLags; ++j) {
      products.push_back(of_u[i > j ? i - j : j - i]);
    }
  }
  const std::vector<double> inverse = inverse_spd(std::move(products), kLags);
  double share = 0;
  for (std::size_t i = 0; i < kLags; ++i) {
    share += with_u[i] * dot(std::span(inverse).subspan(i * kLags, kLags), with_u);
  }
  return std::clamp(share / ee - chance / static_cast<double>(e.size()), 0.0, 1.0);
}

bool follows_u(std::span<const double> residual, std::span<const double> u) {
  return share_following_u(residual, u) > 0;
}

bool is_white(std::span<const double> residual) {
  const auto n = static_cast<double>(residual.size());
  const std::vector<double> r = autocorrelation(residual, kLags);
  double sum = 0;
  for (std::size_t k = 0; k < r.size(); ++k) {
    sum += r[k] * r[k] / (n - static_cast<double>(k + 1));
  }
  return chi_square_score(n * (n + 2) * sum, static_cast<double>(kLags)) < 2.33;
}

double predictable_share(std::span<const double> residual) {
  const double power = dot(residual, residual);
  const double floor =
      colour_of(residual).variance * static_cast<double>(residual.size());
  return power > 0 ? std::clamp(1 - floor / power, 0.0, 1.0) : 0;
}

std::vector<double> without_glitches(std::span<const double> residual) {
  constexpr double kFew = 0.01;  // of the samples
  constexpr double kMost = 0.5;  // of the squares
  std::vector<double> out(residual.begin(), residual.end());
  const auto few = static_cast<std::size_t>(kFew * static_cast<double>(out.size()));
  if (few == 0) return out;
  std::vector<double> sizes(out.size());
  std::ranges::transform(out, sizes.begin(), [](double v) { return std::abs(v); });
  const auto end = sizes.begin() + static_cast<std::ptrdiff_t>(few);
  std::nth_element(sizes.begin(), end, sizes.end(), std::greater<>());
  const double most = *end;
  double rare = 0;
  for (auto it = sizes.begin(); it != end; ++it) rare += *it * *it;
  if (!(rare > kMost * dot(residual, residual))) return out;
  for (double& v : out) v = std::clamp(v, -most, most);
  return out;
}

bool is_noise(std::span<const double> residual) {
  return predictable_share(residual) < kPredictable &&
         predictable_share(without_glitches(residual)) < kPredictable;
}

std::vector<double> autocorrelation(std::span<const double> residual, std::size_t lags) {
  const std::vector<double> v = centred(residual);
  const double power = dot(v, v);
  std::vector<double> out;
  for (std::size_t k = 1; k <= lags && k < v.size(); ++k) {
    const double sum = dot(std::span(v).first(v.size() - k), std::span(v).subspan(k));
    out.push_back(power > 0 ? sum / power : 0);
  }
  return out;
}

}  // namespace workbench
