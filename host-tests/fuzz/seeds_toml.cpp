#include "seeds.hpp"

namespace fuzz {

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
  return {bus + loop, bus + loop + more};
}

}  // namespace fuzz
