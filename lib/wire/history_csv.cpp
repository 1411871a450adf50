#include "wire/history_csv.hpp"

#include <cmath>

#include "wire/calendar.hpp"

namespace wire {
namespace {

class Line {
 public:
  explicit Line(std::span<char, kMostHistoryLine> out) : out_(out) {}

  Line& put(char c) {
    out_[at_++] = c;
    return *this;
  }
  Line& put(std::string_view text) {
    for (const char c : text) put(c);
    return *this;
  }
  // Padded with zeros to `digits`.
  Line& whole(std::uint64_t value, int digits) {
    if (digits > 1 || value >= 10) whole(value / 10, digits - 1);
    return put(static_cast<char>('0' + value % 10));
  }
  // A comma and a number with so many decimals, or nothing.
  Line& cell(double value, int decimals) {
    put(',');
    if (std::isnan(value)) return *this;
    if (value < 0) put('-');
    std::uint64_t unit = 1;
    for (int k = 0; k < decimals; ++k) unit *= 10;
    const auto raw = static_cast<std::uint64_t>(
        std::floor(std::abs(value) * static_cast<double>(unit) + 0.5));
    return whole(raw / unit, 1).put('.').whole(raw % unit, decimals);
  }
  [[nodiscard]] std::size_t size() const { return at_; }

 private:
  std::span<char, kMostHistoryLine> out_;
  std::size_t at_ = 0;
};

// Proleptic Gregorian date of a day since the epoch, by eras of 400 years.
void put_date(std::uint32_t day, Line& out) {
  constexpr std::uint32_t kEra = 146'097;
  const std::uint32_t z = day + 719'468;  // since 0000-03-01
  const std::uint32_t in_era = z % kEra;
  const std::uint32_t year_of_era =
      (in_era - in_era / 1460 + in_era / 36'524 - in_era / 146'096) / 365;
  const std::uint32_t day_of_year =
      in_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
  const std::uint32_t from_march = (5 * day_of_year + 2) / 153;
  const std::uint32_t month = from_march < 10 ? from_march + 3 : from_march - 9;
  out.whole(year_of_era + z / kEra * 400 + (month <= 2 ? 1 : 0), 4).put('-');
  out.whole(month, 2).put('-').whole(day_of_year - (153 * from_march + 2) / 5 + 1, 2);
}

std::string_view name_of(const HistoryRow& row) {
  if (row.verdict == LoopVerdict::kNotEvaluated) return "restart";
  for (const LoopField& field : loop_fields()) {
    if (field.name != "verdict") continue;
    for (const Choice& choice : field.choices) {
      if (choice.value == static_cast<std::uint8_t>(row.verdict)) return choice.name;
    }
  }
  return {};
}

}  // namespace

std::string_view history_csv_header() {
  return "time,verdict,flag,ascending,ascending_low,ascending_high,descending,"
         "descending_low,descending_high,detectable_band,evidence_nats,confidence,"
         "period_s\n";
}

std::size_t write_history_line(const HistoryRow& row,
                               std::span<char, kMostHistoryLine> out) {
  const std::uint32_t second = row.time_s % kDayS;
  Line line(out);
  put_date(row.time_s / kDayS, line);
  line.put('T').whole(second / kHourS, 2).put(':').whole(second / 60 % 60, 2).put(':');
  line.whole(second % 60, 2).put("Z,").put(name_of(row)).put(row.flag ? ",1" : ",0");
  for (const double* value : bands_of(row)) line.cell(*value, 2);
  line.cell(row.evidence_nats, 1).cell(row.confidence_pct, 1).cell(row.period_s, 1);
  line.put('\n');
  return line.size();
}

}  // namespace wire
