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
  EXPECT_EQ((a * b)[0], 10);
  EXPECT_EQ((a * b)[1], -12);
  Two sum{};
  sum += a;
  sum += b;
  EXPECT_EQ(sum[0], 7);
  EXPECT_EQ(sum[1], 1);
  EXPECT_EQ(sum_of<TypeParam>(a), 2);
}

TYPED_TEST(PairOfNumbers, IsReadAnywhere) {
  const TypeParam values[4] = {1, 2, 3, 4};
  const Pair<TypeParam> middle = pair_at(values + 1);
  EXPECT_EQ(middle[0], 2);
  EXPECT_EQ(middle[1], 3);
}

}  // namespace
}  // namespace ident
