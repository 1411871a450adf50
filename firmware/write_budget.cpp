#include "firmware/write_budget.hpp"

#include <algorithm>

#include "wire/calendar.hpp"

namespace firmware {

void WriteBudget::set(int an_hour) {
  constexpr std::int64_t kHour_us = std::int64_t{1'000'000} * wire::kHourS;
  // What is saved up comes on top of what is earned in an hour.
  const int earned = std::max(an_hour, kLeastAnHour) - kMost;
  every_us_ = kHour_us / earned + 1;
  waiting_ = {};
}

void WriteBudget::earn(std::int64_t now_us) {
  if (!started_) {
    started_ = true;
    last_us_ = now_us;
  }
  const std::int64_t earned = std::max<std::int64_t>(now_us - last_us_, 0) / every_us_;
  last_us_ += earned * every_us_;
  credit_ = static_cast<int>(std::min<std::int64_t>(credit_ + earned, kMost));
  // A full purse earns nothing, not even a part of the next one.
  if (credit_ == kMost) last_us_ = now_us;
}

bool WriteBudget::ripe(const Waiting& waiting, std::int64_t now_us) const {
  const auto within = [&](int needs, int waits) {
    return credit_ >= needs || now_us - waiting.since_us >= waits * every_us_;
  };
  switch (waiting.haste) {
    case Haste::kNow:
      return true;
    case Haste::kSoon:
      return within(kSoonNeeds, kSoonWaits);
    case Haste::kLater:
      return within(kMost, kLaterWaits);
    case Haste::kNone:
      break;
  }
  return false;
}

bool WriteBudget::may_write(Written file, Haste haste, std::int64_t now_us) {
  earn(now_us);
  Waiting& own = waiting_[static_cast<std::size_t>(file)];
  if (own.haste == Haste::kNone) own.since_us = now_us;
  own.haste = haste;
  if (credit_ == 0 || !ripe(own, now_us)) return false;
  const bool first = std::ranges::none_of(waiting_, [&](const Waiting& other) {
    return other.since_us < own.since_us && ripe(other, now_us);
  });
  if (!first) return false;
  --credit_;
  own.haste = Haste::kNone;
  return true;
}

void WriteBudget::give_back(int count) {
  credit_ = std::min(credit_ + std::max(count, 0), kMost);
}

}  // namespace firmware
