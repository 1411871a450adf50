#include "hal/modbus.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <utility>

#include "hal/clock.hpp"
#include "hal/modbus_connection.hpp"

namespace hal {
namespace {

constexpr std::int64_t kRetry_us = 1'000'000;

std::int64_t now_us() {
  return SystemClock().monotonic_us();
}

std::chrono::microseconds duration(std::int64_t us) {
  return std::chrono::microseconds(us);
}

}  // namespace

double modbus_number(const ModbusRegister& from, std::uint16_t first,
                     std::uint16_t second) {
  const std::uint32_t high = from.low_word_first ? second : first;
  const std::uint32_t low = from.low_word_first ? first : second;
  const std::uint32_t both = high << 16 | low;
  switch (from.type) {
    case ModbusType::kU16:
      return first;
    case ModbusType::kI16:
      return static_cast<std::int16_t>(first);
    case ModbusType::kU32:
      return both;
    case ModbusType::kI32:
      return static_cast<std::int32_t>(both);
    case ModbusType::kF32:
      return static_cast<double>(std::bit_cast<float>(both));
  }
  return 0;
}

struct ModbusLink::Connection : ModbusConnection {
  using ModbusConnection::ModbusConnection;
};

ModbusLink::ModbusLink(ModbusAddress address) : address_(std::move(address)) {
  error_.set("not asked yet");
}

std::size_t ModbusLink::add(const ModbusRegister& from, std::int64_t period_us) {
  items_.push_back({from, std::max<std::int64_t>(period_us, 1000)});
  return items_.size() - 1;
}

void ModbusLink::start() {
  if (thread_.joinable()) return;
  thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

void ModbusLink::await_first() {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, duration(kRetry_us), [this] { return tried_; });
}

bool ModbusLink::newest(std::size_t item, double& value, Message& why) {
  const std::lock_guard lock(mutex_);
  const Item& known = items_[item];
  const bool fresh =
      known.value_us >= 0 && now_us() - known.value_us <= 3 * known.period_us + kRetry_us;
  value = known.value;
  if (!fresh) why = error_;
  return fresh;
}

// With the lock, which it gives back while it waits for the server.
void ModbusLink::poll(Connection& connection, Item& item, std::int64_t now_us) {
  const ModbusRegister from = item.from;
  item.due_us = std::max(item.due_us + item.period_us, now_us);
  std::uint16_t words[2] = {};
  Message error;
  mutex_.unlock();
  const bool good = connection.read(from, words, error);
  const std::int64_t came_us = hal::now_us();
  mutex_.lock();
  if (!good) {
    error_ = error;
    item.due_us = came_us + kRetry_us;
    return;
  }
  item.value = modbus_number(from, words[0], words[1]);
  item.value_us = came_us;
}

void ModbusLink::work(const std::stop_token& stop) {
  Connection connection(address_);
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    std::int64_t next_us = now_us() + kRetry_us;
    for (std::size_t k = 0; k < items_.size() && !stop.stop_requested(); ++k) {
      const std::int64_t at_us = now_us();
      if (at_us >= items_[k].due_us) poll(connection, items_[k], at_us);
      next_us = std::min(next_us, items_[k].due_us);
    }
    if (!std::exchange(tried_, true)) changed_.notify_all();
    changed_.wait_for(lock, stop, duration(next_us - now_us()), [] { return false; });
  }
}

ModbusInput::ModbusInput(std::shared_ptr<ModbusLink> link, const ModbusRegister& from,
                         std::int64_t period_us)
    : link_(std::move(link)), item_(link_->add(from, period_us)) {}

bool ModbusInput::open() {
  link_->start();
  link_->await_first();
  double value = 0;
  return read(value);
}

bool ModbusInput::read(double& value) {
  return link_->newest(item_, value, error_);
}

}  // namespace hal
