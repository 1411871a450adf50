// Where a residual is looked for: the coordinates of its samples.
#include <gtest/gtest.h>

#include <vector>

#include "workbench/model/judge/views.hpp"

namespace workbench {
namespace {

// u steps up at 10, 30, … and down at 20, 40, …
Situation stairs(std::vector<double>& u) {
  u.resize(100);
  for (std::size_t k = 0; k < u.size(); ++k) u[k] = k / 10 % 2 == 0 ? 0 : 50;
  return situation_of(u, u, 1);
}

const Binning& seen_in(View view, const std::vector<Binning>& all) {
  for (const Binning& one : all) {
    if (one.view == view) return one;
  }
  ADD_FAILURE() << "no such view";
  return all.front();
}

// What y does while u rests at the top answers the step up.
TEST(Views, UHasRisenUntilItTurnsDown) {
  std::vector<double> u;
  const Situation s = stairs(u);
  std::vector<double> t(u.size());
  for (std::size_t k = 0; k < t.size(); ++k) t[k] = static_cast<double>(k);
  const std::vector<Binning> all = binnings_of(s, t);
  const Binning& direction = seen_in(View::kDirection, all);
  for (std::size_t k = 10; k < u.size(); ++k) {
    const auto bin = static_cast<std::size_t>(direction.bin[k]);
    const bool rising = u[k] > 0 && k % 10 != 9;
    if (k % 10 == 9) continue;  // it turns with the next sample
    EXPECT_EQ(place_in_words(direction, bin, bin), rising ? "rising u" : "falling u")
        << k;
  }
  const Binning& travel = seen_in(View::kTravel, all);
  EXPECT_GT(travel.position[static_cast<std::size_t>(travel.bin[15])], 45);
  EXPECT_LT(travel.position[static_cast<std::size_t>(travel.bin[25])], -45);
  const Binning& phase = seen_in(View::kPhase, all);
  EXPECT_LT(phase.position[static_cast<std::size_t>(phase.bin[12])], 0.25);
  EXPECT_GT(phase.position[static_cast<std::size_t>(phase.bin[22])], 0.5);
  EXPECT_LT(phase.position[static_cast<std::size_t>(phase.bin[22])], 0.75);
}

}  // namespace
}  // namespace workbench
