#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "workbench/recording/rows/rows_without.hpp"

namespace workbench {
namespace {

class BadCodes : public testing::Test {
 protected:
  void given(std::vector<double> values) {
    signal_.name = "PV";
    signal_.values = std::move(values);
    take_out_codes(signal_, report_);
  }
  [[nodiscard]] std::size_t gaps() const {
    std::size_t count = 0;
    for (const double value : signal_.values) count += std::isnan(value) ? 1 : 0;
    return count;
  }

  SignalRows signal_;
  ResampleReport report_;
};

TEST_F(BadCodes, FarFromAllOthersAreNoValues) {
  given({57, 60, -9999, 62, 59, -9999, 58});
  EXPECT_EQ(gaps(), 2u);
  EXPECT_EQ(signal_.bad, 2u);
  ASSERT_EQ(report_.notes.size(), 1u);
  EXPECT_EQ(report_.notes[0],
            "2 cells of 'PV' with -9999, a code for a missing value far from all others "
            "(57 to 62): taken as no value");
}

TEST_F(BadCodes, OneAloneOrSeveralAreNoValues) {
  given({57, 60, 65535, 62, 59, -999.25, 58});
  EXPECT_EQ(gaps(), 2u);
  EXPECT_EQ(report_.notes.size(), 2u);
}

TEST_F(BadCodes, BeyondAnyMeasurementIsNoValue) {
  given({57, 60, 3.4028235e38, 62, 59, -1e30, 58});
  EXPECT_EQ(gaps(), 2u);
}

TEST_F(BadCodes, StayInTheRangeOfTheSignal) {
  given({0, 5000, 9999, 10000, 9999, 4000});
  EXPECT_EQ(gaps(), 0u);
  EXPECT_TRUE(report_.notes.empty());
}

TEST_F(BadCodes, StayWhereTheyAreReachedGradually) {
  given({20000, 24000, 30000, 32767, 32767, 32767, 31000});
  EXPECT_EQ(gaps(), 0u);
}

TEST_F(BadCodes, OthersStayHoweverFarTheyJump) {
  given({57, 60, -8000, 62, 59, -1, 58});
  EXPECT_EQ(gaps(), 0u);
}

TEST_F(BadCodes, StayWhereMostRowsHoldThem) {
  given({57, 9999, 9999, 58, 9999});
  EXPECT_EQ(gaps(), 0u);
}

}  // namespace
}  // namespace workbench
