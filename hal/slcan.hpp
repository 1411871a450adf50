// The Lawicel ASCII protocol ("slcan") on a TCP socket that listens on 127.0.0.1: a bus
// for tests and the lab, where third-party clients connect without a kernel driver.
//
// Every client sees the frames sent here and those of the other clients, as on a bus.
// Understood from a client: t T r R (frames), O L C S s V v N F Z (answered, no effect).
// A line that cannot be a command is answered with BEL. A client that does not read
// loses frames; one more than kClients is closed.
#pragma once

#include <array>

#include "hal/can_bus.hpp"
#include "hal/clock.hpp"
#include "hal/descriptor.hpp"
#include "hal/message.hpp"

namespace hal {

/// Longest line write_slcan() writes, with its carriage return.
inline constexpr std::size_t kMaxSlcanLine = 27;

/// A frame as slcan line, e.g. "t1232AABB\r"; characters written, 0 for error
/// frames and CAN FD, which slcan does not have.
[[nodiscard]] std::size_t write_slcan(const wire::CanFrame& frame,
                                      std::span<char, kMaxSlcanLine> out);
/// Reads a line without its carriage return; false when it is not a frame.
[[nodiscard]] bool parse_slcan(std::span<const char> line, wire::CanFrame& out);

class SlcanServer final : public CanBus {
 public:
  static constexpr std::size_t kClients = 4;
  /// Port 0 takes any free one.
  SlcanServer(std::uint16_t port, const Clock& clock) : clock_(clock), port_(port) {}

  [[nodiscard]] bool open() override;
  [[nodiscard]] CanStatus read(std::span<ReceivedFrame> out, std::size_t& count) override;
  [[nodiscard]] CanStatus write(const wire::CanFrame& frame) override;
  [[nodiscard]] int descriptor() const override { return events_.get(); }
  [[nodiscard]] std::uint64_t drops() const override { return drops_; }
  [[nodiscard]] const char* error() const override { return error_.c_str(); }
  /// The port that is listened on, once open.
  [[nodiscard]] std::uint16_t port() const { return port_; }

 private:
  struct Client {
    Descriptor socket;
    std::array<char, 64> line;
    std::size_t length = 0;
    bool overlong = false;
    /// Answers to what was read in one go: sent together.
    std::array<char, 256> answers{};
    std::size_t answered = 0;
  };
  /// Where frames read go to.
  struct Sink {
    std::span<ReceivedFrame> out;
    std::size_t count = 0;
  };

  bool fail(const char* what);
  void accept_client();
  void receive(Client& client, Sink& sink);
  void take_line(Client& client, Sink& sink);
  void send(Client& client, std::span<const char> text);
  void answer(Client& client, std::span<const char> text);
  void send_answers(Client& client);

  const Clock& clock_;
  std::uint16_t port_;
  Descriptor listener_;
  Descriptor events_;
  std::array<Client, kClients> clients_;
  std::uint64_t drops_ = 0;
  Message error_;
};

}  // namespace hal
