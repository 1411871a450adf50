// watch_valve INTERFACE DBC U Y PERIOD_S, e.g. watch_valve can0 plant.dbc OP.OP PV.PV 1.0
// Watches one loop on a CAN bus and says whether its valve sticks.
#include <linux/can.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>

#include "ident/monitor.hpp"
#include "wire/dbc.hpp"

using namespace std::chrono_literals;

int main(int argc, char** argv) {
  if (argc != 6) return std::cerr << "usage: watch_valve INTERFACE DBC U Y PERIOD_S\n", 2;
  std::ifstream file(argv[2]);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  std::array<wire::DbcMessage, 256> messages;
  std::array<wire::DbcSignal, 2048> signals;
  wire::Dbc dbc(messages, signals);
  wire::FrameSignal u_signal, y_signal;
  if (!file) return std::cerr << argv[2] << ": expected a DBC file, cannot read it\n", 3;
  wire::DbcStatus status = dbc.parse(text);
  if (status.ok()) status = dbc.find(argv[3], u_signal);
  if (status.ok()) status = dbc.find(argv[4], y_signal);
  if (!status.ok()) {
    return std::cerr << argv[2] << ':' << status.line << ": expected "
                     << expected_at(status.error) << ", found '" << status.found << "'\n",
           3;
  }
  const int bus = socket(PF_CAN, SOCK_RAW, CAN_RAW);
  sockaddr_can address{AF_CAN, static_cast<int>(if_nametoindex(argv[1])), {}};
  if (bind(bus, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) {
    return std::cerr << argv[1] << ": " << std::strerror(errno) << '\n', 1;
  }
  static ident::Monitor<float, ident::kStandardWindow> monitor(
      {.sample_period_us = static_cast<std::int64_t>(std::atof(argv[5]) * 1e6)});
  double u = NAN, y = NAN;
  for (can_frame raw; read(bus, &raw, sizeof raw) == sizeof raw;) {
    wire::CanFrame frame{raw.can_id & CAN_EFF_MASK, (raw.can_id & CAN_EFF_FLAG) != 0};
    frame.remote = (raw.can_id & CAN_RTR_FLAG) != 0;  // asks for a value, has none
    frame.dlc = raw.len;
    std::memcpy(frame.data.data(), raw.data, raw.len);
    (void)extract(u_signal, frame, u);
    if (extract(y_signal, frame, y) != wire::SignalError::kNone) continue;
    const auto now = std::chrono::steady_clock::now().time_since_epoch() / 1us;
    monitor.push({now, static_cast<float>(u), static_cast<float>(y)});
    monitor.step(100'000);  // all of it: fractions of a second
    while (const auto event = monitor.poll()) {
      const auto& band = event->stick_band.ascending;
      std::cout << name(event->kind);
      if (event->reason != ident::Reason::kNone) {
        std::cout << ": " << sentence(event->reason);
      }
      if (band.known) std::cout << " Band " << band.low << " to " << band.high;
      std::cout << std::endl;
    }
  }
}
