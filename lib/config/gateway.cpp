#include "config/gateway.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "config/consistency.hpp"
#include "config/loop_tag.hpp"
#include "config/source_reader.hpp"
#include "config/toml_mistake.hpp"
#include "config/toml_reader.hpp"
#include "wire/crc32.hpp"

namespace config {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{1} << 20;
constexpr std::size_t kMostKeyBytes = 4096;
constexpr std::size_t kMostNameBytes = 32;  // GatewayStatus::name

Bus read_bus(const toml::table& table, const std::string& name, const std::string& folder,
             Complaints& complaints) {
  TableReader reader(table, "bus." + name, complaints);
  Bus bus;
  bus.name = name;
  bus.place = reader.place();
  std::size_t backend = 0;
  const std::size_t before = complaints.count();
  reader.require("backend", "\"socketcan\", \"slcan\" or \"file\"");
  reader.read_choice("backend", backend, {"socketcan", "slcan", "file"});
  if (complaints.count() > before) return bus;  // which keys there are depends on it
  bus.backend = static_cast<Backend>(backend);
  switch (bus.backend) {
    case Backend::kSocketCan:
      reader.require("interface", "the name of a CAN interface, e.g. \"can0\"");
      reader.read("interface", bus.interface);
      if (bus.interface.size() > 15) {
        reader.complain("interface", "expected at most 15 characters, found \"" +
                                         bus.interface + "\"; correct the name");
      }
      break;
    case Backend::kSlcan:
      reader.require("port", "a TCP port on 127.0.0.1, 0 for any");
      reader.read_integer("port", bus.port, 0, 65535);
      break;
    case Backend::kFile:
      reader.require("path", "a candump log");
      reader.read("path", bus.path);
      bus.path = joined(folder, bus.path);
      reader.read("interface", bus.interface);
      reader.read("real_time", bus.real_time);
      break;
  }
  reader.refuse_unknown();
  return bus;
}

// Under systemd a credential of the file's name takes its place, unless it says "none":
// the service itself may not be allowed to read the file.
std::string key_path(const std::string& folder, const std::string& name) {
  const std::string path = joined(folder, name);
  const char* credentials = std::getenv("CREDENTIALS_DIRECTORY");
  if (!credentials) return path;
  const std::string credential =
      std::string(credentials) + '/' + path.substr(path.rfind('/') + 1);
  std::string text;
  std::string error;
  const bool there = read_text(credential, kMostKeyBytes, text, error);
  return there && text != "none" ? credential : path;
}

void read_key(TableReader& reader, const std::string& folder, Uds& uds) {
  std::string name;
  reader.read("key_file", name);
  if (name.empty()) return;
  uds.key_file = joined(folder, name);
  const std::string path = key_path(folder, name);
  std::string text;
  std::string error;
  if (!read_text(path, kMostKeyBytes, text, error)) {
    reader.complain("key_file", error);
    return;
  }
  struct stat about {};
  if (stat(path.c_str(), &about) == 0 && (about.st_mode & S_IROTH) != 0) {
    reader.complain("key_file", "expected a secret, found that everybody may read " +
                                    path + "; chmod 600 it");
  }
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  uds.has_key = text.size() == 2 * uds.key.size() &&
                text.find_first_not_of("0123456789abcdefABCDEF") == std::string::npos;
  if (!uds.has_key) {
    reader.complain("key_file", "expected 64 hex digits in the file, found " +
                                    std::to_string(text.size()) +
                                    " characters; write 32 random bytes in hex");
    return;
  }
  if (text.find_first_not_of('0') == std::string::npos) {
    reader.complain("key_file",
                    "expected a random key, found all zeros; write 32 random bytes in "
                    "hex");
  }
  for (std::size_t k = 0; k < uds.key.size(); ++k) {
    uds.key[k] = static_cast<std::uint8_t>(std::stoi(text.substr(2 * k, 2), nullptr, 16));
  }
}

Uds read_uds(const toml::table& table, const std::string& folder,
             const SourceReader& sources, Complaints& complaints) {
  TableReader reader(table, "uds", complaints);
  Uds uds;
  uds.place = reader.place();
  uds.bus = sources.read_bus(reader);
  reader.read("extended_ids", uds.extended_ids);
  if (uds.extended_ids) {
    uds.request_id = 0x18DA10F1;
    uds.response_id = 0x18DAF110;
    uds.functional_id = 0x18DB33F1;
  }
  const std::int64_t most =
      uds.extended_ids ? wire::kMaxExtendedId : wire::kMaxStandardId;
  reader.read_integer("request_id", uds.request_id, 0, most);
  reader.read_integer("response_id", uds.response_id, 0, most);
  reader.read_integer("functional_id", uds.functional_id, 0, most);
  reader.read("writes", uds.writes);
  reader.read_integer("block_size", uds.block_size, 0, 255);
  reader.read_integer("st_min_ms", uds.st_min, 0, 127);
  read_key(reader, folder, uds);
  if (uds.writes && !reader.has("key_file")) {
    reader.complain("writes",
                    "expected key_file beside writes = true, found none; name "
                    "a file with 64 hex digits");
  }
  reader.refuse_unknown();
  return uds;
}

Broadcast read_broadcast(const toml::table& table, const SourceReader& sources,
                         Complaints& complaints) {
  TableReader reader(table, "broadcast", complaints);
  Broadcast broadcast;
  broadcast.bus = sources.read_bus(reader);
  reader.read_integer("base_id", broadcast.base_id, 0,
                      wire::kMaxStandardId - wire::kMostLoops);
  if (reader.has("detail_base_id")) {
    std::uint32_t id = wire::kDetailBaseId;
    reader.read_integer("detail_base_id", id, 0,
                        wire::kMaxStandardId - wire::kMostLoops - wire::kBroadcastIds);
    broadcast.detail_base_id = id;
  }
  reader.read("period_s", broadcast.period_s, {0.1, 3600});
  reader.refuse_unknown();
  return broadcast;
}

/// A table that says which file to write, and how often.
template <class File>
File read_written_file(const toml::table& table, const char* name, const char* expected,
                       const std::string& folder, Complaints& complaints) {
  TableReader reader(table, name, complaints);
  File file;
  file.place = reader.place();
  reader.require("path", expected);
  reader.read("path", file.path);
  file.path = joined(folder, file.path);
  reader.read("period_s", file.period_s, {1, 3600});
  reader.refuse_unknown();
  return file;
}

History read_history(const toml::table& table, const std::string& folder,
                     Complaints& complaints) {
  TableReader reader(table, "history", complaints);
  History history;
  history.place = reader.place();
  reader.require("path", "the file to write");
  reader.read("path", history.path);
  history.path = joined(folder, history.path);
  reader.refuse_unknown();
  return history;
}

Flag read_flag(const toml::table& table, const std::string& name,
               Complaints& complaints) {
  TableReader reader(table, name, complaints);
  Flag flag;
  flag.place = reader.place();
  reader.require("chip", "the name or label of a GPIO chip");
  reader.require("line", "the number of a line");
  reader.read("chip", flag.chip);
  reader.read_integer("line", flag.line, 0, 4095);
  reader.read("active_low", flag.active_low);
  reader.read("fail_safe", flag.fail_safe);
  reader.refuse_unknown();
  return flag;
}

void read_ne107(TableReader& reader, std::string_view key, wire::Ne107& status) {
  using wire::Ne107;
  constexpr std::array kStatus = {Ne107::kNormal, Ne107::kFailure, Ne107::kCheckFunction,
                                  Ne107::kOffSpec, Ne107::kMaintenanceRequired};
  auto at =
      static_cast<std::size_t>(std::ranges::find(kStatus, status) - kStatus.begin());
  reader.read_choice(key, at, {"none", "F", "C", "S", "M"});
  status = kStatus[at];
}

void read_alarm(const toml::table& table, const std::string& name, Loop& loop,
                Complaints& complaints) {
  TableReader reader(table, name, complaints);
  wire::LoopParameters& parameters = loop.parameters;
  reader.read_integer("on_delay_windows", parameters.on_delay_windows, 1, 1000);
  reader.read_integer("off_delay_windows", parameters.off_delay_windows, 1, 1000);
  reader.read("band_min_pct", parameters.band_min_pct, {0, 100});
  reader.read("band_hysteresis_pct", loop.band_hysteresis_pct, {0, 100});
  loop.band_limit_pct = std::max(loop.band_limit_pct, parameters.band_min_pct);
  reader.read("band_limit_pct", loop.band_limit_pct, {0, 100});
  if (loop.band_limit_pct < parameters.band_min_pct) {
    reader.complain("band_limit_pct",
                    "expected at least band_min_pct, found less: a band would need "
                    "attention before it counts; raise it, or lower band_min_pct");
  }
  if (const toml::table* ne107 = reader.table("ne107")) {
    TableReader status(*ne107, name + ".ne107", complaints);
    read_ne107(status, "stiction", parameters.stiction);
    read_ne107(status, "backlash", parameters.backlash);
    read_ne107(status, "oscillation_other", parameters.oscillation_other);
    read_ne107(status, "input_invalid", parameters.input_invalid);
    status.refuse_unknown();
  }
  reader.refuse_unknown();
}

void read_tag(TableReader& reader, std::string& tag) {
  reader.require("tag", "the tag of the loop, e.g. \"FIC-211\"");
  reader.read("tag", tag);
  const std::string problem = problem_of_tag(tag);
  if (!problem.empty()) reader.complain("tag", problem);
}

Loop read_loop(const toml::table& table, const std::string& name, SourceReader& sources,
               Complaints& complaints) {
  TableReader reader(table, name, complaints);
  Loop loop;
  loop.place = reader.place();
  loop.id = 0;  // unless the file has a good one
  reader.require("id", "a number from 1 to 31");
  reader.read_integer("id", loop.id, 1, wire::kMostLoops);
  read_tag(reader, loop.tag);
  reader.read("sample_period_s", loop.sample_period_s, {0.01, 3600});
  loop.stale_after_s = 5 * loop.sample_period_s;
  reader.read("stale_after_s", loop.stale_after_s, {0.02, 86400});
  if (loop.stale_after_s < 2 * loop.sample_period_s) {
    reader.complain("stale_after_s",
                    "expected at least two sample periods, found less; "
                    "raise it, or shorten sample_period_s");
  }
  reader.read_pair("span", loop.span, true);
  reader.read_pair("y_span", loop.y_span, true);
  loop.has_y_span = reader.has("y_span");
  const auto source = [&](std::string_view key) -> std::optional<Source> {
    const toml::table* inner = reader.table(key);
    if (!inner) return std::nullopt;
    return sources.read(*inner, name + '.' + std::string(key), complaints);
  };
  reader.require("u", "where the controller output comes from");
  reader.require("y", "where the process output comes from");
  loop.u = source("u").value_or(Source{});
  loop.y = source("y").value_or(Source{});
  loop.sp = source("sp");
  loop.mode = source("mode");
  loop.alive = source("alive");
  reader.read_list("auto_values", loop.auto_values);
  if (reader.has("auto_values") && !loop.mode) {
    reader.complain("auto_values",
                    "expected the key mode beside it, found none; add mode "
                    "or remove auto_values");
  }
  reader.read_integer("evaluate_every_pct", loop.evaluate_every_pct, 1, 100);
  reader.read_integer("evaluate_steady_pct", loop.evaluate_steady_pct, 1, 100);
  if (loop.evaluate_steady_pct < loop.evaluate_every_pct) {
    reader.complain(
        "evaluate_steady_pct",
        "expected at least evaluate_every_pct, found less; raise it, or lower "
        "evaluate_every_pct");
  }
  std::size_t sign = 1;
  reader.read_choice("gain_sign", sign, {"negative", "unknown", "positive"});
  loop.gain_sign = static_cast<int>(sign) - 1;
  if (const toml::table* flag = reader.table("flag")) {
    loop.flag = read_flag(*flag, name + ".flag", complaints);
  }
  if (const toml::table* alarm = reader.table("alarm")) {
    read_alarm(*alarm, name + ".alarm", loop, complaints);
  }
  reader.refuse_unknown();
  return loop;
}

void read_all(const toml::table& root, const std::string& folder, Gateway& gateway,
              Complaints& complaints) {
  TableReader reader(root, "", complaints);
  if (const toml::table* table = reader.table("gateway")) {
    TableReader inner(*table, "gateway", complaints);
    inner.read("group", gateway.group);
    inner.read("name", gateway.name);
    if (gateway.name.size() > kMostNameBytes) {
      inner.complain("name", "expected at most " + std::to_string(kMostNameBytes) +
                                 " bytes, found " + std::to_string(gateway.name.size()) +
                                 "; shorten it");
    }
    inner.read("sysfs_root", gateway.sysfs_root);
    inner.read_integer("writes_per_hour", gateway.writes_per_hour, 10, 3600);
    gateway.sysfs_root = joined(folder, gateway.sysfs_root);
    inner.refuse_unknown();
  }
  if (const toml::table* table = reader.table("bus")) {
    for (const auto& [key, node] : *table) {
      if (const toml::table* bus = node.as_table()) {
        gateway.buses.push_back(
            read_bus(*bus, std::string(key.str()), folder, complaints));
      } else {
        complaints.add(
            static_cast<int>(key.source().begin.line), "bus." + std::string(key.str()),
            "expected a table, found " + found_text(node) + "; write [bus.NAME]");
      }
    }
  }
  SourceReader sources(folder, gateway.buses);
  if (const toml::table* table = reader.table("uds")) {
    gateway.uds = read_uds(*table, folder, sources, complaints);
  }
  if (const toml::table* table = reader.table("broadcast")) {
    gateway.broadcast = read_broadcast(*table, sources, complaints);
  }
  if (const toml::table* table = reader.table("metrics")) {
    gateway.metrics = read_written_file<Metrics>(
        *table, "metrics", "the file to write, *.prom", folder, complaints);
  }
  if (const toml::table* table = reader.table("state")) {
    gateway.state = read_written_file<State>(*table, "state", "the file to write", folder,
                                             complaints);
  }
  if (const toml::table* table = reader.table("history")) {
    gateway.history = read_history(*table, folder, complaints);
  }
  const auto loops = reader.tables("loop");
  for (std::size_t k = 0; k < loops.size(); ++k) {
    gateway.loops.push_back(
        read_loop(*loops[k], "loop[" + std::to_string(k + 1) + ']', sources, complaints));
  }
  if (loops.empty() || loops.size() > wire::kMostLoops) {
    complaints.add(0, "loop",
                   "expected 1 to 31 tables [[loop]], found " +
                       std::to_string(loops.size()) + "; describe each loop in one");
  }
  reader.refuse_unknown();
}

}  // namespace

Gateway parse_gateway(std::string_view text, const std::string& path) {
  Complaints complaints(path);
  Gateway gateway;
  gateway.file = path;
  gateway.crc32 =
      wire::crc32({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  const std::size_t slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "" : path.substr(0, slash);
  toml::table root;
  try {
    root = toml::parse(text, path);
  } catch (const toml::parse_error& error) {
    const auto line = static_cast<int>(error.source().begin.line);
    complaints.add(line, "", toml_mistake(text, line, error.description()));
    complaints.throw_if_any();
  }
  read_all(root, folder, gateway, complaints);
  check_consistency(gateway, complaints);
  complaints.throw_if_any();
  return gateway;
}

Gateway read_gateway(const std::string& path) {
  std::string text;
  std::string error;
  if (!read_text(path, kMaxBytes, text, error)) throw ConfigError(path + ": " + error);
  return parse_gateway(text, path);
}

std::string at_place(const Gateway& gateway, const Place& place,
                     std::string_view message) {
  return gateway.file + ':' + std::to_string(place.line) + ": " + place.key + ": " +
         std::string(message);
}

}  // namespace config
