#include "seeds.hpp"

namespace fuzz {

namespace {

std::string loop_of(const char* tag, const char* sources) {
  return std::string("[[loop]]\nid = 7\ntag = \"") + tag + "\"\n" + sources;
}

constexpr const char* kModbus =
    R"(u = { source = "modbus", host = "10.0.0.5", port = 502, unit = 1, table = "holding", address = 100, type = "f32", word_order = "low_first", scale = 1.0, offset = 0.0 }
y = { source = "modbus", device = "/dev/ttyUSB0", baud = 9600, parity = "E", unit = 247, table = "input", address = 65535, type = "i16", scale = 0.01, minimum = 0, maximum = 100 }
)";

constexpr const char* kJ1939 =
    R"(u = { source = "j1939", pgn = 0xFEF2, source_address = 0x21, start = 0, length = 16, scale = 0.05 }
y = { source = "j1939", bus = "can0", pgn = 65262, start = 16, length = 16, scale = 0.03125, offset = -273.0 }
)";

constexpr const char* kCanopen =
    R"(u = { source = "canopen", node = 5, pdo = 9, cob_id = 0x2A5, object = "6401:01", mapping = [0x60410010, 0x64010110], is_signed = true, scale = 0.01 }
y = { source = "canopen", bus = "can0", node = 127, pdo = 1, object = "6401:02", mapping = [0x64010220] }
)";

constexpr const char* kCanFd =
    R"(u = { source = "can", frame_id = 0x18E, start = 496, length = 16 }
y = { source = "can", frame_id = 0x18FF1000, extended = true, start = 511, length = 8, byte_order = "big_endian", multiplexer = { start = 64, length = 8 }, multiplexer_ids = [2] }
)";

// What is kept, and the trend that is made of it.
constexpr const char* kMemory = R"(evaluate_every_pct = 25
evaluate_steady_pct = 100
gain_sign = "negative"
[loop.alarm]
band_limit_pct = 2.0
band_hysteresis_pct = 20.0
off_delay_windows = 6
[history]
path = "history"
[state]
path = "state"
period_s = 10.0
[broadcast]
base_id = 0x190
detail_base_id = 0x1B0
)";

}  // namespace

std::vector<std::string> toml_seeds() {
  const std::string bus = "[bus.can0]\nbackend = \"socketcan\"\ninterface = \"can0\"\n";
  const auto can = [](const char* name, const char* more) {
    return std::string(name) + " = { source = \"can\", bus = \"can0\", " + more + " }\n";
  };
  const std::string loop =
      "[[loop]]\nid = 1\ntag = \"FIC-211\"\n" +
      can("u", "frame_id = 0x18E, start = 0, length = 16") +
      can("y",
          "frame_id = 0x18F, start = 7, length = 16, byte_order = \"big_endian\", "
          "is_signed = true, scale = 0.01, minimum = 0, maximum = 100");
  const std::string more =
      can("sp", "frame_id = 0x18D, start = 0, length = 32, is_float = true") +
      can("mode",
          "frame_id = 5, extended = true, start = 0, length = 2, multiplexer = { start = "
          "8, length = 4 }, multiplexer_ids = [3]") +
      "auto_values = [1, 2]\nspan = [0.0, 50.0]\nstale_after_s = 5.0\n"
      "flag = { chip = \"gpiochip0\", line = 3, active_low = true, fail_safe = true }\n"
      "[loop.alarm]\non_delay_windows = 3\nne107 = { stiction = \"S\" }\n"
      "[[loop]]\nid = 2\ntag = \"B\"\n"
      "u = { source = \"iio\", name = \"a\", channel = \"voltage0\", shunt_ohm = 250.0, "
      "in "
      "= [4, 20], out = [0, 100], ne43 = true, debounce_s = 1 }\n"
      "y = { source = \"hwmon\", name = \"a\", channel = \"curr1\" }\n"
      "[gateway]\ngroup = \"a\"\nname = \"b\"\nsysfs_root = \"/sys\"\n"
      "[uds]\nbus = \"can0\"\nrequest_id = 0x700\nresponse_id = 0x708\n"
      "[broadcast]\nbus = \"can0\"\nperiod_s = 2.0\n[metrics]\npath = \"a.prom\"\n"
      "[state]\npath = \"state\"\nperiod_s = 1\n"
      "[bus.lab]\nbackend = \"slcan\"\nport = 1\n";
  return {bus + loop,
          bus + loop + more,
          bus + loop_of("M", kModbus),
          bus + loop_of("J", kJ1939),
          bus + loop_of("C", kCanopen),
          bus + loop_of("F", kCanFd),
          bus + loop + kMemory};
}

}  // namespace fuzz
