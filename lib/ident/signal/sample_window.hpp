// The last samples of one loop on an even time grid: what an identification looks at.
//
// Life: new → push, push, push … → copy, at any time and as often as liked. To work on
// the samples where they are: hold, set_scale, … while samples go on coming in, release.
//
// Time is a signed 64-bit count of microseconds from any fixed origin: exact for 73 000
// years, where a double of seconds would lose microseconds after some months of Unix time
// and a float after a minute. Use a monotonic clock where there is one.
//
// The grid. A sample belongs to the slot, one period apart from the next, whose time is
// nearest to its own. With d the distance from the newest slot, in periods:
//
//   d < 0.5          repeat, refused: the slot is taken
//   0.5 ≤ d ≤ 1.5    accepted
//   d > 1.5          gap: d, rounded, less one samples are missing
//
// The slots follow the sender: each accepted sample pulls the grid by 1/8 of its distance
// from it. So neither a nominal period that is wrong by up to 5 % nor jitter of up to
// 0.25 periods makes repeats or gaps.
//
// Gaps. Up to `longest_hold` missing samples are filled with the last one (zero-order
// hold). A longer gap restarts the window: samples from both sides of it do not belong to
// one experiment. kLongestHold bounds what one sample may cost.
//
// Time going back. A sample older than the newest one is refused. When kPatience in a row
// are, the clock was set back and not the sample wrong: the window restarts at the last
// of them. So one stray time stamp, in either direction, costs at most one window.
//
// Refused samples leave the window as it was. One thread; no heap, clock or exceptions.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "ident/signal/signal_scale.hpp"

namespace ident {

/// One sample of the loop.
template <class Real>
struct Sample {
  std::int64_t t_us = 0;  ///< time, µs, −2⁶¹ … 2⁶¹
  Real u = 0;             ///< controller output, units of u
  Real y = 0;             ///< process output, units of y
  Real sp = 0;            ///< setpoint, units of y; ignored unless has_sp
  bool has_sp = false;    ///< the sender knows the setpoint
};

/// What `push` did with a sample.
enum class PushResult : std::uint8_t {
  kAccepted,   ///< in the window
  kGap,        ///< in the window; before it, samples were filled or the window restarted
  kRepeat,     ///< refused: its slot is taken
  kNonFinite,  ///< refused: u, y or sp is not a finite number, or t is out of range
  kTimeBack,   ///< refused: older than the newest sample
};

/// How often each thing happened since construction. Never reset; at one event a
/// microsecond they would overflow after 580 000 years.
struct WindowCounters {
  std::uint64_t accepted = 0;    ///< samples that entered the window
  std::uint64_t gaps = 0;        ///< intervals of more than 1.5 periods
  std::uint64_t filled = 0;      ///< samples made up by hold
  std::uint64_t restarts = 0;    ///< windows given up: long gap, or clock set back
  std::uint64_t repeats = 0;     ///< refused as kRepeat
  std::uint64_t non_finite = 0;  ///< refused as kNonFinite
  std::uint64_t time_back = 0;   ///< refused as kTimeBack
  std::uint64_t overruns = 0;    ///< windows given up: too many samples while held
};

/// Puts time stamps on the grid: everything about a window but its samples.
class SampleGrid {
 public:
  static constexpr std::int64_t kLongestPeriod_us = std::int64_t{1} << 40;  // 12 days
  static constexpr std::int64_t kLargestTime_us = std::int64_t{1} << 61;
  /// Samples in a row that must be older than the newest before the grid goes back.
  static constexpr int kPatience = 8;
  /// Most samples that are filled before one.
  static constexpr int kLongestHold = 16;

  /// What to do with one sample.
  struct Step {
    PushResult result = PushResult::kAccepted;
    bool restart = false;  ///< empty the window first
    int hold = 0;          ///< repeat the newest sample that often first
  };

  SampleGrid(std::int64_t period_us, int longest_hold);

  /// Takes the time of the next sample; `finite`: its values can be used. Cost: constant.
  Step push(std::int64_t t_us, bool finite);

  [[nodiscard]] std::int64_t period_us() const { return period_us_; }
  /// Time of the newest slot; meaningless before the first accepted sample.
  [[nodiscard]] std::int64_t newest_us() const { return slot_us_; }
  [[nodiscard]] const WindowCounters& counters() const { return counters_; }
  void count_overrun() { ++counters_.overruns; }

