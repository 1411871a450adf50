// Values of signals, from the cells of rows.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "workbench/recording/rows/row_scanner.hpp"
#include "workbench/recording/rows/row_table.hpp"
#include "workbench/recording/spelling/cell_number.hpp"
#include "workbench/recording/times/time_column.hpp"

namespace workbench {

/// Which of the wanted cells make the time of a row.
struct TimeSlots {
  std::size_t column = 0;
  std::optional<std::size_t> clock;
  bool clock_is_number = false;
  std::optional<std::size_t> millis;
  double millis_s = 1e-3;
  std::vector<std::size_t> parts;  ///< as in TimePlace
  std::string name;                ///< of the column, or of the parts
};

/// Reads the cells of one file, and says what is wrong with one.
class ValueReader {
 public:
  ValueReader(const CsvLayout& layout, bool plain)
      : numbers_(layout.separator, plain, layout.style),
        separator_(layout.separator),
        plain_(plain),
        marks_known_(layout.style.decimal != 0),
        marks_given_(layout.style.given) {}

  /// Appends the cell of `slot` to `signal`: its number, or NaN where the cell is empty
  /// or says that there is no value; for a load, NaN for whatever is no number. In an
  /// u may be True and False: 1 and 0. In an
  /// export a unit may stand behind the numbers, the same in every cell but for a prefix,
  /// or a K where others have none; and brackets around negative ones. Throws InputError
  /// for anything else.
  void append(const RowScanner& row, std::size_t slot, SignalRows& signal);

  /// Appends the time of the row. False: it has none, time_error() says why.
  [[nodiscard]] bool append_time(const RowScanner& row, const TimeSlots& slots,
                                 TimeColumn& times);
  [[nodiscard]] InputError time_error(const RowScanner& row, const TimeSlots& slots,
                                      TimeForm form) const;

 private:
  bool append_truth(const RowScanner& row, std::size_t slot, SignalRows& signal) const;
  // What the parts say as one text.
  std::optional<std::string> joined_time(const RowScanner& row, const TimeSlots& slots);
  // The number of a cell, and the unit behind it.
  NumberReader::Result read(std::string_view cell, double& value, std::string_view& unit);
  // Numbers of 1.2 bar and 980 mbar are not to be compared as they are.
  static void scale_to_unit(const RowScanner& row, std::size_t slot, SignalRows& signal,
                            std::string_view unit, double& value);
  [[nodiscard]] static InputError bracket_error(const RowScanner& row, std::size_t slot,
                                                const SignalRows& signal);
  // Keeps what the marks of the number say while both readings are left.
  void doubt_marks(const RowScanner& row, std::size_t slot, SignalRows& signal,
                   std::string_view number, double value) const;
  void doubt_fraction(const RowScanner& row, std::size_t slot, SignalRows& signal,
                      std::string_view number) const;
  [[nodiscard]] InputError number_error(const RowScanner& row, std::size_t slot,
                                        const std::string& name,
                                        NumberReader::Result result) const;

  NumberReader numbers_;
  char separator_;
  bool plain_;
  bool marks_known_;
  bool marks_given_;
  NumberReader::Result time_result_ = NumberReader::Result::kOk;
};

}  // namespace workbench
