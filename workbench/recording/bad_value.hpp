// What historians write where a value is missing or not to be trusted.
#pragma once

#include <cstdint>
#include <string_view>

namespace workbench {

/// True for a cell that says "no value": a gap, not a mistake. Known, without regard
/// to case, are
/// - words: null, none, n/a, void, invalid, missing, unknown, shutdown, off-line,
/// off-scan,
///   ungültig, schlecht, Fehler, gestört, keine Daten, kein Wert; and `---`, `***`,
///   `???`;
/// - whatever begins with Bad, No Data, No Good Data, No Result, I/O Timeout, Timeout,
///   Digital State, Pt Created, Scan, Comm, Out of Serv, Not Connect, Not Available, Not
///   Collect, Configure, Calc, Over Range, Under Range, Intf, Equip, Failed, Error, Arc,
///   Set to Bad, Access Denied, Resize to, or with `#` and a letter (#N/A, #DIV/0!, #NV);
/// - only in an `export_file`: NaN, -nan, 1.#QNAN, -1.#IND, and single - * ? marks.
/// Everything else that is no number is an error of its file: `12..3` and `abc` are
/// typing mistakes, and infinities are no gap.
[[nodiscard]] bool says_no_value(std::string_view cell, bool export_file);

/// How far a quality cell lets its value count.
enum class Quality : std::uint8_t { kGood, kBad };

/// Quality cells of one signal. Words: Good, OK, Valid, Uncertain and all unknown ones
/// are good; Bad, Invalid, Schlecht, False and what says_no_value() are bad. Numbers
/// are read on the scale that the whole column shows: OPC (192 good, 64 to 191 uncertain:
/// kept, below bad), OPC UA (0 good, from 2147483648 bad), percent or 1 good and 0 bad;
/// a column of nothing but zeros is good.
class QualityScale {
 public:
  /// Code of a cell, and the column remembers its range. An empty cell counts as good.
  [[nodiscard]] double add(std::string_view cell);
  /// What a code means, once all cells are added.
  [[nodiscard]] Quality meaning(double code) const;

 private:
  double most_ = 0;
};

}  // namespace workbench
