// Whether u and y are what the controller saw: faults of sensor, columns, files,
// historian.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <variant>

#include "ident/signal/seam.hpp"
#include "ident/signal/sensor_hold.hpp"
#include "ident/signal/storage.hpp"
#include "ident/signal/swap.hpp"

namespace ident {

/// Whether the record itself is checked: on a desk. On a device, which computes in float,
/// the searches would take 6 KiB of flash and several units a piece.
template <class Real>
inline constexpr bool kChecksRecord = std::is_same_v<Real, double>;

/// What is wrong with a recording itself.
template <class Real>
struct RecordHealth {
  bool sensor_sticks = false;   ///< sensor_hold.hpp, noisy_hold.hpp
  bool swapped = false;         ///< the columns u and y: swap.hpp
  bool compressed = false;      ///< straight lines between stored points: storage.hpp
  Real points_apart = 1;        ///< mean distance of those points, samples; 1: not known
  Real held_apart = 1;          ///< the same of y where it is held between them
  std::size_t seam_at = 0;      ///< first sample after the first seam; 0: none. seam.hpp
  std::size_t part_first = 0;   ///< of the longest part without seam: its first sample
  std::size_t part_length = 0;  ///< and its samples
};

/// Asks the five searches, one after the other, in one place. Offset and scale do not
/// matter.
///
/// Life: start → step until true → health. Cost: nineteen passes, eight more where a jump
/// stands out.
template <class Real>
class RecordCheck {
 public:
  /// Equal lengths; the spans must outlive the work. `sp` may be empty.
  void start(std::span<const Real> u, std::span<const Real> y, std::span<const Real> sp);
  /// A few passes; true when done.
  bool step();
  [[nodiscard]] const RecordHealth<Real>& health() const { return health_; }

 private:
  enum class Stage : std::uint8_t {
    kSensor,
    kSwap,
    kSeam,
    kStorageOfU,
    kStorageOfY,
    kDone
  };

  template <class Search>
  [[nodiscard]] Search& search() {
    return *std::get_if<Search>(&search_);
  }
  void take_seams();
  void take_storage();

  std::span<const Real> u_;
  std::span<const Real> y_;
  std::span<const Real> sp_;
  std::variant<SensorHoldSearch<Real>, SwapSearch<Real>, SeamSearch<Real>,
               StorageSearch<Real>>
      search_;
  StoredSignal<Real> stored_u_;
  RecordHealth<Real> health_;
  Stage stage_ = Stage::kDone;
};

}  // namespace ident
