#include "workbench/serve/axis_times.hpp"

#include <array>
#include <cmath>
#include <ctime>
#include <optional>
#include <regex>

#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/recording/time_unit.hpp"
#include "workbench/recording/written_time.hpp"
#include "workbench/report/html_texts.hpp"

namespace workbench {
namespace {

constexpr int kDigits = 4;  // of the times in sentences

// The start of a recording in s since 1970, as the file writes it.
std::optional<double> clock_of(const std::string& start) {
  constexpr double kMinuteS = 60;
  const std::optional<WrittenTime> time = written_time(start);
  if (!time || time->kind != WrittenTime::Day::kKnown || !time->has_clock) {
    return std::nullopt;
  }
  return std::floor(time->since_1970_s() + kMinuteS * time->zone_min);
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
    const std::time_t at = std::llround(seconds);
    std::tm parts{};
    gmtime_r(&at, &parts);
    std::array<char, 32> text;
    std::strftime(text.data(), text.size(), to_the_second ? "%F %T" : "%F %R", &parts);
    constexpr std::size_t kDate = 11;
    return text.data() + (span_s_ >= kDayS ? 0 : kDate);
  }

  std::optional<double> clock_;
  double from_s_;
  double span_s_;
};

// "t between 437.2 and 1124 s", as failures are told; "t = 10 s", "t = 10 s to 20 s".
std::string with_times(std::string_view text, const Axis& axis) {
  static const std::string number = R"((-?\d+(?:\.\d+)?(?:e[-+]?\d+)?))";
  static const std::string seconds = number + R"( s(?=$|[ ,.):]))";
  static const std::regex times("t between " + number + " and " + seconds +
                                "|t = " + seconds + "(?: to " + seconds + ")?");
  std::string out;
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::cmatch found; std::regex_search(at, end, found, times);
       at = found.suffix().first) {
    const auto told = [&](std::size_t k) { return axis.text(std::stod(found[k])); };
    out += found.prefix();
    out += found[1].matched   ? filled("t between {0} and {1}", {told(1), told(2)})
           : found[4].matched ? "t = " + told(3) + " to " + told(4)
                              : "t = " + told(3);
  }
  return out.append(at, end);
}

}  // namespace

std::string with_axis_times(std::string_view html, const Recording& recording) {
  const Axis axis(recording);
  return with_texts(html,
                    [&axis](std::string_view text) { return with_times(text, axis); });
}

}  // namespace workbench
