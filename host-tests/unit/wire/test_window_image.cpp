#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "wire/big_endian.hpp"
#include "wire/crc32.hpp"
#include "wire/window_image.hpp"

namespace wire {
namespace {

using Bytes = std::vector<std::uint8_t>;

void close(Bytes& image) {
  const std::uint32_t crc = crc32(image);
  image.resize(image.size() + 4);
  put_big_endian(crc, std::span(image).last(4));
}

// Two windows, the second one empty.
Bytes image() {
  Bytes out(kWindowsHeaderBytes);
  encode_windows_header(2, -5, std::span(out).first<kWindowsHeaderBytes>());
  for (std::uint32_t samples : {3U, 0U}) {
    std::array<std::uint8_t, kWindowMarkBytes> mark{};
    encode_window_mark({.tag = FixedText<32>("FIC-211"),
                        .configuration = 0xCBF43926,
                        .judged_ms = 1'436'509'052'249,
                        .unjudged = samples},
                       mark);
    out.insert(out.end(), mark.begin(), mark.end());
    std::array<std::uint8_t, kRecordingHeaderBytes> header{};
    encode_recording_header({.loop = 7,
                             .has_setpoint = false,
                             .samples = samples,
                             .period_us = 1000,
                             .first_ms = 1'436'509'052'000},
                            header);
    out.insert(out.end(), header.begin(), header.end());
    for (std::uint32_t k = 0; k < samples; ++k) {
      std::array<std::uint8_t, kRecordingSampleBytes> sample{};
      encode_recording_sample({static_cast<float>(k), 50, NAN}, sample);
      out.insert(out.end(), sample.begin(), sample.end());
    }
  }
  close(out);
  return out;
}

StateError error_of(const Bytes& bytes) {
  return WindowReader(bytes).check();
}

TEST(WindowImage, IsReadAsItWasWritten) {
  const Bytes bytes = image();
  EXPECT_EQ(bytes.size(), windows_bytes(2, 0) + 3 * kRecordingSampleBytes);
  WindowReader windows(bytes);
  ASSERT_EQ(windows.check(), StateError::kNone);
  EXPECT_EQ(windows.offset_us(), -5);
  ASSERT_TRUE(windows.next());
  EXPECT_EQ(windows.mark().tag.view(), "FIC-211");
  EXPECT_EQ(windows.mark().configuration, 0xCBF43926);
  EXPECT_EQ(windows.mark().judged_ms, 1'436'509'052'249);
  EXPECT_EQ(windows.mark().unjudged, 3U);
  EXPECT_EQ(windows.header().loop, 7);
  EXPECT_EQ(windows.header().samples, 3U);
  EXPECT_EQ(windows.sample(2).u, 2);
  EXPECT_TRUE(std::isnan(windows.sample(2).sp));
  ASSERT_TRUE(windows.next());
  EXPECT_EQ(windows.header().samples, 0U);
  EXPECT_FALSE(windows.next());
}

TEST(WindowImage, DamageIsFound) {
  const Bytes good = image();
  for (std::size_t size = 0; size < good.size(); ++size) {
    EXPECT_NE(error_of(Bytes(good.begin(), good.begin() + static_cast<long>(size))),
              StateError::kNone)
        << size;
  }
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    Bytes bad = good;
    bad[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
    EXPECT_NE(error_of(bad), StateError::kNone) << bit;
  }
}

TEST(WindowImage, WhatHasTheRightChecksumIsStillCheckedForSense) {
  const auto changed = [](std::size_t at, std::size_t size, std::uint64_t value) {
    Bytes bad = image();
    bad.resize(bad.size() - 4);
    put_big_endian(value, std::span(bad).subspan(at, size));
    close(bad);
    return error_of(bad);
  };
  constexpr std::size_t kMarkAt = kWindowsHeaderBytes;
  constexpr std::size_t kWindowAt = kMarkAt + kWindowMarkBytes;
  EXPECT_EQ(changed(0, 1, 'X'), StateError::kForeign);
  EXPECT_EQ(changed(4, 1, 9), StateError::kVersion);
  EXPECT_EQ(changed(5, 1, 1), StateError::kLength) << "a window too many";
  EXPECT_EQ(changed(5, 1, 3), StateError::kContent) << "one too few";
  EXPECT_EQ(changed(kMarkAt + 44, 4, 4), StateError::kContent) << "unjudged";
  EXPECT_EQ(changed(kWindowAt, 1, 'X'), StateError::kContent) << "no window";
  EXPECT_EQ(changed(kWindowAt + 8, 4, 1000), StateError::kContent) << "samples";
  EXPECT_EQ(changed(kWindowAt + 12, 4, 0), StateError::kContent) << "period";
  EXPECT_EQ(changed(kWindowAt + 16, 8, ~0ULL), StateError::kContent) << "time";
}

}  // namespace
}  // namespace wire
