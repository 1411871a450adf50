// Words of dates, and the habits of other languages than English and German.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace workbench {

/// 1 … 12 of a word in small letters that begins with a month's name; 0: none.
[[nodiscard]] int month_named(std::string_view lower);

/// True for a weekday, short or long, in small letters.
[[nodiscard]] bool is_weekday(std::string_view lower);

/// The cell as written_time.hpp reads it: 2026年3月14日 8時00分00秒 as 2026-3-14 8:00:00,
/// in Korean too; 午前, 上午, 오전, a. m. as AM behind, and their like as PM; 08.00.00
/// behind a date as 08:00:00; literals of IEC 61131-3 (T#1h2m3s, TOD#, D#, DT#) and
/// 1h 2m 3s as a clock; the years of Japanese eras, R8/11/27, 令和8年11月27日;
/// without kl., klo, um, at, à and the Russian г. Nothing: it needs none of this. It may
/// be no time all the same.
[[nodiscard]] std::optional<std::string> plain_time(std::string_view cell);

/// 14.05.30 and 14.05.30.250, which may be a date by themselves, as 14:05:30; nothing
/// where the cell is no time of day so.
[[nodiscard]] std::optional<std::string> dotted_clock(std::string_view cell);

}  // namespace workbench
