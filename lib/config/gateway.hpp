// The gateway's configuration: a TOML file in, checked values out.
//
// read_gateway() refuses a file that says something unknown, of the wrong type, out of
// range or in contradiction to itself, and names every such place at once; it does not
// look at devices. Every key with unit, range and default: firmware/gateway.toml.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "wire/diagnostics.hpp"
#include "wire/signal.hpp"

namespace config {

/// A configuration that cannot be used. what(): one line for each place,
/// `file:line: key: expected …, found …; do …`.
class ConfigError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class Backend : std::uint8_t { kSocketCan, kSlcan, kFile };

/// A key of the file, for messages about devices found later.
struct Place {
  int line = 0;
  std::string key;  ///< e.g. "loop[2].flag"
};

struct Bus {
  std::string name;
  Backend backend = Backend::kSocketCan;
  std::string interface;   ///< socketcan; file: only its lines, empty: all
  std::uint16_t port = 0;  ///< slcan, on 127.0.0.1; 0: any
  std::string path;        ///< file
  bool real_time = true;   ///< file: as recorded, not as fast as possible
  Place place;
};

/// The interface by which a log of several buses names it.
[[nodiscard]] inline const std::string& name_in_log(const Bus& bus) {
  return bus.interface.empty() ? bus.name : bus.interface;
}

enum class SourceKind : std::uint8_t { kCan, kIio, kHwmon, kModbus };

/// NAMUR NE43 limits, mA.
struct CurrentLimits {
  double failure_low_ma = 3.6;
  double saturated_low_ma = 3.8;
  double saturated_high_ma = 20.5;
  double failure_high_ma = 21.0;
  double debounce_s = 3.0;
};

enum class RegisterType : std::uint8_t { kU16, kI16, kU32, kI32, kF32 };

/// A register of a Modbus server, or two.
struct Modbus {
  std::string host;  ///< IPv4 address; empty: RTU on `device`
  std::uint16_t port = 502;
  std::string device;
  int baud = 9600;
  char parity = 'E';  ///< N, E, O
  int unit = 1;
  bool input_table = false;  ///< input registers, not holding
  std::uint16_t address = 0;
  RegisterType type = RegisterType::kU16;
  bool low_word_first = false;
};

/// Where a value comes from.
struct Source {
  SourceKind kind = SourceKind::kCan;
  bool readable = false;    ///< the file said it all, and nothing wrong
  std::string description;  ///< for people, e.g. "can0 18E LoopOP.OP"

  std::size_t bus = 0;       ///< index into Gateway::buses
  wire::FrameSignal signal;  ///< kCan
  std::string dbc;           ///< kCan: the file it is named in; empty: laid out inline

  std::string name;     ///< device, as in its file `name`
  std::string channel;  ///< "voltage0", "current1", "in0", "curr1"
  /// iio: mV or mA for each count, and counts; absent: the driver's. modbus: the value of
  /// each count, and of 0.
  std::optional<double> scale;
  std::optional<double> offset;
  unsigned index = 0;                    ///< among devices of that name
  double shunt_ohm = 0;                  ///< > 0: mV / shunt_ohm = mA
  bool is_current = false;               ///< the channel, or the shunt, gives mA; else V
  std::array<double, 2> in = {4, 20};    ///< mA or V …
  std::array<double, 2> out = {0, 100};  ///< … and the value they stand for
  bool ne43 = false;
  CurrentLimits limits;
  Modbus modbus;           ///< kModbus; its `name` and `channel` say it in words
  bool has_range = false;  ///< `minimum` and `maximum` hold
  double minimum = 0;
  double maximum = 0;
  Place place;
};

struct Flag {
  std::string chip;  ///< name, label or path
  unsigned line = 0;
  bool active_low = false;
  bool fail_safe = false;  ///< level while nothing is known, and when the daemon ends
  Place place;
};

struct Loop {
  int id = 1;  ///< 1 … 31
  std::string tag;
  double sample_period_s = 1;
  double stale_after_s = 5;
  std::array<double, 2> span = {0, 100};    ///< of u
  std::array<double, 2> y_span = {0, 100};  ///< of y and sp
  bool has_y_span = false;                  ///< the file gives it
  Source u;
  Source y;
  std::optional<Source> sp;
  std::optional<Source> mode;
  std::vector<double> auto_values = {1};  ///< of mode
  std::optional<Source> alive;
  std::optional<Flag> flag;
  int gain_sign = 0;
  int evaluate_every_pct = 25;    ///< new samples, % of the window
  int evaluate_steady_pct = 100;  ///< the same, of a loop that goes on as it did
  wire::LoopParameters parameters;
  double band_hysteresis_pct = 20;
  double band_limit_pct = 2;  ///< stick band that needs attention, % of span; at least
                              ///< band_min_pct
  Place place;
};

struct Uds {
  std::size_t bus = 0;
  std::uint32_t request_id = 0x7E0;
  std::uint32_t response_id = 0x7E8;
  std::uint32_t functional_id = 0x7DF;
  bool extended_ids = false;
  bool writes = false;
  bool has_key = false;
  std::array<std::uint8_t, 32> key{};
  std::string key_file;  ///< empty: none
  std::uint8_t block_size = 0;
  std::uint8_t st_min = 0;
  Place place;
};

struct Broadcast {
  std::size_t bus = 0;
  std::uint32_t base_id = wire::kBroadcastBaseId;
  std::optional<std::uint32_t> detail_base_id;  ///< of frames 2 and 3; absent: not sent
  double period_s = 1;
};

struct Metrics {
  std::string path;
  double period_s = 15;
  Place place;
};

/// What survives a restart.
struct State {
  std::string path;
  double period_s = 10;  ///< from a change of a DTC to its being written
  Place place;
};

/// What windows said, for years.
struct History {
  std::string path;
  Place place;
};

struct Gateway {
  std::string file;  ///< as it was named
  std::string group = "stickband";
  std::string name = "gateway";
  std::string sysfs_root = "/sys";
  int writes_per_hour = 60;  ///< of state, windows and history together, at most
  std::vector<Bus> buses;
  std::optional<Uds> uds;
  std::optional<Broadcast> broadcast;
  std::optional<Metrics> metrics;
  std::optional<State> state;
  std::optional<History> history;
  std::vector<Loop> loops;  ///< 1 … 31
  std::uint32_t crc32 = 0;  ///< of the file
};

/// Reads the file; paths in it are relative to its folder. Throws ConfigError.
[[nodiscard]] Gateway read_gateway(const std::string& path);
/// The same for a text in memory.
[[nodiscard]] Gateway parse_gateway(std::string_view text, const std::string& path);

/// `file:line: key: message`, for what is found out later, about devices.
[[nodiscard]] std::string at_place(const Gateway& gateway, const Place& place,
                                   std::string_view message);

}  // namespace config
