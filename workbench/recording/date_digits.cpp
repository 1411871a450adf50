#include "workbench/recording/date_digits.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

#include "workbench/recording/letters.hpp"

namespace workbench {
namespace {

constexpr std::int32_t kExcel1970 = 25569;  // days from 30 December 1899
constexpr std::int32_t kExcel2000 = 36526;
constexpr std::int32_t kExcel2100 = 73051;

// The digits before decimals that are zero.
std::string_view whole_digits(std::string_view cell) {
  const std::size_t mark = cell.find_first_of(".,");
  const std::string_view whole = cell.substr(0, mark);
  const std::string_view behind =
      mark == std::string_view::npos ? "" : cell.substr(mark + 1);
  const bool zeros = behind.find_first_not_of('0') == std::string_view::npos;
  return zeros && std::ranges::all_of(whole, is_digit) ? whole : "";
}

}  // namespace

std::optional<WrittenTime> date_digits(std::string_view cell,
                                       std::optional<DateOrder> order) {
  const std::string text(whole_digits(cell));
  if (text.size() == 8) {
    return written_time(text.substr(0, 4) + '-' + text.substr(4, 2) + '-' +
                        text.substr(6));
  }
  if (text.size() == 6) {
    return written_time(
        text.substr(0, 2) + '/' + text.substr(2, 2) + '/' + text.substr(4), order);
  }
  if (text.size() != 5) return std::nullopt;
  const std::int32_t day = std::stoi(text);
  if (day < kExcel2000 || day >= kExcel2100) return std::nullopt;
  WrittenTime out;
  out.kind = WrittenTime::Day::kKnown;
  out.day = day - kExcel1970;
  return out;
}

}  // namespace workbench
