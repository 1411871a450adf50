// Numbers as files spell them.
#pragma once

#include <optional>
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
/// number_spelling.hpp says. About 20 ns a number.
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

/// A cell that as a whole is a number with a decimal point, as programs write them: no
/// sign +, no groups, no unit. Nothing for any other.
[[nodiscard]] std::optional<double> as_number(std::string_view cell);

}  // namespace workbench
