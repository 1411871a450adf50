#include "ident/signal/range_end.hpp"

#include <algorithm>
#include <cmath>

namespace ident {
namespace {

constexpr std::size_t kShortest = 3;   // readings of a stay, and beside it
constexpr std::size_t kFewest = 3;     // stays
constexpr double kLong = 6;            // readings of a stay that noise does not make
constexpr double kLeastShare = 0.02;   // of the samples
constexpr double kBand = 0.002;        // of the range, or one step of the resolution
constexpr double kWide = 16;           // bands
constexpr double kOfAPeak = 0.25;      // of the wide band's samples, in the narrow one
constexpr double kDependent = 3;       // samples that count as one
constexpr double kDeviations = 4;      // of the binomial distribution
constexpr double kLeastBetween = 0.1;  // of the samples, between the ends
constexpr double kMostRests = 0.5;     // of those between the ends
constexpr double kHardlyRests = 0.1;
constexpr double kTurnsByNoise = 0.2;
constexpr double kSlower = 5;  // at most, in than out and out than in

// Depths below the end of the range: 0 there.
class Depths {
 public:
  Depths(std::span<const double> y, bool upper) : y_(y), sign_(upper ? -1 : 1) {
    const auto [low, high] = std::ranges::minmax_element(y);
    end_ = upper ? *high : *low;
    range_ = *high - *low;
    step_ = range_;
    for (std::size_t k = 1; k < y.size(); ++k) {
      const double move = std::abs(y[k] - y[k - 1]);
      if (move > kRounding * range_) step_ = std::min(step_, move);
    }
  }
  [[nodiscard]] double operator[](std::size_t k) const { return sign_ * (y_[k] - end_); }
  [[nodiscard]] bool at_end(std::size_t k) const {
    return k < y_.size() && (*this)[k] <= kRounding * range_;
  }
  [[nodiscard]] std::size_t size() const { return y_.size(); }
  [[nodiscard]] double end() const { return end_; }
  [[nodiscard]] double range() const { return range_; }
  [[nodiscard]] double band() const { return std::max(kBand * range_, step_); }

 private:
  static constexpr double kRounding = 1e-6;
  std::span<const double> y_;
  double sign_;
  double end_ = 0;
  double range_ = 0;
  double step_ = 0;  // smallest move
};

// Whether more samples are in the narrow band at the end than a peak leaves there.
bool is_crowded(const Depths& depths) {
  constexpr double kBelowTheNext = 0.999;  // of a step
  double narrow = 0;
  double wide = 0;
  for (std::size_t k = 0; k < depths.size(); ++k) {
    narrow += depths[k] < kBelowTheNext * depths.band() ? 1 : 0;
    wide += depths[k] <= kWide * depths.band() ? 1 : 0;
  }
  const double trials = wide / kDependent;
  return narrow / kDependent - kOfAPeak * trials >
         kDeviations * std::sqrt(kOfAPeak * (1 - kOfAPeak) * trials);
}

// How y moves off its ends, shares of the samples there.
struct Between {
  double samples = 0;
  double rests = 0;
  double turns = 0;
  // No switch, no stairs.
  [[nodiscard]] bool moves(std::size_t of) const {
    return samples >= kLeastBetween * static_cast<double>(of) && rests <= kMostRests;
  }
  // So that not even what settles would repeat a reading.
  [[nodiscard]] bool is_noisy() const {
    return rests <= kHardlyRests && turns >= kTurnsByNoise;
  }
};

Between between_ends(const Depths& depths) {
  const auto is_between = [&](std::size_t k) {
    return depths[k] > depths.band() && depths[k] < depths.range() - depths.band();
  };
  Between out;
  double before = 0;
  for (std::size_t k = 1; k < depths.size(); ++k) {
    if (!is_between(k - 1) || !is_between(k)) continue;
    const double move = depths[k] - depths[k - 1];
    ++out.samples;
    out.rests += move == 0 ? 1 : 0;
    out.turns += move * before < 0 ? 1 : 0;
    before = move;
  }
  out.rests /= std::max(out.samples, 1.0);
  out.turns /= std::max(out.samples, 1.0);
  return out;
}

// The stays at the end, and how y comes to them and goes.
struct Stays {
  std::size_t count = 0;
  double samples = 0;
  double longest = 0;
  double before = 0;  // depths of the samples beside them, summed
  double after = 0;
  void take(const Depths& depths, std::size_t first, std::size_t last) {
    const double length = static_cast<double>(last - first);
    ++count;
    samples += length;
    longest = std::max(longest, length);
    if (first < kShortest || last + kShortest > depths.size()) return;
    for (std::size_t i = 0; i < kShortest; ++i) {
      before += depths[first - 1 - i];
      after += depths[last + i];
    }
  }
  [[nodiscard]] bool settles() const {
    return before * kSlower < after || after * kSlower < before;
  }
};

Stays stays_at_end(const Depths& depths) {
  Stays out;
  std::size_t length = 0;
  for (std::size_t k = 0; k <= depths.size(); ++k) {
    if (depths.at_end(k)) {
      ++length;
      continue;
    }
    if (length >= kShortest) out.take(depths, k - length, k);
    length = 0;
  }
  return out;
}

}  // namespace

RangeEnd find_range_end(std::span<const double> y, bool upper) {
  if (y.empty()) return {};
  const Depths depths(y, upper);
  const Between between = between_ends(depths);
  if (!(depths.range() > 0) || !between.moves(y.size()) || !is_crowded(depths)) return {};
  const Stays stays = stays_at_end(depths);
  const double share = stays.samples / static_cast<double>(y.size());
  const bool is_cut = share >= kLeastShare &&
                      (between.is_noisy() ? stays.longest >= kLong
                                          : stays.count >= kFewest && !stays.settles());
  return is_cut ? RangeEnd{depths.end(), stays.count, share} : RangeEnd{};
}

}  // namespace ident
