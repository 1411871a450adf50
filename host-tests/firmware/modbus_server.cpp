#include "firmware/modbus_server.hpp"

#ifdef STICKBAND_MODBUS

#include <fcntl.h>
#include <modbus/modbus.h>
#include <netinet/in.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <vector>

namespace firmware {
namespace {

constexpr int kRegisters = 200;
constexpr int kTurn_ms = 20;

// The end of a pseudo terminal that stays with us; `name` is the other one.
int open_terminal(std::string& name) {
  const int master = posix_openpt(O_RDWR | O_NOCTTY);
  if (master < 0 || grantpt(master) != 0 || unlockpt(master) != 0) return -1;
  name = ptsname(master);
  termios raw{};
  tcgetattr(master, &raw);
  cfmakeraw(&raw);
  tcsetattr(master, TCSANOW, &raw);
  return master;
}

void copy(int from, int to) {
  std::array<char, 256> bytes;
  const ssize_t count = read(from, bytes.data(), bytes.size());
  if (count > 0) (void)!write(to, bytes.data(), static_cast<std::size_t>(count));
}

}  // namespace

struct ModbusServer::Handles {
  modbus_t* context = nullptr;
  modbus_mapping_t* registers = modbus_mapping_new(0, 0, kRegisters, kRegisters);
  int listener = -1;
  int ours = -1;  // ends of two terminals
  int theirs = -1;
  ~Handles() {
    for (const int file : {listener, ours, theirs}) {
      if (file >= 0) close(file);
    }
    modbus_mapping_free(registers);
    if (context) modbus_free(context);
  }
};

ModbusServer::ModbusServer(std::uint16_t port) : handles_(std::make_unique<Handles>()) {
  Handles& h = *handles_;
  h.context = modbus_new_tcp("127.0.0.1", port);
  h.listener = h.context ? modbus_tcp_listen(h.context, 4) : -1;
  if (h.listener < 0) return;
  sockaddr_in address{};
  socklen_t size = sizeof address;
  getsockname(h.listener, reinterpret_cast<sockaddr*>(&address), &size);
  port_ = ntohs(address.sin_port);
  ready_ = true;
  thread_ = std::thread([this] { serve(); });
}

ModbusServer::ModbusServer(Line /*line*/) : handles_(std::make_unique<Handles>()) {
  Handles& h = *handles_;
  std::string own;
  h.ours = open_terminal(own);
  h.theirs = open_terminal(device_);
  if (h.ours < 0 || h.theirs < 0) return;
  h.context = modbus_new_rtu(own.c_str(), 115'200, 'N', 8, 1);
  if (!h.context) return;
  modbus_set_slave(h.context, 1);
  modbus_set_indication_timeout(h.context, 0, 100'000);
  if (modbus_connect(h.context) != 0) return;
  ready_ = true;
  thread_ = std::thread([this] { serve_serial(); });
  relay_ = std::thread([this] {
    while (!ended_) {
      std::array<pollfd, 2> ends = {
          {{handles_->ours, POLLIN, 0}, {handles_->theirs, POLLIN, 0}}};
      if (poll(ends.data(), ends.size(), kTurn_ms) <= 0) continue;
      if (ends[0].revents & POLLIN) copy(handles_->ours, handles_->theirs);
      if (ends[1].revents & POLLIN) copy(handles_->theirs, handles_->ours);
      if ((ends[0].revents | ends[1].revents) & POLLHUP) usleep(kTurn_ms * 1000);
    }
  });
}

ModbusServer::~ModbusServer() {
  ended_ = true;
  if (thread_.joinable()) thread_.join();
  if (relay_.joinable()) relay_.join();
}

void ModbusServer::holding(int address, std::uint16_t value) {
  handles_->registers->tab_registers[address] = value;
}

void ModbusServer::input(int address, std::uint16_t value) {
  handles_->registers->tab_input_registers[address] = value;
}

void ModbusServer::serve() {
  std::vector<pollfd> waiting = {{handles_->listener, POLLIN, 0}};
  std::array<std::uint8_t, MODBUS_TCP_MAX_ADU_LENGTH> request;
  while (!ended_) {
    if (poll(waiting.data(), waiting.size(), kTurn_ms) <= 0) continue;
    if (waiting[0].revents) {
      const int client = accept(handles_->listener, nullptr, nullptr);
      if (client >= 0) waiting.push_back({client, POLLIN, 0});
    }
    for (std::size_t k = 1; k < waiting.size(); ++k) {
      if (!waiting[k].revents) continue;
      modbus_set_socket(handles_->context, waiting[k].fd);
      const int size = modbus_receive(handles_->context, request.data());
      if (size > 0) {
        modbus_reply(handles_->context, request.data(), size, handles_->registers);
      } else {
        close(waiting[k].fd);
        waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(k--));
      }
    }
  }
  for (std::size_t k = 1; k < waiting.size(); ++k) close(waiting[k].fd);
}

void ModbusServer::serve_serial() {
  std::array<std::uint8_t, MODBUS_RTU_MAX_ADU_LENGTH> request;
  while (!ended_) {
    const int size = modbus_receive(handles_->context, request.data());
    if (size > 0) {
      modbus_reply(handles_->context, request.data(), size, handles_->registers);
    }
  }
  modbus_close(handles_->context);
}

}  // namespace firmware

#else

namespace firmware {

struct ModbusServer::Handles {};
ModbusServer::ModbusServer(std::uint16_t) {}
ModbusServer::ModbusServer(Line) {}
ModbusServer::~ModbusServer() = default;
void ModbusServer::holding(int, std::uint16_t) {}
void ModbusServer::input(int, std::uint16_t) {}

}  // namespace firmware

#endif
