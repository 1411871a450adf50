// Whether the files that a gateway writes can be written, before it has to.
#pragma once

#include <string>

#include "config/gateway.hpp"

namespace firmware {

/// What stands in the way, one line for each place; empty: nothing.
struct TargetFaults {
  std::string wrong;    ///< on any machine: a folder named as a file, and its like
  std::string missing;  ///< on this one: folders that do not exist or are not ours
};
[[nodiscard]] TargetFaults check_targets(const config::Gateway& gateway);

}  // namespace firmware
