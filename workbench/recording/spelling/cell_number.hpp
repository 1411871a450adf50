// Numbers as files spell them, in other letters than those of programs, too.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace workbench {

/// How the numbers of one file are written, as far as its first rows show it.
struct NumberStyle {
  char decimal = 0;           ///< '.' or ','; 0: not seen
  bool given = false;         ///< the user says so, and the other mark groups thousands
  bool grouped = false;       ///< some number shows thousands separators and decimals
  bool dotted_dates = false;  ///< 13.05.2026: a decimal comma is likely
};

/// Whether a cell looks like a number in any style, and what it tells of the style.
class NumberEvidence {
 public:
  /// False: no number in any style.
  bool add(std::string_view cell);
  /// The style that all cells so far agree on.
  [[nodiscard]] NumberStyle style() const;

 private:
  bool decimal_point_ = false;
  bool decimal_comma_ = false;
  bool grouped_ = false;
};

/// Reads numbers of one file; one decimal mark throughout. A `plain` file has no
/// thousands separators, and a decimal comma only where the comma does not separate
/// columns. In an export a number may be grouped in threes by the other mark, a blank,
/// a no-break blank or an apostrophe, where that is unambiguous: 1.234,5 or 1,234,567, or
/// 1.234 once another number of the first rows showed 1.234,5; and be spelled as
/// plain_number() says. About 20 ns a number.
class NumberReader {
 public:
  enum class Result { kOk, kText, kNotFinite, kMixedMarks, kUnclear };

  NumberReader(char separator, bool plain, NumberStyle style)
      : separator_(separator), plain_(plain), style_(style) {}

  Result read(std::string_view cell, double& value);

 private:
  Result read_as_it_is(std::string_view cell, double& value);
  Result read_marked(std::string_view cell, double& value);
  Result accept(char decimal);

  char separator_;
  bool plain_;
  NumberStyle style_;
  bool points_ = false;
  bool commas_ = false;
};

/// A cell of a number in the letters that programs read: without no-break and thin blanks
/// around it; U+2212, a dash or a minus behind (44.9-, as SAP writes) as '-' in front;
/// full-width and Arabic digits and marks as ASCII; D in the exponent as E; without the
/// apostrophe in front or ="" around by which spreadsheets keep text; 1,23,456.7, as
/// India groups digits, in groups of three. Nothing: the cell needs none of this.
[[nodiscard]] std::optional<std::string> plain_number(std::string_view cell);

/// Without blanks around it, no-break and thin ones included.
[[nodiscard]] std::string_view without_blanks(std::string_view cell);

}  // namespace workbench
