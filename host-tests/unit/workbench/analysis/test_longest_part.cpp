// Recordings joined by hand, cut again.
#include <gtest/gtest.h>

#include "support/ident/pi_loop.hpp"
#include "workbench/analysis/identification_json.hpp"
#include "workbench/analysis/longest_part.hpp"

namespace workbench {
namespace {

void append(Recording& recording, std::size_t samples, std::uint64_t seed, double above) {
  const ::test::LoopRecord more = ::test::run({}, samples, seed);
  recording.period_s = 1;
  for (std::size_t i = 0; i < samples; ++i) {
    recording.t.push_back(static_cast<double>(recording.t.size()));
    recording.u.push_back(more.u[i] + above);
    recording.y.push_back(more.y[i] + above);
  }
}

TEST(LongestPart, IsAllOfAWholeRecording) {
  Recording recording;
  append(recording, 1000, 1, 0);
  const UncutPart part = longest_part(recording);
  EXPECT_EQ(part.first, 0u);
  EXPECT_EQ(part.length, 1000u);
  EXPECT_EQ(part.seam_at, 0u);
}

TEST(LongestPart, EndsAtTheSeams) {
  Recording recording;
  append(recording, 400, 1, 0);
  append(recording, 900, 2, 20);
  append(recording, 500, 3, 40);
  const UncutPart part = longest_part(recording);
  EXPECT_EQ(part.first, 400u);
  EXPECT_EQ(part.length, 900u);
  EXPECT_EQ(part.seam_at, 400u);
  const Recording alone = cut_out(recording, part);
  EXPECT_EQ(alone.size(), 900u);
  EXPECT_EQ(alone.t.front(), 400);
  EXPECT_EQ(alone.u.front(), recording.u[400]);
  EXPECT_EQ(alone.y.back(), recording.y[1299]);
  EXPECT_TRUE(alone.sp.empty());
}

TEST(LongestPart, IsJudgedAloneAndSaysSo) {
  Recording recording;
  append(recording, 400, 1, 0);
  append(recording, 900, 2, 20);
  const Analysis analysis(recording);
  ASSERT_EQ(analysis.notes().size(), 1u);
  EXPECT_NE(analysis.notes()[0].find("400 to 1299 s"), std::string::npos)
      << analysis.notes()[0];
  EXPECT_NE(analysis.result().reason, ident::Reason::kSeam);
  const auto json = identification_json(recording, analysis);
  EXPECT_EQ(json["rivals"].dump(), R"([{"cause":"seam","nats":null}])");
  EXPECT_EQ(json["recording"]["samples"], 1300);
}

}  // namespace
}  // namespace workbench
