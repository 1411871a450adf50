#include "workbench/serve/axis_times.hpp"

#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>

#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/recording/time_unit.hpp"
#include "workbench/serve/html_texts.hpp"

namespace workbench {
namespace {

constexpr int kDigits = 4;  // of the times in sentences

// The start of a recording in s since 1970, as the file writes it.
std::optional<double> clock_of(const std::string& start) {
  int year = 0, month = 0, day = 0, hour = 0, minute = 0, second = 0;
  if (std::sscanf(start.c_str(), "%d-%d-%dT%d:%d:%d", &year, &month, &day, &hour, &minute,
                  &second) < 5) {
    return std::nullopt;
  }
  const std::chrono::sys_days date =
      std::chrono::year(year) / static_cast<unsigned>(month) / static_cast<unsigned>(day);
  return static_cast<double>(date.time_since_epoch().count()) * kDayS + hour * kHourS +
         minute * 60 + second;
}

class Axis {
 public:
  explicit Axis(const Recording& recording)
      : clock_(clock_of(recording.start)),
        from_s_(recording.t.front()),
        span_s_(recording.t.back() - recording.t.front()) {}

  [[nodiscard]] std::string text(double t) const {
    if (clock_) return clock_text(*clock_ + t - from_s_, std::abs(t - from_s_) < 1e4);
    const auto [size, unit] = span_s_ < 600          ? std::pair(1.0, " s")
                              : span_s_ < 6 * kHourS ? std::pair(60.0, " min")
                              : span_s_ < 4 * kDayS  ? std::pair(kHourS, " h")
                                                     : std::pair(kDayS, " d");
    return number(t / size, kDigits) + unit;
  }

 private:
  [[nodiscard]] std::string clock_text(double seconds, bool to_the_second) const {
    using namespace std::chrono;
    const sys_seconds at(std::chrono::seconds(std::llround(seconds)));
    const sys_days midnight = floor<days>(at);
    const year_month_day date(midnight);
    const hh_mm_ss time(at - midnight);
    char text[32];
    std::string out;
    if (span_s_ >= kDayS) {
      std::snprintf(text, sizeof text, "%04d-%02u-%02u ", static_cast<int>(date.year()),
                    static_cast<unsigned>(date.month()),
                    static_cast<unsigned>(date.day()));
      out += text;
    }
    std::snprintf(text, sizeof text, "%02d:%02d", static_cast<int>(time.hours().count()),
                  static_cast<int>(time.minutes().count()));
    out += text;
    if (to_the_second) {
      std::snprintf(text, sizeof text, ":%02d", static_cast<int>(time.seconds().count()));
      out += text;
    }
    return out;
  }

  std::optional<double> clock_;
  double from_s_;
  double span_s_;
};

// Takes "12.5 s" off the front; nothing where it is something else.
std::optional<double> take_seconds(std::string_view& text) {
  double value = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return std::nullopt;
  const std::string_view rest = text.substr(static_cast<std::size_t>(end - text.data()));
  const bool seconds =
      rest.starts_with(" s") && (rest.size() == 2 || rest[2] == ' ' || rest[2] == ',' ||
                                 rest[2] == '.' || rest[2] == ')' || rest[2] == ':');
  if (!seconds) return std::nullopt;
  text = rest.substr(2);
  return value;
}

// "t between 437.2 and 1124 s", as failures are told.
std::string with_stretches(std::string_view text, const Axis& axis) {
  constexpr std::string_view kBegin = "t between ";
  constexpr std::string_view kAnd = " and ";
  std::string out;
  while (true) {
    const std::size_t at = text.find(kBegin);
    if (at == std::string_view::npos) return out + std::string(text);
    out += text.substr(0, at);
    text.remove_prefix(at);
    std::string_view rest = text.substr(kBegin.size());
    double from = 0;
    const auto [end, error] =
        std::from_chars(rest.data(), rest.data() + rest.size(), from);
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    std::optional<double> to;
    if (error == std::errc() && rest.starts_with(kAnd)) {
      rest.remove_prefix(kAnd.size());
      to = take_seconds(rest);
    }
    if (to) {
      out += filled("t between {0} and {1}", {axis.text(from), axis.text(*to)});
      text = rest;
    } else {
      out += text.substr(0, kBegin.size());
      text.remove_prefix(kBegin.size());
    }
  }
}

std::string with_times(std::string_view text, const Axis& axis) {
  constexpr std::string_view kBegin = "t = ";
  constexpr std::string_view kTo = " to ";
  std::string out;
  while (true) {
    const std::size_t at = text.find(kBegin);
    if (at == std::string_view::npos) return out + std::string(text);
    out += text.substr(0, at + kBegin.size());
    text.remove_prefix(at + kBegin.size());
    const auto from = take_seconds(text);
    if (!from) continue;
    out += axis.text(*from);
    if (!text.starts_with(kTo)) continue;
    std::string_view rest = text.substr(kTo.size());
    if (const auto to = take_seconds(rest)) {
      out += std::string(kTo) + axis.text(*to);
      text = rest;
    }
  }
}

}  // namespace

std::string with_axis_times(std::string_view html, const Recording& recording) {
  const Axis axis(recording);
  return with_texts(html, [&axis](std::string_view text) {
    return with_times(with_stretches(text, axis), axis);
  });
}

}  // namespace workbench
