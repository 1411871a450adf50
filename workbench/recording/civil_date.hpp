// Dates of the Gregorian calendar as numbers of days.
#pragma once

#include <cstdint>

namespace workbench {

/// Days from 1 January 1970 of a Gregorian date, and back.
struct CivilDate {
  int year;
  int month;
  int day;
};
[[nodiscard]] std::int32_t days_from_civil(const CivilDate& date);
[[nodiscard]] CivilDate civil_from_days(std::int32_t days);

}  // namespace workbench
