// Whether a recording was joined from two exports.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "ident/signal/controller_action.hpp"

namespace ident {

/// Where a recording was joined, and its longest part without a seam.
template <class Real>
struct Seams {
  static constexpr std::size_t kMost = 3;
  std::size_t count = 0;                ///< seams found, 0 … 3
  std::array<std::size_t, kMost> at{};  ///< first sample after each, ascending
  Real sureness = 0;       ///< the jump of y at the smallest seam, over its largest other
                           ///< move; > 3, or 0: no seam
  std::size_t first = 0;   ///< of the longest part: its first sample
  std::size_t length = 0;  ///< and its samples
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
/// Life: start → step until true → seams. Cost: one pass; where a jump
/// stands out, those of ControllerRecognition and two more.
template <class Real>
class SeamSearch {
 public:
  /// Equal lengths; the spans must outlive the work. `sp` may be empty.
  void start(std::span<const Real> u, std::span<const Real> y, std::span<const Real> sp);
  /// One or two passes; true when done.
  bool step();
  [[nodiscard]] const Seams<Real>& seams() const { return seams_; }

 private:
  enum class Stage : std::uint8_t { kMoves, kLaw, kDone };
  // The largest moves of a signal, largest first.
  struct Moves {
    static constexpr std::size_t kKept = Seams<Real>::kMost + 1;
    std::array<Real, kKept> size{};
    std::array<std::size_t, kKept> at{};
    void take(Real move, std::size_t t);
    [[nodiscard]] bool among_first(std::size_t count, std::size_t t) const;
    [[nodiscard]] Real clearness(std::size_t count) const;
  };

  void find_moves();
  void measure_parts();
  void check_law();
  [[nodiscard]] static bool stays(std::span<const Real> x, std::size_t t);

  std::span<const Real> u_;
  std::span<const Real> y_;
  std::span<const Real> sp_;
  ControllerRecognition<Real> law_;
  Seams<Real> seams_;
  bool u_jumps_ = false;  // as clearly as y
  Stage stage_ = Stage::kDone;
};

/// The same, all at once.
template <class Real>
[[nodiscard]] Seams<Real> find_seams(std::span<const Real> u, std::span<const Real> y,
                                     std::span<const Real> sp);

}  // namespace ident
