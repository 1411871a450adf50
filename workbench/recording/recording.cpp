#include "workbench/recording/recording.hpp"

#include <algorithm>

namespace workbench {

std::string_view name_of(Column column) {
  constexpr std::array<std::string_view, kColumns> kNames = {"t", "u", "y", "sp", "x"};
  return kNames[static_cast<std::size_t>(column)];
}

std::optional<Column> column_named(std::string_view name) {
  for (const Column column : kAllColumns) {
    if (name_of(column) == name) return column;
  }
  return std::nullopt;
}

const std::vector<double>& Recording::values(Column column) const {
  return of_column(column, t, u, y, sp, x);
}

std::vector<double>& Recording::values(Column column) {
  return const_cast<std::vector<double>&>(  // NOLINT: *this is not const here
      static_cast<const Recording*>(this)->values(column));
}

std::vector<SampleRange> clipped(const std::vector<SampleRange>& ranges,
                                 SampleRange part) {
  std::vector<SampleRange> out;
  for (const SampleRange& range : ranges) {
    const std::size_t first = std::max(range.first, part.first);
    const std::size_t last = std::min(range.last, part.last);
    if (first < last) out.push_back({first - part.first, last - part.first});
  }
  return out;
}

std::vector<bool> marked(const std::vector<SampleRange>& ranges, std::size_t size) {
  std::vector<bool> out(size, false);
  for (const SampleRange& range : ranges) {
    std::fill(out.begin() + static_cast<std::ptrdiff_t>(range.first),
              out.begin() + static_cast<std::ptrdiff_t>(range.last), true);
  }
  return out;
}

std::size_t samples_in(const std::vector<SampleRange>& ranges) {
  std::size_t samples = 0;
  for (const SampleRange& range : ranges) samples += range.last - range.first;
  return samples;
}

}  // namespace workbench
