#include <gtest/gtest.h>

#include "ident/base/pair.hpp"

namespace ident {
namespace {

template <class Real>
class PairOfNumbers : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(PairOfNumbers, Precisions);

TYPED_TEST(PairOfNumbers, CalculatesByElement) {
  using Two = Pair<TypeParam>;
  const Two a{TypeParam(5), TypeParam(-3)};
  const Two b{TypeParam(2), TypeParam(4)};
  EXPECT_EQ((a + b)[0], 7);
  EXPECT_EQ((a + b)[1], 1);
  EXPECT_EQ((a - b)[0], 3);
  EXPECT_EQ((a - b)[1], -7);
  EXPECT_EQ((a * b)[0], 10);
  EXPECT_EQ((a * b)[1], -12);
  Two sum{};
  sum += a;
  sum += b;
  EXPECT_EQ(sum[0], 7);
  EXPECT_EQ(sum[1], 1);
  EXPECT_EQ(sum_of<TypeParam>(a), 2);
  EXPECT_EQ(twice(TypeParam(6))[0], 6);
  EXPECT_EQ(twice(TypeParam(6))[1], 6);
}

TYPED_TEST(PairOfNumbers, IsReadAndWrittenAnywhere) {
  TypeParam values[4] = {1, 2, 3, 4};
  const Pair<TypeParam> middle = pair_at(values + 1);
  EXPECT_EQ(middle[0], 2);
  EXPECT_EQ(middle[1], 3);
  store<TypeParam>(middle, values + 2);
  EXPECT_EQ(values[1], 2);
  EXPECT_EQ(values[2], 2);
  EXPECT_EQ(values[3], 3);
}

}  // namespace
}  // namespace ident
