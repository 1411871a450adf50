// A connection to a Modbus server: the part of hal/modbus.hpp that needs libmodbus. One
// thread; read() blocks for the server, a second at most where it answers nothing.
#pragma once

#include <memory>

#include "hal/modbus.hpp"

namespace hal {

class ModbusConnection {
 public:
  explicit ModbusConnection(const ModbusAddress& address);
  ~ModbusConnection();

  /// Reads the register, of 32 bits both; connects first where there is no connection.
  [[nodiscard]] bool read(const ModbusRegister& from, std::uint16_t (&words)[2],
                          Message& error);

 private:
  struct Handle;
  std::unique_ptr<Handle> handle_;
};

}  // namespace hal
