// Times of a recording in sentences as on the axes of the page.
#pragma once

#include <string>
#include <string_view>

#include "workbench/recording/recording.hpp"

namespace workbench {

/// HTML with each time "t = 1.512e+05 s" of `recording`, "t = 10 s to 20 s" and
/// "t between 10 and 20 s" likewise, as the axis of time shows it: "14:30" or
/// "2026-03-04 14:30" where the recording has a start, else in s, min, h or d as its
/// length asks for. Tags, code, style and script stay as they are.
[[nodiscard]] std::string with_axis_times(std::string_view html,
                                          const Recording& recording);

}  // namespace workbench
