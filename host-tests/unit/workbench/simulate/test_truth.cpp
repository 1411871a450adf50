#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "workbench/simulate/truth.hpp"

namespace workbench {
namespace {

TEST(SimulateTruth, NoiseCeilingByHand) {
  // Mean 2, squares around it 4 + 0 + 4 = 8; missed 0 + 1 + 1 = 2.
  const std::vector<double> y{0, 2, 4};
  const std::vector<double> clean{0, 1, 5};
  EXPECT_DOUBLE_EQ(noise_ceiling_percent(y, clean), 50);
  EXPECT_DOUBLE_EQ(noise_ceiling_percent(y, y), 100);
  EXPECT_DOUBLE_EQ(noise_ceiling_percent(y, std::vector<double>(3, 2.0)), 0);
  EXPECT_TRUE(std::isnan(
      noise_ceiling_percent(std::vector<double>{1, 1}, std::vector<double>{1, 1})));
}

TEST(SimulateTruth, JsonCarriesTheFigures) {
  LoopTruth truth;
  truth.scenario = "stiction";
  truth.seed = 0xFFFFFFFFFFFFFFFFu;
  truth.kind = "stiction";
  truth.cause = "stiction";
  truth.stick_band_ascending = 5;
  truth.slip_jump_descending = 2;
  truth.controller.high = 20;
  truth.noise_ceiling_percent = std::nan("");
  const nlohmann::json json = truth_json(truth);
  EXPECT_EQ(json.at("schema"), 1);
  EXPECT_EQ(json.at("kind"), "stiction");
  EXPECT_EQ(json.at("seed").get<std::uint64_t>(), truth.seed);
  EXPECT_EQ(json.at("stick_band").at("ascending"), 5);
  EXPECT_EQ(json.at("stick_band").at("descending"), 0);
  EXPECT_EQ(json.at("slip_jump").at("descending"), 2);
  EXPECT_TRUE(json.at("controller").at("low").is_null());
  EXPECT_EQ(json.at("controller").at("high"), 20);
  EXPECT_TRUE(json.at("noise_ceiling_percent").is_null());
  EXPECT_TRUE(json.at("oscillation_period_s").is_null());
  EXPECT_EQ(nlohmann::json::parse(json.dump()), json);
}

}  // namespace
}  // namespace workbench
