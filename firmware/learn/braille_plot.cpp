#include "firmware/learn/braille_plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace firmware {
namespace {

// Bits of the dots of U+2800 …, by row and column.
constexpr std::array<std::array<unsigned, 2>, 4> kDots = {
    {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}}};

std::string utf8(unsigned dots) {
  constexpr unsigned kBlank = 0x2800;
  const unsigned code = kBlank + dots;
  return {static_cast<char>(0xE0 | code >> 12),
          static_cast<char>(0x80 | (code >> 6 & 0x3F)),
          static_cast<char>(0x80 | (code & 0x3F))};
}

}  // namespace

std::vector<std::string> braille_plot(std::span<const double> values, std::size_t columns,
                                      std::size_t rows) {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  const std::size_t width = 2 * columns;
  const std::size_t height = 4 * rows;
  std::vector<std::vector<bool>> dots(height, std::vector<bool>(width));
  const auto level = [&](double value) {
    const double share = high > low ? (value - low) / (high - low) : 0.5;
    return static_cast<std::size_t>(std::lround(share * static_cast<double>(height - 1)));
  };
  std::size_t before = height;  // level of the value before; height: none
  for (std::size_t column = 0; column < width && !values.empty(); ++column) {
    const std::size_t first = column * values.size() / width;
    const std::size_t end = std::max(first + 1, (column + 1) * values.size() / width);
    for (std::size_t k = first; k < end; ++k) {
      if (!std::isfinite(values[k])) continue;
      const std::size_t at = level(values[k]);
      const std::size_t from = before == height ? at : before;
      for (std::size_t dot = std::min(at, from); dot <= std::max(at, from); ++dot) {
        dots[height - 1 - dot][column] = true;
      }
      before = at;
    }
  }
  std::vector<std::string> out;
  for (std::size_t row = 0; row < rows; ++row) {
    std::string line;
    for (std::size_t column = 0; column < columns; ++column) {
      unsigned pattern = 0;
      for (std::size_t y = 0; y < 4; ++y) {
        for (std::size_t x = 0; x < 2; ++x) {
          if (dots[4 * row + y][2 * column + x]) pattern |= kDots[y][x];
        }
      }
      line += utf8(pattern);
    }
    out.push_back(std::move(line));
  }
  return out;
}

}  // namespace firmware
