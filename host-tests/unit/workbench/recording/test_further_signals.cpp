#include <gtest/gtest.h>

#include "workbench/recording/further_signals.hpp"

namespace workbench {
namespace {

using Names = std::vector<std::string>;

TEST(FurtherSignals, AreThoseThatMoveAndAreNotOnlyWanted) {
  EXPECT_EQ(names_of_moving({{"q2", "%", {1, 2}},
                             {"rest", "", {3, 3}},
                             {"T setpoint", "", {1, 2}},
                             {"feed", "", {2, 1}}}),
            (Names{"q2", "feed"}));
  EXPECT_EQ(names_of_moving({}), Names{});
}

TEST(FurtherSignals, AreNamedUpToThree) {
  EXPECT_EQ(first_three({"a"}), "a");
  EXPECT_EQ(first_three({"a", "b", "c"}), "a, b, c");
  EXPECT_EQ(first_three({"a", "b", "c", "d", "e"}), "a, b, c and 2 more");
}

}  // namespace
}  // namespace workbench
