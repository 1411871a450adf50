#include <gtest/gtest.h>

#include "workbench/recording/recording.hpp"

namespace workbench {
namespace {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

Pairs pairs(const std::vector<SampleRange>& ranges) {
  Pairs out;
  for (const SampleRange& range : ranges) out.emplace_back(range.first, range.last);
  return out;
}

TEST(Recording, RangesAreClippedAndCountedFromThePart) {
  const std::vector<SampleRange> ranges{{0, 5}, {8, 12}, {20, 30}, {40, 50}};
  EXPECT_EQ(pairs(clipped(ranges, {10, 45})), (Pairs{{0, 2}, {10, 20}, {30, 35}}));
  EXPECT_TRUE(clipped(ranges, {5, 8}).empty());
}

TEST(Recording, AColumnHasAName) {
  EXPECT_EQ(name_of(Column::u), "u");
  EXPECT_EQ(name_of(Column::sp), "sp");
  EXPECT_EQ(column_named("sp"), Column::sp);
  EXPECT_EQ(column_named("t"), Column::t);
  EXPECT_EQ(column_named("load"), std::nullopt);
}

}  // namespace
}  // namespace workbench
