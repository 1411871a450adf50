// From values that arrive whenever their senders like to samples on an even grid.
//
// u, y and sp come in different frames at different rates. An instant of the grid takes
// the newest value of each that is not later than itself (zero-order hold on the time
// stamps). The grid keeps away from the usual arrival of values that come once in a
// period or less often, so that jitter never decides whether a value belongs to this
// instant or the next: it starts after a few arrivals and then follows the senders'
// clocks by at most kSteer of a period at a time.
//
// Life: new → take, as values come, in order of time; before each, next until it is
// false. One thread; no heap or clock. Cost: constant.
#pragma once

#include <array>
#include <cstdint>

namespace firmware {

enum class Channel : std::uint8_t { kU, kY, kSp };

/// What an instant of the grid brought.
struct GridSample {
  std::int64_t t_us = 0;
  double u = 0;
  double y = 0;
  double sp = 0;
  bool has_sp = false;
  bool held = false;        ///< a cyclic signal missed its turn: its old value is used
  bool stale = false;       ///< u or y is older than allowed: the values are void
  std::int64_t passed = 0;  ///< stale instants before this one that were passed over
};

class Resampler {
 public:
  static constexpr double kSteer = 0.02;  ///< of a period, in one step

  /// `period_us` > 0; `stale_after_us`: age from which u and y are void.
  Resampler(std::int64_t period_us, std::int64_t stale_after_us);

  /// Takes a value. A time before the newest instant given counts for the next one.
  void take(Channel channel, std::int64_t t_us, double value);
  /// The next instant, if it is not later than `until_us`.
  [[nodiscard]] bool next(std::int64_t until_us, GridSample& out);
  /// Before the first value: `instant_us` was an instant of the grid, shortly before. The
  /// grid goes on from it, as soon as u and y have come.
  void resume(std::int64_t instant_us);
  /// Usual time between the values of a channel, none of which came sooner than two
  /// thirds of it after the one before; 0: not known yet, or one did.
  [[nodiscard]] std::int64_t interval_us(Channel channel) const;

 private:
  struct Series {
    double value = 0;
    std::int64_t t_us = 0;
    std::int64_t interval_us = 0;  // smoothed; 0: not known
    std::int64_t shortest_us = 0;  // of all intervals; 0: not known
    double cosine = 0;             // of the phase of arrivals, smoothed
    double sine = 0;
    int arrivals = 0;  // saturates
    bool present = false;

    [[nodiscard]] bool cyclic() const;
    /// Of arrivals, in periods after the instant before, 0 … 1.
    [[nodiscard]] double phase() const;
  };

  std::int64_t pass_over(std::int64_t until_us);
  [[nodiscard]] bool begin(std::int64_t until_us);
  /// How far the grid should move, in periods, −0.5 … 0.5; 0: it stands well.
  [[nodiscard]] double misplaced() const;
  void move(double periods);
  [[nodiscard]] bool missed(const Series& series) const;

  std::int64_t period_us_;
  std::int64_t stale_after_us_;
  std::int64_t instant_us_ = 0;  // the next one; before the start: the origin of phases
  std::int64_t first_us_ = 0;
  std::array<Series, 3> series_{};
  bool any_ = false;
  bool running_ = false;
  bool resumed_ = false;  // how the senders' arrivals lie to the grid was known before
};

}  // namespace firmware
