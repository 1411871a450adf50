#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <string>

#include "support/gateway/sample_status.hpp"
#include "wire/history_csv.hpp"

namespace wire {
namespace {

std::string line_of(const HistoryRow& row) {
  std::array<char, kMostHistoryLine> line;
  return {line.data(), write_history_line(row, line)};
}

TEST(HistoryCsv, WritesWhatIsKnown) {
  HistoryRow row = history_row(support::sticking_loop());
  row.time_s = 1'763'857'000;
  row.evidence_nats = -0.25;
  EXPECT_EQ(
      line_of(row),
      "2025-11-23T00:16:40Z,stiction,1,5.01,4.80,5.20,4.98,4.75,5.15,0.63,-0.3,97.5,"
      "140.3\n");
  const std::string header(history_csv_header());
  const std::string line = line_of(row);
  EXPECT_EQ(std::count(line.begin(), line.end(), ','),
            std::count(header.begin(), header.end(), ','));
}

TEST(HistoryCsv, LeavesOutWhatIsNot) {
  HistoryRow row;
  EXPECT_EQ(line_of(row), "1970-01-01T00:00:00Z,restart,0,,,,,,,,,,\n");
  row.verdict = LoopVerdict::kNoStiction;
  row.time_s = 951'782'399;  // the day before a leap day of a century
  EXPECT_EQ(line_of(row), "2000-02-28T23:59:59Z,no_stiction,0,,,,,,,,,,\n");
  row.time_s += 1;
  EXPECT_EQ(line_of(row).substr(0, 10), "2000-02-29");
  row.time_s = 0xFFFFFFFF;
  EXPECT_EQ(line_of(row).substr(0, 20), "2106-02-07T06:28:15Z");
}

TEST(HistoryCsv, WritesEveryDigit) {
  HistoryRow row;
  for (const int period : {1, 9, 10, 11, 99, 100, 1000}) {
    row.period_s = period;
    EXPECT_TRUE(line_of(row).ends_with("," + std::to_string(period) + ".0\n")) << period;
  }
}

TEST(HistoryCsv, TheLongestLineFits) {
  HistoryRow row;
  row.verdict = LoopVerdict::kOtherOscillation;
  row.stick_band_pct = row.stick_band_low_pct =
      row.stick_band_high_pct = {655.34, 655.34};
  row.detectable_band_pct = 655.34;
  row.evidence_nats = -3276.8;
  row.confidence_pct = 127;
  row.period_s = 6553.4;
  EXPECT_LT(line_of(row).size(), kMostHistoryLine);
}

TEST(HistoryCsv, EveryDayHasTheDateOfTheCalendar) {
  using std::chrono::days;
  using std::chrono::sys_days;
  HistoryRow row;
  for (std::uint32_t day = 0; day < 0xFFFFFFFF / 86'400; day += 5) {
    row.time_s = day * 86'400;
    const std::chrono::year_month_day date{sys_days{days{day}}};
    std::array<char, 24> expected;
    std::snprintf(expected.data(), expected.size(), "%04d-%02u-%02uT00:00:00Z",
                  static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                  static_cast<unsigned>(date.day()));
    ASSERT_EQ(line_of(row).substr(0, 20), expected.data());
  }
}

}  // namespace
}  // namespace wire
