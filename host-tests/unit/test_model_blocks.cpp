// Which samples are fitted and which judge.
#include <gtest/gtest.h>

#include <numeric>

#include "workbench/model/blocks.hpp"

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

}  // namespace
}  // namespace workbench
