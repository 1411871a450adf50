// Where an object lies in a CANopen PDO (CiA 301): from its mapping, given as the numbers
// of object 1A00, or by an EDS or DCF file.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "wire/signal.hpp"

namespace config {

/// An object and its sub-index, e.g. 6401:01.
struct ObjectName {
  std::uint16_t index = 0;
  std::uint8_t sub = 0;
};

/// Reads "6401:01" or "0x6401:1" (hex); false: it is none.
[[nodiscard]] bool parse_object(std::string_view text, ObjectName& out);

/// Entries of a mapping: index, sub-index and length in bits, e.g. 0x64010110.
using PdoMapping = std::vector<std::uint32_t>;

/// The mapping of transmit PDO 1 … 512 in the text of an EDS or DCF file, whose
/// ParameterValue counts more than its DefaultValue; empty: it has none.
[[nodiscard]] PdoMapping read_mapping(std::string_view eds, int pdo);
/// Sets sign and float type as the file declares the object; false: it does not.
bool read_data_type(std::string_view eds, const ObjectName& object, wire::Signal& signal);

/// Lays out `object` of a mapping: start and length. False: it is not mapped, or not
/// within eight bytes.
[[nodiscard]] bool lay_out(const PdoMapping& mapping, const ObjectName& object,
                           wire::Signal& signal);

}  // namespace config
