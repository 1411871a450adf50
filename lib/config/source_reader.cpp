#include "config/source_reader.hpp"

#include <arpa/inet.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>

namespace config {
namespace {

constexpr Range kAny = {-std::numeric_limits<double>::infinity(),
                        std::numeric_limits<double>::infinity()};

std::string number_text(double value) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.12g", value);
  return text.data();
}

// The server of a register: a host with its port, or a serial line. No name is looked up.
void read_server(TableReader& reader, Modbus& modbus) {
  if (reader.has("host") == reader.has("device")) {
    reader.complain("host",
                    "expected the IPv4 address of a server, or device, a serial line, "
                    "found neither or both; give one");
  }
  const std::size_t before = reader.complaints().count();
  reader.read("host", modbus.host);
  reader.read("device", modbus.device);
  in_addr address{};
  if (reader.has("host") && reader.complaints().count() == before &&
      inet_pton(AF_INET, modbus.host.c_str(), &address) != 1) {
    reader.complain("host",
                    "expected an IPv4 address, as \"10.0.0.5\", found \"" + modbus.host +
                        "\"; write the four numbers, and the port under the key port");
  }
  if (reader.has("device")) {
    std::size_t parity = 1;
    reader.read_integer("baud", modbus.baud, 1200, 115200);
    reader.read_choice("parity", parity, {"N", "E", "O"});
    modbus.parity = "NEO"[parity];
  } else {
    reader.read_integer("port", modbus.port, 1, 65535);
  }
}

}  // namespace

void read_layout(TableReader& reader, wire::Signal& signal) {
  reader.require("start", "the start bit of the signal");
  reader.require("length", "the length of the signal in bits");
  reader.read_integer("start", signal.start, 0, 8 * wire::kMaxFdLength - 1);
  reader.read_integer("length", signal.length, 1, 64);
  std::size_t order = 0;
  reader.read_choice("byte_order", order, {"little_endian", "big_endian"});
  signal.byte_order =
      order == 0 ? wire::ByteOrder::kLittleEndian : wire::ByteOrder::kBigEndian;
  reader.read("is_signed", signal.is_signed);
  bool is_float = false;
  reader.read("is_float", is_float);
  if (is_float) {
    signal.type =
        signal.length == 64 ? wire::ValueType::kFloat64 : wire::ValueType::kFloat32;
  }
  read_scale(reader, signal, "start");
}

void read_scale(TableReader& reader, wire::Signal& signal, std::string_view blamed) {
  reader.read("scale", signal.scale, kAny);
  reader.read("offset", signal.offset, kAny);
  std::string unit;
  reader.read("unit", unit);
  const wire::SignalError error = wire::check(signal);
  if (error != wire::SignalError::kNone) {
    reader.complain(blamed, std::string("expected a signal inside a frame, found that ") +
                                wire::describe(error) +
                                "; check start, length and byte_order");
  }
}

bool read_text(const std::string& path, std::size_t max_bytes, std::string& text,
               std::string& error) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
      std::fopen(path.c_str(), "rb"), std::fclose);
  text.clear();
  if (file) {
    std::array<char, 65536> bytes;
    std::size_t count = 0;
    while (text.size() <= max_bytes &&
           (count = std::fread(bytes.data(), 1, bytes.size(), file.get())) > 0) {
      text.append(bytes.data(), count);
    }
  }
  if (!file || std::ferror(file.get()) != 0) {
    error = "expected a file, found that " + path + " cannot be read (" +
            std::strerror(errno) + "); correct the path";
    return false;
  }
  if (text.size() > max_bytes) {
    error = "expected a file of at most " + std::to_string(max_bytes >> 10) +
            " KiB, found " + path + " longer; is it the right one?";
    return false;
  }
  return true;
}

std::string joined(const std::string& folder, const std::string& path) {
  return path.starts_with('/') || folder.empty() ? path : folder + '/' + path;
}

std::string hex_id(std::uint32_t id, bool extended) {
  std::array<char, 16> text;
  std::snprintf(text.data(), text.size(), extended ? "%08X" : "%03X", unsigned{id});
  return text.data();
}

std::size_t SourceReader::read_bus(TableReader& reader) const {
  std::string name;
  std::string names;
  reader.read("bus", name);
  for (std::size_t k = 0; k < buses_.size(); ++k) {
    if (buses_[k].name == name) return k;
    names += (k == 0 ? "\"" : ", \"") + buses_[k].name + '"';
  }
  if (name.empty() && buses_.size() == 1) return 0;
  reader.complain("bus", "expected one of the buses " +
                             (names.empty() ? "(there is no [bus.NAME])" : names) +
                             ", found " + (name.empty() ? "nothing" : '"' + name + '"') +
                             "; name one of them");
  return 0;
}

