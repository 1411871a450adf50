#include "workbench/model/judge/without_beginning.hpp"

#include <algorithm>
#include <cmath>

#include "workbench/model/base/least_squares.hpp"
#include "workbench/model/base/noise.hpp"

namespace workbench {
namespace {

constexpr std::size_t kFewest = 5;   // samples that are a beginning
constexpr std::size_t kShares = 20;  // of a piece, of which the beginning is one

std::span<const double> within(std::span<const double> values, const SampleRange& range) {
  return values.subspan(range.first, range.last - range.first);
}

bool is_in(std::size_t sample, std::span<const SampleRange> ranges) {
  return std::any_of(ranges.begin(), ranges.end(), [sample](const SampleRange& range) {
    return sample >= range.first && sample < range.last;
  });
}

}  // namespace

std::vector<SampleRange> beginnings(std::span<const Piece> pieces, const Blocks& blocks) {
  const std::vector<unsigned char>& fitted = blocks.estimation();
  std::vector<SampleRange> out;
  const auto add = [&](std::size_t first, std::size_t last) {
    const std::size_t wanted = std::max(kFewest, (last - first) / kShares);
    std::size_t count = 0;
    std::size_t end = first;
    while (end < last && count < wanted) count += fitted[end++];
    out.push_back({first, end});
  };
  if (pieces.empty()) add(0, fitted.size());
  for (const Piece& piece : pieces) add(piece.first, piece.last);
  return out;
}

WithoutBeginning::WithoutBeginning(const std::vector<std::vector<double>>& jacobian,
                                   std::span<const double> residual, const Blocks& blocks,
                                   std::span<const SampleRange> begun)
    : moved(jacobian.size()), variance(jacobian.size(), 1.0) {
  const std::size_t n = jacobian.size();
  std::vector<double> all(n * n);
  std::vector<double> rest(n * n);
  std::vector<double> pull(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const double whole = dot(jacobian[i], jacobian[j]);
      double left = whole;
      for (const SampleRange& range : begun) {
        left -= dot(within(jacobian[i], range), within(jacobian[j], range));
      }
      all[i * n + j] = all[j * n + i] = whole;
      rest[i * n + j] = rest[j * n + i] = left;
    }
    for (const SampleRange& range : begun) {
      pull[i] += dot(within(jacobian[i], range), within(residual, range));
    }
  }
  double count = 0;  // of the fitted samples behind the beginnings, and their error
  double error = 0;
  double whole_error = 0;
  for (std::size_t k = 0; k < residual.size(); ++k) {
    if (!blocks.estimation()[k]) continue;
    const double square = residual[k] * residual[k];
    whole_error += square;
    if (is_in(k, begun)) continue;
    ++count;
    error += square;
  }
  all = inverse_spd(std::move(all), n);
  rest = inverse_spd(std::move(rest), n);
  for (std::size_t i = 0; i < n; ++i) {
    const double whole = all[i * n + i];
    const double left = rest[i * n + i];
    if (!(whole > 0) || !(left > 0)) continue;  // nothing tells it, or nothing else does
    variance[i] = std::max(1.0, left / whole);
    for (std::size_t j = 0; j < n; ++j) moved[i] += rest[i * n + j] * pull[j];
  }
  for (std::size_t i = 0; i < n; ++i) error -= pull[i] * moved[i];
  const auto samples = static_cast<double>(blocks.estimation_samples());
  if (whole_error > 0 && count > 0) {
    noise = std::max(error, 0.0) / count * samples / whole_error;
  }
}

double WithoutBeginning::minding(double width, std::size_t i) const {
  constexpr double kSurely = 3;
  const double by_chance = width / kNormal95 * std::sqrt((variance[i] - 1) * noise);
  const double away = std::abs(moved[i]);
  return away > std::max(width, kSurely * by_chance) ? width + away : width;
}

}  // namespace workbench
