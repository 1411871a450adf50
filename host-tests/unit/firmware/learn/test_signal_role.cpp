#include <gtest/gtest.h>

#include "firmware/learn/signal_role.hpp"

namespace firmware {
namespace {

TEST(SignalRole, IsInTheName) {
  EXPECT_TRUE(named_u("OP"));
  EXPECT_TRUE(named_u("FIC211_op"));
  EXPECT_TRUE(named_u("ValvePosition"));
  EXPECT_TRUE(named_y("PV"));
  EXPECT_TRUE(named_y("TankLevel"));
  EXPECT_TRUE(named_sp("Setpoint"));
  EXPECT_TRUE(named_sp("SP_3"));
  EXPECT_FALSE(named_u("Speed"));
  EXPECT_FALSE(named_u("STOPPED")) << "two letters within a word say nothing";
  EXPECT_FALSE(named_sp("RESPONSE"));
  EXPECT_FALSE(named_y("OP"));
  EXPECT_FALSE(named_u(""));
}

TEST(SignalRole, TitlesWithTheSameNumbersAreOfOneLoop) {
  EXPECT_EQ(same_loop("L1OP.OP", "L1PV.PV"), SameLoop::kYes);
  EXPECT_EQ(same_loop("L1OP.OP", "L3PV.PV"), SameLoop::kNo);
  EXPECT_EQ(same_loop("L1OP.OP", "L10PV.PV"), SameLoop::kNo);
  EXPECT_EQ(same_loop("FIC_211.MV", "fic-211.flow"), SameLoop::kYes);
  EXPECT_EQ(same_loop("FIC211.OP", "FT211.PV"), SameLoop::kYes);
}

TEST(SignalRole, TitlesWithoutNumbersAreOfOneLoopWhereTheRestIsTheSame) {
  EXPECT_EQ(same_loop("BoilerOP.OP", "BoilerPV.PV"), SameLoop::kYes);
  EXPECT_EQ(same_loop("BoilerOP.OP", "DrumPV.PV"), SameLoop::kUnknown);
  EXPECT_EQ(same_loop("OP", "PV"), SameLoop::kUnknown) << "nothing is left of either";
  EXPECT_EQ(same_loop("Boiler1.OP", "Drum.PV"), SameLoop::kUnknown);
  EXPECT_EQ(same_loop("", ""), SameLoop::kUnknown);
}

}  // namespace
}  // namespace firmware
