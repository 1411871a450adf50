#include <algorithm>
#include <cmath>
#include <vector>

#include "ident/signal/differences.hpp"
#include "ident/signal/storage.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::effects {
namespace {

constexpr double kFarOff = 8;           // of what neighbours usually differ by
constexpr std::size_t kWidest = 2;      // readings in a row that are one spike
constexpr double kMostOf = 0.03;        // of the samples; more are no exceptions
constexpr double kWideGap = 4;          // between spikes and whatever is next in height
constexpr double kMattering = 0.02;     // of the squared residual
constexpr std::size_t kTimesNamed = 5;  // in the sentence

// How far `signal` is off both neighbours of the `width` readings from `k` on, on the
// same side of both; 0 where it is not, and where it turns: there the readings go on from
// where the two before them came, and to where the two behind them go.
double excursion(std::span<const double> signal, std::size_t k, std::size_t width) {
  if (k == 0 || k + width >= signal.size()) return 0;
  const std::size_t next = k + width;
  const double before = signal[k - 1];
  const double after = signal[next];
  double up = 1e300;
  double down = 1e300;
  for (std::size_t i = k; i < next; ++i) {
    up = std::min(up, signal[i] - std::max(before, after));
    down = std::min(down, std::min(before, after) - signal[i]);
  }
  const double height = std::max({up, down, 0.0});
  const double way = up > down ? 1 : -1;
  const double came = k > 1 ? before - signal[k - 2] : 0;
  const double goes = next + 1 < signal.size() ? signal[next + 1] - after : 0;
  const bool turns = 2 * way * (signal[k] - before - came) < height ||
                     2 * way * (signal[next - 1] - after + goes) < height;
  return !turns && 2 * std::abs(after - before) <= height ? height : 0;
}

template <class Found>
void for_each_spike_in(std::span<const double> signal, double least, const Found& found) {
  for (std::size_t k = 1; k + 1 < signal.size(); ++k) {
    // No spike is higher than its first reading is off the one before.
    if (std::abs(signal[k] - signal[k - 1]) < least) continue;
    for (std::size_t width = 1; width <= kWidest; ++width) {
      const double height = excursion(signal, k, width);
      if (!(height >= least)) continue;
      found(k, width, height);
      k += width;
      break;
    }
  }
}

// Calls `found(first, width, height)` for each spike of y at least `least` high. Across a
// gap nothing is back at once.
template <class Found>
void for_each_spike(const Situation& s, double least, const Found& found) {
  Piece whole;
  whole.last = s.samples();
  for (const Piece& piece : s.pieces.empty() ? std::span(&whole, 1) : s.pieces) {
    for_each_spike_in(s.y.subspan(piece.first, piece.last - piece.first), least,
                      [&](std::size_t k, std::size_t width, double height) {
                        found(piece.first + k, width, height);
                      });
  }
}

// What a reading that differs at all usually differs by from the mean of its neighbours;
// of a record in straight lines, what a stored one does.
double usual_difference(std::span<const double> signal) {
  constexpr double kToDeviation = 1.4826;
  const bool in_lines =
      ident::find_storage(signal).storage == ident::Storage::kInterpolated;
  const double none = in_lines ? ident::measure_differences(signal).straight / 2 : 0;
  std::vector<double> off;
  for (std::size_t k = 1; k + 1 < signal.size(); ++k) {
    const double distance = std::abs(signal[k] - (signal[k - 1] + signal[k + 1]) / 2);
    if (distance > none) off.push_back(distance);
  }
  return off.empty() ? 0 : kToDeviation * quantile(off, 0.5);
}

// Far off what is usual from one sample to the next.
double least_spike(std::span<const double> signal) {
  return std::max(kFarOff * usual_difference(signal), 2 * lattice_of(signal).step);
}

// What is seen beside the range of the signal.
double seen_spike(std::span<const double> signal) {
  constexpr double kSeen = 0.1;
  return kSeen * (quantile(signal, 0.95) - quantile(signal, 0.05));
}

// Heights of the spikes from `least` on, the highest first.
std::vector<double> heights_of(const Situation& s, double least) {
  std::vector<double> heights;
  for_each_spike(s, least, [&](std::size_t, std::size_t, double height) {
    heights.push_back(height);
  });
  std::sort(heights.rbegin(), heights.rend());
  return heights;
}

double next_of(const std::vector<double>& heights, std::size_t i) {
  return i + 1 < heights.size() ? heights[i + 1] : 0;
}

// Height of the lowest spike of those that are at least `least` high; 0: there is none.
// A heavy tail reaches from near to far; spikes stand apart.
double lowest_seen(const Situation& s, double least) {
  const std::vector<double> heights = heights_of(s, least / 2);
  double lowest = 0;
  for (std::size_t i = 0; i < heights.size() && heights[i] >= least; ++i) {
    const double next = next_of(heights, i);
    const bool apart = next < heights[i] / kWideGap;
    const bool few_below = next < least && 3 * (i + 1) > 2 * heights.size();
    if (apart || few_below) lowest = heights[i];
  }
  return lowest;
}

// The same of spikes that the range of the signal hides: nothing may lie between them and
// what is usual. Of a record that was compressed nobody knows what is usual.
double lowest_hidden(const Situation& s, double least) {
  if (ident::find_storage(s.y).storage != ident::Storage::kEverySample) {
    return 0;
  }
  const std::vector<double> heights = heights_of(s, least / kWideGap);
  double lowest = 0;
  for (std::size_t i = 0; i < heights.size() && heights[i] >= least; ++i) {
    if (next_of(heights, i) < heights[i] / kWideGap) lowest = heights[i];
  }
  return lowest;
}

constexpr Description kDescription{
    .code = "sensor.spikes",
    .title = "single readings far off",
    .place = Place::kRecord,
    .view = View::kTime,
    .signature = "is large in single samples and small on either side of them",
    .cure =
        "Look for loose contacts, radio, earth loops, air bubbles at the sensor or "
        "telegrams that were lost; leave these readings out.",
    .split = "record with a second sensor: only one of them has the spike",
    .needs_u = false,
    .least_share = -0.005,
};

class Spikes final : public Effect {
 public:
  Spikes() : Effect(kDescription) {}
  [[nodiscard]] SearchedParameters searched(const Situation& s) const override {
    return {{.name = "readings",
             .unit = "1",
             .high = static_cast<double>(s.samples()),
             .constant = true,
             .off = 0.0},
            {.name = "least_height",
             .unit = "y",
             .high = std::max(s.y_span(), 1e-12),
             .constant = true}};
  }
  [[nodiscard]] std::vector<Values> starts(const Situation& s) const override {
    const double least = least_spike(s.y);
    if (!(least > 0) || least > s.y_span()) return {};
    double lowest = lowest_seen(s, std::max(least, seen_spike(s.y)));
    if (lowest == 0) lowest = lowest_hidden(s, least);
    if (lowest == 0) return {};
    double readings = 0;
    for_each_spike(s, lowest * (1 - 1e-9), [&](std::size_t, std::size_t width, double) {
      readings += static_cast<double>(width);
    });
    if (readings > kMostOf * static_cast<double>(s.samples())) return {};
    return {{readings, lowest}};
  }
  [[nodiscard]] Excitation excitation(const Situation&, Reals p) const override {
    return {static_cast<int>(p[0]), "readings far off both neighbours", 1};
  }
  [[nodiscard]] std::string evidence(const Situation& s, Reals p, Reals) const override {
    std::string times;
    std::size_t count = 0;
    for_each_spike(s, lower(p), [&](std::size_t k, std::size_t, double) {
      if (count++ >= kTimesNamed) return;
      times +=
          (times.empty() ? "" : ", ") + s.when(static_cast<double>(k) * s.period_s, 6);
    });
    if (count > kTimesNamed) {
      times = filled("{0} and {1} more", {times, std::to_string(count - kTimesNamed)});
    }
    return filled(p[0] == 1
                      ? "The output leaves for {0} reading in all, by {1} y or more, "
                        "and is back at once (t = {2})."
                      : "The output leaves for {0} readings in all, by {1} y or more, "
                        "and is back at once (t = {2}).",
                  {number(p[0], 6), number(p[1], 3), times}) +
           " They are left out of the fit.";
  }
  // A process that is fast enough passes on what u does in a single sample.
  [[nodiscard]] std::string objection(const Situation& s, Reals p, Reals) const override {
    const double least = kFarOff / 2 * usual_difference(s.u);
    int all = 0;
    int led = 0;
    for_each_spike(s, lower(p), [&](std::size_t k, std::size_t width, double) {
      ++all;
      led += least > 0 && excursion(s.u, k - 1, width) >= least;
    });
    return 3 * led > all ? "u leaves in the same way one sample before" : "";
  }
  [[nodiscard]] std::optional<double> own_test(const Situation& s,
                                               Reals p) const override {
    double power = 0;
    for_each_spike(s, lower(p), [&](std::size_t, std::size_t width, double height) {
      power += static_cast<double>(width) * height * height;
    });
    const double left =
        s.residual_std * s.residual_std * static_cast<double>(s.samples());
    if (power < kMattering * left) return 1;
    return 1e-12;  // a chance of 8 standard deviations, among any number of samples
  }
  // Left out: nothing is to be explained there.
  void record(Reals p, const Situation& s, std::span<double> y) const override {
    for_each_reading(p, s, [&](std::size_t i) { y[i] = s.y[i]; });
  }
  bool record_part(Reals p, const Situation& s, std::span<double> part) const override {
    for_each_reading(p, s, [&](std::size_t i) { part[i] = 0; });
    return true;
  }

 private:
  // The lowest of them counts, whatever rounding makes of its height.
  static double lower(Reals p) { return p[1] * (1 - 1e-9); }

  template <class Found>
  static void for_each_reading(Reals p, const Situation& s, const Found& found) {
    for_each_spike(s, lower(p), [&](std::size_t k, std::size_t width, double) {
      for (std::size_t i = k; i < k + width; ++i) found(i);
    });
  }
};

}  // namespace

const Effect& sensor_spikes() {
  static const Spikes effect;
  return effect;
}

}  // namespace workbench::effects
