// The end of a candump log that was cut while it was written: a full disk, a copy of a
// running recording, the power.
#pragma once

#include <cstddef>
#include <string_view>

namespace hal {

/// Whether `line`, the last one of a log and without a newline, is the beginning of a
/// frame rather than broken: wire::parse_candump() failed at `column`, counted from 1,
/// where at most one word that is not complete is left.
[[nodiscard]] bool is_cut_short(std::string_view line, std::size_t column);

}  // namespace hal
