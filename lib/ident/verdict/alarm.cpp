#include "ident/verdict/alarm.hpp"

#include <algorithm>

namespace ident {
namespace {

// NaN becomes 0.
float percentage(float value) {
  return value > 0.0f ? std::min(value, 100.0f) : 0.0f;
}

std::int16_t delay(int windows) {
  return static_cast<std::int16_t>(std::clamp(windows, 1, kLongestDelay));
}

}  // namespace

Alarm::Alarm(const AlarmSettings& settings)
    : raise_pct_(percentage(settings.band_min_pct)),
      keep_pct_(raise_pct_ * (1.0f - percentage(settings.band_hysteresis_pct) / 100.0f)),
      on_delay_(delay(settings.on_delay_windows)),
      off_delay_(delay(settings.off_delay_windows)) {}

void Alarm::restore(const AlarmState& state) {
  raised_ = state.raised;
  windows_ = static_cast<std::int16_t>(std::clamp(state.windows, 0, kLongestDelay));
}

Alarm::Vote Alarm::vote(Verdict verdict, float band_pct, bool oscillates) const {
  switch (verdict) {
    case Verdict::kStiction:
      return band_pct >= (raised_ ? keep_pct_ : raise_pct_) ? Vote::kFor : Vote::kAgainst;
    case Verdict::kBacklash:
    case Verdict::kNoStiction:
      return Vote::kAgainst;
    case Verdict::kUndecided:
      return oscillates ? Vote::kNone : Vote::kAgainst;
    case Verdict::kBadData:
      return Vote::kNone;
  }
  return Vote::kNone;
}

AlarmChange Alarm::take(Verdict verdict, float band_pct, bool oscillates) {
  const Vote cast = vote(verdict, band_pct, oscillates);
  if (!raised_) {
    windows_ =
        cast == Vote::kFor ? static_cast<std::int16_t>(windows_ + 1) : std::int16_t{0};
    if (windows_ < on_delay_) {
      return AlarmChange::kNone;
    }
  } else {
    if (cast == Vote::kFor) {
      windows_ = 0;
    } else if (cast == Vote::kAgainst) {
      ++windows_;
    }
    if (windows_ < off_delay_) {
      return AlarmChange::kNone;
    }
  }
  raised_ = !raised_;
  windows_ = 0;
  return raised_ ? AlarmChange::kRaised : AlarmChange::kCleared;
}

}  // namespace ident
