// Decimal numbers without the C library.
#pragma once

#include <string_view>

namespace wire {

/// Parses the whole of `text`: [+-]digits[.digits][(e|E)[+-]digits]. False for
/// anything else and for values beyond the largest double. Correctly rounded up to 15
/// significant digits and powers of ten up to 22 (every scale and offset in practice),
/// otherwise within a few units in the last place.
[[nodiscard]] bool parse_decimal(std::string_view text, double& value);

}  // namespace wire
