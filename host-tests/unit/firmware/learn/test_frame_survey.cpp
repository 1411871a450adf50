#include <gtest/gtest.h>

#include "firmware/learn/frame_survey.hpp"

namespace firmware {
namespace {

wire::CanFrame frame_of(std::uint32_t id, std::uint8_t first, std::uint8_t length = 8) {
  wire::CanFrame frame;
  frame.id = id;
  frame.dlc = length;
  frame.data[0] = first;
  return frame;
}

TEST(FrameSurvey, CountsByBusAndIdentifier) {
  FrameSurvey survey;
  for (int k = 0; k <= 100; ++k) {
    survey.take("can0", 10'000 * k, frame_of(0x18E, static_cast<std::uint8_t>(k)));
    survey.take("can1", 10'000 * k, frame_of(0x18E, 7, k < 50 ? 2 : 4));
  }
  wire::CanFrame extended = frame_of(0x18E, 1);
  extended.extended = true;
  survey.take("can0", 0, extended);
  wire::CanFrame remote = frame_of(0x18E, 1);
  remote.remote = true;
  survey.take("can0", 0, remote);
  EXPECT_EQ(survey.frames(), 203U);
  EXPECT_EQ(survey.duration_s(), 1);
  const auto all = survey.all();
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0]->count, 101U);
  EXPECT_NEAR(all[0]->rate_hz(), 100, 1e-9);
  EXPECT_EQ(all[0]->changes[0], 100U);
  EXPECT_EQ(all[0]->changes[1], 0U);
  EXPECT_TRUE(all[1]->extended);
  EXPECT_EQ(all[1]->rate_hz(), 0) << "once";
  EXPECT_EQ(all[2]->bus, "can1");
  EXPECT_EQ(all[2]->shortest, 2);
  EXPECT_EQ(all[2]->longest, 4);
}

TEST(FrameSurvey, KeepsALongTimeEvenly) {
  FrameSurvey survey;
  constexpr int kFrames = 100'000;
  for (int k = 0; k < kFrames; ++k) survey.take("can0", 1000 * k, frame_of(1, 0));
  const SurveyedFrame& only = *survey.all()[0];
  EXPECT_EQ(only.count, static_cast<std::uint64_t>(kFrames));
  EXPECT_LE(only.frames.size(), FrameSurvey::kMostKept);
  EXPECT_GE(only.frames.size(), FrameSurvey::kMostKept / 2);
  ASSERT_EQ(only.frames.size(), only.time_us.size());
  const std::int64_t step = only.time_us[1] - only.time_us[0];
  for (std::size_t k = 1; k < only.time_us.size(); ++k) {
    EXPECT_EQ(only.time_us[k] - only.time_us[k - 1], step) << k;
  }
  EXPECT_GT(only.time_us.back(), 1000LL * kFrames - 2 * step);
}

TEST(FrameSurvey, HasRoomForSoManyIdentifiers) {
  FrameSurvey survey;
  for (std::uint32_t id = 0; id < 600; ++id) survey.take("can0", 0, frame_of(id, 0));
  EXPECT_EQ(survey.all().size(), FrameSurvey::kMostIds);
  EXPECT_EQ(survey.passed_over(), 600 - FrameSurvey::kMostIds);
}

}  // namespace
}  // namespace firmware
