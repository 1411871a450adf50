#include "ident/signal/input_health.hpp"

#include <algorithm>
#include <array>

#include "ident/base/limits.hpp"

namespace ident {
namespace {

constexpr std::int64_t kDefaultStalePeriods = 5;
constexpr std::int32_t kLongestRun = 1 << 20;
constexpr std::int32_t kShortestRun = 8;
constexpr int kMostRestore = 1000;
// A signal moves if it changes at least once in that many samples.
constexpr std::int32_t kMoves = 8;
constexpr float kFrozenPeriods = 3;
// 48 KiB of flash have no room for it.
constexpr bool kWatchesClock = !kLeastSizes;

std::int64_t stale_after(std::int64_t setting_us, std::int64_t period_us) {
  const std::int64_t period =
      std::clamp<std::int64_t>(period_us, 1, SampleGrid::kLongestPeriod_us);
  return setting_us == 0 ? kDefaultStalePeriods * period
                         : std::clamp<std::int64_t>(setting_us, 2 * period,
                                                    SampleGrid::kLargestTime_us);
}

bool in_range(std::int64_t t_us) {
  return t_us <= SampleGrid::kLargestTime_us && t_us >= -SampleGrid::kLargestTime_us;
}

}  // namespace

std::string_view name(InputFault fault) {
  constexpr std::array<std::string_view, 5> kNames = {"none", "stale", "non_finite",
                                                      "frozen_u", "frozen_y"};
  return kNames[static_cast<std::size_t>(fault)];
}

template <class Real>
InputHealth<Real>::InputHealth(const InputHealthSettings& settings,
                               std::int64_t period_us)
    : stale_after_us_(stale_after(settings.stale_after_us, period_us)),
      frozen_after_(settings.frozen_after_samples == 0
                        ? 0
                        : std::clamp<int>(settings.frozen_after_samples, kShortestRun,
                                          kLongestRun)),
      restore_after_(static_cast<std::int16_t>(
          std::clamp(settings.restore_after_samples, 1, kMostRestore))) {}

template <class Real>
bool InputHealth<Real>::overdue(std::int64_t t_us) const {
  return seen_ && in_range(t_us) && t_us - usable_us_ > stale_after_us_;
}

template <class Real>
bool InputHealth<Real>::frozen(const Run& run, std::int32_t limit) {
  return run.length >= limit && run.moves >= run.length / kMoves;
}

template <class Real>
HealthChange InputHealth<Real>::begin(InputFault fault, std::int64_t t_us) {
  good_ = 0;
  if (fault_ != InputFault::kNone) {
    return HealthChange::kNone;
  }
  fault_ = fault;
  changed_us_ = t_us;
  return HealthChange::kFault;
}

template <class Real>
HealthChange InputHealth<Real>::push(const Sample<Real>& sample, PushResult result,
                                     Real period_samples) {
  if (kWatchesClock) {
    const auto stamp = static_cast<std::uint32_t>(sample.t_us);
    standing_ = stamp == stamp_ ? static_cast<std::uint8_t>(standing_ + 1) : 0;
    stamp_ = stamp;
  }
  if (result == PushResult::kAccepted || result == PushResult::kGap) {
    return take_usable(sample, period_samples);
  }
  if (result == PushResult::kNonFinite) {
    if (!seen_ && in_range(sample.t_us)) {
      seen_ = true;
      usable_us_ = sample.t_us;
    }
    good_ = 0;
    if (overdue(sample.t_us)) {
      return begin(InputFault::kNonFinite, usable_us_ + stale_after_us_);
    }
  }
  return kWatchesClock && standing_ == kStanding ? begin(InputFault::kStale, sample.t_us)
                                                 : HealthChange::kNone;
}

template <class Real>
HealthChange InputHealth<Real>::take_usable(const Sample<Real>& sample,
                                            Real period_samples) {
  const bool late = overdue(sample.t_us);
  const std::int64_t due_us = usable_us_ + stale_after_us_;
  const bool u_changed = !usable_ || sample.u != u_.value;
  const bool y_changed = !usable_ || sample.y != y_.value;
  const auto follow = [](Run& run, Real value, bool changed, bool other_changed) {
    if (changed) {
      run = {value, 0, 0};
    } else if (run.length < kLongestRun) {
      ++run.length;
      run.moves += other_changed ? 1 : 0;
    }
  };
  follow(u_, sample.u, u_changed, y_changed);
  follow(y_, sample.y, y_changed, u_changed);
  seen_ = usable_ = true;
  usable_us_ = sample.t_us;
  if (late) {
    return begin(InputFault::kStale, due_us);
  }
  if (frozen_after_ > 0) {
    const Real periods = std::clamp(Real(kFrozenPeriods) * period_samples, Real(0),
                                    static_cast<Real>(kLongestRun));
    const std::int32_t limit =
        std::max(frozen_after_, static_cast<std::int32_t>(periods));
    if (frozen(y_, limit)) {
      return begin(InputFault::kFrozenY, sample.t_us);
    }
    if (frozen(u_, limit)) {
      return begin(InputFault::kFrozenU, sample.t_us);
    }
  }
  if (fault_ == InputFault::kNone) {
    return HealthChange::kNone;
  }
  const bool counts = fault_ == InputFault::kFrozenU   ? u_changed
                      : fault_ == InputFault::kFrozenY ? y_changed
                                                       : true;
  good_ = static_cast<std::int16_t>(good_ + (counts ? 1 : 0));
  if (good_ < restore_after_) {
    return HealthChange::kNone;
  }
  fault_ = InputFault::kNone;
  good_ = 0;
  changed_us_ = sample.t_us;
  return HealthChange::kRestored;
}

template <class Real>
HealthChange InputHealth<Real>::advance(std::int64_t now_us) {
  return overdue(now_us) ? begin(InputFault::kStale, usable_us_ + stale_after_us_)
                         : HealthChange::kNone;
}

template class InputHealth<float>;
template class InputHealth<double>;

}  // namespace ident
