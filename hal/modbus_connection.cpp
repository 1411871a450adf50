#include "hal/modbus_connection.hpp"

#include <modbus/modbus.h>

#include <cerrno>
#include <cstring>
#include <string>

namespace hal {
namespace {

constexpr std::uint32_t kTimeout_us = 500'000;

std::string name_of(const ModbusAddress& address) {
  return address.host.empty() ? address.device
                              : address.host + ':' + std::to_string(address.port);
}

modbus_t* make(const ModbusAddress& address) {
  if (!address.host.empty()) return modbus_new_tcp(address.host.c_str(), address.port);
  return modbus_new_rtu(address.device.c_str(), address.baud, address.parity, 8,
                        address.parity == 'N' ? 2 : 1);
}

}  // namespace

struct ModbusConnection::Handle {
  explicit Handle(const ModbusAddress& address)
      : context(make(address)), name(name_of(address)), tcp(!address.host.empty()) {
    if (context) modbus_set_response_timeout(context, 0, kTimeout_us);
  }
  ~Handle() {
    close();
    modbus_free(context);
  }
  void close() {
    if (connected) modbus_close(context);
    connected = false;
  }
  bool fail(Message& error, const char* what) {
    const char* const cure = refused() ? "unit and register"
                             : tcp     ? "host, port, and that the server runs"
                                       : "device, baud rate, parity and wiring";
    error.set("%s: %s: %s; check %s", name.c_str(), what, modbus_strerror(errno), cure);
    return false;
  }
  // The server answered that it will not; the connection stands.
  [[nodiscard]] static bool refused() { return errno >= EMBXILFUN && errno <= EMBXGTAR; }

  modbus_t* context;
  std::string name;
  bool tcp;
  bool connected = false;
};

ModbusConnection::ModbusConnection(const ModbusAddress& address)
    : handle_(std::make_unique<Handle>(address)) {}
ModbusConnection::~ModbusConnection() = default;

bool ModbusConnection::read(const ModbusRegister& from, std::uint16_t (&words)[2],
                            Message& error) {
  Handle& h = *handle_;
  if (h.context == nullptr) return h.fail(error, "no such server");
  if (!h.connected) {
    h.connected = modbus_connect(h.context) == 0;
    if (!h.connected) return h.fail(error, "cannot connect");
    if (h.tcp) (void)modbus_flush(h.context);
  }
  const int count =
      from.type == ModbusType::kU16 || from.type == ModbusType::kI16 ? 1 : 2;
  (void)modbus_set_slave(h.context, from.unit);
  const int got =
      from.table == ModbusTable::kHolding
          ? modbus_read_registers(h.context, from.address, count, words)
          : modbus_read_input_registers(h.context, from.address, count, words);
  if (got == count) return true;
  (void)h.fail(error, "no answer");
  if (!Handle::refused()) h.close();
  return false;
}

}  // namespace hal
