#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "ident/signal/stroke_pace.hpp"

namespace ident {
namespace {

using Strokes = std::vector<Reversal<double>>;

// Strokes that last 100 samples up and 60 down but for a share of that, and go as far as
// `together` says.
Strokes strokes_of(int count, double spread, double together) {
  Strokes out;
  for (int k = 0; k < count; ++k) {
    const double away = std::sqrt(2.0) * std::sin(1.7 * k);
    const double other = std::sqrt(2.0) * std::cos(2.9 * k);
    const double time = (k % 2 == 0 ? 100 : 60) * (1 + spread * away);
    const double way =
        5 * (1 + 0.03 * (together * away + std::sqrt(1 - together * together) * other));
    out.push_back({static_cast<std::size_t>(std::lround(time)), way, k % 2 == 0});
  }
  return out;
}

bool keeps(const Strokes& strokes) {
  StrokePace<double> pace;
  if constexpr (kStrokePace) pace = measure_pace<double>(strokes);
  return keeps_foreign_time(pace);
}

TEST(StrokePace, MeasuresEachDirectionByItself) {
  const StrokePace<double, true> pace = measure_pace<double>(strokes_of(40, 0.05, 0.8));
  EXPECT_EQ(pace.strokes, 40);
  EXPECT_NEAR(pace.spread, 0.05, 0.01);
  EXPECT_NEAR(pace.together, 0.8, 0.1);
}

TEST(StrokePace, OfAForeignTimeGoesFartherWhereItLastsLonger) {
  EXPECT_EQ(keeps(strokes_of(40, 0.05, 0.8)), kStrokePace);
  EXPECT_FALSE(keeps(strokes_of(40, 0.05, -0.5)));
  EXPECT_FALSE(keeps(strokes_of(40, 0.05, 0)));
  EXPECT_FALSE(keeps(strokes_of(40, 0.25, 0.8))) << "what disturbs it makes it vary";
  EXPECT_FALSE(keeps(strokes_of(6, 0.05, 0.8))) << "too few";
  EXPECT_FALSE(keeps(strokes_of(12, 0.05, 0.3))) << "by chance";
}

TEST(StrokePace, OfStrokesThatAreAllAlikeSaysNothing) {
  EXPECT_FALSE(keeps(Strokes(20, {50, 3.0, true})));
  EXPECT_FALSE(keeps({}));
}

}  // namespace
}  // namespace ident
