#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "wire/recording_image.hpp"

namespace wire {
namespace {

constexpr RecordingHeader kHeader = {7, true, 2048, 500'000, 1'436'509'052'249};

std::array<std::uint8_t, kRecordingHeaderBytes> image_of(const RecordingHeader& header) {
  std::array<std::uint8_t, kRecordingHeaderBytes> out{};
  encode_recording_header(header, out);
  return out;
}

TEST(RecordingImage, GoldenHeader) {
  const std::array<std::uint8_t, kRecordingHeaderBytes> expected = {
      'S', 'B',  'R',  'W',  1, 7, 1,    0,    0,    0,    8,    0,
      0,   0x07, 0xA1, 0x20, 0, 0, 0x01, 0x4E, 0x76, 0x9C, 0x9D, 0x59};
  EXPECT_EQ(image_of(kHeader), expected);
  RecordingHeader back;
  ASSERT_TRUE(decode_recording_header(expected, back));
  EXPECT_EQ(back.loop, 7);
  EXPECT_TRUE(back.has_setpoint);
  EXPECT_EQ(back.samples, 2048U);
  EXPECT_EQ(back.period_us, 500'000U);
  EXPECT_EQ(back.first_ms, 1'436'509'052'249U);
  EXPECT_EQ(recording_bytes(2048), 24U + 12 * 2048);
}

TEST(RecordingImage, RefusesWhatItIsNot) {
  RecordingHeader back;
  const auto good = image_of(kHeader);
  EXPECT_FALSE(decode_recording_header(std::span(good).first(23), back));
  auto bad = good;
  bad[0] = 's';
  EXPECT_FALSE(decode_recording_header(bad, back));
  bad = good;
  bad[4] = 2;
  EXPECT_FALSE(decode_recording_header(bad, back));
  RecordingHeader header = kHeader;
  header.period_us = 0;
  EXPECT_FALSE(decode_recording_header(image_of(header), back));
  header = kHeader;
  header.samples = kMostRecordingSamples + 1;
  EXPECT_FALSE(decode_recording_header(image_of(header), back));
}

TEST(RecordingImage, SamplesComeBack) {
  std::array<std::uint8_t, kRecordingSampleBytes> out{};
  encode_recording_sample({50.25F, -1.5F, NAN}, out);
  const std::array<std::uint8_t, 8> start = {0x42, 0x49, 0, 0, 0xBF, 0xC0, 0, 0};
  EXPECT_TRUE(std::equal(start.begin(), start.end(), out.begin()));
  const RecordingSample back = decode_recording_sample(out);
  EXPECT_EQ(back.u, 50.25F);
  EXPECT_EQ(back.y, -1.5F);
  EXPECT_TRUE(std::isnan(back.sp));
}

}  // namespace
}  // namespace wire
