#include <gtest/gtest.h>

#include "ident/verdict/pooled_view.hpp"

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
  EXPECT_EQ(view(93, 4), PooledView::kSticks);
  EXPECT_EQ(view(91, 4), PooledView::kSilent);
  EXPECT_EQ(view(93, 9), PooledView::kSilent);
  EXPECT_EQ(view(139, 9), PooledView::kSticks);
}

TEST(PooledView, KnowsOfNothingBelowNone) {
  EXPECT_EQ(view(-1, 2), PooledView::kNothing);
  EXPECT_EQ(view(1, 2), PooledView::kSilent);
}

}  // namespace
}  // namespace ident
