// The parts of SourceReader that know J1939 and CANopen.
#include <algorithm>
#include <cmath>

#include "config/pdo_mapping.hpp"
#include "config/source_reader.hpp"
#include "wire/j1939.hpp"

namespace config {
namespace {

namespace j1939 = wire::j1939;

constexpr std::size_t kMostEdsBytes = std::size_t{4} << 20;

void set_valid_range(Source& source) {
  const wire::Signal& signal = source.signal.signal;
  if (!j1939::has_error_codes(signal) || source.has_range) return;
  const double most = j1939::kFirstErrorCode * std::ldexp(1.0, signal.length - 8) - 1;
  const double ends[2] = {signal.offset, signal.offset + signal.scale * most};
  source.has_range = true;
  source.minimum = std::min(ends[0], ends[1]);
  source.maximum = std::max(ends[0], ends[1]);
}

}  // namespace

void SourceReader::read_j1939(TableReader& reader, Source& source) {
  source.bus = read_bus(reader);
  std::uint32_t pgn = 0;
  reader.require("pgn", "a parameter group number, e.g. 0xFEF2");
  reader.read_integer("pgn", pgn, 0, j1939::kMaxPgn);
  std::string path;
  reader.read("dbc", path);
  if (path.empty()) {
    read_layout(reader, source.signal.signal);
  } else {
    std::uint32_t spn = 0;
    reader.require("spn", "a suspect parameter number beside dbc, e.g. 183");
    reader.read_integer("spn", spn, 0, 0x7FFFF);
    source.dbc = joined(folder_, path);
    DbcFile* file = dbc(reader, path);
    if (file && !file->find_spn(pgn, spn, source.signal)) {
      reader.complain("spn", file->error());
    }
    source.description = " SPN " + std::to_string(spn);
    const wire::Signal& signal = source.signal.signal;
    source.has_range = signal.minimum < signal.maximum;
    source.minimum = signal.minimum;
    source.maximum = signal.maximum;
  }
  wire::FrameSignal& signal = source.signal;
  signal.extended = true;
  signal.ignored = j1939::kPriority | (j1939::is_to_one(pgn) ? j1939::kDestination : 0);
  signal.frame_id = (pgn << 8 & wire::kMaxExtendedId) & ~signal.ignored;
  if (reader.has("source_address")) {
    std::uint32_t address = 0;
    reader.read_integer("source_address", address, 0, 0xFD);
    signal.frame_id |= address;
  } else {
    signal.ignored |= j1939::kSourceAddress;
  }
  set_valid_range(source);
  const std::string bus = source.bus < buses_.size() ? buses_[source.bus].name : "";
  source.description = bus + " PGN " + hex_id(pgn, false) + source.description;
}

// Where the object `name` stands in its PDO, by the mapping given or that of its EDS.
// False where there is no EDS to read.
bool SourceReader::read_mapped(TableReader& reader, const PdoSource& source,
                               wire::Signal& signal) {
  const auto& [name, pdo, eds_path, numbers] = source;
  ObjectName object;
  if (!parse_object(name, object)) {
    reader.complain("object",
                    "expected index:sub-index in hex, e.g. \"6401:01\", found \"" + name +
                        "\"; correct it");
  }
  PdoMapping mapping;
  for (const double number : numbers) {
    mapping.push_back(
        number >= 0 && number <= 0xFFFFFFFF ? static_cast<std::uint32_t>(number) : 0);
  }
  std::string eds;
  if (!eds_path.empty()) {
    std::string error;
    if (!read_text(joined(folder_, eds_path), kMostEdsBytes, eds, error)) {
      reader.complain("eds", error);
      return false;
    }
    mapping = read_mapping(eds, pdo);
    (void)read_data_type(eds, object, signal);
  }
  if (!lay_out(mapping, object, signal)) {
    reader.complain(eds_path.empty() ? "mapping" : "eds",
                    "expected object " + name + " in transmit PDO " +
                        std::to_string(pdo) +
                        ", found it not mapped there; give the mapping of the device, "
                        "e.g. mapping = [0x60410010, 0x64010110], or its EDS");
  }
  reader.read("is_signed", signal.is_signed);
  bool is_float = signal.type != wire::ValueType::kInteger;
  reader.read("is_float", is_float);
  signal.type = !is_float             ? wire::ValueType::kInteger
                : signal.length == 64 ? wire::ValueType::kFloat64
                                      : wire::ValueType::kFloat32;
  return true;
}

void SourceReader::read_canopen(TableReader& reader, Source& source) {
  source.bus = read_bus(reader);
  int node = 1;
  PdoSource mapped;
  reader.require("node", "a node id, 1 to 127");
  reader.require("object", "an object and its sub-index, e.g. \"6401:01\"");
  reader.read_integer("node", node, 1, 127);
  reader.read_integer("pdo", mapped.pdo, 1, 512);
  reader.read("object", mapped.object);
  reader.read("eds", mapped.eds_path);
  reader.read_list("mapping", mapped.mapping);
  wire::Signal& signal = source.signal.signal;
  // The predefined identifiers reach four PDOs.
  if (mapped.pdo > 4 && !reader.has("cob_id")) {
    reader.complain("pdo", "expected cob_id beside a PDO above 4, found none; add it");
  }
  source.signal.frame_id =
      static_cast<std::uint32_t>(0x180 + 0x100 * ((mapped.pdo - 1) % 4) + node);
  reader.read_integer("cob_id", source.signal.frame_id, 1, wire::kMaxStandardId);
  if (!read_mapped(reader, mapped, signal)) return;
  read_scale(reader, signal, "object");
  const std::string bus = source.bus < buses_.size() ? buses_[source.bus].name : "";
  source.description = bus + " node " + std::to_string(node) + " PDO " +
                       std::to_string(mapped.pdo) + ' ' + mapped.object;
}

}  // namespace config
