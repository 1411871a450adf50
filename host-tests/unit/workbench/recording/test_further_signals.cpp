#include <gtest/gtest.h>

#include <cmath>

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

std::vector<double> made(double (*value)(int k)) {
  std::vector<double> out;
  for (int k = 0; k < 200; ++k) out.push_back(value(k));
  return out;
}

TEST(FurtherSignals, AreNoCountsOfRowsOrTime) {
  EXPECT_TRUE(is_count(made([](int k) { return k + 1.0; })));
  EXPECT_TRUE(is_count(made([](int k) { return 500.0 - 2 * k; })));
  EXPECT_TRUE(is_count(made([](int k) { return std::sqrt(k); }))) << "a totaliser";
  EXPECT_TRUE(is_count(made([](int k) { return (k + 17) % 60 * 0.1; }))) << "a batch";
  EXPECT_TRUE(is_count(made([](int k) { return k % 20 == 7 ? k - 1.0 : k; })))
      << "rows that lack";
  EXPECT_EQ(names_of_moving({{"row", "", made([](int k) { return k + 1.0; })}}), Names{});
}

TEST(FurtherSignals, AreNoCountsWhereTheyTurn) {
  EXPECT_FALSE(is_count(made([](int k) { return std::sin(0.1 * k); })));
  EXPECT_FALSE(is_count(made([](int k) { return k / 100 + 0.0; }))) << "a step";
  EXPECT_FALSE(is_count(made([](int k) { return k % 3 + 0.0; })));
  EXPECT_FALSE(is_count(made([](int k) { return k + 3 * std::sin(1.7 * k); })))
      << "a drift with noise";
  EXPECT_FALSE(is_count(made([](int k) { return std::exp(k % 40 * 0.1); })))
      << "a vessel that is filled again and again";
  EXPECT_FALSE(is_count({})) << "nothing";
}

TEST(FurtherSignals, AreNamedUpToThree) {
  EXPECT_EQ(first_three({"a"}), "a");
  EXPECT_EQ(first_three({"a", "b", "c"}), "a, b, c");
  EXPECT_EQ(first_three({"a", "b", "c", "d", "e"}), "a, b, c and 2 more");
}

}  // namespace
}  // namespace workbench
