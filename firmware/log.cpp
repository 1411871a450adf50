#include "firmware/log.hpp"

#include <algorithm>

namespace firmware {

void Log::write(std::int64_t now_us, Priority priority, const char* text) {
  constexpr std::int64_t kLine_us = 1'000'000 / kPerSecond;
  credit_us_ = started_ ? std::min(credit_us_ + (now_us - last_us_), kBurst * kLine_us)
                        : kBurst * kLine_us;
  started_ = true;
  last_us_ = now_us;
  if (credit_us_ < kLine_us) {
    ++suppressed_;
    return;
  }
  credit_us_ -= kLine_us;
  if (suppressed_ > told_) {
    std::fprintf(out_, "<4>%llu messages suppressed\n",
                 static_cast<unsigned long long>(suppressed_ - told_));
    told_ = suppressed_;
  }
  std::fprintf(out_, "<%d>%s\n", static_cast<int>(priority), text);
  std::fflush(out_);
}

}  // namespace firmware
