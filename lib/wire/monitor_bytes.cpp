#include "wire/monitor_bytes.hpp"

#include <bit>
#include <cmath>

#include "wire/byte_stream.hpp"

namespace wire {
namespace {

constexpr std::uint8_t kVerdicts = 5;  // of ident

void write_evidence(const ident::EvidencePool& pool, ByteWriter& out) {
  const ident::EvidencePool::Memory memory = pool.memory();
  out.number(std::bit_cast<std::uint32_t>(memory.windows), 4);
  out.number(std::bit_cast<std::uint32_t>(memory.predicted), 4);
  for (const std::int16_t sum : memory.quarter_nats) {
    out.number(static_cast<std::uint16_t>(sum), 2);
  }
}

bool read_evidence(ByteReader& in, ident::EvidencePool& pool) {
  ident::EvidencePool::Memory memory;
  memory.windows = in.single();
  memory.predicted = in.single();
  for (std::int16_t& sum : memory.quarter_nats) {
    sum = static_cast<std::int16_t>(in.number(2));
  }
  pool = ident::EvidencePool(memory);
  constexpr float kMost = 1e12F;  // more samples no loop has seen
  const auto counts = [](float number) { return number >= 0 && number <= kMost; };
  return counts(memory.windows) && counts(memory.predicted);
}

void write_valve(const ident::EarlierValve& valve, ByteWriter& out) {
  const ident::ValveFriction<float>& friction = valve.friction;
  for (const float number :
       {friction.deadband, friction.slip_ascending, friction.slip_descending, valve.slow,
        valve.fast, valve.unexplained}) {
    out.number(std::bit_cast<std::uint32_t>(number), 4);
  }
  out.number(static_cast<std::uint64_t>(friction.motion), 1);
  out.number(valve.trusted, 1);
}

bool read_valve(ByteReader& in, ident::EarlierValve& valve) {
  ident::ValveFriction<float>& friction = valve.friction;
  bool finite = true;
  for (float* number :
       {&friction.deadband, &friction.slip_ascending, &friction.slip_descending,
        &valve.slow, &valve.fast, &valve.unexplained}) {
    *number = in.single();
    finite = finite && std::isfinite(*number);
  }
  const std::uint64_t motion = in.number(1);
  friction.motion = static_cast<ident::SlipMotion>(motion);
  valve.trusted = static_cast<std::uint8_t>(in.number(1));
  return finite && friction.deadband >= 0 && friction.slip_ascending >= 0 &&
         friction.slip_descending >= 0 && motion < ident::kSlipMotions &&
         valve.trusted <= ident::kTrustedWindows;
}

}  // namespace

std::array<std::uint8_t, kMonitorBytes> encode_monitor(
    const ident::MonitorMemory& monitor) {
  std::array<std::uint8_t, kMonitorBytes> bytes;
  ByteWriter out(bytes);
  out.number(monitor.alarm.raised ? 1 : 0, 1);
  out.number(static_cast<std::uint64_t>(monitor.alarm.windows), 2);
  out.number(static_cast<std::uint64_t>(monitor.alike_windows), 2);
  out.number(static_cast<std::uint64_t>(monitor.alike_verdict), 1);
  out.number(monitor.alike_oscillation ? 1 : 0, 1);
  write_evidence(monitor.pool, out);
  write_valve(monitor.earlier, out);
  return bytes;
}

bool decode_monitor(std::span<const std::uint8_t, kMonitorBytes> data,
                    ident::MonitorMemory& monitor) {
  ByteReader in(data);
  const std::uint64_t raised = in.number(1);
  monitor.alarm = {raised == 1, static_cast<int>(in.number(2))};
  monitor.alike_windows = static_cast<int>(in.number(2));
  const std::uint64_t verdict = in.number(1);
  monitor.alike_verdict = static_cast<ident::Verdict>(verdict);
  const std::uint64_t oscillation = in.number(1);
  monitor.alike_oscillation = oscillation == 1;
  const bool evidence = read_evidence(in, monitor.pool);
  return read_valve(in, monitor.earlier) && evidence && raised <= 1 && oscillation <= 1 &&
         verdict < kVerdicts && monitor.alarm.windows <= ident::kLongestDelay &&
         monitor.alike_windows <= ident::kLongestDelay;
}

}  // namespace wire
