#include "hal/modbus_connection.hpp"

namespace hal {

struct ModbusConnection::Handle {};

ModbusConnection::ModbusConnection(const ModbusAddress& /*address*/) {}
ModbusConnection::~ModbusConnection() = default;

bool ModbusConnection::read(const ModbusRegister& /*from*/, std::uint16_t (&)[2],
                            Message& error) {
  error.set(
      "this program was built without libmodbus; install libmodbus-dev, build anew");
  return false;
}

}  // namespace hal
