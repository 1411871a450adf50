// What the name of a signal says: its part in a loop, and which loop.
#pragma once

#include <string_view>

namespace firmware {

/// Called as a controller output, a process output or a setpoint usually is.
[[nodiscard]] bool named_u(std::string_view name);
[[nodiscard]] bool named_y(std::string_view name);
[[nodiscard]] bool named_sp(std::string_view name);

enum class SameLoop { kUnknown, kYes, kNo };

/// Whether two titles ("L1OP.OP", "L1PV.PV") are of one loop: what is left of both
/// without the words for their parts is the same, or has the same numbers in it; not,
/// where both have numbers and these differ.
[[nodiscard]] SameLoop same_loop(std::string_view one, std::string_view other);

}  // namespace firmware
