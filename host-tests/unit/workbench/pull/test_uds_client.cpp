#include <gtest/gtest.h>

#include "support/uds/bus.hpp"
#include "workbench/pull/uds_client.hpp"

namespace workbench {
namespace {

using Bytes = std::vector<std::uint8_t>;
using support::UdsBus;

wire::CanFrame answer_of(Bytes data) {
  wire::CanFrame frame;
  frame.id = 0x7E8;
  frame.dlc = 8;
  std::copy(data.begin(), data.end(), frame.data.begin());
  return frame;
}

std::string complaint(UdsClient& client, const Bytes& request, int tries = 1) {
  try {
    (void)client.ask(request, tries);
  } catch (const DeviceError& error) {
    return error.what();
  }
  return "";
}

TEST(UdsClient, ShortAndLongAnswers) {
  for (const bool extended : {false, true}) {
    const wire::IsoTpSettings link =
        extended ? wire::normal_fixed_settings() : wire::IsoTpSettings{};
    UdsBus bus(link);
    UdsClient client(bus, link);
    EXPECT_EQ(client.ask(Bytes{0x3E, 0x00}), (Bytes{0x7E, 0x00}));
    EXPECT_EQ(client.ask(Bytes{0x22, 0xFD, 0x01}).size(), 3 + 4 * 31U);
    EXPECT_EQ(client.ask(Bytes{0x22, 0xFD, 0x10, 0xFD, 0x11, 0xF1, 0x86, 0xF1, 0x95})[0],
              0x62)
        << "a request of two frames";
  }
}

TEST(UdsClient, RefusalsNameTheReason) {
  UdsBus bus;
  UdsClient client(bus, {});
  EXPECT_NE(complaint(client, {0x22, 0x12, 0x34}).find("NRC 31"), std::string::npos);
  EXPECT_NE(complaint(client, {0x85, 0x01}).find("does not offer"), std::string::npos);
}

TEST(UdsClient, SilenceIsSaidToBe) {
  UdsBus bus;
  bus.connected = false;
  UdsClient client(bus, {});
  EXPECT_NE(complaint(client, {0x3E, 0x00}).find("within 1 s"), std::string::npos);
  EXPECT_EQ(bus.sent, 1);
  EXPECT_NE(complaint(client, {0x3E, 0x00}, 3).find("found none"), std::string::npos);
  EXPECT_EQ(bus.sent, 4) << "as often as allowed";
}

TEST(UdsClient, LostAnswerIsAskedForAgain) {
  UdsBus bus;
  int frames = 0;
  bus.change = [&](wire::CanFrame&) { return frames++ != 0; };
  UdsClient client(bus, {});
  EXPECT_EQ(client.ask(Bytes{0x3E, 0x00}, 2), (Bytes{0x7E, 0x00}));
}

TEST(UdsClient, WaitsWhileTheGatewayIsBusyOrAsksForTime) {
  UdsBus bus;
  UdsClient client(bus, {});
  bus.waiting = {answer_of({0x03, 0x7F, 0x3E, 0x21}),
                 answer_of({0x03, 0x7F, 0x3E, 0x78})};
  EXPECT_EQ(client.ask(Bytes{0x3E, 0x00}), (Bytes{0x7E, 0x00}));
  EXPECT_EQ(bus.sent, 2);
  bus.change = [](wire::CanFrame& frame) {
    frame = answer_of({0x03, 0x7F, 0x3E, 0x21});
    return true;
  };
  EXPECT_NE(complaint(client, {0x3E, 0x00}).find("another tester"), std::string::npos);
  bus.connected = false;
  bus.waiting = {answer_of({0x03, 0x7F, 0x3E, 0x78})};
  const std::int64_t start = bus.now;
  EXPECT_NE(complaint(client, {0x3E, 0x00}).find("within 5 s"), std::string::npos);
  EXPECT_GE(bus.now - start, UdsClient::kPending_us);
}

TEST(UdsClient, AnswersToOthersAreIgnored) {
  UdsBus bus;
  bus.waiting = {answer_of({0x02, 0x50, 0x03}), answer_of({0x03, 0x7F, 0x22, 0x31})};
  UdsClient client(bus, {});
  EXPECT_EQ(client.ask(Bytes{0x3E, 0x00}), (Bytes{0x7E, 0x00}));
}

}  // namespace
}  // namespace workbench
