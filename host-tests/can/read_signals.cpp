// read_signals FILE.dbc: for each line `MESSAGE.SIGNAL HEXBYTES` on stdin one line on
// stdout: the physical value, `not selected` (another multiplex value), or `refused`.
// What another reader of DBC files is compared with.
#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "wire/dbc.hpp"

int main(int argc, char** argv) {
  constexpr std::size_t kMost = 20'000;
  if (argc != 2) {
    std::fputs("usage: read_signals FILE.dbc\n", stderr);
    return 2;
  }
  std::ifstream file(argv[1], std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  std::vector<wire::DbcMessage> messages(kMost);
  std::vector<wire::DbcSignal> signals(kMost);
  wire::Dbc dbc(messages, signals);
  const wire::DbcStatus status = dbc.parse(text);
  if (!status.ok()) {
    std::fprintf(stderr, "%s:%u:%u: expected %s\n", argv[1], status.line, status.column,
                 wire::expected_at(status.error));
    return 3;
  }
  std::string reference;
  std::string hex;
  while (std::cin >> reference >> hex) {
    wire::FrameSignal signal;
    wire::CanFrame frame;
    double value = 0;
    wire::SignalError error = wire::SignalError::kLength;
    if (dbc.find(reference, signal).ok() && hex.size() <= 2 * frame.data.size()) {
      frame.id = signal.frame_id;
      frame.extended = signal.extended;
      frame.fd = wire::needs_fd(signal);
      frame.dlc = static_cast<std::uint8_t>(hex.size() / 2);
      for (std::size_t i = 0; i < frame.dlc; ++i) {
        frame.data[i] =
            static_cast<std::uint8_t>(std::stoi(hex.substr(2 * i, 2), nullptr, 16));
      }
      error = wire::extract(signal, frame, value);
    }
    if (error == wire::SignalError::kNone) {
      std::printf("%.17g\n", value);
    } else {
      std::puts(error == wire::SignalError::kNotSelected ? "not selected" : "refused");
    }
  }
  return 0;
}
