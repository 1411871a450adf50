#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <string_view>

#include "firmware/monitored_loop.hpp"
#include "support/gateway/sample_status.hpp"

namespace firmware {
namespace {

// A loop whose windows have said all that there is to say.
class Judged : public testing::Test {
 protected:
  Judged() { status = support::sticking_loop(); }

  config::Gateway gateway = config::parse_gateway(
      "[bus.a]\nbackend = \"slcan\"\nport = 0\n[[loop]]\nid = 1\ntag = "
      "\"FIC-211\"\nu = { source = \"can\", frame_id = 1, start = 0, length = 16 }\n"
      "y = { source = \"can\", frame_id = 2, start = 0, length = 16 }\n",
      "g.toml");

  // Fields that a window fills, as the views show them: all of these objects, and those
  // of the state that no input and no delay makes.
  static bool is_of_window(const wire::LoopField& field) {
    static const std::set<std::string_view> kOthers = {"verdict",
                                                       "ne107",
                                                       "input_status",
                                                       "trend_pct_per_day",
                                                       "trend_low_pct_per_day",
                                                       "trend_high_pct_per_day",
                                                       "days_to_limit"};
    const bool object =
        field.object == 0 || field.object == 3 || field.object == 4 || field.object == 10;
    return object && !kOthers.contains(field.name);
  }

  wire::LoopStatus status;
  std::unique_ptr<SwapWatch> swaps = std::make_unique<SwapWatch>();
  MonitoredLoop loop{gateway.loops[0], status, *swaps};
};

TEST_F(Judged, NewParametersMakeVoidWhatWindowsSaidAndNothingElse) {
  const wire::LoopStatus before = status;
  loop.set_parameters(status.parameters);
  for (const wire::LoopField& field : wire::loop_fields()) {
    if (!field.number) continue;
    ASSERT_TRUE(wire::shown(field, before).has_value()) << field.name;
    if (is_of_window(field)) {
      EXPECT_EQ(wire::shown(field, status).value_or(0), 0) << field.name;
    } else {
      EXPECT_EQ(wire::shown(field, status), wire::shown(field, before)) << field.name;
    }
  }
  EXPECT_EQ(status.window_verdict, wire::LoopVerdict::kNotEvaluated);
  EXPECT_EQ(status.path_knots, 0);
  EXPECT_EQ(status.tag.view(), before.tag.view());
  EXPECT_EQ(status.mapping.view(), before.mapping.view());
  EXPECT_TRUE(status.confirmed && status.flag);
}

TEST_F(Judged, AResetMakesTheTrendVoidToo) {
  loop.reset();
  for (const wire::LoopField& field : wire::loop_fields()) {
    if (field.name.find("trend") == 0 || field.name == "days_to_limit") {
      EXPECT_EQ(wire::shown(field, status), std::nullopt) << field.name;
    }
  }
}

TEST_F(Judged, CountsOfTheInputLeaveThoseOfTheWindowsAlone) {
  (void)loop.refresh({.us = 1'000'000, .epoch_us = 1'700'000'000'000'000});
  EXPECT_EQ(status.counters.frames, 0U);
  EXPECT_EQ(status.counters.refused_fits, 5U);
}

}  // namespace
}  // namespace firmware
