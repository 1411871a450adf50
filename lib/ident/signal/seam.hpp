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
  Real sureness = 0;      ///< the jump at the least clear seam, in the signal where it is
                          ///< smaller, over the largest other move; > 3, or 0: no seam
  std::size_t first = 0;  ///< of the longest part: its first sample
  std::size_t length = 0;  ///< and its samples
};

/// Finds the one to three places at which both signals jump, from one sample to the next,
/// several times further than anywhere else in the recording, and stay away. A step of
/// the setpoint moves u at once but not y, a spike comes back. A load that acts on the
/// measurement itself makes y jump, and u with it by the controller's law: where that law
/// is known and explains the jump of u, there is no seam.
///
/// Only a seam that stands out is found: where the parts happen to meet, or where either
/// signal jumps as far elsewhere, there is no telling. Offset and scale do not matter.
///
/// Life: start → step until true → seams. Cost: one pass, and those of
/// ControllerRecognition where a jump stands out.
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
  Stage stage_ = Stage::kDone;
};

/// The same, all at once.
template <class Real>
[[nodiscard]] Seams<Real> find_seams(std::span<const Real> u, std::span<const Real> y,
                                     std::span<const Real> sp);

}  // namespace ident
