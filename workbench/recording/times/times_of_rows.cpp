#include "workbench/recording/times/times_of_rows.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "workbench/recording/statistics.hpp"
#include "workbench/recording/time_unit.hpp"

namespace workbench {
namespace {

std::chrono::year_month_day date_of(std::int32_t day) {
  return std::chrono::sys_days(std::chrono::days(day));
}

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

std::string date_text(std::int32_t day) {
  constexpr std::array<const char*, 12> kNames = {
      "January", "February", "March",     "April",   "May",      "June",
      "July",    "August",   "September", "October", "November", "December"};
  const std::chrono::year_month_day date = date_of(day);
  return std::to_string(static_cast<unsigned>(date.day())) + ' ' +
         kNames[static_cast<unsigned>(date.month()) - 1] + ' ' +
         std::to_string(static_cast<int>(date.year()));
}

TimesOfRows::Doubt doubt_of_zones(const std::string& a, const std::string& b) {
  return {"times of one zone, or of zones with one meaning", a + " beside " + b,
          "export the times in one zone, or with offsets, as 14:30:00+08:00"};
}

TimesOfRows::Doubt doubt_of_days(const std::string& found) {
  return {"times with one meaning", found,
          "say which after the name: --time \"NAME [s]\" or --time \"NAME [d]\""};
}

TimesOfRows::Doubt doubt_of_clock(const std::string& found) {
  return {"times with one meaning", found,
          "say after the name whether the last two are seconds or minutes: --time "
          "\"NAME [s]\" or --time \"NAME [min]\""};
}

ClockTime clock_time(const TimesOfRows& times, double t) {
  const double seconds = times.origin_seconds + t;
  const double days = std::floor(seconds / kDayS);
  return {times.origin_day + static_cast<std::int32_t>(days), seconds - days * kDayS};
}

std::string clock_text(const TimesOfRows& times, double t) {
  if (!times.dated) return {};
  const double to_ms = std::round((t + 60.0 * times.zone_min) * 1e3) / 1e3;
  const ClockTime at = clock_time(times, to_ms);
  const std::chrono::year_month_day date = date_of(at.day);
  const auto ms = static_cast<int>(std::min(std::round(at.seconds * 1e3), 86399999.0));
  const int whole = ms / 1000;
  std::array<char, 80> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02u-%02uT%02d:%02d:%02d",
                static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                static_cast<unsigned>(date.day()), whole / 3600, whole / 60 % 60,
                whole % 60);
  std::string out = text.data();
  if (ms % 1000 > 0) {
    std::snprintf(text.data(), text.size(), ".%03d", ms % 1000);
    out += text.data();
  }
  if (times.zoned) {
    out += times.zone_min == 0 ? "Z" : zone_text({times.zone_min, nullptr});
  }
  return out;
}

std::string zone_written(const TimesOfRows& times) {
  if (!times.dated) return {};
  if (!times.zoned) return times.zone_word;
  return times.open_zone != nullptr ? std::string(times.open_zone->name)
                                    : zone_text(times.zone());
}

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
