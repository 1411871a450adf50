// Words that names of columns and tags are made of.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace workbench {

/// The part a column plays, told from its name alone.
enum class Part {
  kNone,
  kTime,     ///< t, time, timestamp, date, Zeit, Datum, ...
  kU,        ///< u, OP, OUT, CO, CV, LMN, Ausgang, Stellgröße, ...
  kMv,       ///< MV: manipulated variable, or valve position where there is a kU too
  kY,        ///< y, PV, MEAS, Istwert, Regelgröße, ...
  kSp,       ///< sp, SV, SPT, Sollwert, setpoint, ...
  kX,        ///< x, POS, position, Stellung, readback, ...
  kQuality,  ///< quality, status, validity, ...
  kTag,      ///< tag, name, point, item, ...: long format
  kValue,    ///< value, Wert, ...: long format
  kMillis,   ///< ms beside a time column
};

/// A signal of a loop.
[[nodiscard]] constexpr bool is_signal(Part part) {
  return part == Part::kU || part == Part::kMv || part == Part::kY || part == Part::kSp ||
         part == Part::kX;
}

/// The part that a word means; `key` as column_name.hpp makes keys ("stellgroesse").
[[nodiscard]] Part part_named(std::string_view key);

/// The part that words of a longer name hint at, the last of them where there are
/// several: "heater 1 temp" is measured, "heater 1" is moved. Good for a suggestion, no
/// more.
[[nodiscard]] Part part_hinted(const std::vector<std::string>& pieces);

/// True for a word behind a name that only says "the value of it": value, CV, avg, ...
[[nodiscard]] bool is_value_word(std::string_view key);

/// True for a unit as rows of units hold them: %, m3/h, degC, [bar], "No EngUnits".
[[nodiscard]] bool is_unit(std::string_view text);

/// The unit behind the number of a cell: "%" of "47.3 %", "m3/h" of "12 m3/h"; none: "".
[[nodiscard]] std::string_view unit_behind(std::string_view cell);

/// A unit without its brackets.
[[nodiscard]] std::string_view without_brackets(std::string_view unit);

}  // namespace workbench
