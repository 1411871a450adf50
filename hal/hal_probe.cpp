// Pokes the hardware from a shell, one capability at a time.
#include <poll.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "hal/clock.hpp"
#include "hal/gpio_line.hpp"
#include "hal/slcan.hpp"
#include "hal/socketcan.hpp"
#include "hal/sysfs_adc.hpp"
#include "wire/candump.hpp"
#include "wire/text.hpp"

namespace {

constexpr const char* kUsage =
    "usage: hal_probe can IF ID[,ID...] [SECONDS]   print the frames that arrive\n"
    "       hal_probe can-send IF 123#0011          send one frame\n"
    "       hal_probe slcan PORT [SECONDS]          listen as slcan bus, print the "
    "frames\n"
    "       hal_probe gpio CHIP LINE 0|1 [SECONDS]  drive a line for that long\n"
    "       hal_probe iio|hwmon NAME CHANNEL [ROOT] print a value (mV or mA)\n"
    "Identifiers in hex; more than three digits are an extended one. SECONDS: 10.\n";

constexpr int kFailed = 1;
constexpr int kWrongUsage = 2;

int complain(const char* error) {
  std::fprintf(stderr, "hal_probe: %s\n", error);
  return kFailed;
}

template <class T>
bool parse(std::string_view text, T& value, int base = 10) {
  const std::optional<T> number = wire::number_of<T>(text, base);
  value = number.value_or(value);
  return number.has_value();
}

int print_frames(hal::CanBus& bus, const char* name, int seconds) {
  if (!bus.open()) return complain(bus.error());
  const hal::SystemClock clock;
  const std::int64_t end_us = clock.monotonic_us() + std::int64_t{seconds} * 1'000'000;
  std::vector<hal::ReceivedFrame> frames(64);
  while (clock.monotonic_us() < end_us) {
    pollfd waiting{bus.descriptor(), POLLIN, 0};
    poll(&waiting, 1, 100);
    std::size_t count = 0;
    const hal::CanStatus status = bus.read(frames, count);
    for (std::size_t k = 0; k < count; ++k) {
      char text[wire::kMaxCandumpLine];
      const std::size_t length =
          wire::format_candump({frames[k].time_us * 1000, name, frames[k].frame}, text);
      std::printf("%.*s\n", static_cast<int>(length), text);
    }
    std::fflush(stdout);
    if (status == hal::CanStatus::kDown || status == hal::CanStatus::kLost) {
      return complain(bus.error());
    }
  }
  std::fprintf(stderr, "%llu dropped\n", static_cast<unsigned long long>(bus.drops()));
  return 0;
}

int send_frame(const char* interface, const std::string& text) {
  wire::CandumpLine line;
  const std::string whole = "(0.0) " + std::string(interface) + ' ' + text;
  if (!wire::parse_candump(whole, line).ok()) return kWrongUsage;
  hal::SocketCan bus(interface, {});
  if (!bus.open()) return complain(bus.error());
  return bus.write(line.frame) == hal::CanStatus::kOk ? 0 : complain(bus.error());
}

int drive(const char* chip, unsigned line, bool active, int seconds) {
  hal::GpioLine output(chip, line, false);
  if (!output.open(active)) return complain(output.error());
  std::printf("%s: %s line %u is %s\n", hal::GpioLine::library(), chip, line,
              active ? "active" : "inactive");
  std::fflush(stdout);
  poll(nullptr, 0, seconds * 1000);
  return 0;
}

int print_value(hal::SysfsAdc input) {
  double value = 0;
  if (!input.open() || !input.read(value)) return complain(input.error());
  std::printf("%.6g\n", value);
  return 0;
}

bool parse_filters(std::string_view list, std::vector<hal::CanFilter>& filters) {
  while (!list.empty()) {
    const std::string_view id = list.substr(0, list.find(','));
    hal::CanFilter filter{.extended = id.size() > 3};
    if (!parse(id, filter.id, 16)) return false;
    filters.push_back(filter);
    list.remove_prefix(std::min(list.size(), id.size() + 1));
  }
  return true;
}

int run(const std::vector<const char*>& words) {
  const std::string_view command = words.empty() ? "" : words[0];
  const std::size_t count = words.size();
  int seconds = 10;
  if (command == "can" && (count == 3 || (count == 4 && parse(words[3], seconds)))) {
    std::vector<hal::CanFilter> filters;
    if (!parse_filters(words[2], filters)) return kWrongUsage;
    hal::SocketCan bus(words[1], filters);
    return print_frames(bus, words[1], seconds);
  }
  if (command == "can-send" && count == 3) return send_frame(words[1], words[2]);
  std::uint16_t port = 0;
  if (command == "slcan" && (count == 2 || (count == 3 && parse(words[2], seconds))) &&
      parse(words[1], port)) {
    const hal::SystemClock clock;
    hal::SlcanServer bus(port, clock);
    return print_frames(bus, "slcan0", seconds);
  }
  unsigned line = 0;
  int level = 0;
  if (command == "gpio" && (count == 4 || (count == 5 && parse(words[4], seconds))) &&
      parse(words[2], line) && parse(words[3], level)) {
    return drive(words[1], line, level != 0, seconds);
  }
  if ((command == "iio" || command == "hwmon") && (count == 3 || count == 4)) {
    return print_value({command == "iio" ? hal::AdcKind::kIio : hal::AdcKind::kHwmon,
                        count == 4 ? words[3] : "/sys", words[1], words[2]});
  }
  return kWrongUsage;
}

}  // namespace

int main(int argc, char** argv) {
  const int code = run({argv + 1, argv + argc});
  if (code == kWrongUsage) std::fputs(kUsage, stderr);
  return code;
}
