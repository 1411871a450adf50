#include "config/pdo_mapping.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <optional>
#include <string>

#include "wire/text.hpp"

namespace config {
namespace {

constexpr int kFirstMapping = 0x1A00;
constexpr std::size_t kMostEntries = 64;

using wire::trimmed;

bool same(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) ==
           std::tolower(static_cast<unsigned char>(y));
  });
}

std::optional<std::uint32_t> number(std::string_view text, int base = 10) {
  if (text.starts_with("0x") || text.starts_with("0X")) {
    text.remove_prefix(2);
    base = 16;
  }
  return wire::number_of<std::uint32_t>(text, base);
}

// The number under `key` in `section`; both without case.
std::optional<std::uint32_t> entry(std::string_view eds, std::string_view section,
                                   std::string_view key) {
  bool inside = false;
  while (!eds.empty()) {
    const std::string_view line = trimmed(wire::take_line(eds));
    if (line.starts_with('[')) {
      inside = line.ends_with(']') && same(line.substr(1, line.size() - 2), section);
      continue;
    }
    const std::size_t equals = line.find('=');
    if (!inside || equals == std::string_view::npos) continue;
    if (same(trimmed(line.substr(0, equals)), key)) {
      return number(trimmed(line.substr(equals + 1)));
    }
  }
  return std::nullopt;
}

std::string section_of(unsigned index, int sub) {
  std::array<char, 24> name;
  if (sub < 0) {
    std::snprintf(name.data(), name.size(), "%X", index);
  } else {
    std::snprintf(name.data(), name.size(), "%Xsub%X", index, static_cast<unsigned>(sub));
  }
  return name.data();
}

std::optional<std::uint32_t> value_of(std::string_view eds, unsigned index, int sub) {
  const std::string section = section_of(index, sub);
  const auto set = entry(eds, section, "ParameterValue");
  return set ? set : entry(eds, section, "DefaultValue");
}

}  // namespace

bool parse_object(std::string_view text, ObjectName& out) {
  const std::size_t colon = text.find(':');
  const auto index = number(text.substr(0, colon), 16);
  const auto sub = colon == std::string_view::npos ? std::optional<std::uint32_t>(0)
                                                   : number(text.substr(colon + 1), 16);
  if (!index || !sub || *index > 0xFFFF || *sub > 0xFF) return false;
  out = {static_cast<std::uint16_t>(*index), static_cast<std::uint8_t>(*sub)};
  return true;
}

PdoMapping read_mapping(std::string_view eds, int pdo) {
  const auto index = static_cast<unsigned>(kFirstMapping + pdo - 1);
  PdoMapping mapping;
  const std::size_t count =
      std::min<std::size_t>(value_of(eds, index, 0).value_or(0), kMostEntries);
  for (std::size_t k = 1; k <= count; ++k) {
    const auto mapped = value_of(eds, index, static_cast<int>(k));
    if (!mapped) return {};
    mapping.push_back(*mapped);
  }
  return mapping;
}

bool read_data_type(std::string_view eds, const ObjectName& object,
                    wire::Signal& signal) {
  auto type = entry(eds, section_of(object.index, object.sub), "DataType");
  if (!type && object.sub == 0)
    type = entry(eds, section_of(object.index, -1), "DataType");
  if (!type) return false;
  // Numbers of CiA 301: INTEGER8 … 32 and 24 … 64, REAL32, REAL64.
  constexpr std::array<std::uint32_t, 8> kSigned = {2,    3,    4,    0x10,
                                                    0x12, 0x13, 0x14, 0x15};
  constexpr std::uint32_t kReal32 = 8;
  constexpr std::uint32_t kReal64 = 0x11;
  signal.is_signed = std::ranges::find(kSigned, *type) != kSigned.end();
  signal.type = *type == kReal32   ? wire::ValueType::kFloat32
                : *type == kReal64 ? wire::ValueType::kFloat64
                                   : wire::ValueType::kInteger;
  return true;
}

bool lay_out(const PdoMapping& mapping, const ObjectName& object, wire::Signal& signal) {
  unsigned start = 0;
  for (const std::uint32_t mapped : mapping) {
    const unsigned length = mapped & 0xFF;
    if (mapped >> 16 == object.index && (mapped >> 8 & 0xFF) == object.sub) {
      signal.start = static_cast<std::uint16_t>(start);
      signal.length = static_cast<std::uint16_t>(length);
      return length >= 1 && start + length <= 64;
    }
    start += length;
  }
  return false;
}

}  // namespace config
