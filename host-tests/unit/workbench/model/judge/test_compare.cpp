// Where a model fails, in the coordinates of the physics.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/model/judge/compare.hpp"
#include "workbench/model/judge/views.hpp"
#include "workbench/model/search/ladder.hpp"

namespace workbench {
namespace {

bool told(const Comparison& comparison, View view) {
  return std::any_of(comparison.failures.begin(), comparison.failures.end(),
                     [view](const Failure& f) { return f.view == view; });
}

TEST(Compare, ACleanLoopHasAWhiteResidual) {
  const Recording recording = test::simulated({});
  const Comparison result = compare(recording, start_model(recording, Column::y).model);
  EXPECT_TRUE(result.residual_test.white);
  EXPECT_FALSE(result.residual_test.follows_u);
  EXPECT_EQ(result.simulated.size(), recording.size());
  EXPECT_NEAR(result.residual_test.bound, 1.96 / std::sqrt(1200.0), 1e-9);
  EXPECT_EQ(result.views.size(), 8u);
}

TEST(Compare, EndsWhereAStopIsAskedFor) {
  const Recording recording = test::simulated({});
  const Model model = start_model(recording, Column::y).model;
  std::stop_source stop;
  const Work work({.stop = stop.get_token()});
  EXPECT_NO_THROW((void)compare(recording, model, standard_catalogue(), work));
  stop.request_stop();
  EXPECT_THROW((void)compare(recording, model, standard_catalogue(), work), Stopped);
}

TEST(Compare, APassingLoadFailsInTimeAndSharesAreOrdered) {
  test::SetpointLoop loop;
  loop.load = [](std::size_t k) { return k >= 700 && k < 800 ? 8.0 : 0.0; };
  const Recording recording = test::simulated(loop);
  const Comparison result = compare(recording, start_model(recording, Column::y).model);
  EXPECT_FALSE(result.residual_test.white);
  ASSERT_TRUE(told(result, View::kTime));
  for (std::size_t i = 1; i < result.failures.size(); ++i) {
    EXPECT_GE(result.failures[i - 1].share_of_error, result.failures[i].share_of_error);
  }
  for (const Failure& failure : result.failures) {
    if (failure.view != View::kTime) continue;
    EXPECT_GT(failure.share_of_error, 0.5);
    EXPECT_GE(failure.t_from, 600);
    EXPECT_LE(failure.t_to, 900);
  }
}

TEST(Views, PutEverySampleWhereItBelongs) {
  const std::vector<double> u = {0, 2, 4, 6, 8, 10, 8, 6, 4, 2, 0, 2, 4, 6, 8, 10, 8};
  std::vector<double> t;
  for (std::size_t k = 0; k < u.size(); ++k) t.push_back(static_cast<double>(k));
  const Situation s = situation_of(u, u, 1);
  for (const Binning& binning : binnings_of(s, t)) {
    ASSERT_EQ(binning.bin.size(), u.size());
    for (const int bin : binning.bin) {
      EXPECT_LT(bin, static_cast<int>(binning.position.size()));
    }
    EXPECT_FALSE(place_in_words(binning, 0, binning.position.size() - 1).empty());
    if (binning.view == View::kDirection) {
      EXPECT_EQ(binning.bin[12], 2);  // rising
      EXPECT_EQ(binning.bin[8], 0);   // falling
    }
  }
}

}  // namespace
}  // namespace workbench
