#include "ident/signal/swap.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace ident {
namespace {

// Δsp, sp, in, Δin, and Δout, which they explain.
constexpr std::size_t kTerms = 5;
constexpr std::size_t kIntegral = 2;
constexpr std::size_t kProportional = 3;
constexpr std::size_t kOut = 4;
constexpr std::size_t kFewest = 32;
// A term that the ones before it explain up to this share of its own adds nothing.
constexpr double kDependent = 1e-6;
// What the law must explain, and how much more the reading as labelled must leave, at
// least what rounding leaves of either.
constexpr double kExplained = 0.9;
constexpr double kTimesMoreLeft = 4;
constexpr double kLeftAtLeast = 1e-4;
// One sample in so many has to bring another `out`: where it rests longer, a rounded
// process output steps and the controller answers at once, a law in both readings.
constexpr double kSamplesPerMove = 4;
// A part of the law below this share of Δout may have any sign.
constexpr double kMinor = 0.0005;

using Terms = std::array<double, kTerms>;
using Products = std::array<Terms, kTerms>;  // the upper triangle

void add_products(const Terms& x, Products& sums) {
  for (std::size_t k = 0; k < kTerms; ++k) {
    for (std::size_t j = k; j < kTerms; ++j) {
      sums[k][j] += x[k] * x[j];
    }
  }
}

// Gaussian elimination; each term is left with what those before it do not explain.
// Returns what each was before.
Terms eliminate(Products& sums) {
  Terms whole;
  for (std::size_t k = 0; k < kTerms; ++k) {
    whole[k] = sums[k][k];
  }
  for (std::size_t k = 0; k < kOut; ++k) {
    if (!(sums[k][k] > kDependent * whole[k])) {
      sums[k][k] = 0;
      continue;
    }
    for (std::size_t i = k + 1; i < kTerms; ++i) {
      const double share = sums[k][i] / sums[k][k];
      for (std::size_t j = i; j < kTerms; ++j) {
        sums[i][j] -= share * sums[k][j];
      }
    }
  }
  return whole;
}

struct Law {
  bool known = false;  // out moves, and is off its limits for half of the samples
  double r_squared = 0;
  bool agree = false;  // proportional and integral part act the same way
};

Law fit(std::span<const double> out, std::span<const double> in,
        std::span<const double> sp) {
  const auto [low, high] = std::minmax_element(out.begin(), out.end());
  const double margin = (*high - *low) * 1e-6;
  const double lowest = *low + margin;
  const double highest = *high - margin;
  const auto terms = [&](std::size_t t, Terms& x) {
    x = {0, 0, in[t] - in[0], in[t] - in[t - 1], out[t] - out[t - 1]};
    if (!sp.empty()) {
      x[0] = sp[t] - sp[t - 1];
      x[1] = sp[t] - sp[0];
    }
    return out[t] > lowest && out[t] < highest;
  };
  Terms x;
  Terms mean{};
  double count = 0;
  for (std::size_t t = 1; t < out.size(); ++t) {
    if (terms(t, x)) {
      count += 1;
      for (std::size_t k = 0; k < kTerms; ++k) {
        mean[k] += x[k];
      }
    }
  }
  Law law;
  if (2 * count < static_cast<double>(out.size())) {
    return law;
  }
  double moves = 0;
  Products sums{};
  for (std::size_t t = 1; t < out.size(); ++t) {
    if (terms(t, x)) {
      moves += x[kOut] != 0 ? 1 : 0;
      for (std::size_t k = 0; k < kTerms; ++k) {
        x[k] -= mean[k] / count;
      }
      add_products(x, sums);
    }
  }
  const Terms whole = eliminate(sums);
  const double total = whole[kOut];
  if (!(total > 0)) {
    return law;
  }
  const auto weight = [&](std::size_t k, double explained) {
    return sums[k][k] > 0 ? explained / sums[k][k] : 0.0;
  };
  const double proportional = weight(kProportional, sums[kProportional][kOut]);
  const double integral = weight(
      kIntegral, sums[kIntegral][kOut] - sums[kIntegral][kProportional] * proportional);
  const double minor = std::min(proportional * proportional * whole[kProportional],
                                integral * integral * whole[kIntegral]);
  law.known = kSamplesPerMove * moves >= count;
  law.r_squared = 1 - std::max(sums[kOut][kOut], 0.0) / total;
  law.agree = proportional * integral > 0 || minor < kMinor * total;
  return law;
}

}  // namespace

bool are_swapped(std::span<const double> u, std::span<const double> y,
                 std::span<const double> sp) {
  if (u.size() < kFewest) {
    return false;
  }
  const Law labelled = fit(u, y, sp);
  const Law exchanged = fit(y, u, sp);
  const double left = 1 - labelled.r_squared;
  return labelled.known && exchanged.known && exchanged.agree &&
         exchanged.r_squared > kExplained && left > kLeftAtLeast &&
         left > kTimesMoreLeft * (1 - exchanged.r_squared);
}

}  // namespace ident