DbcFile* SourceReader::dbc(TableReader& reader, const std::string& path) {
  auto& entry = dbcs_[path];
  if (!entry) {
    std::string text;
    std::string error;
    if (!read_text(joined(folder_, path), DbcFile::kMaxBytes, text, error)) {
      dbcs_.erase(path);
      reader.complain("dbc", error);
      return nullptr;
    }
    entry = std::make_unique<DbcFile>(std::move(text), joined(folder_, path));
    if (!entry->error().empty()) {
      reader.complain("dbc", entry->error());
      dbcs_.erase(path);
      return nullptr;
    }
  }
  return entry.get();
}

void SourceReader::read_dbc_signal(TableReader& reader, Source& source) {
  std::string path;
  std::string message;
  std::string signal;
  reader.read("dbc", path);
  const bool named = reader.require("message", "the name of a message in the DBC file") &&
                     reader.require("signal", "the name of a signal of that message");
  reader.read("message", message);
  reader.read("signal", signal);
  if (path.empty() || !named) return;
  source.dbc = joined(folder_, path);
  DbcFile* file = dbc(reader, path);
  if (!file) return;
  if (!file->find(message + '.' + signal, source.signal)) {
    reader.complain(file->misses_message() ? "message" : "signal", file->error());
    return;
  }
  source.description += ' ' + message + '.' + signal;
}

void SourceReader::read_inline_signal(TableReader& reader, Source& source) {
  if (!reader.require("frame_id", "an identifier, or the keys dbc, message and signal")) {
    return;
  }
  wire::FrameSignal& signal = source.signal;
  reader.read("extended", signal.extended);
  reader.read_integer("frame_id", signal.frame_id, 0, wire::kMaxExtendedId);
  if (!signal.extended && signal.frame_id > wire::kMaxStandardId) {
    reader.complain("frame_id", "expected at most 0x7FF, found 0x" +
                                    hex_id(signal.frame_id, true) +
                                    "; add extended = true for 29 bits");
  }
  read_layout(reader, signal.signal);
  if (const toml::table* table = reader.table("multiplexer")) {
    TableReader inner(*table, reader.path_of("multiplexer"), reader.complaints());
    signal.multiplexed = true;
    read_layout(inner, signal.multiplexor);
    inner.refuse_unknown();
    std::vector<double> ids;
    reader.require("multiplexer_ids", "the value of the multiplexer, e.g. [2]");
    reader.read_list("multiplexer_ids", ids);
    if (ids.size() > 1) {
      reader.complain("multiplexer_ids",
                      "expected one value, found several; configure one of them");
    } else if (!ids.empty()) {
      const double most = std::exp2(signal.multiplexor.length) - 1;
      if (ids[0] >= 0 && ids[0] <= most && ids[0] == std::floor(ids[0])) {
        signal.multiplex_value = static_cast<std::uint32_t>(ids[0]);
      } else {
        reader.complain("multiplexer_ids",
                        "expected a whole number from 0 to " + number_text(most) +
                            ", as the multiplexer can have, found " +
                            number_text(ids[0]) + "; correct the value");
      }
    }
  }
}

void SourceReader::read_can(TableReader& reader, Source& source) {
  source.bus = read_bus(reader);
  if (reader.has("dbc")) {
    read_dbc_signal(reader, source);
  } else {
    read_inline_signal(reader, source);
  }
  if (source.bus < buses_.size()) {
    source.description = buses_[source.bus].name + ' ' +
                         hex_id(source.signal.frame_id, source.signal.extended) +
                         source.description;
  }
  const wire::Signal& signal = source.signal.signal;
  source.has_range = signal.minimum < signal.maximum;
  source.minimum = signal.minimum;
  source.maximum = signal.maximum;
}

