// Units of time that all who count days share.
#pragma once

namespace wire {

inline constexpr int kHourS = 3'600;
inline constexpr int kDayS = 24 * kHourS;

}  // namespace wire
