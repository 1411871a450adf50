#include "workbench/recording/within_row.hpp"

#include <algorithm>
#include <cstddef>

namespace workbench {

int sign_of_jumps(std::span<const double> u, std::span<const double> y) {
  constexpr double kJump = 0.3;         // of the range
  constexpr std::ptrdiff_t kStays = 3;  // rows to either side
  constexpr double kClear = 2;          // of what moves on either side
  constexpr int kFewest = 3;
  const auto jump = [](std::span<const double> signal, std::size_t k, double least) {
    const auto at = signal.begin() + static_cast<std::ptrdiff_t>(k);
    const auto [low, high] = std::minmax_element(at - kStays, at);
    const auto [low_then, high_then] = std::minmax_element(at, at + kStays);
    const double clear =
        std::max(least, kClear * std::max(*high - *low, *high_then - *low_then));
    if (*low_then - *high > clear) return 1;
    return *low - *high_then > clear ? -1 : 0;
  };
  const auto least_of = [](std::span<const double> signal) {
    const auto [low, high] = std::ranges::minmax(signal);
    return kJump * (high - low);
  };
  if (u.size() < 2 * kStays || y.size() != u.size()) return 0;
  const double of_u = least_of(u);
  const double of_y = least_of(y);
  int same = 0;
  int opposite = 0;
  for (std::size_t k = kStays; k + kStays <= u.size(); ++k) {
    const int both = jump(u, k, of_u) * jump(y, k, of_y);
    same += both > 0;
    opposite += both < 0;
  }
  if (same >= kFewest && opposite == 0) return 1;
  return opposite >= kFewest && same == 0 ? -1 : 0;
}

void note_within_row(Recording& recording) {
  if (sign_of_jumps(recording.u, recording.y) == 0) return;
  recording.resampling.notes.emplace_back(
      "y jumps in the rows in which u does: the log wrote y after u had acted, or its "
      "rows are means. Models take u one row earlier; what happens within a row needs a "
      "faster log");
}

}  // namespace workbench
