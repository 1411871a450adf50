// Registers of a Modbus server, TCP or RTU (libmodbus).
//
//   auto link = std::make_shared<ModbusLink>(ModbusAddress{.host = "10.0.0.5"});
//   ModbusInput flow(link, {.unit = 1, .address = 100}, 250'000);
//   flow.open(); flow.read(value);
//
// A link polls the registers of all its inputs by a thread of its own, one connection for
// all of them, so that a slow server holds up nobody else: open() and read() only look at
// what came. Between two polls read() gives the newest value; one that is older than
// three periods and a second is none. A server that is away is tried again every second.
//
// Built without libmodbus, open() says so.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "hal/analog_input.hpp"
#include "hal/message.hpp"

namespace hal {

/// Where the server is: a host, or a serial line.
struct ModbusAddress {
  std::string host;          ///< IPv4 address; empty: RTU
  std::uint16_t port = 502;  ///< TCP
  std::string device;        ///< RTU, e.g. /dev/ttyUSB0; 8 data bits
  int baud = 9600;
  char parity = 'E';  ///< N, E or O; N has two stop bits, the others one

  friend bool operator==(const ModbusAddress&, const ModbusAddress&) = default;
};

enum class ModbusTable : std::uint8_t { kHolding, kInput };
enum class ModbusType : std::uint8_t { kU16, kI16, kU32, kI32, kF32 };

struct ModbusRegister {
  int unit = 1;  ///< 0 … 247
  ModbusTable table = ModbusTable::kHolding;
  std::uint16_t address = 0;  ///< as in the telegram: register 40001 is 0
  ModbusType type = ModbusType::kU16;
  bool low_word_first = false;  ///< of 32 bits
};

/// One register, or two, as a number.
[[nodiscard]] double modbus_number(const ModbusRegister& from, std::uint16_t first,
                                   std::uint16_t second);

class ModbusLink {
 public:
  explicit ModbusLink(ModbusAddress address);

  [[nodiscard]] const ModbusAddress& address() const { return address_; }

 private:
  friend class ModbusInput;
  struct Item {
    ModbusRegister from;
    std::int64_t period_us = 0;
    std::int64_t due_us = 0;
    std::int64_t value_us = -1;  // when it came; −1: never
    double value = 0;
  };
  struct Connection;

  std::size_t add(const ModbusRegister& from, std::int64_t period_us);
  void start();
  /// False: there is no value that is new enough; `why` says what went wrong.
  [[nodiscard]] bool newest(std::size_t item, double& value, Message& why);
  /// The first time, waits for the first answer, a second at most.
  void await_first();
  void work(const std::stop_token& stop);
  void poll(Connection& connection, Item& item, std::int64_t now_us);

  ModbusAddress address_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::vector<Item> items_;
  Message error_;
  bool tried_ = false;   // every item, once
  std::jthread thread_;  // last: it uses the others
};

class ModbusInput final : public AnalogInput {
 public:
  /// Polled every `period_us`.
  ModbusInput(std::shared_ptr<ModbusLink> link, const ModbusRegister& from,
              std::int64_t period_us);

  void start() override { link_->start(); }
  [[nodiscard]] bool open() override;
  /// The number in the register, without unit.
  [[nodiscard]] bool read(double& value) override;
  [[nodiscard]] const char* error() const override { return error_.c_str(); }

 private:
  std::shared_ptr<ModbusLink> link_;
  std::size_t item_;
  Message error_;
};

}  // namespace hal
