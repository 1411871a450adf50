// Sentences with gaps.
#include <gtest/gtest.h>

#include "workbench/recording/filled.hpp"

namespace workbench {
namespace {

TEST(Filled, PutsValuesWhereTheirNumbersStand) {
  EXPECT_EQ(filled("{1} before {0}, {0} again.", {"a", "b"}), "b before a, a again.");
  EXPECT_EQ(filled("nothing", {}), "nothing");
  EXPECT_EQ(filled("", {"a"}), "");
}

TEST(Filled, LeavesWhatIsNoGap) {
  EXPECT_EQ(filled("{x} {0 {} {2} {", {"a", "b"}), "{x} {0 {} {2} {");
  EXPECT_EQ(filled("{0}", {"{1}", "b"}), "{1}");
}

}  // namespace
}  // namespace workbench
