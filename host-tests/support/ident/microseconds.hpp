// Time stamps, which count microseconds.
#pragma once

#include <cstdint>

namespace test {

inline constexpr std::int64_t kSecond = 1'000'000;

}  // namespace test
