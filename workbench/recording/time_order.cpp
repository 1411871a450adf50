#include "workbench/recording/time_order.hpp"

#include <algorithm>
#include <cmath>

#include "workbench/recording/statistics.hpp"

namespace workbench {
namespace {

constexpr double kHourS = 3600;
constexpr double kLatestChangeS = 4 * kHourS;  // of the day
constexpr double kSlack = 1.5;       // intervals that one across the change may last
constexpr double kMostJoinedS = 60;  // of real time across the step back, or 10 intervals

double typical_interval(const std::vector<double>& t) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < t.size(); ++i) {
    if (t[i] > t[i - 1]) steps.push_back(t[i] - t[i - 1]);
  }
  if (steps.empty()) return 0;
  return of_rank(steps, steps.size() / 2);
}

// Most clocks go ahead in the night to a Sunday.
bool is_sunday(std::int32_t day) {
  return (day + 4) % 7 == 0;  // 1 January 1970 was a Thursday
}

class DaylightSaving {
 public:
  DaylightSaving(TimesOfRows& times, TimeOrder& order) : times_(times), order_(order) {}

  void remove() {
    std::vector<double>& t = times_.t;
    const bool suspect = [&t] {
      for (std::size_t i = 1; i < t.size(); ++i) {
        if (t[i] < t[i - 1] || t[i] - t[i - 1] > kHourS) return true;
      }
      return false;
    }();
    if (!suspect) return;
    interval_ = typical_interval(t);
    double shift = 0;
    double before = t.front();
    for (std::size_t i = 1; i < t.size(); ++i) {
      const double written = t[i];
      shift += change(before, written);
      before = written;
      t[i] = written + shift;
    }
  }

 private:
  // Seconds to add from here on.
  double change(double before, double after) {
    const double step = after - before;
    if (step < 0 && step > -kHourS) {
      const double real = step + kHourS;
      if (real <= std::max(kMostJoinedS, 10 * interval_) && crosses(before, real, true)) {
        tell(before, "back", "later");
        return kHourS;
      }
    }
    if (step > kHourS && interval_ < kHourS / 2) {
      const double real = step - kHourS;
      if (real <= kSlack * interval_ && crosses(before, real, false)) {
        tell(before, "ahead", "earlier");
        return -kHourS;
      }
    }
    return 0;
  }

  // A full hour of the night. On any day for a step back, which no pause explains.
  [[nodiscard]] bool crosses(double before, double real, bool any_day) const {
    const ClockTime from = clock_time(times_, before);
    const ClockTime to = clock_time(times_, before + real);
    return (any_day || is_sunday(to.day)) && to.seconds < kLatestChangeS + kHourS &&
           (from.day != to.day ||
            std::floor(from.seconds / kHourS) != std::floor(to.seconds / kHourS));
  }

  void tell(double before, const char* way, const char* moved) {
    order_.notes.push_back(
        "after " + clock_text(times_, before) + " the clock goes an hour " + way +
        ": taken as daylight saving, the times behind it are an hour " + moved);
  }

  TimesOfRows& times_;
  TimeOrder& order_;
  double interval_ = 0;
};

}  // namespace

TimeOrder put_in_order(TimesOfRows& times) {
  TimeOrder order;
  std::vector<double>& t = times.t;
  std::size_t rising = 0;
  std::size_t falling = 0;
  for (std::size_t i = 1; i < t.size(); ++i) {
    if (t[i] > t[i - 1]) ++rising;
    if (t[i] < t[i - 1]) ++falling;
  }
  // One step against many is a change of daylight saving time.
  const bool local = times.dated && !times.zoned;
  if (falling >= 2 && (rising == 0 || (local && rising * 100 < falling))) {
    std::ranges::reverse(t);
    order.turned = true;
    order.notes.emplace_back("the newest row came first: turned");
  }
  if (local && t.size() > 1) DaylightSaving(times, order).remove();
  for (std::size_t i = 1; i < t.size(); ++i) {
    if (!(t[i] >= t[i - 1])) {
      order.step_back = i;
      break;
    }
  }
  return order;
}

}  // namespace workbench
