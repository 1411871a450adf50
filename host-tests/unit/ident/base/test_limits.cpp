#include <gtest/gtest.h>

#include "ident/base/limits.hpp"
#include "ident/base/nnls.hpp"
#include "ident/two_path/lagged_gram.hpp"

namespace ident {
namespace {

// κ, d and the increments of both paths.
static_assert(2 + 2 * kMaxSegments <= kMaxHats, "the iteration's problem must fit");
static_assert(kMaxNa + kMaxNb + 1 <= kMaxHats, "its process must fit");
// a, b, d, the initial state, κ and the increments.
static_assert(kMaxNa + kMaxNb + 1 + kMaxNa + 1 + 2 * kMaxSegments <= kMaxUnknowns,
              "the refinement's problem must fit");
static_assert(2 + 4 <= kMaxUnknowns, "two gains and four nuisances must fit");
static_assert(kMaxUnknowns < 64, "an unknown is one bit of an UnknownSet");

TEST(Limits, LeaveRoomForTheOldestLagOfEveryStructure) {
  EXPECT_GE(LaggedGram<float>::kFirst, kMaxNk + kMaxNb);
  EXPECT_GE(LaggedGram<float>::kFirst, kMaxNa);
  EXPECT_EQ(kMaxKnots, kMaxSegments + 1);
}

}  // namespace
}  // namespace ident
