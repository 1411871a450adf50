// The last samples of one loop on an even time grid: what an identification looks at.
//
// Life: new → push, push, push … → copy, at any time and as often as liked.
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
// one experiment.
//
// Time going back. A sample older than the newest one is refused. When kPatience in a row
// are, the clock was set back and not the sample wrong: the window restarts at the last
// of them. So one stray time stamp, in either direction, costs at most one window.
//
// Refused samples leave the window as it was. One thread; no heap, clock or exceptions.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

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
};

/// Puts time stamps on the grid: everything about a window but its samples.
class SampleGrid {
 public:
  static constexpr std::int64_t kLongestPeriod_us = std::int64_t{1} << 40;  // 12 days
  static constexpr std::int64_t kLargestTime_us = std::int64_t{1} << 61;
  /// Samples in a row that must be older than the newest before the grid goes back.
  static constexpr int kPatience = 8;

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
/// Memory: 3·Capacity·sizeof(Real) for u, y and sp, and kOverhead bytes. With float and
/// 4096 samples: 49 152 + 160 bytes. Cost of `push`: constant, plus the samples held; of
/// `copy`: one pass.
template <class Real, std::size_t Capacity>
class SampleWindow {
 public:
  static_assert(Capacity > 0, "a window holds at least one sample");
  static constexpr std::size_t kCapacity = Capacity;
  static constexpr std::size_t kOverhead = 160;
  static constexpr int kDefaultHold = 3;

  /// `period_us`: nominal time between samples, 1 … 2⁴⁰ µs. `longest_hold`: missing
  /// samples that are filled, ≥ 0. Values outside are moved to the nearest bound.
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
      size_ = 0;
    }
    for (int k = 0; k < step.hold; ++k) {
      const std::size_t newest = (next_ + Capacity - 1) % Capacity;
      append(u_[newest], y_[newest], sp_[newest]);
    }
    if (step.result == PushResult::kAccepted || step.result == PushResult::kGap) {
      append(sample.u, sample.y,
             sample.has_sp ? sample.sp : std::numeric_limits<Real>::quiet_NaN());
    }
    return step.result;
  }

  /// Samples held, 0 … Capacity.
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] bool full() const { return size_ == Capacity; }
  [[nodiscard]] std::int64_t period_us() const { return grid_.period_us(); }
  /// Time of the newest sample, µs; meaningless while empty.
  [[nodiscard]] std::int64_t newest_us() const { return grid_.newest_us(); }
  [[nodiscard]] const WindowCounters& counters() const { return grid_.counters(); }

  /// Copies the newest samples, oldest first: as many as there are and as fit into the
  /// shorter of u and y. `sp` may be empty, else no shorter; a sample that came without
  /// setpoint gives NaN. Returns how many samples were written to each span.
  std::size_t copy(std::span<Real> u, std::span<Real> y, std::span<Real> sp = {}) const {
    const std::size_t room = u.size() < y.size() ? u.size() : y.size();
    const std::size_t count = room < size_ ? room : size_;
    const bool with_sp = count > 0 && sp.size() >= count;
    std::size_t from = (next_ + Capacity - count) % Capacity;
    for (std::size_t k = 0; k < count; ++k) {
      u[k] = u_[from];
      y[k] = y_[from];
      if (with_sp) {
        sp[k] = sp_[from];
      }
      from = from + 1 < Capacity ? from + 1 : 0;
    }
    return count;
  }
  /// Every sample in the window came with its setpoint. Cost: one pass.
  [[nodiscard]] bool has_setpoint() const {
    std::size_t at = (next_ + Capacity - size_) % Capacity;
    for (std::size_t k = 0; k < size_; ++k) {
      if (!std::isfinite(sp_[at])) {
        return false;
      }
      at = at + 1 < Capacity ? at + 1 : 0;
    }
    return size_ > 0;
  }

 private:
  void append(Real u, Real y, Real sp) {
    u_[next_] = u;
    y_[next_] = y;
    sp_[next_] = sp;
    next_ = next_ + 1 < Capacity ? next_ + 1 : 0;
    size_ = size_ < Capacity ? size_ + 1 : Capacity;
  }

  SampleGrid grid_;
  std::size_t next_ = 0;
  std::size_t size_ = 0;
  std::array<Real, Capacity> u_{};
  std::array<Real, Capacity> y_{};
  std::array<Real, Capacity> sp_{};
};

static_assert(sizeof(SampleWindow<float, 4096>) <=
                  3 * 4096 * sizeof(float) + SampleWindow<float, 4096>::kOverhead,
              "the memory of a window is its samples and one grid, nothing else");

}  // namespace ident
