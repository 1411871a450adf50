#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "workbench/recording/listed.hpp"

namespace workbench {
namespace {

TEST(Listed, SaysEachWithMarksBetween) {
  const std::vector<std::string> names{"a", "b", "c"};
  EXPECT_EQ(listed(names), "a, b, c");
  EXPECT_EQ(listed(names, " or "), "a or b or c");
  EXPECT_EQ(listed(std::vector{1, 2}, ";", [](int n) { return std::to_string(2 * n); }),
            "2;4");
  EXPECT_EQ(listed(std::vector<std::string>{}), "");
}

TEST(Listed, SaysHowManyMoreThereAre) {
  const std::vector<std::string> names{"a", "bc", "d"};
  EXPECT_EQ(first_listed(names, {.things = 2}), "a, bc and 1 more");
  EXPECT_EQ(first_listed(names, {.things = 3}), "a, bc, d");
  EXPECT_EQ(first_listed(names, {.letters = 1}, " "), "a bc and 1 more");
  EXPECT_EQ(first_listed(names, {.letters = 0}), "a and 2 more");
  EXPECT_EQ(first_listed(std::vector<std::string>{}, {.things = 0}), "");
}

}  // namespace
}  // namespace workbench
