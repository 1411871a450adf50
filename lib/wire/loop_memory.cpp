#include "wire/loop_memory.hpp"

#include <cmath>

#include "wire/byte_stream.hpp"
#include "wire/monitor_bytes.hpp"

namespace wire {
namespace {

constexpr std::int64_t kMost_ms = std::int64_t{1} << 53;

constexpr std::array<KeptNumber, kKeptNumbers> kNumbers = {
    [](LoopStatus& l) -> double& { return l.confidence_pct; },
    [](LoopStatus& l) -> double& { return l.stick_band_pct.ascending; },
    [](LoopStatus& l) -> double& { return l.stick_band_pct.descending; },
    [](LoopStatus& l) -> double& { return l.stick_band_low_pct.ascending; },
    [](LoopStatus& l) -> double& { return l.stick_band_low_pct.descending; },
    [](LoopStatus& l) -> double& { return l.stick_band_high_pct.ascending; },
    [](LoopStatus& l) -> double& { return l.stick_band_high_pct.descending; },
    [](LoopStatus& l) -> double& { return l.slip_jump_pct.ascending; },
    [](LoopStatus& l) -> double& { return l.slip_jump_pct.descending; },
    [](LoopStatus& l) -> double& { return l.detectable_band_pct; },
    [](LoopStatus& l) -> double& { return l.evidence_nats; },
    [](LoopStatus& l) -> double& { return l.period_s; },
    [](LoopStatus& l) -> double& { return l.window_samples; },
    [](LoopStatus& l) -> double& { return l.window_cycles; },
    [](LoopStatus& l) -> double& { return l.fit_percent; },
    [](LoopStatus& l) -> double& { return l.fit_linear_percent; },
    [](LoopStatus& l) -> double& { return l.share_of_error_pct; },
    [](LoopStatus& l) -> double& { return l.residual_share_pct; },
};

// ms since the epoch, 2⁵³ of them at most, or −1 for none.
std::int64_t time_of(std::uint64_t raw) {
  const auto ms = static_cast<std::int64_t>(raw);
  return ms >= 0 && ms <= kMost_ms ? ms : -1;
}

}  // namespace

std::span<const KeptNumber, kKeptNumbers> kept_numbers() {
  return kNumbers;
}

void encode_loop_memory(const LoopMemory& memory, const LoopStatus& status,
                        std::span<std::uint8_t, kLoopMemoryBytes> out) {
  LoopStatus shown = status;
  ByteWriter writer(out);
  writer.number(memory.judged ? 1 : 0, 1);
  writer.number(memory.configuration, 4);
  writer.number(static_cast<std::uint64_t>(memory.ended_ms), 8);
  writer.number(static_cast<std::uint64_t>(memory.evidence_ms), 8);
  const bool changed = status.changed_ms >= 0;
  writer.number(changed ? static_cast<std::uint64_t>(status.changed_ms) : ~0ULL, 8);
  writer.number(static_cast<std::uint64_t>(status.window_verdict), 1);
  writer.number(static_cast<std::uint64_t>(memory.standing), 1);
  writer.number(memory.standing_samples, 2);
  writer.number(status.suspect_effect, 1);
  for (const KeptNumber number : kNumbers) writer.single(number(shown));
  for (const BandInterval& band : memory.told_bands) {
    for (const double end : band) writer.single(end);
  }
  writer.bytes(encode_monitor(memory.monitor));
}

bool decode_loop_memory(std::span<const std::uint8_t, kLoopMemoryBytes> data,
                        LoopMemory& memory, LoopStatus& status) {
  ByteReader in(data);
  const std::uint64_t judged = in.number(1);
  memory.judged = judged == 1;
  memory.configuration = static_cast<std::uint32_t>(in.number(4));
  memory.ended_ms = time_of(in.number(8));
  memory.evidence_ms = time_of(in.number(8));
  const std::int64_t changed_ms = time_of(in.number(8));
  status.changed_ms = changed_ms >= 0 ? static_cast<double>(changed_ms) : kNotAvailable;
  const auto window = static_cast<std::uint8_t>(in.number(1));
  const auto standing = static_cast<std::uint8_t>(in.number(1));
  status.window_verdict = static_cast<LoopVerdict>(window);
  memory.standing = static_cast<LoopVerdict>(standing);
  memory.standing_samples = static_cast<std::uint16_t>(in.number(2));
  status.suspect_effect = static_cast<std::uint8_t>(in.number(1));
  bool finite = true;
  const auto next = [&](double& number) {
    number = static_cast<double>(in.single());
    finite = finite && !std::isinf(number);
  };
  for (const KeptNumber number : kNumbers) next(number(status));
  for (BandInterval& band : memory.told_bands) {
    for (double& end : band) next(end);
  }
  const auto monitor = in.bytes(kMonitorBytes).first<kMonitorBytes>();
  return decode_monitor(monitor, memory.monitor) && finite && judged <= 1 &&
         is_verdict(window) && is_verdict(standing);
}

}  // namespace wire
