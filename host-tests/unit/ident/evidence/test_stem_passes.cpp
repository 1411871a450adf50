// Passes over a window thinned out: what is laid, and what is summed of it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "ident/evidence/stem_passes.hpp"
#include "support/ident/problems.hpp"

namespace ident {
namespace {

using Signal = std::vector<double>;

// y follows a stem that plays between u − 1 and u + 1.
struct PlayingLoop {
  Signal u, y, stem, scratch;
  OneStepSums<double> sums;
  StemPasses<double> passes;

  explicit PlayingLoop(std::size_t samples) : scratch(samples) {
    test::Random random(3);
    double x = 0;
    double state = 0;
    for (std::size_t t = 0; t < samples; ++t) {
      u.push_back(4 * std::sin(static_cast<double>(t) / 40));
      x = moved(x, u.back());
      state += 0.2 * (x - state);
      stem.push_back(x);
      y.push_back(state + 0.05 * test::normal(random));
    }
  }
  static double moved(double x, double now) {
    return std::fmin(std::fmax(x, now - 1), now + 1);
  }
  void start(double period = 100) { passes.start({u, y, scratch, &sums, period, 8, 8}); }
  template <class Move>
  double nats_of(Move move) {
    bool over = false;
    while (!over) passes.piece(move, [&over] { over = true; });
    return passes.nats();
  }
  void divide() {
    passes.divide();
    bool over = false;
    while (!over) passes.piece([](double u) { return u; }, [&over] { over = true; });
  }
  void begin_with_u() {
    start();
    ASSERT_TRUE(passes.begin(kCoarseLagBins));
    EXPECT_EQ(nats_of_u(), 0);
    passes.next();
  }
  double nats_of_u() {
    return nats_of([](double) { return 100.0; });
  }
  double nats_of_play() {
    return nats_of([x = 0.0](double now) mutable { return x = moved(x, now); });
  }
};

// Means that begin with the first sample; what does not fill the last one is left.
TEST(StemPasses, ThinOutByMeans) {
  const Signal from{1, 2, 6, 0, -3, 3, 100};
  Signal to(2);
  thin_out<double>(from, 3, to);
  EXPECT_EQ(to, Signal({3, 0}));
}

TEST(StemPasses, LayUItselfFirst) {
  PlayingLoop loop(1000);
  loop.start();
  ASSERT_TRUE(loop.passes.begin(kCoarseLagBins));
  EXPECT_EQ(loop.nats_of_u(), 0);
  EXPECT_TRUE(loop.passes.follows());
  loop.passes.next();
  EXPECT_EQ(loop.nats_of([](double u) { return u; }), 0);
  EXPECT_FALSE(loop.passes.follows());
}

TEST(StemPasses, SumAStemWhereUStood) {
  PlayingLoop loop(1000);
  loop.begin_with_u();
  const double found = loop.nats_of_play();
  EXPECT_GT(found, 20);

  OneStepSums<double> sums;
  const std::size_t reach = 60;
  sums.start(kCoarseLagBins);
  sums.add(loop.y, {}, reach, 1000);
  sums.begin_input();
  sums.add(loop.y, loop.stem, reach, 1000);
  EXPECT_NEAR(found, 470 * std::log(loop.passes.error_of_u() / sums.error()), 1e-6);
}

TEST(StemPasses, AreTheSameForASecondSetOfLags) {
  PlayingLoop loop(1000);
  loop.begin_with_u();
  const double found = loop.nats_of_play();
  ASSERT_TRUE(loop.passes.begin(kCoarseLagBins));
  EXPECT_EQ(loop.nats_of_u(), 0);
  loop.passes.next();
  EXPECT_EQ(loop.nats_of_play(), found);
}

TEST(StemPasses, DivideWhatAStemSaysIntoParts) {
  PlayingLoop loop(1000);
  loop.start();
  ASSERT_TRUE(loop.passes.begin(kCoarseLagBins));
  double nats = loop.nats_of_u();
  loop.divide();
  EXPECT_TRUE(loop.passes.divided());
  loop.passes.next();
  EXPECT_FALSE(loop.passes.divided());
  nats = loop.nats_of_play();
  loop.divide();
  EXPECT_GT(loop.passes.without_excess(nats), nats / 2);
  EXPECT_LE(loop.passes.without_excess(nats), nats);
}

TEST(StemPasses, ThinOutALongWindow) {
  PlayingLoop loop(2000);
  loop.start(500);
  EXPECT_EQ(loop.passes.thinning(), 4U);
  EXPECT_EQ(loop.passes.count(), 500U);
  loop.passes.thin();
  EXPECT_NEAR(loop.passes.y()[1], (loop.y[4] + loop.y[5] + loop.y[6] + loop.y[7]) / 4,
              1e-12);
}

TEST(StemPasses, BeginInNoWindowTooShort) {
  PlayingLoop loop(200);
  loop.start();
  EXPECT_EQ(loop.passes.rows(), 0U);
  ASSERT_TRUE(loop.passes.begin(kCoarseLagBins));
  EXPECT_EQ(loop.passes.rows(), 178U) << "the past is an eighth";
  EXPECT_TRUE(loop.passes.begin_at(140, kCoarseLagBins));
  EXPECT_EQ(loop.passes.rows(), 60U);
  EXPECT_FALSE(loop.passes.begin_at(141, kCoarseLagBins));
  EXPECT_EQ(loop.passes.rows(), 60U);
}

}  // namespace
}  // namespace ident
