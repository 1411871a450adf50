#include "hal/candump_tail.hpp"

namespace hal {

bool is_cut_short(std::string_view line, std::size_t column) {
  constexpr std::size_t kLongestWord =
      8;  // an extended identifier: faults are told there
  const std::size_t first = line.find_first_not_of(" \t");
  if (first == std::string_view::npos || line[first] != '(') return false;
  return column > 0 && column + kLongestWord > line.size();
}

}  // namespace hal
