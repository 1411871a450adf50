#include <gtest/gtest.h>

#include "firmware/notice_text.hpp"

namespace firmware {
namespace {

config::Gateway one_loop(const std::string& more = "") {
  return config::parse_gateway(
      "[bus.a]\nbackend = \"slcan\"\nport = 0\n[[loop]]\nid = 1\ntag = \"A\"\n"
      "u = { source = \"can\", frame_id = 1, start = 0, length = 16 }\n"
      "y = { source = \"can\", frame_id = 2, start = 0, length = 16 }\n" +
          more,
      "g.toml");
}

TEST(NoticeText, OfTwoSendersNamesBothAndTheKey) {
  const Notice notice{.kind = NoticeKind::kTwoSenders,
                      .event = {},
                      .senders = {.role = Role::kY, .used = 0x21, .other = 0x0A}};
  EXPECT_EQ(text_of(notice, one_loop()).view(),
            "A: y comes from the source addresses 0x21 and 0x0A: only the first is used; "
            "expected one sender, give its source_address");
  EXPECT_EQ(priority_of(notice), Priority::kWarning);
  EXPECT_EQ(topic_of(notice), Topic::kLoops);
  EXPECT_EQ(name_of(notice), "two_senders");
}

TEST(NoticeText, OfExchangedSignalsSaysToExchangeThem) {
  const Notice notice{.kind = NoticeKind::kSignalsSwapped, .event = {}};
  EXPECT_EQ(text_of(notice, one_loop()).view(),
            "A: y moves as a controller moves its output, and u does not: expected the "
            "controller output as u and the process output as y; exchange `u` and `y`");
  EXPECT_EQ(priority_of(notice), Priority::kWarning);
  EXPECT_EQ(topic_of(notice), Topic::kLoops);
  EXPECT_EQ(name_of(notice), "signals_swapped");
}

TEST(NoticeText, OfASlowSignalNamesPeriodAndInterval) {
  const Notice notice{.kind = NoticeKind::kSlowSignal,
                      .event = {},
                      .slow = {.role = Role::kY, .interval_s = 1.0004}};
  const config::Gateway gateway = one_loop("sample_period_s = 0.2\n");
  EXPECT_EQ(
      text_of(notice, gateway).view(),
      "A: sample_period_s is 0.2, but y comes every 1 s: what lies between is held; "
      "expected at least that, correct sample_period_s");
  EXPECT_EQ(priority_of(notice), Priority::kWarning);
  EXPECT_EQ(topic_of(notice), Topic::kLoops);
  EXPECT_EQ(name_of(notice), "slow_signal");
}

TEST(NoticeText, OfAModeListsWhatIsAutomatic) {
  config::Gateway gateway = one_loop();
  EXPECT_EQ(text_of_mode(gateway.loops[0], true, 2).view(),
            "suspended: mode reads 2, automatic is 1");
  gateway.loops[0].auto_values.assign(200, 1234567);
  EXPECT_LT(text_of_mode(gateway.loops[0], false, 1).view().size(), 160U);
}

TEST(NoticeText, OfAFaultByItsSpanIsWhole) {
  config::Gateway gateway = one_loop();
  gateway.loops[0].tag = "0123456789012345678901";
  gateway.loops[0].has_y_span = true;
  const Notice notice{.kind = NoticeKind::kInputFault,
                      .event = {},
                      .input = wire::InputStatus::kOutOfRange,
                      .far = FarSignal{Role::kY, 655.35}};
  EXPECT_TRUE(text_of(notice, gateway).view().ends_with("by `minimum` and `maximum`"));
}

}  // namespace
}  // namespace firmware
