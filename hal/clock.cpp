#include "hal/clock.hpp"

#include <ctime>

namespace hal {
namespace {

std::int64_t read_us(clockid_t id) {
  timespec now{};
  clock_gettime(id, &now);
  return std::int64_t{now.tv_sec} * 1'000'000 + now.tv_nsec / 1000;
}

}  // namespace

std::int64_t SystemClock::monotonic_us() const {
  return read_us(CLOCK_MONOTONIC);
}
std::int64_t SystemClock::realtime_us() const {
  return read_us(CLOCK_REALTIME);
}

}  // namespace hal