 private:
  Step restart_at(std::int64_t t_us);

  std::int64_t period_us_;
  std::int64_t slot_us_ = 0;   // of the newest slot
  std::int64_t stamp_us_ = 0;  // of the newest accepted sample
  WindowCounters counters_;
  int longest_hold_;
  int going_back_ = 0;
  bool started_ = false;
};

/// The last `Capacity` samples; the oldest is overwritten.
///
/// While the window is held, its samples are the holder's to scale, and new ones wait in
/// a queue of kWaiting. When it is full, and when a gap or the clock restarts the window,
/// what was held is given up at the release: the window goes on with what waits.
///
/// Memory: 3·sizeof(Real) for each of Capacity + kWaiting samples, and kOverhead bytes.
/// Cost of `push`: constant, plus the samples filled; of all else: one pass.
template <class Real, std::size_t Capacity>
class SampleWindow {
 public:
  static_assert(Capacity > 0, "a window holds at least one sample");
  static constexpr std::size_t kCapacity = Capacity;
  static constexpr std::size_t kOverhead = 256;
  static constexpr std::size_t kWaiting = Capacity < 128 ? 8 : Capacity / 16;
  static constexpr int kDefaultHold = 3;

  /// `period_us`: nominal time between samples, 1 … 2⁴⁰ µs. `longest_hold`: missing
  /// samples that are filled, 0 … kLongestHold. Values outside are moved to the nearest
  /// bound.
  explicit SampleWindow(std::int64_t period_us, int longest_hold = kDefaultHold)
      : grid_(period_us, longest_hold) {}
  SampleWindow(const SampleWindow&) = delete;
  SampleWindow& operator=(const SampleWindow&) = delete;

  /// Takes the next sample. Every result but kAccepted is counted.
  PushResult push(const Sample<Real>& sample) {
    const bool finite = std::isfinite(sample.u) && std::isfinite(sample.y) &&
                        (!sample.has_sp || std::isfinite(sample.sp));
    const SampleGrid::Step step = grid_.push(sample.t_us, finite);
    if (step.restart) {
      give_up();
    }
    for (int k = 0; k < step.hold; ++k) {
      append(newest_);
    }
    if (step.result == PushResult::kAccepted || step.result == PushResult::kGap) {
      newest_ = {sample.u, sample.y,
                 sample.has_sp ? sample.sp : std::numeric_limits<Real>::quiet_NaN()};
      append(newest_);
    }
    return step.result;
  }

  /// Samples in the window, 0 … Capacity; while it is held, those that it will have.
  [[nodiscard]] std::size_t size() const {
    return given_up_ ? waiting_ : std::min(size_ + waiting_, Capacity);
  }
  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] std::int64_t period_us() const { return grid_.period_us(); }
  /// Time of the newest sample, µs; meaningless while empty.
  [[nodiscard]] std::int64_t newest_us() const { return grid_.newest_us(); }
  [[nodiscard]] const WindowCounters& counters() const { return grid_.counters(); }

