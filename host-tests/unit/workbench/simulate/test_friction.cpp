#include <gtest/gtest.h>

#include "workbench/simulate/friction.hpp"

namespace workbench {
namespace {

TEST(SimulateFriction, ContractFormulas) {
  const Friction friction{5, 3, 1, 0.5};
  EXPECT_DOUBLE_EQ(friction.stick_band_ascending(), 5.5);
  EXPECT_DOUBLE_EQ(friction.stick_band_descending(), 4);
  EXPECT_DOUBLE_EQ(friction.slip_jump_ascending(), 4);
  EXPECT_DOUBLE_EQ(friction.slip_jump_descending(), 2.5);
}

TEST(SimulateFriction, PaperValveHasBandAndJumpFive) {
  const Friction friction{5, 5, 0, 0};
  EXPECT_DOUBLE_EQ(friction.stick_band_ascending(), 5);
  EXPECT_DOUBLE_EQ(friction.slip_jump_ascending(), 5);
}

TEST(SimulateFriction, BandsAndJumpsShareTheDeadband) {
  const Friction friction{5, 3, 1, 0.5};
  EXPECT_DOUBLE_EQ(friction.stick_band_ascending() - friction.slip_jump_ascending(),
                   friction.stick_band_descending() - friction.slip_jump_descending());
}

TEST(SimulateFriction, SymmetricBandAndJumpThereAndBack) {
  const Friction friction = friction_from_s_j(5, 3);
  EXPECT_DOUBLE_EQ(friction.static_ascending, 4);
  EXPECT_DOUBLE_EQ(friction.static_descending, 4);
  EXPECT_DOUBLE_EQ(friction.kinetic_ascending, 1);
  EXPECT_DOUBLE_EQ(friction.kinetic_descending, 1);
  EXPECT_DOUBLE_EQ(friction.stick_band_descending(), 5);
  EXPECT_DOUBLE_EQ(friction.slip_jump_descending(), 3);
}

TEST(SimulateFriction, UnequalBandsThereAndBack) {
  const Friction friction = friction_from_bands(6, 4, 1);
  EXPECT_DOUBLE_EQ(friction.stick_band_ascending(), 6);
  EXPECT_DOUBLE_EQ(friction.stick_band_descending(), 4);
  EXPECT_DOUBLE_EQ(friction.slip_jump_ascending(), 5);
  EXPECT_DOUBLE_EQ(friction.slip_jump_descending(), 3);
}

TEST(SimulateFriction, WithoutDeadbandOneStrokeIsFree) {
  const Friction friction = friction_from_bands(6, 0, 0);
  EXPECT_DOUBLE_EQ(friction.stick_band_descending(), 0);
  EXPECT_DOUBLE_EQ(friction.slip_jump_descending(), 0);
  EXPECT_DOUBLE_EQ(friction.slip_jump_ascending(), 6);
}

}  // namespace
}  // namespace workbench
