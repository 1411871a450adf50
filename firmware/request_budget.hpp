// What evaluations that testers ask for may cost: a share of a core, however many ask.
//
// Time earns credit, evaluations spend it; one may begin while there is credit left and
// is not interrupted then, so that samples do not wait for it. In the long run
// evaluations on request take 1 / kEarnEvery of a core at most, plus kMost_us once.
//
// Life: new → may_begin, before each evaluation; spend, what it took. One thread; no heap
// or clock. Cost: constant.
#pragma once

#include <algorithm>
#include <cstdint>

namespace firmware {

class RequestBudget {
 public:
  static constexpr std::int64_t kEarnEvery = 20;     ///< one µs in that many
  static constexpr std::int64_t kMost_us = 100'000;  ///< of credit

  [[nodiscard]] bool may_begin(std::int64_t now_us) {
    if (started_) {
      const std::int64_t earned_us = (now_us - last_us_) / kEarnEvery;
      last_us_ += earned_us * kEarnEvery;
      credit_us_ = std::min(credit_us_ + earned_us, kMost_us);
    } else {
      started_ = true;
      last_us_ = now_us;
    }
    return credit_us_ > 0;
  }
  void spend(std::int64_t us) { credit_us_ -= us; }

 private:
  std::int64_t credit_us_ = kMost_us;
  std::int64_t last_us_ = 0;  // of the time that has earned
  bool started_ = false;
};

}  // namespace firmware
