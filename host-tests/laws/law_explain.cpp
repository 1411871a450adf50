// What explain may call noise, over random loops.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/model/search/ladder.hpp"

namespace workbench {
namespace {

bool is_explained(const test::SetpointLoop& loop) {
  const Recording recording = test::simulated(loop);
  return explain(recording, start_model(recording, Column::y).model).explained;
}

// Loads that wander are in no effect of the catalogue: they stay, and are no noise.
TEST(ExplainLaw, CallsNothingExplainedThatIsNotNoise) {
  for (std::uint64_t seed = 1010; seed < 1015; ++seed) {
    test::SetpointLoop loop;
    loop.seed = seed;
    EXPECT_TRUE(is_explained(loop)) << seed;
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::vector<double> load(loop.samples);
    double last = 0;
    for (double& value : load) value = last = 0.97 * last + 0.3 * normal(random);
    loop.load = [&load](std::size_t k) { return load[std::min(k, load.size() - 1)]; };
    EXPECT_FALSE(is_explained(loop)) << seed;
  }
}

}  // namespace
}  // namespace workbench
