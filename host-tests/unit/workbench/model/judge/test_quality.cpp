// How a fit stands against its recordings.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/model/base/joined.hpp"
#include "workbench/model/judge/quality.hpp"

namespace workbench {
namespace {

Recording noisy_recording(const char* name, double noise, std::uint64_t seed) {
  test::SetpointLoop loop;
  loop.noise_std = noise;
  loop.seed = seed;
  Recording out = test::simulated(loop);
  out.name = name;
  return out;
}

TEST(Quality, IsToldOfAllAndOfEach) {
  const Recording both =
      joined({noisy_recording("a.csv", 0.1, 1), noisy_recording("b.csv", 0.4, 2)});
  const Fitter fitter(both, Column::y);
  const Fit fit = fitter.start({});
  const FitQuality all = quality(fitter, fit);
  ASSERT_EQ(all.recordings.size(), 2U);
  EXPECT_EQ(all.recordings[1].file, "b.csv");
  EXPECT_NEAR(all.recordings[0].rmse, 0.1, 0.02);
  EXPECT_NEAR(all.recordings[1].rmse_validation, 0.4, 0.05);
  const double mean =
      (std::pow(all.recordings[0].rmse, 2) + std::pow(all.recordings[1].rmse, 2)) / 2;
  EXPECT_NEAR(all.rmse, std::sqrt(mean), 1e-9);
}

TEST(Quality, IsNoBetterForRecordingsThatLieApart) {
  Recording second = noisy_recording("b.csv", 0.4, 2);
  for (double& value : second.y) value += 50;
  const Recording both = joined({noisy_recording("a.csv", 0.1, 1), second});
  const Fitter fitter(both, Column::y);
  const FitQuality all = quality(fitter, fitter.start({}));
  // Each is measured by its own spread, whatever lies between them.
  double error = 0;
  double spread = 0;
  for (const RecordingFit& part : all.recordings) {
    error += part.rmse * part.rmse;
    spread += std::pow(part.rmse / (1 - part.fit_percent / 100), 2);
  }
  EXPECT_NEAR(all.fit_percent, 100 * (1 - std::sqrt(error / spread)), 1e-6);
  EXPECT_LE(all.fit_percent,
            std::max(all.recordings[0].fit_percent, all.recordings[1].fit_percent));
}

TEST(Quality, TakesTheValidationErrorFromWhatJudges) {
  const Recording both =
      joined({noisy_recording("a.csv", 0.1, 1)}, {noisy_recording("b.csv", 0.4, 2)});
  const Fitter fitter(both, Column::y);
  const Fit fit = fitter.start({});
  const FitQuality all = quality(fitter, fit);
  EXPECT_NEAR(all.rmse, 0.1, 0.02);
  EXPECT_NEAR(all.rmse, fitter.rmse_on(fit, true), 1e-12);
  ASSERT_EQ(all.recordings.size(), 2U);
  EXPECT_TRUE(all.recordings[1].judges);
  EXPECT_NEAR(all.rmse_validation, all.recordings[1].rmse, 1e-9);
  EXPECT_NEAR(all.rmse_validation, 0.4, 0.05);
}

TEST(Quality, OfASingleRecordingIsItsOwn) {
  const Recording one = noisy_recording("a.csv", 0.2, 3);
  const Fitter fitter(one, Column::y);
  const FitQuality all = quality(fitter, fitter.start({}));
  ASSERT_EQ(all.recordings.size(), 1U);
  EXPECT_NEAR(all.recordings[0].rmse, all.rmse, 1e-12);
  EXPECT_NEAR(all.recordings[0].fit_percent, all.fit_percent, 1e-9);
  EXPECT_NEAR(all.recordings[0].rmse_validation, all.rmse_validation, 1e-12);
}

}  // namespace
}  // namespace workbench
