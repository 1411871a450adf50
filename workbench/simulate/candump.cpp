#include "workbench/simulate/candump.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <ostream>
#include <stdexcept>

#include "workbench/simulate/random.hpp"

namespace workbench {
namespace {

constexpr std::int64_t kEpochMicroseconds = 1'700'000'000'000'000;

enum class ByteOrder { kIntel, kMotorola };

std::array<unsigned, 4> bytes_of(std::uint32_t raw, ByteOrder order) {
  std::array<unsigned, 4> bytes{};
  for (unsigned i = 0; i < 4; ++i) {
    bytes[order == ByteOrder::kIntel ? i : 3 - i] = (raw >> (8 * i)) & 0xFFu;
  }
  return bytes;
}

std::uint32_t scaled(double value, const char* signal) {
  const double raw = std::round(value / kSignalScale);
  if (!(std::abs(raw) <= 2147483647.0)) {
    throw std::out_of_range("candump: " + std::string(signal) + " = " +
                            std::to_string(value) + " does not fit 32 bits of " +
                            std::to_string(kSignalScale));
  }
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(raw));
}

void write_frame(std::ostream& out, std::int64_t microseconds, std::uint32_t id,
                 const std::array<unsigned, 4>& data) {
  const std::int64_t stamp = kEpochMicroseconds + microseconds;
  char line[64];
  std::snprintf(line, sizeof line, "(%lld.%06lld) can0 %03X#%02X%02X%02X%02X\n",
                static_cast<long long>(stamp / 1'000'000),
                static_cast<long long>(stamp % 1'000'000), static_cast<unsigned>(id),
                data[0], data[1], data[2], data[3]);
  out << line;
}

}  // namespace

void write_candump(const SimulatedLoop& loop, std::ostream& out) {
  Random random("candump", loop.truth.seed);
  for (std::size_t i = 0; i < loop.t.size(); ++i) {
    const auto instant = static_cast<std::int64_t>(std::llround(loop.t[i] * 1e6));
    write_frame(out, instant + random.integer(0, 400), kProcessFrame,
                bytes_of(scaled(loop.y[i], "PV"), ByteOrder::kMotorola));
    write_frame(out, instant + 1500 + random.integer(0, 400), kOutputFrame,
                bytes_of(scaled(loop.u[i], "OP"), ByteOrder::kIntel));
    if (i % 10 == 0 || loop.sp[i] != loop.sp[i - 1]) {
      const auto raw = std::bit_cast<std::uint32_t>(static_cast<float>(loop.sp[i]));
      write_frame(out, instant + 2500, kSetpointFrame, bytes_of(raw, ByteOrder::kIntel));
    }
  }
}

std::string dbc_text() {
  const auto number = [](std::uint32_t id) { return std::to_string(id); };
  const std::string scale = "(0.00001,0) [-21474.83647|21474.83647] \"\" Vector__XXX\n";
  return "VERSION \"\"\n\nNS_ :\n\nBS_:\n\nBU_: Loop\n\n"
         "BO_ " +
         number(kSetpointFrame) +
         " LoopSP: 4 Loop\n"
         " SG_ SP : 0|32@1- (1,0) [0|0] \"\" Vector__XXX\n\n"
         "BO_ " +
         number(kOutputFrame) +
         " LoopOP: 4 Loop\n"
         " SG_ OP : 0|32@1- " +
         scale +
         "\n"
         "BO_ " +
         number(kProcessFrame) +
         " LoopPV: 4 Loop\n"
         " SG_ PV : 7|32@0- " +
         scale +
         "\n"
         "SIG_VALTYPE_ " +
         number(kSetpointFrame) + " SP : 1;\n";
}

}  // namespace workbench
