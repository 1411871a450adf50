// Rows of a file between reading and resampling: times, and values with gaps.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "workbench/recording/input_error.hpp"
#include "workbench/recording/recording.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/recording/spelling/bad_value.hpp"
#include "workbench/recording/spelling/mark_doubt.hpp"

namespace workbench {

/// One signal, a value a row; NaN where there is none.
struct SignalRows {
  Column column = Column::u;  ///< of a load: Column::t
  std::string name;           ///< as in the file
  std::string unit;
  std::optional<std::string> cell_unit;  ///< behind the numbers; none: no number yet
  std::vector<double> values;
  std::vector<double> quality;  ///< codes of `scale`; empty: none recorded
  QualityScale scale;
  std::size_t bad = 0;                 ///< cells that said "no value"
  std::string bad_word;                ///< the first of them
  std::size_t truths = 0;              ///< cells that said True or False
  std::size_t uncertain = 0;           ///< values that are kept though questionable
  WordCounts strangers;                ///< of bad: words that nobody knows
  std::optional<InputError> stranger;  ///< to be thrown if they are too many
  MarkDoubt marks;
  std::optional<InputError> doubt;  ///< to be thrown if the marks stay in doubt
  FractionDoubt fractions;
  std::optional<InputError> fraction;  ///< to be thrown if it is one
  BracketDoubt brackets;
  std::optional<InputError> bracket;  ///< to be thrown if they are no signs
  ScaledCells scaled;
  std::optional<InputError> thousand;  ///< to be thrown if K is none
  bool is_mode = false;                ///< codes of mode_column.hpp; NaN: as before
};

struct RowTable {
  std::vector<double> t;  ///< s
  std::vector<std::uint32_t> line;
  std::vector<SignalRows> signals;
  std::vector<double> between;  ///< as in TimedRows
};

/// Where a table comes from, for messages.
struct TableContext {
  const std::string& file;
  std::size_t header_line = 1;
  const std::vector<Column>& required;
  [[nodiscard]] bool requires_it(const SignalRows& signal) const {
    return signal.column != Column::t &&
           std::ranges::find(required, signal.column) != required.end();
  }
};

inline constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// The rows in reverse order, times aside.
void turn(RowTable& table);

/// Throws the doubt of a signal whose marks are likely of thousands; of one that has
/// nothing but such marks where no signal shows decimals and `points_group`; the
/// stranger where unknown words stand in more than a tenth of the rows; and what brackets
/// or a K may mean otherwise.
void refuse_doubtful(std::span<const SignalRows> signals, bool points_group);

/// Where commas separate columns: throws what a signal has to say that is likely the
/// fractions of another one, if no signal shows a decimal mark, or of the times that
/// stand before it, if it is signal `behind_time`.
void refuse_fractions(std::span<const SignalRows> signals,
                      std::optional<std::size_t> behind_time);

/// Values of bad quality become gaps, uncertain ones are counted. Throws InputError when
/// more than half of the cells of a required signal say "no value".
void take_out_bad(RowTable& table, const TableContext& context);

/// Notes unknown words among the values and qualities of a signal, values of uncertain
/// quality, brackets and other prefixes of units.
void note_words(const SignalRows& signal, ResampleReport& report);

/// Drops rows that repeat the time of the row before; they only supply values that one
/// lacks, as a logger with one signal a row does. Counts and notes them. Times must
/// not fall.
void merge_repeats(RowTable& table, ResampleReport& report);

/// Fills gaps with the value before. A signal without any value is dropped, an error if
/// it is required, as is a load that begins after the first tenth of the rows; then the
/// rows before every signal has a value go. Counts and notes all of it.
void hold_values(RowTable& table, const TableContext& context, ResampleReport& report);

/// Moves the table into equally spaced samples of `out`, with units and loads.
void resample(RowTable&& table, const std::string& file, Recording& out);

}  // namespace workbench
