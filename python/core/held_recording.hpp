// A recording for Python: its samples stay where they are.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "python/core/arrays.hpp"
#include "workbench/recording/recording_view.hpp"

namespace stickband_python {

/// What a caller says of arrays.
struct ArrayNotes {
  std::string name;                                        ///< stands for a file's name
  std::optional<double> ts;                                ///< s; instead of t
  std::vector<std::pair<std::string, std::string>> units;  ///< column, unit
  std::string start;  ///< clock time of the first sample, ISO 8601; "": unknown
};

/// Takes the loads out that are made of the loop's own columns, and says so in the notes:
/// no loads of their own, but a model from elsewhere may have one of them.
[[nodiscard]] std::vector<workbench::Load> taken_aside(workbench::Recording& recording);

/// Samples in arrays of the caller, or in a Recording that a reader made. Every member
/// needs the interpreter's lock but for what was taken from view() or whole() before.
class HeldRecording {
 public:
  using Column = workbench::Column;
  /// Column, array; a load by its name.
  using Columns = std::vector<std::pair<std::string, Doubles>>;

  /// `own_readings`: as taken_aside() has given them.
  explicit HeldRecording(workbench::Recording recording,
                         std::vector<workbench::Load> own_readings = {});
  /// Arrays of one length: `columns` of t, u, y, sp and x, and loads. Equally spaced
  /// samples stay where they are; others are resampled, as from a file, and noted. Throws
  /// InputError for lengths that differ, fewer than two samples, values that are not
  /// finite, times that do not rise, and as resample(). Own readings among the loads are
  /// taken aside.
  HeldRecording(Columns columns, Columns loads, ArrayNotes notes);

  [[nodiscard]] const workbench::RecordingView& view() const { return view_; }
  /// With its loads, as fits take it: they keep columns of their own. Of arrays a copy,
  /// made once.
  [[nodiscard]] const std::shared_ptr<const workbench::Recording>& whole() const;
  /// The same, and with those own readings that are named: a model has them.
  [[nodiscard]] std::shared_ptr<const workbench::Recording> whole_with(
      std::span<const std::string> own_readings) const;

  /// Some samples of what a reader made, with its notes and what is left out of it; null
  /// where the samples are a caller's. `count` ≥ 2.
  [[nodiscard]] std::shared_ptr<HeldRecording> part(std::size_t first, std::size_t count,
                                                    std::string name) const;

  /// The very array that was passed, or a read-only one over what a reader made; None
  /// where there is no such column.
  [[nodiscard]] pybind11::object array(Column column) const;
  /// The same of every load, by name.
  [[nodiscard]] pybind11::dict loads() const;
  /// And of what was taken aside.
  [[nodiscard]] pybind11::dict own_readings() const;

 private:
  void lay_in_time(std::optional<double> ts, std::size_t length);
  void take_own_readings_aside();
  void take(workbench::Recording recording);

  Columns columns_;
  Columns loads_;
  std::vector<double> t_;  // of equally spaced samples without times
  workbench::RecordingView view_;
  mutable std::shared_ptr<const workbench::Recording> whole_;
  std::vector<workbench::Load> own_readings_;  // left out of whole_ and loads_
  bool lent_ = false;                          // the samples are the caller's
};

}  // namespace stickband_python
