// A small plot of a series in a terminal: four dots high and two wide a character.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace firmware {

/// `rows` lines of `columns` characters of UTF-8, from the highest to the lowest value,
/// without line ends; the series is drawn from left to right as it comes, each column
/// from the least to the greatest value that falls into it. An empty series, or one
/// without a finite value, is blank.
[[nodiscard]] std::vector<std::string> braille_plot(std::span<const double> values,
                                                    std::size_t columns,
                                                    std::size_t rows);

}  // namespace firmware
