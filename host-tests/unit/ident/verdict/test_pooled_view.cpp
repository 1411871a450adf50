#include "ident/verdict/pooled_view.hpp"

#include <gtest/gtest.h>

namespace ident {
namespace {

PooledView view(double nats, float windows) {
  LadderFinding<double> pooled;
  pooled.predicted = 1000;
  pooled.nats = nats;
  return view_of(pooled, windows);
}

TEST(PooledView, SaysNothingThatOneWindowDoesNot) {
  EXPECT_EQ(view(1000, 1), PooledView::kSilent);
  EXPECT_EQ(view(-1000, 1), PooledView::kSilent);
  EXPECT_EQ(view_of(LadderFinding<double>{}, 9), PooledView::kSilent);
}

TEST(PooledView, NeedsMoreOfMoreWindows) {
  EXPECT_EQ(view(81, 4), PooledView::kSticks);
  EXPECT_EQ(view(79, 4), PooledView::kSilent);
  EXPECT_EQ(view(81, 9), PooledView::kSilent);
  EXPECT_EQ(view(121, 9), PooledView::kSticks);
}

TEST(PooledView, KnowsOfNothingBelowNone) {
  EXPECT_EQ(view(-1, 2), PooledView::kNothing);
  EXPECT_EQ(view(1, 2), PooledView::kSilent);
}

}  // namespace
}  // namespace ident
