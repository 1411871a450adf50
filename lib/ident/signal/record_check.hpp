// Whether u and y are what the controller saw: faults of sensor, columns, files,
// historian.
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>

namespace ident {

/// Whether the record itself is checked: on a desk. On a device, which computes in float,
/// the searches would take 6 KiB of flash.
template <class Real>
inline constexpr bool kChecksRecord = std::is_same_v<Real, double>;

/// What is wrong with a recording itself.
template <class Real>
struct RecordHealth {
  bool sensor_sticks = false;  ///< sensor_hold.hpp, noisy_hold.hpp
  bool swapped = false;        ///< the columns u and y: swap.hpp
  bool compressed = false;     ///< straight lines between stored points: storage.hpp
  Real points_apart = 1;       ///< mean distance of those points, samples; 1: not known
  Real held_apart = 1;         ///< the same of y where it is held between them
  Real cut_off = 0;         ///< share of y at an end of its range, 0 … 1: range_end.hpp
  std::size_t seam_at = 0;  ///< first sample after the first seam; 0: none. seam.hpp
};

/// Asks the seven searches, one after the other. Equal lengths; `sp` may be empty. Offset
/// and scale do not matter. Cost: some 36 passes, eight more where a jump stands out.
[[nodiscard]] RecordHealth<double> check_record(std::span<const double> u,
                                                std::span<const double> y,
                                                std::span<const double> sp);

}  // namespace ident
