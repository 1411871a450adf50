// What the tag of a loop may look like.
#pragma once

#include <cstddef>
#include <string>

namespace config {

inline constexpr std::size_t kMostTagBytes = 32;

/// What is wrong with it, as `expected …, found …; do …`; empty: nothing.
[[nodiscard]] std::string problem_of_tag(const std::string& tag);

}  // namespace config
