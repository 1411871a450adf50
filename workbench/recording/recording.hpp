// A recording: equally spaced samples of one control loop, whatever file they
// came from. csv.hpp, candump_log.hpp and source.hpp make one.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace workbench {

/// The columns a recording can have, in the words of the contract.
enum class Column { t, u, y, sp, x };
inline constexpr std::array kAllColumns = {Column::t, Column::u, Column::y, Column::sp,
                                           Column::x};
inline constexpr std::size_t kColumns = kAllColumns.size();
[[nodiscard]] std::string_view name_of(Column column);
/// The one of that name; nothing: there is none.
[[nodiscard]] std::optional<Column> column_named(std::string_view name);

/// Those that are signals of the loop.
inline constexpr std::array kLoopColumns = {Column::u, Column::y, Column::sp, Column::x};

/// Of one thing for each column, that of `column`.
template <class T>
[[nodiscard]] const T& of_column(Column column, const T& t, const T& u, const T& y,
                                 const T& sp, const T& x) {
  return *std::array{&t, &u, &y, &sp, &x}[static_cast<std::size_t>(column)];
}

/// Longest recording, in samples: bounds the memory of every reader.
inline constexpr std::size_t kMaxSamples = 10'000'000;

/// A stretch of samples, [first, last).
struct SampleRange {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// What of `ranges` lies in `part`, counted from the beginning of `part`.
[[nodiscard]] std::vector<SampleRange> clipped(const std::vector<SampleRange>& ranges,
                                               SampleRange part);

/// Whether each of `size` samples lies in one of `ranges`.
[[nodiscard]] std::vector<bool> marked(const std::vector<SampleRange>& ranges,
                                       std::size_t size);

/// The stretches of samples, of `size`, that all fit.
template <class Fits>
[[nodiscard]] std::vector<SampleRange> stretches_where(std::size_t size, Fits fits) {
  std::vector<SampleRange> out;
  for (std::size_t k = 0; k < size; ++k) {
    if (!fits(k)) continue;
    if (out.empty() || out.back().last != k) out.push_back({k, k});
    out.back().last = k + 1;
  }
  return out;
}

/// Samples of all `ranges` together.
[[nodiscard]] std::size_t samples_in(const std::vector<SampleRange>& ranges);

/// Samples recorded in one go. What the loop did before the first of them is not known,
/// unless it was at rest.
struct Piece {
  std::size_t first = 0;  ///< samples [first, last)
  std::size_t last = 0;
  std::string recording{};  ///< name of the file
  double start_s = 0;       ///< time of its first sample in that file, s
  bool judges = false;      ///< nothing is fitted to it but its own initial state
  bool at_rest = false;     ///< the process had settled where the first samples hold u
};

/// What had to be done to get equally spaced samples. Nothing is repaired
/// silently: whatever is counted here is also in the notes.
struct ResampleReport {
  std::size_t rows = 0;         ///< samples read, before resampling
  std::size_t missing = 0;      ///< instants without a sample of their own: value held
  std::size_t irregular = 0;    ///< intervals more than 1 % off a multiple of the period
  std::size_t repeated = 0;     ///< samples dropped because their time had been seen
  std::size_t empty_cells = 0;  ///< cells without a value: previous value held
  double longest_gap_s = 0;     ///< longest interval between samples; s
  std::vector<SampleRange> gaps;   ///< the long ones (long_gaps.hpp): values are held
  bool resampled = false;          ///< true: the values are not the rows one to one
  std::vector<std::string> notes;  ///< one sentence each, for people
};

/// A further measured signal, recorded beside the loop.
struct Load {
  std::string name;    ///< as in the file, with the unit where it stands in the name
  std::string unit{};  ///< as in the file; "" if it names none
  std::vector<double> values{};
};

/// How samples are shared out between those that are fitted and those that only judge
/// (model/blocks.hpp).
struct Split {
  double estimation_share = 0.6;  ///< 0.2 … 0.9
  /// Length of an estimation block with the validation block after it, samples; 0: as
  /// long as the memory of the output asks for.
  double pair_samples = 0;
};

/// Invariants, held by every reader: at least 2 samples; every column and load has the
/// length of `t` or is empty (absent); all values finite; `period_s` > 0; `t`
/// strictly increasing, and t[k] = t[0] + k·period_s up to the jitter of the file.
struct Recording {
  std::string name;         ///< file name without folders
  double period_s = 0;      ///< s
  std::vector<double> t;    ///< s
  std::vector<double> u;    ///< controller output
  std::vector<double> y;    ///< process output
  std::vector<double> sp;   ///< setpoint
  std::vector<double> x;    ///< valve position
  std::vector<Load> loads;  ///< as asked for, in the order of the file or the options
  std::array<std::string, kColumns> units;  ///< by Column, as in the file; "" unknown
  /// "u FIC101.OP, y FIC101.PV": what the file calls them; "" where it is u and y, too.
  std::string tags;
  /// Loop of the instrument of y (instrument_tag.hpp), where the file alone says which
  /// columns are u and y; "": unknown.
  std::string loop;
  /// Of one joined from several (model/joined.hpp), in order and without a sample between
  /// them; `t` runs on as if there were no pause. Empty: all of it in one go.
  std::vector<Piece> pieces;
  /// The first sample is one of a process that had settled (rest_before.hpp).
  bool begins_at_rest = false;
  /// Clock time of the first sample, ISO 8601, with a zone only where the file names
  /// one: 2026-05-03T14:30:00+02:00. "": unknown.
  std::string start;
  /// Of `start` as the file writes it, CST or IST too, whose offset is not sure; or
  /// +02:00.
  std::string zone;
  /// Stretches in manual, in the order of time, where the file says so (mode_column.hpp).
  std::vector<SampleRange> manual;
  ResampleReport resampling;
  /// In the order of time, apart from each other: neither fitted nor judged. Readers
  /// leave nothing out.
  std::vector<SampleRange> left_out;
  Split split;

  [[nodiscard]] std::size_t size() const { return t.size(); }
  [[nodiscard]] bool has(Column column) const { return !values(column).empty(); }
  [[nodiscard]] const std::vector<double>& values(Column column) const;
  [[nodiscard]] std::vector<double>& values(Column column);
  [[nodiscard]] const std::string& unit(Column column) const {
    return units[static_cast<std::size_t>(column)];
  }
};

}  // namespace workbench
