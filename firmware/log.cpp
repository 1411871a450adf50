#include "firmware/log.hpp"

#include <algorithm>
#include <cstdarg>

#include "hal/message.hpp"

namespace firmware {
namespace {

constexpr std::array<const char*, kTopics> kNames{"the gateway", "devices", "inputs",
                                                  "loops", "flags"};

}  // namespace

void Log::write(std::int64_t now_us, Priority priority, const char* text, Topic topic) {
  constexpr std::int64_t kLine_us = 1'000'000 / kPerSecond;
  Budget& own = budgets_[static_cast<std::size_t>(topic)];
  own.credit_us =
      own.started ? std::min(own.credit_us + (now_us - own.last_us), kBurst * kLine_us)
                  : kBurst * kLine_us;
  own.started = true;
  own.last_us = now_us;
  if (own.credit_us < kLine_us) {
    ++own.suppressed;
    return;
  }
  own.credit_us -= kLine_us;
  if (own.suppressed > own.told) {
    std::fprintf(out_, "<4>%llu messages about %s suppressed\n",
                 static_cast<unsigned long long>(own.suppressed - own.told),
                 kNames[static_cast<std::size_t>(topic)]);
    own.told = own.suppressed;
  }
  std::fprintf(out_, "<%d>%s\n", static_cast<int>(priority), text);
  std::fflush(out_);
}

void Log::print(std::int64_t now_us, Priority priority, const char* format, ...) {
  hal::Message text;
  std::va_list arguments;
  va_start(arguments, format);
  text.print(format, arguments);
  va_end(arguments);
  write(now_us, priority, text.c_str());
}

std::uint64_t Log::suppressed() const {
  std::uint64_t lines = 0;
  for (const Budget& budget : budgets_) lines += budget.suppressed;
  return lines;
}

}  // namespace firmware
