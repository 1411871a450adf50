#include <gtest/gtest.h>

#include <memory>

#include "firmware/swap_watch.hpp"
#include "support/ident/pi_loop.hpp"

namespace firmware {
namespace {

// A window of a loop under a wandering load; `exchanged`: its columns.
std::unique_ptr<SwapWatch::Window> window_of(bool exchanged, std::size_t samples,
                                             bool with_setpoint = true) {
  const test::LoopRecord record = test::run({}, samples, 1);
  auto window = std::make_unique<SwapWatch::Window>(1'000'000);
  for (std::size_t t = 0; t < samples; ++t) {
    const auto u = static_cast<float>(record.u[t]);
    const auto y = static_cast<float>(record.y[t]);
    ident::Sample<float> sample{.t_us = static_cast<std::int64_t>(t) * 1'000'000,
                                .u = exchanged ? y : u,
                                .y = exchanged ? u : y};
    sample.sp = 0.3f;
    sample.has_sp = with_setpoint;
    (void)window->push(sample);
  }
  return window;
}

TEST(SwapWatch, FindsSignalsThatWereExchanged) {
  SwapWatch watch;
  for (const bool with_setpoint : {true, false}) {
    EXPECT_TRUE(watch.exchanged(*window_of(true, 600, with_setpoint), 600));
    EXPECT_FALSE(watch.exchanged(*window_of(false, 600, with_setpoint), 600));
  }
}

TEST(SwapWatch, LooksAtNoMoreThanIsUsable) {
  SwapWatch watch;
  EXPECT_FALSE(watch.exchanged(*window_of(true, 600), 0));
  EXPECT_FALSE(watch.exchanged(*window_of(true, 600), 20));
  EXPECT_TRUE(watch.exchanged(*window_of(true, 3000), 5000));
}

}  // namespace
}  // namespace firmware