void SourceReader::read_analog(TableReader& reader, Source& source) {
  reader.require("name", "the name of the device");
  reader.require("channel", "a channel, e.g. \"voltage0\" (iio) or \"in0\" (hwmon)");
  reader.read("name", source.name);
  reader.read("channel", source.channel);
  reader.read_integer("index", source.index, 0, 255);
  const auto factor = [&reader](const char* key, std::optional<double>& value) {
    double number = 0;
    if (!reader.has(key)) return;
    reader.read(key, number, kAny);
    value = number;
  };
  if (source.kind == SourceKind::kIio) {
    factor("scale", source.scale);
    factor("offset", source.offset);
  }
  reader.read("shunt_ohm", source.shunt_ohm, {1e-3, 1e6});
  source.is_current = source.shunt_ohm > 0 || source.channel.starts_with("curr");
  if (!source.is_current) source.in = {0, 10};
  reader.read_pair("in", source.in, true);
  reader.read_pair("out", source.out, false);
  reader.read("ne43", source.ne43);
  if (source.ne43 && !source.is_current) {
    reader.complain("ne43",
                    "expected a current for NE43, found a voltage channel; add "
                    "shunt_ohm or remove ne43");
  }
  constexpr Range kCurrent = {0, 30};
  CurrentLimits& limits = source.limits;
  reader.read("failure_low_ma", limits.failure_low_ma, kCurrent);
  reader.read("saturated_low_ma", limits.saturated_low_ma, kCurrent);
  reader.read("saturated_high_ma", limits.saturated_high_ma, kCurrent);
  reader.read("failure_high_ma", limits.failure_high_ma, kCurrent);
  reader.read("debounce_s", limits.debounce_s, {0, 600});
  if (!(limits.failure_low_ma <= limits.saturated_low_ma &&
        limits.saturated_low_ma < limits.saturated_high_ma &&
        limits.saturated_high_ma <= limits.failure_high_ma)) {
    reader.complain("failure_low_ma",
                    "expected failure_low_ma ≤ saturated_low_ma < saturated_high_ma ≤ "
                    "failure_high_ma, found another order; correct the limits");
  }
  source.description = source.name + ' ' + source.channel;
}

void SourceReader::read_modbus(TableReader& reader, Source& source) {
  Modbus& modbus = source.modbus;
  read_server(reader, modbus);
  reader.read_integer("unit", modbus.unit, 0, 247);
  std::size_t table = 0;
  reader.read_choice("table", table, {"holding", "input"});
  modbus.input_table = table == 1;
  reader.require("address", "the number of a register as in the telegram: 40001 is 0");
  reader.read_integer("address", modbus.address, 0, 65535);
  std::size_t type = 0;
  reader.read_choice("type", type, {"u16", "i16", "u32", "i32", "f32"});
  modbus.type = static_cast<RegisterType>(type);
  std::size_t order = 0;
  reader.read_choice("word_order", order, {"high_first", "low_first"});
  modbus.low_word_first = order == 1;
  double scale = 1;
  double offset = 0;
  reader.read("scale", scale, kAny);
  reader.read("offset", offset, kAny);
  if (!(std::abs(scale) > 0 && std::isfinite(scale) && std::isfinite(offset))) {
    reader.complain("scale",
                    "expected a finite scale that is not 0 and a finite offset, found "
                    "otherwise; correct them");
  }
  source.scale = scale;
  source.offset = offset;
  source.name = modbus.device.empty() ? modbus.host + ':' + std::to_string(modbus.port)
                                      : modbus.device;
  source.channel = std::to_string(modbus.unit) + (table == 1 ? " input " : " holding ") +
                   std::to_string(modbus.address);
  source.description = source.name + ' ' + source.channel;
}

Source SourceReader::read(const toml::table& table, const std::string& name,
                          Complaints& complaints) {
  TableReader reader(table, name, complaints);
  Source source;
  source.place = reader.place();
  struct Kind {
    std::string_view name;
    SourceKind kind;
    void (SourceReader::*read)(TableReader&, Source&);
  };
  static constexpr std::array<Kind, 6> kKinds = {{
      {"can", SourceKind::kCan, &SourceReader::read_can},
      {"iio", SourceKind::kIio, &SourceReader::read_analog},
      {"hwmon", SourceKind::kHwmon, &SourceReader::read_analog},
      {"modbus", SourceKind::kModbus, &SourceReader::read_modbus},
      {"j1939", SourceKind::kCan, &SourceReader::read_j1939},
      {"canopen", SourceKind::kCan, &SourceReader::read_canopen},
  }};
  std::vector<std::string_view> names;
  for (const Kind& kind : kKinds) names.push_back(kind.name);
  std::size_t chosen = 0;
  const std::size_t before = complaints.count();
  reader.require("source", one_of(names));
  reader.read_choice("source", chosen, names);
  if (complaints.count() > before) return source;  // which keys there are depends on it
  source.kind = kKinds[chosen].kind;
  (this->*kKinds[chosen].read)(reader, source);
  const bool low = reader.has("minimum");
  const bool high = reader.has("maximum");
  reader.read("minimum", source.minimum, kAny);
  reader.read("maximum", source.maximum, kAny);
  if (low != high || (low && !(source.minimum < source.maximum))) {
    reader.complain(
        low ? "minimum" : "maximum",
        "expected minimum and maximum together and ascending, found otherwise; "
        "give both");
  } else if (low) {
    source.has_range = true;
  }
  reader.refuse_unknown();
  source.readable = complaints.count() == before;
  return source;
}

}  // namespace config
