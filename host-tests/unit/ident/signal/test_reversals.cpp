#include <gtest/gtest.h>

#include <vector>

#include "ident/signal/reversals.hpp"
#include "support/ident/problems.hpp"

namespace ident {
namespace {

using Values = std::vector<double>;

struct Marked {
  std::size_t count = 0;
  std::vector<Reversal<double>> found;
  std::vector<unsigned char> ascending;
};

Marked mark(const Values& u, double threshold, std::size_t room = 100) {
  Marked m;
  m.found.resize(room);
  m.ascending.resize(u.size(), 7);
  m.count = mark_directions<double>(u, threshold, m.ascending, m.found);
  m.found.resize(std::min(m.count, room));
  return m;
}

using Flags = std::vector<unsigned char>;

// Up to 3 at sample 3, down to 0 at 6, up again. With a threshold of 1.5 the maximum is
// confirmed at sample 5 (3 − 1), the minimum at 8 (2 − 0). Sample 0 is in the middle of a
// stroke for all that is known.
TEST(Reversals, DateBackToTheExtreme) {
  const Values u{0, 1, 2, 3, 2, 1, 0, 1, 2, 3};
  ReversalTracker<double> tracker(1.5);
  for (std::size_t t = 0; t < u.size(); ++t) {
    const auto reversal = tracker.push(u[t]);
    EXPECT_EQ(reversal.has_value(), t == 5 || t == 8) << t;
    if (t == 5) {
      EXPECT_TRUE(reversal->maximum);
      EXPECT_EQ(reversal->index, 3U);
      EXPECT_EQ(reversal->value, 3);
    }
    if (t == 8) {
      EXPECT_FALSE(reversal->maximum);
      EXPECT_EQ(reversal->index, 6U);
      EXPECT_EQ(reversal->value, 0);
    }
    EXPECT_EQ(tracker.direction(), t < 2 ? 0 : t < 5 ? 1 : t < 8 ? -1 : 1) << t;
  }
}

TEST(Reversals, MarkEachSampleByTheStrokeItBelongsTo) {
  const Marked m = mark({0, 1, 2, 3, 2, 1, 0, 1, 2, 3}, 1.5);
  // The extreme itself ends the stroke that led to it.
  EXPECT_EQ(m.ascending, (Flags{1, 1, 1, 1, 0, 0, 0, 1, 1, 1}));
  EXPECT_EQ(m.count, 2U);
}

TEST(Reversals, IgnoreARetreatOfTheThresholdItself) {
  EXPECT_EQ(mark({0, 5, 4, 5, 4, 6}, 1.0).count, 0U);
  EXPECT_EQ(mark({0, 5, 3.9, 5, 3.9, 6}, 1.0).count, 4U);
}

// A flat top is dated to its first sample.
TEST(Reversals, OnAPlateau) {
  const Marked m = mark({0, 2, 4, 4, 4, 4, 2, 0, 0, 0, 2, 4}, 1);
  ASSERT_EQ(m.count, 2U);
  EXPECT_EQ(m.found[0].index, 2U);
  EXPECT_EQ(m.found[1].index, 7U);
  EXPECT_EQ(m.ascending, (Flags{1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1, 1}));
}

TEST(Reversals, NoneInAConstant) {
  const Marked m = mark(Values(50, 3.25), 0.1);
  EXPECT_EQ(m.count, 0U);
  EXPECT_EQ(m.ascending, Flags(50, 0));
}

TEST(Reversals, NoneBelowTheThresholdTakesTheTrend) {
  EXPECT_EQ(mark({0, 0.2, 0.1, 0.3}, 1).ascending, Flags(4, 1));
  EXPECT_EQ(mark({0.3, 0.2, 0.1, 0.2}, 1).ascending, Flags(4, 0));
  EXPECT_EQ(mark({}, 1).count, 0U);
  EXPECT_EQ(mark({2}, 1).ascending, Flags(1, 0));
}

TEST(Reversals, CountBeyondTheRoom) {
  const Values u{0, 3, 0, 3, 0, 3, 0};
  const Marked all = mark(u, 1);
  const Marked two = mark(u, 1, 2);
  EXPECT_EQ(all.count, 5U);
  EXPECT_EQ(two.count, 5U);
  EXPECT_EQ(two.found.size(), 2U);
  EXPECT_EQ(two.found[1].index, all.found[1].index);
  EXPECT_EQ(two.ascending, all.ascending);
}

// A triangle of amplitude 1 and period 100 with noise of 5 %, threshold 0.6: exactly two
// reversals a period, alternating, each within the reach of the noise (0.04 a sample,
// four standard deviations of 0.05: five samples).
TEST(Reversals, OfANoisyTriangle) {
  test::Random random(7);
  Values u(1000);
  for (std::size_t t = 0; t < u.size(); ++t) {
    const double phase = static_cast<double>(t % 100) / 100;
    u[t] = (phase < 0.5 ? 4 * phase - 1 : 3 - 4 * phase) + 0.05 * test::normal(random);
  }
  const Marked m = mark(u, 0.6);
  ASSERT_EQ(m.count, 19U);
  for (std::size_t k = 0; k < m.count; ++k) {
    EXPECT_EQ(m.found[k].maximum, k % 2 == 0);
    EXPECT_NEAR(static_cast<double>(m.found[k].index), 50.0 * static_cast<double>(k + 1),
                6);
    EXPECT_EQ(m.found[k].value, u[m.found[k].index]);
  }
  // Equation (3) taken literally would find a few hundred.
  EXPECT_GT(mark(u, 1e-9).count, 200U);
}

}  // namespace
}  // namespace ident
