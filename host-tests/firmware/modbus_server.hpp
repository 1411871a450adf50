// A Modbus server of libmodbus in a thread, on 127.0.0.1 or on a pseudo terminal.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>

namespace firmware {

class ModbusServer {
 public:
  enum class Line : std::uint8_t { kTcp, kSerial };

  /// `port` 0: any free one.
  explicit ModbusServer(std::uint16_t port = 0);
  explicit ModbusServer(Line line);
  ~ModbusServer();

  /// False: it cannot be had here.
  [[nodiscard]] bool ready() const { return ready_; }
  [[nodiscard]] std::uint16_t port() const { return port_; }
  /// The end of the line for the client.
  [[nodiscard]] const std::string& device() const { return device_; }
  void holding(int address, std::uint16_t value);
  void input(int address, std::uint16_t value);

 private:
  struct Handles;
  void serve();
  void serve_serial();

  std::unique_ptr<Handles> handles_;
  std::uint16_t port_ = 0;
  std::string device_;
  bool ready_ = false;
  std::atomic<bool> ended_ = false;
  std::thread thread_;
  std::thread relay_;
};

}  // namespace firmware
