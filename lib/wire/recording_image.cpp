#include "wire/recording_image.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "wire/big_endian.hpp"

namespace wire {
namespace {

constexpr std::array<std::uint8_t, 4> kMagic = {'S', 'B', 'R', 'W'};
constexpr std::uint8_t kVersion = 1;
constexpr std::uint8_t kHasSetpoint = 1;

std::uint32_t word_at(std::span<const std::uint8_t> data, std::size_t at) {
  return static_cast<std::uint32_t>(get_big_endian(data.subspan(at, 4)));
}

}  // namespace

void encode_recording_header(const RecordingHeader& header,
                             std::span<std::uint8_t, kRecordingHeaderBytes> out) {
  std::copy(kMagic.begin(), kMagic.end(), out.begin());
  out[4] = kVersion;
  out[5] = header.loop;
  out[6] = header.has_setpoint ? kHasSetpoint : std::uint8_t{0};
  out[7] = 0;
  put_big_endian(header.samples, out.subspan(8, 4));
  put_big_endian(header.period_us, out.subspan(12, 4));
  put_big_endian(header.first_ms, out.subspan(16, 8));
}

bool decode_recording_header(std::span<const std::uint8_t> data, RecordingHeader& out) {
  if (data.size() < kRecordingHeaderBytes ||
      !std::equal(kMagic.begin(), kMagic.end(), data.begin()) || data[4] != kVersion) {
    return false;
  }
  out.loop = data[5];
  out.has_setpoint = (data[6] & kHasSetpoint) != 0;
  out.samples = word_at(data, 8);
  out.period_us = word_at(data, 12);
  out.first_ms = get_big_endian(data.subspan(16, 8));
  return out.samples <= kMostRecordingSamples && out.period_us > 0;
}

void encode_recording_sample(const RecordingSample& sample,
                             std::span<std::uint8_t, kRecordingSampleBytes> out) {
  std::size_t at = 0;
  for (const float value : {sample.u, sample.y, sample.sp}) {
    put_big_endian(std::bit_cast<std::uint32_t>(value), out.subspan(at, 4));
    at += 4;
  }
}

RecordingSample decode_recording_sample(
    std::span<const std::uint8_t, kRecordingSampleBytes> data) {
  return {std::bit_cast<float>(word_at(data, 0)), std::bit_cast<float>(word_at(data, 4)),
          std::bit_cast<float>(word_at(data, 8))};
}

}  // namespace wire
