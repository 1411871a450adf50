#include "workbench/recording/output_limit.hpp"

#include <algorithm>
#include <cmath>

namespace workbench {
namespace {

constexpr double kAtTheEnd = 1e-3;     // of the span
constexpr double kSame = 1e-6;         // of the span
constexpr std::size_t kShortest = 3;   // samples of a stay
constexpr std::size_t kFewest = 3;     // stays
constexpr double kLeastShare = 0.05;   // of all samples, in stays
constexpr double kLeastBetween = 0.1;  // of all samples, between the ends
constexpr double kMostRests = 0.5;     // of the samples between the ends

// True where u, between its ends, moves from sample to sample.
bool moves_between(std::span<const double> u, double low, double high) {
  const double span = high - low;
  const auto between = [&](double value) {
    return value > low + kAtTheEnd * span && value < high - kAtTheEnd * span;
  };
  std::size_t count = 0;
  std::size_t rests = 0;
  for (std::size_t k = 1; k < u.size(); ++k) {
    if (!between(u[k]) || !between(u[k - 1])) continue;
    ++count;
    rests += std::abs(u[k] - u[k - 1]) <= kSame * span;
  }
  return static_cast<double>(count) >= kLeastBetween * static_cast<double>(u.size()) &&
         static_cast<double>(rests) <= kMostRests * static_cast<double>(count);
}

OutputLimit limit_at(std::span<const double> u, double level, double span, bool upper) {
  OutputLimit limit{level, upper, 0, 0};
  std::size_t inside = 0;
  std::size_t length = 0;
  for (std::size_t k = 0; k <= u.size(); ++k) {
    if (k < u.size() && std::abs(u[k] - level) <= kAtTheEnd * span) {
      ++length;
      continue;
    }
    if (length >= kShortest) {
      ++limit.stays;
      inside += length;
    }
    length = 0;
  }
  limit.share = static_cast<double>(inside) / static_cast<double>(u.size());
  return limit;
}

}  // namespace

std::vector<OutputLimit> limits_of_output(std::span<const double> u) {
  if (u.empty()) return {};
  const auto [low, high] = std::ranges::minmax_element(u);
  const double span = *high - *low;
  if (!(span > 0) || !moves_between(u, *low, *high)) return {};
  std::vector<OutputLimit> out = {limit_at(u, *low, span, false),
                                  limit_at(u, *high, span, true)};
  std::erase_if(out, [](const OutputLimit& limit) {
    return limit.stays < kFewest || limit.share < kLeastShare;
  });
  return out;
}

}  // namespace workbench
