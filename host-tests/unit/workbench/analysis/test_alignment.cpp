#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <string>

#include "support/ident/pi_loop.hpp"
#include "workbench/analysis/alignment.hpp"
#include "workbench/analysis/analysis.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace workbench {
namespace {

// With y `late` samples behind u, or u behind y where below 0.
template <class Loop>
Recording recorded(const Loop& loop, int late) {
  Recording out;
  out.period_s = 1;
  const std::size_t of_y = late > 0 ? static_cast<std::size_t>(late) : 0;
  const std::size_t of_u = late < 0 ? static_cast<std::size_t>(-late) : 0;
  const std::size_t first = of_y + of_u;
  for (std::size_t t = first; t < loop.u.size(); ++t) {
    out.t.push_back(static_cast<double>(t - first));
    out.u.push_back(loop.u[t - of_u]);
    out.y.push_back(loop.y[t - of_y]);
  }
  return out;
}

TEST(Alignment, IsSeenFromTheLawOfTheController) {
  for (const int late : {-2, -1, 0, 1, 3}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const test::LoopRecord loop = test::run(test::PiLoop{}, 600, seed);
      EXPECT_EQ(samples_late(recorded(loop, late)), late) << seed;
    }
  }
}

// In manual y answers u, not the other way round, and where nothing is known of the law
// nothing is moved.
TEST(Alignment, StaysWhereNoControllerIsSeen) {
  std::mt19937 random(5);
  std::normal_distribution<> normal;
  test::LoopRecord manual;
  double y = 0;
  for (int t = 0; t < 600; ++t) {
    const double before = manual.u.empty() ? 0 : manual.u.back();
    y = 0.7 * y + 0.3 * before + 0.01 * normal(random);
    manual.u.push_back(t / 50 % 2 == 0 ? 1.0 : -1.0);
    manual.y.push_back(y);
  }
  EXPECT_EQ(samples_late(recorded(manual, 0)), 0);
  EXPECT_EQ(samples_late(recorded(test::run(test::PiLoop{}, 40, 1), 1)), 0);
}

// Of a controller with much derivative action the law two rows late is the sharper one
// whose two parts agree; but it answers what it reads one row late.
TEST(Alignment, OfALawWithoutAnIntegralPartItsNeighbourIsNotTaken) {
  std::mt19937 random(5);
  std::normal_distribution<> normal;
  test::LoopRecord loop;
  for (std::size_t t = 0; t < 300; ++t) {
    loop.y.push_back(10 - 0.001 * static_cast<double>(t) + 0.1 * normal(random));
    loop.u.push_back(t < 2 ? 0 : 450 * (loop.y[t - 1] - 10) - 154 * (loop.y[t - 2] - 10));
  }
  EXPECT_EQ(samples_late(recorded(loop, 0)), 0);
}

// The rows of a start-up hide a law that is integral alone; without them it is seen, but
// as well from one row late to four.
TEST(Alignment, ALawThatIsIntegralAloneDoesNotTellWhen) {
  std::mt19937 random(5);
  std::normal_distribution<> normal;
  test::LoopRecord loop;
  double sum = 100;
  for (std::size_t t = 0; t < 300; ++t) {
    loop.y.push_back(std::sin(0.05 * static_cast<double>(t)));
    sum -= 0.5 * loop.y.back();
    loop.u.push_back(t < 3 ? 0 : sum + 0.05 * normal(random));
  }
  EXPECT_EQ(samples_late(recorded(loop, 0)), 0);
}

TEST(Alignment, PutsThemBesideOneAnother) {
  const test::LoopRecord loop = test::run(test::PiLoop{}, 100, 1);
  for (const int late : {-2, 1}) {
    const Recording recording = recorded(loop, late);
    const RecordingView view = aligned(recording, late);
    ASSERT_EQ(view.u.size(), view.y.size());
    ASSERT_EQ(view.t.size(), view.y.size());
    const std::size_t first = late > 0 ? 1 : 2;
    EXPECT_EQ(view.u[0], loop.u[first]);
    EXPECT_EQ(view.y[0], loop.y[first]);
    EXPECT_EQ(view.u.back(), loop.u[first + view.u.size() - 1]);
    EXPECT_EQ(view.y.back(), loop.y[first + view.u.size() - 1]);
  }
}

// u of the sample before was computed from a y that is late: it foretells that better
// than any stem does, and the valve went unseen.
TEST(Alignment, LetsAStickingValveBeSeen) {
  const SimulatedLoop loop = *simulate("stiction", 3);
  const Analysis analysis(recorded(loop, 1));
  EXPECT_EQ(analysis.result().verdict, ident::Verdict::kStiction);
  ASSERT_EQ(analysis.notes().size(), 1U);
  EXPECT_EQ(analysis.notes()[0], alignment_note(1));
}

TEST(Alignment, IsTold) {
  EXPECT_EQ(alignment_note(2),
            "y is recorded 2 samples later than the controller read it: moved back by as "
            "much");
  EXPECT_EQ(alignment_note(-1),
            "u is recorded one sample later than the controller set it: moved back by as "
            "much");
}

}  // namespace
}  // namespace workbench
