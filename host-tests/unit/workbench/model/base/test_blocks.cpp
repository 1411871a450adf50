// Which samples are fitted and which judge.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "workbench/model/base/blocks.hpp"
#include "workbench/recording/rest_before.hpp"

namespace workbench {
namespace {

TEST(Blocks, CoverEverySampleOnceInTurnsThreeToTwo) {
  for (const std::size_t n : {60u, 61u, 1500u, 3001u}) {
    for (const double memory : {1.0, 20.0, 500.0}) {
      const Blocks blocks(n, memory);
      std::size_t at = 0;
      bool estimation = true;
      for (const Block& block : blocks.blocks()) {
        EXPECT_EQ(block.first, at);
        EXPECT_LT(block.first, block.last);
        EXPECT_EQ(block.estimation, estimation);
        estimation = !estimation;
        at = block.last;
      }
      EXPECT_EQ(at, n);
      const auto& mask = blocks.estimation();
      EXPECT_EQ(std::accumulate(mask.begin(), mask.end(), std::size_t{0}),
                blocks.estimation_samples());
      EXPECT_NEAR(static_cast<double>(blocks.estimation_samples()),
                  0.6 * static_cast<double>(n), 0.06 * static_cast<double>(n));
    }
  }
}

TEST(Blocks, AreLongerWhereTheOutputRemembersLonger) {
  EXPECT_GT(Blocks(3000, 5).blocks().size(), Blocks(3000, 50).blocks().size());
  EXPECT_GE(Blocks(3000, 5000).blocks().size(), 10u);
}

TEST(Blocks, JudgeEachPieceOnSamplesOfItsOwn) {
  const std::vector<Piece> pieces = {
      {0, 1000, "a", 0, false}, {1000, 1200, "b", 0, false}, {1200, 1230, "b", 0, false}};
  const Blocks blocks(pieces, 50);
  std::size_t at = 0;
  std::vector<int> validation(1231, 0);
  for (const Block& block : blocks.blocks()) {
    EXPECT_EQ(block.first, at);
    at = block.last;
    if (!block.estimation) ++validation[block.piece];
    EXPECT_TRUE(block.piece == 0 || block.piece == 1000 || block.piece == 1200);
    EXPECT_GE(block.first, block.piece);
  }
  EXPECT_EQ(at, 1230U);
  EXPECT_GE(validation[0], 4);
  EXPECT_GE(validation[1000], 2);
  EXPECT_EQ(validation[1200], 1);
}

TEST(Blocks, AreAllOfTheOneKindWhereAPieceJudges) {
  const std::vector<Piece> pieces = {{0, 1000, "a", 0, false},
                                     {1000, 1700, "b", 0, true}};
  const Blocks blocks(pieces, 50);
  EXPECT_EQ(blocks.estimation_samples(), 1000U);
  int judging = 0;
  for (const Block& block : blocks.blocks()) {
    EXPECT_EQ(block.estimation, block.first < 1000);
    judging += !block.estimation;
  }
  EXPECT_GE(judging, 5);  // for the bootstrap
}

TEST(Blocks, HaveTheShareAndTheLengthThatAreAskedFor) {
  const Blocks half(3000, 20, {0.5, 0});
  EXPECT_NEAR(static_cast<double>(half.estimation_samples()), 1500, 60);
  const Blocks few(3000, 20, {0.6, 1000});
  EXPECT_EQ(few.blocks().size(), 6u);
  const Blocks many(3000, 20, {0.6, 1});
  EXPECT_GT(many.blocks().size(), 400u);
  EXPECT_EQ(many.samples(), 3000u);
  EXPECT_GE(Blocks(3000, 20, {0.6, 1e6}).blocks().size(), 4u);
}

TEST(Blocks, FitTheJudgingOnesThatARangeMeets) {
  const Blocks blocks(1000, 10);
  const Block& judging = blocks.blocks()[1];
  const Blocks more = blocks.fitting({judging.last - 1, judging.last + 1});
  EXPECT_EQ(more.estimation_samples(),
            blocks.estimation_samples() + judging.last - judging.first);
  EXPECT_EQ(more.estimation()[judging.first], 1);
  EXPECT_TRUE(more.blocks()[1].estimation);
  EXPECT_FALSE(more.blocks()[3].estimation);
  EXPECT_EQ(more.samples(), blocks.samples());
}

TEST(Blocks, OfARecordingAreAsManyBesideAnotherAsAlone) {
  const std::array both = {Piece{0, 900, "one.csv", 0, false, false},
                           Piece{900, 2400, "two.csv", 0, false, false}};
  constexpr double kMemory = 120;
  const auto in_first = [&](std::span<const Piece> pieces) {
    const Blocks blocks(pieces, kMemory);
    return std::ranges::count_if(blocks.blocks(),
                                 [](const Block& b) { return b.first < 900; });
  };
  EXPECT_EQ(in_first(both), in_first(std::span(both).first(1)));
  EXPECT_EQ(in_first(both), 12);
}

TEST(Blocks, BeginBehindARestThatWasPutInFront) {
  std::array pieces = {Piece{0, 132, "step.csv", 0, false, true}};
  const Blocks rested(pieces, 2);
  pieces[0] = {0, 120, "step.csv", 0, false, false};
  const Blocks plain(pieces, 2);
  ASSERT_EQ(rested.blocks().size(), plain.blocks().size());
  EXPECT_EQ(rested.blocks()[0].first, 0U);
  EXPECT_TRUE(rested.blocks()[0].estimation);
  for (std::size_t i = 0; i < rested.blocks().size(); ++i) {
    EXPECT_EQ(rested.blocks()[i].last, plain.blocks()[i].last + kRestSamples);
  }
}

TEST(Blocks, LeaveOutWhatIsLeftOut) {
  const std::vector<SampleRange> left_out = {{0, 100}, {700, 1300}, {2990, 3000}};
  const Blocks blocks(3000, 20, {}, left_out);
  const auto& mask = blocks.estimation();
  ASSERT_EQ(mask.size(), 3000u);
  std::size_t samples = 0;
  for (const Block& block : blocks.blocks()) {
    for (const SampleRange& range : left_out) {
      EXPECT_TRUE(block.last <= range.first || block.first >= range.last);
    }
    samples += block.last - block.first;
  }
  EXPECT_EQ(samples, 3000u - 100 - 600 - 10);
  EXPECT_EQ(blocks.samples(), samples);
  EXPECT_EQ(std::accumulate(mask.begin(), mask.end(), std::size_t{0}),
            blocks.estimation_samples());
  ASSERT_EQ(blocks.kept().size(), 2u);
  EXPECT_EQ(blocks.kept()[0].first, 100u);
  EXPECT_EQ(blocks.kept()[1].last, 2990u);
  EXPECT_EQ(blocks.left_out().size(), 3u);
}

}  // namespace
}  // namespace workbench
