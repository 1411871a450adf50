// Times as they come in a file, made to run forward.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "workbench/recording/time_column.hpp"

namespace workbench {

struct TimeOrder {
  bool turned = false;  ///< newest first: times.t is reversed now, the rows must follow
  std::optional<std::size_t> step_back;  ///< first row (as turned) before the row before
  std::vector<std::string> notes;
};

/// Turns times that never rise (at least three rows), and takes off the jumps of daylight
/// saving: in local time, before 4 o'clock or at midnight and across a full hour, where
/// the clock steps back by an hour less one interval, or, on a Sunday, ahead by an hour
/// and one interval. O(n).
[[nodiscard]] TimeOrder put_in_order(TimesOfRows& times);

}  // namespace workbench
