// A recording where its samples lie: in a Recording, or in memory of somebody else.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "workbench/recording/recording.hpp"

namespace workbench {

/// What reads a recording once takes this: nothing is copied but names and notes. The
/// invariants are those of Recording; the samples must outlive it and stay as they are.
struct RecordingView {
  RecordingView() = default;
  /// Of the samples of `recording`, without its loads. Not explicit: whoever has a
  /// Recording has a view of it.
  RecordingView(const Recording& recording);

  std::string name;
  double period_s = 0;        ///< s
  std::span<const double> t;  ///< s
  std::span<const double> u;  ///< controller output
  std::span<const double> y;  ///< process output
  std::span<const double> sp;
  std::span<const double> x;
  std::array<std::string, kColumns> units;  ///< by Column; "" unknown
  std::string tags;                         ///< as Recording::tags
  std::string loop;                         ///< as Recording::loop
  std::string start;                        ///< as Recording::start
  std::vector<std::string> notes;           ///< what was repaired, one sentence each
  std::vector<SampleRange> gaps;            ///< as ResampleReport::gaps

  [[nodiscard]] std::size_t size() const { return t.size(); }
  [[nodiscard]] bool has(Column column) const { return !values(column).empty(); }
  [[nodiscard]] std::span<const double> values(Column column) const {
    return of_column(column, t, u, y, sp, x);
  }
  [[nodiscard]] const std::string& unit(Column column) const {
    return units[static_cast<std::size_t>(column)];
  }
  /// `length` samples from `first` on with the gaps in them; all else stays.
  [[nodiscard]] RecordingView part(std::size_t first, std::size_t length) const;
};

}  // namespace workbench
