#include "workbench/analysis/median.hpp"

#include <algorithm>
#include <cstddef>

namespace workbench {

double median(std::vector<double> values) {
  const std::size_t middle = values.size() / 2;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(middle),
                   values.end());
  if (values.size() % 2 == 1) return values[middle];
  return (values[middle] +
          *std::max_element(values.begin(),
                            values.begin() + static_cast<std::ptrdiff_t>(middle))) /
         2;
}

}  // namespace workbench
