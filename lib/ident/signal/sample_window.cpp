#include "ident/signal/sample_window.hpp"

#include <algorithm>

namespace ident {
namespace {

constexpr std::int64_t kPull = 8;  // share of a sample's distance that moves the grid

}  // namespace

SampleGrid::SampleGrid(std::int64_t period_us, int longest_hold)
    : period_us_(std::clamp<std::int64_t>(period_us, 1, kLongestPeriod_us)),
      longest_hold_(std::clamp(longest_hold, 0, kLongestHold)) {}

SampleGrid::Step SampleGrid::restart_at(std::int64_t t_us) {
  slot_us_ = stamp_us_ = t_us;
  going_back_ = 0;
  ++counters_.restarts;
  ++counters_.accepted;
  return {PushResult::kGap, true, 0};
}

SampleGrid::Step SampleGrid::push(std::int64_t t_us, bool finite) {
  if (!finite || t_us > kLargestTime_us || t_us < -kLargestTime_us) {
    ++counters_.non_finite;
    return {PushResult::kNonFinite};
  }
  if (!started_) {
    started_ = true;
    slot_us_ = stamp_us_ = t_us;
    ++counters_.accepted;
    return {PushResult::kAccepted};
  }
  if (t_us < stamp_us_) {
    if (++going_back_ >= kPatience) {
      return restart_at(t_us);
    }
    ++counters_.time_back;
    return {PushResult::kTimeBack};
  }
  going_back_ = 0;
  // Times are within ±2⁶¹ and the slot within a period of its stamp: no overflow.
  const std::int64_t distance = t_us - slot_us_;
  if (distance < period_us_ && 2 * distance < period_us_) {
    ++counters_.repeats;
    return {PushResult::kRepeat};
  }
  if (distance - period_us_ <= period_us_ / 2) {
    slot_us_ += period_us_ + (distance - period_us_) / kPull;
    stamp_us_ = t_us;
    ++counters_.accepted;
    return {PushResult::kAccepted};
  }
  ++counters_.gaps;
  const bool beyond_half = 2 * (distance % period_us_) > period_us_;
  const std::int64_t slots = distance / period_us_ + (beyond_half ? 1 : 0);
  if (slots - 1 > longest_hold_) {
    return restart_at(t_us);
  }
  const int hold = static_cast<int>(slots - 1);
  slot_us_ += slots * period_us_;
  slot_us_ += (t_us - slot_us_) / kPull;
  stamp_us_ = t_us;
  counters_.filled += static_cast<std::uint64_t>(hold);
  ++counters_.accepted;
  return {PushResult::kGap, false, hold};
}

}  // namespace ident
