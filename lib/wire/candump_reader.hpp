// The lines of a candump log one after another, with the times of the log.
//
// Life: new → next, while it is true → cut_line. Points into the text, which has to stay.
// No allocation; linear in the text, twice where its times may be deltas.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "wire/candump.hpp"

namespace wire {

class CandumpReader {
 public:
  CandumpReader() = default;
  /// Lines end with `\n`, `\r` or both; the mark of UTF-8 before the first is passed
  /// over.
  explicit CandumpReader(std::string_view log);

  /// Goes to the next line that is not blank. False behind the last one, and at a last
  /// one without an end that was cut: the beginning of a frame rather than broken, as a
  /// full disk, the copy of a running recording or the power leave it.
  [[nodiscard]] bool next();

  [[nodiscard]] const CandumpStatus& status() const { return status_; }
  /// A line of CAN XL, of which line() has all but the frame.
  [[nodiscard]] bool is_xl() const { return status_.error == CandumpError::kXlFrame; }
  /// As parse_candump() says it; a time since the line before (candump -t d) is summed
  /// up.
  [[nodiscard]] const CandumpLine& line() const { return line_; }
  [[nodiscard]] std::string_view text() const { return text_; }
  [[nodiscard]] std::size_t number() const {
    return number_;
  }  ///< from 1, with blank ones
  /// What to do about a line that is none.
  [[nodiscard]] const char* cure() const;
  /// Number of the last line where it was cut and left out; 0: it was not, so far.
  [[nodiscard]] std::size_t cut_line() const { return cut_line_; }

 private:
  // What relative times mean, which a single line does not show: since the start (-t z),
  // or, if one of them is less than that before, since the line before (-t d).
  enum class Relative : unsigned char { kUnknown, kToStart, kToLineBefore };

  [[nodiscard]] Relative meaning_of_times() const;

  std::string_view rest_;
  std::string_view text_;
  CandumpLine line_;
  CandumpStatus status_;
  std::size_t number_ = 0;
  std::size_t cut_line_ = 0;
  bool any_ = false;  // a line of candump was read
  Relative relative_ = Relative::kUnknown;
  std::int64_t clock_ns_ = 0;  // sum of the deltas
};

}  // namespace wire
