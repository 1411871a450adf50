// What each key alone cannot show: two that contradict each other.
#pragma once

#include "config/gateway.hpp"
#include "config/toml_reader.hpp"

namespace config {

/// Complains of loops with one id or tag, flags on one line, identifiers with two
/// meanings on one bus, signals that serve twice in a loop, and files to be written that
/// serve another purpose too.
void check_consistency(const Gateway& gateway, Complaints& complaints);

}  // namespace config
