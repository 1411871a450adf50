#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include <memory>
#include <string>

#include "hal/slcan.hpp"

namespace hal {
namespace {

class Client {
 public:
  explicit Client(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port);
    EXPECT_EQ(
        connect(socket_.get(), reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  }
  void send(const std::string& text) const {
    EXPECT_EQ(::send(socket_.get(), text.data(), text.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(text.size()));
  }
  [[nodiscard]] std::string receive() const {
    pollfd waiting{socket_.get(), POLLIN, 0};
    if (poll(&waiting, 1, 2000) <= 0) return {};
    char bytes[512];
    const ssize_t count = recv(socket_.get(), bytes, sizeof bytes, 0);
    return {bytes, count > 0 ? static_cast<std::size_t>(count) : 0};
  }

 private:
  Descriptor socket_;
};

class Slcan : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(bus.open()) << bus.error(); }
  // Waits for something to read, then reads until nothing is left.
  std::vector<ReceivedFrame> read() {
    std::vector<ReceivedFrame> all;
    std::array<ReceivedFrame, 4> some;
    std::size_t count = 0;
    pollfd waiting{bus.descriptor(), POLLIN, 0};
    for (int wait_ms = 2000; poll(&waiting, 1, wait_ms) > 0; wait_ms = 50) {
      EXPECT_NE(bus.read(some, count), CanStatus::kLost);
      all.insert(all.end(), some.begin(), some.begin() + static_cast<long>(count));
    }
    return all;
  }
  FakeClock clock;
  SlcanServer bus{0, clock};
};

TEST(SlcanLine, RoundTripsEveryKindOfFrame) {
  for (const wire::CanFrame& frame :
       {wire::CanFrame{.id = 0x7FF, .dlc = 2, .data = {0xAB, 0x01}},
        wire::CanFrame{.id = 0x18DAF110,
        .extended = true,
        .dlc = 8,
        .data = {1, 2, 3, 4, 5, 6, 7, 0xFF}},
        wire::CanFrame{.id = 1, .remote = true, .dlc = 4}, wire::CanFrame{}}) {
    std::array<char, kMaxSlcanLine> text;
    const std::size_t length = write_slcan(frame, text);
    ASSERT_GT(length, 1U);
    EXPECT_EQ(text[length - 1], '\r');
    wire::CanFrame back;
    ASSERT_TRUE(parse_slcan(std::span(text).first(length - 1), back));
    EXPECT_EQ(back, frame);
  }
}

TEST(SlcanLine, RefusesWhatIsNoFrame) {
  wire::CanFrame out;
  for (const std::string text :
       {"", "t", "t12", "t123", "t1239", "t8000", "t1231A", "x1230", "T123456781",
        "T200000000", "t12g0", "t1231AAB"}) {
    EXPECT_FALSE(parse_slcan(text, out)) << text;
  }
  EXPECT_TRUE(parse_slcan(std::string_view("t1231AA1234"), out)) << "with a time stamp";
}

TEST_F(Slcan, AClientsFramesComeInAndOursGoOut) {
  const Client client(bus.port());
  client.send("C\rS8\rO\rt7E02");
  client.send("3E00\rT18DA10F10\r");
  const std::vector<ReceivedFrame> frames = read();
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].frame.id, 0x7E0U);
  EXPECT_EQ(frames[0].frame.data[0], 0x3E);
  EXPECT_EQ(frames[0].time_us, clock.realtime_us());
  EXPECT_TRUE(frames[1].frame.extended);
  EXPECT_EQ(client.receive(), "\r\r\rz\rZ\r");
  ASSERT_EQ(bus.write({.id = 0x7E8, .dlc = 1, .data = {0x7E}}), CanStatus::kOk);
  EXPECT_EQ(client.receive(), "t7E817E\r");
}

TEST_F(Slcan, ClientsSeeEachOtherAsOnABus) {
  const Client first(bus.port());
  const Client second(bus.port());
  first.send("O\r");
  second.send("O\r");
  EXPECT_TRUE(read().empty());
  EXPECT_EQ(first.receive(), "\r");
  EXPECT_EQ(second.receive(), "\r");
  first.send("t1230\r");
  EXPECT_EQ(read().size(), 1U);
  EXPECT_EQ(second.receive(), "t1230\r");
}

TEST_F(Slcan, NonsenseIsRefusedAndAClientThatLeavesIsForgotten) {
  {
    const Client client(bus.port());
    client.send(std::string(500, 'x') + "\rq\r");
    EXPECT_TRUE(read().empty());
    EXPECT_EQ(client.receive(), "\a\a");
  }
  for (std::size_t k = 0; k < 3 * SlcanServer::kClients; ++k) {
    const Client client(bus.port());
    client.send("t1230\r");
    EXPECT_EQ(read().size(), 1U) << k;
  }
}

TEST_F(Slcan, OneClientTooManyIsClosedAndWakesNobody) {
  std::vector<std::unique_ptr<Client>> clients;
  for (std::size_t k = 0; k < SlcanServer::kClients + 3; ++k) {
    clients.push_back(std::make_unique<Client>(bus.port()));
    EXPECT_TRUE(read().empty());
  }
  pollfd waiting{bus.descriptor(), POLLIN, 0};
  EXPECT_EQ(poll(&waiting, 1, 50), 0) << "nothing to do";
  clients[0]->send("t1230\r");
  EXPECT_EQ(read().size(), 1U);
}

TEST_F(Slcan, APortThatIsTakenCannotBeOpened) {
  SlcanServer other(bus.port(), clock);
  EXPECT_FALSE(other.open());
  EXPECT_NE(std::string(other.error()).find("port"), std::string::npos);
}

}  // namespace
}  // namespace hal
