// Where the stick band of a loop goes to over weeks: slope, interval, days to a limit.
//
// Life: new → add, one value a window, in any order of days → find, at any time.
//
// The band of a day is the mean of its windows, that of a week the mean of its days. A
// line is laid through the weeks, each by its days, of the newest kWeeks; the interval is
// Student's, wider by (1+r)/(1−r) in variance where neighbouring weeks depend on each
// other, r corrected for the bias of few weeks. There is a trend when an interval of
// 99.8 % excludes zero, and did so kConfirmDays before: it is asked every day for years,
// and has to be silent where nothing wears.
//
// A value counts for its day as long as the day is in the ring; add() of a day that is
// kDays older than another is not used. Days without windows (outages, a healthy valve)
// have no part. No heap or clock. Memory: 2.2 KB. Cost: add constant, find some thousand
// operations.
#pragma once

#include <array>
#include <cstdint>

#include "wire/diagnostics.hpp"

namespace firmware {

struct Trend {
  bool fitted = false;  ///< false: too few weeks, nothing below means anything
  bool stands = false;  ///< there is a trend
  double slope = 0;     ///< % of span a day
  double low = 0;       ///< its 95 % interval
  double high = 0;
  double band_pct = 0;  ///< of the line, at the end
  /// Until the line reaches the limit, with the slope and its interval; NaN: not with it.
  double days = wire::kNotAvailable;
  double days_early = wire::kNotAvailable;
  double days_late = wire::kNotAvailable;
};

class BandTrend {
 public:
  static constexpr int kWeeks = 26;
  static constexpr int kDays = 7 * kWeeks;
  static constexpr int kFewestWeeks = 6;
  static constexpr int kConfirmDays = 14;

  /// `band_pct`, % of span, of a window that ended `epoch_s` seconds since the epoch.
  void add(std::int64_t epoch_s, double band_pct);
  /// The valve, or what is measured, is another one.
  void clear() { days_ = {}; }
  /// As of the day of `epoch_s`. `limit_pct`: the band that needs attention, % of span.
  [[nodiscard]] Trend find(std::int64_t epoch_s, double limit_pct) const;

 private:
  struct Day {
    std::int32_t day = -1;  // since the epoch; −1: none
    std::uint32_t windows = 0;
    float mean = 0;
  };
  [[nodiscard]] Trend fit(std::int32_t today) const;

  std::array<Day, kDays> days_;
};

}  // namespace firmware
