// Whether a recording was joined from two exports.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace ident {

/// Where a recording was joined, and its longest part without a seam.
struct Seams {
  static constexpr std::size_t kMost = 3;
  std::size_t count = 0;                ///< seams found, 0 … 3
  std::array<std::size_t, kMost> at{};  ///< first sample after each, ascending
  std::size_t first = 0;                ///< of the longest part: its first sample
  std::size_t length = 0;               ///< and its samples
};

/// Finds the one to three places at which y jumps, from one sample to the next, several
/// times further than anywhere else in the recording and stays away, and u breaks with
/// its past: it jumps as clearly, or the controller's law, where it is known, misses it
/// there by several times more than anywhere else. A step of the setpoint moves u at once
/// but not y, a spike comes back. Where y jumps by itself, because the sensor was moved,
/// u answers by the law: where that explains the jump of u, there is no seam.
///
/// Only a seam that stands out is found: where the parts happen to meet, or where y jumps
/// as far elsewhere, there is no telling. Offset and scale do not matter.
///
/// Equal lengths; `sp` may be empty. Cost: one pass; where a jump stands out, those of
/// ControllerRecognition and two more.
[[nodiscard]] Seams find_seams(std::span<const double> u, std::span<const double> y,
                               std::span<const double> sp);

}  // namespace ident