  /// The samples, oldest first, that belong to the holder until `release`. u and y are
  /// rounded as ValueGrid says, so that they come back as they were held, however often.
  struct Held {
    std::span<Real> u;
    std::span<Real> y;
    std::span<const Real> sp;  ///< empty unless every sample came with its setpoint
  };
  /// Holds the newest `count` ≤ size() samples. Not while held.
  [[nodiscard]] Held hold(std::size_t count) {
    const std::size_t oldest = (next_ + Capacity - size_) % Capacity;
    for (auto* values : {&u_, &y_, &sp_}) {
      std::rotate(values->begin(), values->begin() + static_cast<std::ptrdiff_t>(oldest),
                  values->end());
    }
    next_ = size_ % Capacity;
    held_ = true;
    first_scaled_ = size_ - count;
    grid_of_u_ = ValueGrid<Real>({&u_[first_scaled_], count});
    grid_of_y_ = ValueGrid<Real>({&y_[first_scaled_], count});
    for (std::size_t k = first_scaled_; k < size_; ++k) {
      u_[k] = grid_of_u_.round(u_[k]);
      y_[k] = grid_of_y_.round(y_[k]);
    }
    const Real* const sp = &sp_[first_scaled_];
    const bool known = count > 0 && all_finite<Real>({sp, count});
    return {{&u_[first_scaled_], count},
            {&y_[first_scaled_], count},
            {&sp_[first_scaled_], known ? count : 0}};
  }
  /// What the holder did to u and y, so that others still see the samples as they were:
  /// value · factor + offset leads back.
  void set_scale(const SignalScale<Real>& of_u, const SignalScale<Real>& of_y) {
    of_u_ = of_u;
    of_y_ = of_y;
  }
  /// Ends the hold: samples are scaled back, those that wait come in.
  void release() {
    for (std::size_t k = first_scaled_; k < size_; ++k) {
      u_[k] = grid_of_u_.round(of_u_.back(u_[k]));
      y_[k] = grid_of_y_.round(of_y_.back(y_[k]));
    }
    set_scale({}, {});
    held_ = false;
    if (given_up_) {
      size_ = next_ = 0;
      given_up_ = false;
    }
    const std::size_t count = waiting_;
    waiting_ = 0;
    for (std::size_t k = 0; k < count; ++k) {
      append(queue_[k]);
    }
  }

  /// Copies the newest samples, oldest first: as many as there are and as fit into the
  /// shorter of u and y. `sp` may be empty, else no shorter; a sample that came without
  /// setpoint gives NaN. Returns how many samples were written to each span.
  std::size_t copy(std::span<Real> u, std::span<Real> y, std::span<Real> sp = {}) const {
    const std::size_t room = u.size() < y.size() ? u.size() : y.size();
    const std::size_t count = room < size() ? room : size();
    const bool with_sp = count > 0 && sp.size() >= count;
    for (std::size_t k = 0; k < count; ++k) {
      const Values values = at(size() - count + k);
      u[k] = values.u;
      y[k] = values.y;
      if (with_sp) {
        sp[k] = values.sp;
      }
    }
    return count;
  }

 private:
  struct Values {
    Real u, y, sp;
  };

  void append(const Values& values) {
    if (held_) {
      if (waiting_ == kWaiting) {
        grid_.count_overrun();
        give_up();
      }
      queue_[waiting_++] = values;
      return;
    }
    u_[next_] = values.u;
    y_[next_] = values.y;
    sp_[next_] = values.sp;
    next_ = next_ + 1 < Capacity ? next_ + 1 : 0;
    size_ = size_ < Capacity ? size_ + 1 : Capacity;
  }
  // Starts anew, at once or at the release.
  void give_up() {
    given_up_ = held_;
    waiting_ = 0;
    size_ = held_ ? size_ : 0;
  }
  // Of what the window will be, oldest first.
  [[nodiscard]] Values at(std::size_t index) const {
    const std::size_t before = size() - waiting_;  // of the samples that are in already
    if (index >= before) {
      return queue_[index - before];
    }
    const std::size_t slot = (next_ + 2 * Capacity - before + index) % Capacity;
    if (!held_ || slot < first_scaled_) {
      return {u_[slot], y_[slot], sp_[slot]};
    }
    return {grid_of_u_.round(of_u_.back(u_[slot])),
            grid_of_y_.round(of_y_.back(y_[slot])), sp_[slot]};
  }

  SampleGrid grid_;
  std::size_t next_ = 0;
  std::size_t size_ = 0;
  std::array<Real, Capacity> u_{};
  std::array<Real, Capacity> y_{};
  std::array<Real, Capacity> sp_{};
  std::array<Values, kWaiting> queue_{};
  Values newest_{};
  SignalScale<Real> of_u_;
  SignalScale<Real> of_y_;
  ValueGrid<Real> grid_of_u_;
  ValueGrid<Real> grid_of_y_;
  std::size_t first_scaled_ = 0;
  std::size_t waiting_ = 0;
  bool held_ = false;
  bool given_up_ = false;  // what is held, at the release
};

static_assert(sizeof(SampleWindow<float, 4096>) <=
                  3 * (4096 + 256) * sizeof(float) + SampleWindow<float, 4096>::kOverhead,
              "the memory of a window is its samples and one grid, nothing else");

}  // namespace ident
