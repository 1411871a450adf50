#include <gtest/gtest.h>

#include "ident/two_path/knots.hpp"

namespace ident {
namespace {

TEST(Knots, BeginEqualOverTheRangeOfU) {
  const KnotGrid<double> grid = uniform_grid<double>();
  for (const Path<double>* path : {&grid.ascending, &grid.descending}) {
    ASSERT_EQ(path->segments, kMaxSegments);
    EXPECT_EQ(path->knots[0], 0);
    EXPECT_DOUBLE_EQ(path->knots[1], 1.0 / kMaxSegments);
    EXPECT_EQ(path->knots[kMaxSegments], 1);
  }
}

// Flat, a jump, flat: the knots inside the flat ends go, the jump is split in three.
TEST(Knots, GatherWhereThePathRises) {
  Path<double> path;
  path.segments = 5;
  path.knots = {0, 0.2, 0.4, 0.6, 0.8, 1};
  path.x = {1, 1, 1, 2, 2, 2};
  ASSERT_TRUE(refine_knots(path));
  ASSERT_EQ(path.segments, 5);
  const double knots[] = {0, 0.4, 0.4 + 0.2 / 3, 0.4 + 0.4 / 3, 0.6, 1};
  const double x[] = {1, 1, 1 + 1.0 / 3, 1 + 2.0 / 3, 2, 2};
  for (int k = 0; k <= path.segments; ++k) {
    EXPECT_NEAR(path.knots[k], knots[k], 1e-12) << k;
    EXPECT_NEAR(path.x[k], x[k], 1e-12) << k;
  }
}

TEST(Knots, StayWhereNothingRisesOrNoRoomIsLeft) {
  Path<double> flat;
  flat.segments = 1;
  flat.knots = {0, 1};
  flat.x = {2, 2};
  EXPECT_FALSE(refine_knots(flat));
  Path<double> full = uniform_grid<double>().ascending;
  for (int k = 0; k <= kMaxSegments; ++k) full.x[k] = k * k;
  EXPECT_FALSE(refine_knots(full));
}

// One step in many that is worth splitting: two more segments have to fit.
TEST(Knots, SplitAsLongAsThereIsRoomForTwoMore) {
  for (const int segments : {kMaxSegments - 2, kMaxSegments - 1}) {
    Path<double> path;
    path.segments = segments;
    for (int k = 0; k <= segments; ++k) {
      path.knots[k] = static_cast<double>(k) / segments;
      path.x[k] = k < segments ? k : k + 2;
    }
    EXPECT_EQ(refine_knots(path), segments + 2 <= kMaxSegments) << segments;
    EXPECT_EQ(path.segments, segments + 2 <= kMaxSegments ? segments + 2 : segments);
    EXPECT_EQ(path.knots[path.segments], 1);
    EXPECT_EQ(path.x[path.segments], segments + 2);
  }
}

}  // namespace
}  // namespace ident
