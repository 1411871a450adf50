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

}  // namespace
}  // namespace workbench
