#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "firmware/learn/braille_plot.hpp"

namespace firmware {
namespace {

TEST(BraillePlot, DrawsFromTheLowestToTheHighest) {
  const std::array<double, 4> rise = {0, 1, 2, 3};
  const auto lines = braille_plot(rise, 2, 1);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0], "⣠⠞") << "each column from the value before it";
}

TEST(BraillePlot, AStandingValueIsALineAndNothingIsBlank) {
  const std::array<double, 3> still = {5, 5, 5};
  EXPECT_EQ(braille_plot(still, 3, 1)[0], "⠒⠒⠒");
  EXPECT_EQ(braille_plot({}, 2, 2), (std::vector<std::string>{"⠀⠀", "⠀⠀"}));
  const std::array<double, 2> none = {NAN, HUGE_VAL};
  EXPECT_EQ(braille_plot(none, 2, 1)[0], "⠀⠀");
}

}  // namespace
}  // namespace firmware
