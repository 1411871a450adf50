// The measured signal that a model lacks.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <string>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/model/judge/helpful_load.hpp"
#include "workbench/model/search/ladder.hpp"

namespace workbench {
namespace {

std::vector<double> wandering(std::uint64_t seed, std::size_t count) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> out(count);
  for (std::size_t k = 1; k < count; ++k) out[k] = 0.95 * out[k - 1] + normal(random);
  return out;
}

// A loop that `feed` disturbs by `gain` y for each of its units.
Recording disturbed(const std::vector<double>& feed, double gain) {
  test::SetpointLoop loop;
  loop.load = [&](std::size_t k) { return gain * feed[std::min(k, feed.size() - 1)]; };
  return simulated(loop);
}

TEST(HelpfulLoad, IsTheOneThatMovesTheOutputAmongMany) {
  const std::vector<double> feed = wandering(1, 1200);
  const Recording recording = disturbed(feed, 0.3);
  std::vector<Load> unused;
  for (std::uint64_t i = 2; i < 30; ++i) {
    unused.push_back({"t" + std::to_string(i), "", wandering(i, 1200)});
  }
  unused.push_back({"feed", "", feed});
  unused.push_back({"copy of y", "", recording.y});
  unused.push_back({"of another length", "", {1, 2, 3}});
  const Model model = start_model(recording, Column::y).model;
  const auto best = helpful_load(recording, model, unused);
  ASSERT_TRUE(best);
  EXPECT_EQ(best->name, "feed");
  EXPECT_GT(best->share, 0.5);
}

TEST(HelpfulLoad, IsNoneWhereNoneIsOne) {
  const Recording recording = disturbed(wandering(1, 1200), 0.3);
  std::vector<Load> unused;
  for (std::uint64_t i = 2; i < 30; ++i) {
    unused.push_back({"t" + std::to_string(i), "", wandering(i, 1200)});
  }
  const Model model = start_model(recording, Column::y).model;
  EXPECT_FALSE(helpful_load(recording, model, unused));
  EXPECT_FALSE(helpful_load(recording, model, {}));
}

// Two things that go one way look alike.
TEST(HelpfulLoad, IsNoCountOfRows) {
  std::vector<double> rows(1200);
  std::iota(rows.begin(), rows.end(), 1.0);
  std::vector<double> drift = wandering(1, 1200);
  for (std::size_t k = 0; k < drift.size(); ++k)
    drift[k] = 0.1 * drift[k] + 0.005 * rows[k];
  const Recording recording = disturbed(drift, 1);
  const Model model = start_model(recording, Column::y).model;
  EXPECT_FALSE(helpful_load(recording, model, {{"row", "", rows}}));
}

}  // namespace
}  // namespace workbench
