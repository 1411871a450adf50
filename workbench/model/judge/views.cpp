#include "workbench/model/judge/views.hpp"

#include <algorithm>
#include <cmath>

#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

struct Turn {
  std::size_t at = 0;
  bool lower = true;  // u rises from here on
};

// Turning points of u: extremes after which it retreats by more than `threshold`, the
// last sample of those that it rests at: what y does there answers the move before.
std::vector<Turn> turns_of(std::span<const double> u, double threshold) {
  std::vector<Turn> turns;
  int direction = 0;
  std::size_t high = 0;
  std::size_t low = 0;
  for (std::size_t k = 0; k < u.size(); ++k) {
    if (u[k] >= u[high]) high = k;
    if (u[k] <= u[low]) low = k;
    if (direction >= 0 && u[high] - u[k] > threshold) {
      turns.push_back({high, false});
      direction = -1;
      low = k;
    } else if (direction <= 0 && u[k] - u[low] > threshold) {
      turns.push_back({low, true});
      direction = 1;
      high = k;
    }
  }
  return turns;
}

// Equal bins over [low, high].
Binning equal_bins(View view, std::string coordinate, std::span<const double> values,
                   double low, double high, int count) {
  Binning out;
  out.view = view;
  out.coordinate = std::move(coordinate);
  const double width = (high - low) / count;
  for (int i = 0; i < count; ++i) out.position.push_back(low + (i + 0.5) * width);
  for (const double value : values) {
    const bool inside = std::isfinite(value) && width > 0;
    out.bin.push_back(
        inside ? std::clamp(static_cast<int>((value - low) / width), 0, count - 1) : -1);
  }
  return out;
}

constexpr double kNowhere = NAN;

}  // namespace

std::vector<Binning> binnings_of(const Situation& s, std::span<const double> t,
                                 const Work& work) {
  const std::size_t n = s.samples();
  const std::vector<Turn> turns = turns_of(s.u, s.u_span() / 10);
  std::vector<double> time(t.begin(), t.end());
  std::vector<double> phase(n, kNowhere);
  std::vector<double> travel(n, kNowhere);
  std::vector<double> direction(n, kNowhere);
  std::vector<double> speed(n, kNowhere);
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const std::size_t end = i + 1 < turns.size() ? turns[i + 1].at : n;
    const auto length = static_cast<double>(std::max<std::size_t>(end - turns[i].at, 1));
    for (std::size_t k = turns[i].at; k < end; ++k) {
      const double part = static_cast<double>(k - turns[i].at) / length;
      if (i + 1 < turns.size()) phase[k] = 0.5 * part + (turns[i].lower ? 0 : 0.5);
      travel[k] = s.u[k] - s.u[turns[i].at];
      direction[k] = turns[i].lower ? 1 : -1;
    }
  }
  // Speed over a few samples, so that noise in u does not count as motion.
  const std::size_t reach = 2;
  double fastest = 0;
  for (std::size_t k = reach; k + reach < n; ++k) {
    speed[k] =
        (s.u[k + reach] - s.u[k - reach]) / (2 * static_cast<double>(reach) * s.period_s);
    fastest = std::max(fastest, std::abs(speed[k]));
  }
  std::vector<Binning> out;
  const auto add = [&](View view, const char* coordinate, std::span<const double> values,
                       double low, double high, int count) {
    work.check();
    out.push_back(equal_bins(view, coordinate, values, low, high, count));
  };
  add(View::kTime, "t, s", time, t.front(), t.back(), 24);
  add(View::kPhase, "phase of the cycle of u", phase, 0, 1, 16);
  out.back().ring = true;
  add(View::kLevel, "u", s.u, s.u_low, s.u_high, 14);
  add(View::kDirection, "direction of u", direction, -1.5, 1.5, 3);
  add(View::kSpeed, "speed of u, u/s", speed, -fastest, fastest, 15);
  const double most = s.u_span();
  add(View::kTravel, "travel of u since its last reversal, u", travel, -most, most, 24);
  return out;
}

std::string place_in_words(const Binning& b, std::size_t first, std::size_t last) {
  const double width = b.position.size() > 1 ? b.position[1] - b.position[0] : 0;
  const double low = b.position[first] - width / 2;
  const double high = b.position[last] + width / 2;
  const auto between = [&](std::string_view sentence, double from, double to) {
    return filled(sentence, {number(from, 4), number(to, 4)});
  };
  switch (b.view) {
    case View::kTime:
      return between("t between {0} and {1} s", low, high);
    case View::kPhase:
      return between(
          "phase between {0} and {1} of the cycle (0: u turns up, 0.5: u turns down)",
          low, high);
    case View::kLevel:
      return between("u between {0} and {1}", low, high);
    case View::kDirection:
      return b.position[first] > 0 ? "rising u" : "falling u";
    case View::kSpeed:
      return between("speed of u between {0} and {1} u/s", low, high);
    case View::kTravel:
      if (low >= -width / 2) {
        return low <= width / 2
                   ? filled("the first {0} of u after an ascending reversal",
                            {number(high, 3)})
                   : between(
                         "travel of u between {0} and {1} after an ascending reversal",
                         low, high);
      }
      if (high <= width / 2) {
        return high >= -width / 2
                   ? filled("the first {0} of u after a descending reversal",
                            {number(-low, 3)})
                   : between(
                         "travel of u between {0} and {1} after a descending reversal",
                         -high, -low);
      }
      return between("travel of u between {0} and {1} around its reversals", low, high);
    case View::kFrequency:
      return between("periods between {0} and {1} s", low, high);
    case View::kLag:
      return between("lags between {0} and {1} s behind u", low, high);
  }
  return {};
}

}  // namespace workbench
