#include "wire/recording_image.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "wire/byte_stream.hpp"

namespace wire {
namespace {

constexpr std::array<std::uint8_t, 4> kMagic = {'S', 'B', 'R', 'W'};
constexpr std::uint8_t kVersion = 1;
constexpr std::uint8_t kHasSetpoint = 1;

}  // namespace

void encode_recording_header(const RecordingHeader& header,
                             std::span<std::uint8_t, kRecordingHeaderBytes> out) {
  ByteWriter writer(out);
  writer.bytes(kMagic);
  writer.number(kVersion, 1);
  writer.number(header.loop, 1);
  writer.number(header.has_setpoint ? kHasSetpoint : 0, 1);
  writer.number(0, 1);
  writer.number(header.samples, 4);
  writer.number(header.period_us, 4);
  writer.number(header.first_ms, 8);
}

bool decode_recording_header(std::span<const std::uint8_t> data, RecordingHeader& out) {
  if (data.size() < kRecordingHeaderBytes) return false;
  ByteReader in(data);
  if (!std::ranges::equal(in.bytes(kMagic.size()), kMagic) || in.number(1) != kVersion) {
    return false;
  }
  out.loop = static_cast<std::uint8_t>(in.number(1));
  out.has_setpoint = (in.number(1) & kHasSetpoint) != 0;
  (void)in.number(1);
  out.samples = static_cast<std::uint32_t>(in.number(4));
  out.period_us = static_cast<std::uint32_t>(in.number(4));
  out.first_ms = in.number(8);
  return out.samples <= kMostRecordingSamples && out.period_us > 0;
}

void encode_recording_sample(const RecordingSample& sample,
                             std::span<std::uint8_t, kRecordingSampleBytes> out) {
  ByteWriter writer(out);
  for (const float value : {sample.u, sample.y, sample.sp}) {
    writer.number(std::bit_cast<std::uint32_t>(value), 4);
  }
}

RecordingSample decode_recording_sample(
    std::span<const std::uint8_t, kRecordingSampleBytes> data) {
  ByteReader in(data);
  return {in.single(), in.single(), in.single()};
}

}  // namespace wire
