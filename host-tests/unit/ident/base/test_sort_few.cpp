#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "ident/base/sort_few.hpp"

namespace ident {
namespace {

TEST(SortFew, PutsEveryOrderOfAFewInOrder) {
  std::vector<int> values{1, 2, 2, 5, 9};
  const std::vector<int> sorted = values;
  do {
    std::vector<int> copy = values;
    sort_few(copy.begin(), copy.end(), std::less<>());
    ASSERT_EQ(copy, sorted);
  } while (std::next_permutation(values.begin(), values.end()));
}

TEST(SortFew, LeavesWhatLiesBehindTheEnd) {
  std::vector<int> values{3, 1, 2, 0};
  sort_few(values.begin(), values.begin() + 3, std::greater<>());
  EXPECT_EQ(values, (std::vector<int>{3, 2, 1, 0}));
  sort_few(values.begin(), values.begin(), std::less<>());
  EXPECT_EQ(values.front(), 3);
}

}  // namespace
}  // namespace ident
