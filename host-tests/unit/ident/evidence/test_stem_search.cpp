// What the search proposes, and what it makes of what its stems are said to weigh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "ident/evidence/stem_search.hpp"

namespace ident {
namespace {

constexpr double kSwing = 2;
constexpr double kFirstU = 0.5;
constexpr double kWorth = 20;

struct Weighed {
  double nats = 0;
  int strokes = 30;
};
using Scales = std::function<Weighed(const ValveFriction<double>&)>;

/// The stems that were weighed until the search ended.
template <class Real>
int run(StemSearch<Real>& search, const Scales& scales) {
  search.start(Real(kSwing), Real(kFirstU), Real(kWorth));
  int count = 0;
  for (; !search.done() && count < 10000; ++count) {
    const ValveFriction<Real>& f = search.proposed().friction;
    const Weighed found =
        scales({static_cast<double>(f.deadband), static_cast<double>(f.slip_ascending),
                static_cast<double>(f.slip_descending), f.motion});
    search.report(static_cast<Real>(found.nats), found.strokes);
  }
  return count;
}

// A hill around stick bands of 1.2 and 0.5, the share of the slip of less weight.
Weighed hill(const ValveFriction<double>& f) {
  const double up = f.stick_ascending() - 1.2;
  const double down = f.stick_descending() - 0.5;
  const double deadband = f.deadband - 0.3;
  return {200 - 300 * (up * up + down * down) - 10 * deadband * deadband, 30};
}

TEST(StemSearch, FindsBandsThatTheGridDoesNotHave) {
  StemSearch<double> search;
  run(search, hill);
  ASSERT_TRUE(search.best().known);
  EXPECT_NEAR(search.best().friction.stick_ascending(), 1.2, 0.03);
  EXPECT_NEAR(search.best().friction.stick_descending(), 0.5, 0.03);
  EXPECT_GT(search.best().nats, 199);
  EXPECT_EQ(search.best().strokes, 30);
}

TEST(StemSearch, IsTheSameSearchInFloat) {
  StemSearch<float> search;
  run(search, hill);
  EXPECT_NEAR(search.best().friction.stick_ascending(), 1.2f, 0.03f);
  EXPECT_NEAR(search.best().friction.stick_descending(), 0.5f, 0.03f);
}

TEST(StemSearch, EndsWithTheGridWhereNothingIsWorthMore) {
  StemSearch<double> search;
  EXPECT_EQ(run(search, [](const auto&) { return Weighed{20, 30}; }), 176);
  EXPECT_EQ(search.best().nats, 20);
  const int more = run(search, [](const auto&) { return Weighed{20.1, 30}; });
  EXPECT_GT(more, 176);
  EXPECT_LE(more, 176 + 3 * 80);
}

TEST(StemSearch, AsksOnlyForValvesThatSlideWithinTheSwing) {
  StemSearch<double> search;
  run(search, [](const ValveFriction<double>& f) {
    EXPECT_EQ(f.motion, SlipMotion::kSlides);
    EXPECT_GE(f.deadband, 0);
    EXPECT_GE(f.slip_ascending, 0);
    EXPECT_GE(f.slip_descending, 0);
    EXPECT_LT(f.stick_ascending(), 1.5 * kSwing);
    EXPECT_GT(f.deadband + f.slip_ascending + f.slip_descending, 0);
    return hill(f);
  });
}

// What moves seldom, moves by chance.
TEST(StemSearch, DoesNotTakeAStemThatHardlyTurns) {
  StemSearch<double> search;
  EXPECT_EQ(run(search, [](const auto&) { return Weighed{500, 7}; }), 176);
  EXPECT_FALSE(search.best().known);
  run(search, [](const ValveFriction<double>& f) {
    return f.stick_ascending() > 1 ? Weighed{500, 7} : Weighed{hill(f).nats, 8};
  });
  EXPECT_LE(search.best().friction.stick_ascending(), 1);
  EXPECT_EQ(search.best().strokes, 8);
}

// 20 nats around the best, no more.
TEST(StemSearch, TellsWhichBandsComeNearTheBest) {
  StemSearch<double> search;
  double low = 9, high = 0;
  run(search, [&](const ValveFriction<double>& f) {
    const Weighed found = hill(f);
    if (found.nats > 180) {
      low = std::min(low, f.stick_ascending());
      high = std::max(high, f.stick_ascending());
    }
    return found;
  });
  EXPECT_LE(search.ascending().low, low);
  EXPECT_GE(search.ascending().high, high);
  EXPECT_LT(search.ascending().low, 1.2);
  EXPECT_GT(search.ascending().high, 1.2);
  // The hill falls by 20 nats within 0.26 of its top; a better stem that comes later
  // leaves what was near those before it.
  EXPECT_GT(search.ascending().low, 1.2 - 2 * 0.26);
  EXPECT_LT(search.ascending().high, 1.2 + 2 * 0.26);
  EXPECT_GT(search.descending().low, 0.5 - 2 * 0.26);
  EXPECT_LT(search.descending().high, 0.5 + 2 * 0.26);
}

TEST(StemSearch, KnowsTheBetterOfTwoHills) {
  StemSearch<double> search;
  run(search, [](const ValveFriction<double>& f) {
    const double far = std::hypot(f.stick_ascending() - 0.4, f.stick_descending() - 0.4);
    return Weighed{std::max(hill(f).nats, 230 - 900 * far), 30};
  });
  EXPECT_NEAR(search.best().friction.stick_ascending(), 0.4, 0.02);
  EXPECT_NEAR(search.best().friction.stick_descending(), 0.4, 0.02);
}

TEST(StemSearch, BeginsAnew) {
  StemSearch<double> search;
  run(search, hill);
  run(search, [](const auto&) { return Weighed{3, 30}; });
  EXPECT_EQ(search.best().nats, 3);
}

}  // namespace
}  // namespace ident
