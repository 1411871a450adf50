#include <gtest/gtest.h>

#include <algorithm>

#include "workbench/simulate/cycles.hpp"
#include "workbench/simulate/plant.hpp"

namespace workbench {
namespace {

PlantOptions small(std::uint64_t seed) {
  PlantOptions options;
  options.seed = seed;
  options.samples = 1500;
  return options;
}

TEST(Plant, OneValveSticksAndShakesFive) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const PlantArea area = simulate_area(small(seed), 1);
    ASSERT_EQ(area.loops.size(), 20U);
    const auto sticks =
        std::count_if(area.loops.begin(), area.loops.end(),
                      [](const PlantLoop& loop) { return loop.stick_band > 0; });
    const auto shaken =
        std::count_if(area.loops.begin(), area.loops.end(),
                      [](const PlantLoop& loop) { return !loop.leader.empty(); });
    EXPECT_EQ(sticks, 1);
    EXPECT_EQ(shaken, kShaken);
    for (const PlantLoop& loop : area.loops) {
      EXPECT_EQ(loop.u.size(), 1500U);
      if (loop.stick_band > 0) {
        EXPECT_GE(measure_cycles(loop.y).count, 6) << seed;
      }
    }
  }
}

TEST(Plant, TheSameOptionsMakeTheSamePlant) {
  EXPECT_EQ(area_csv(simulate_area(small(4), 1)), area_csv(simulate_area(small(4), 1)));
  EXPECT_NE(area_csv(simulate_area(small(4), 1)), area_csv(simulate_area(small(5), 1)));
}

TEST(Plant, WithoutStickingValvesNothingSticks) {
  PlantOptions options = small(1);
  options.sticking = 0;
  for (const PlantLoop& loop : simulate_area(options, 1).loops) {
    EXPECT_EQ(loop.stick_band, 0);
    EXPECT_TRUE(loop.leader.empty());
  }
}

TEST(Plant, AreasFillUp) {
  PlantOptions options = small(1);
  options.loops = 23;
  EXPECT_EQ(areas_of(options), 2);
  EXPECT_EQ(simulate_area(options, 2).loops.size(), 3U);
  const std::string csv = area_csv(simulate_area(options, 2));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1501);
  EXPECT_EQ(csv.rfind("Timestamp,", 0), 0U);
}

}  // namespace
}  // namespace workbench
