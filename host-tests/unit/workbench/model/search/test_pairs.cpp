// Two effects of which none explains much without the other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/search/candidates.hpp"

namespace workbench {
namespace {

using test::SetpointLoop;
using test::simulated;

// Stays where it is, away from u at first, until u is 4 ahead; then follows 1.5 behind
// until u turns.
std::function<double(double)> sticking() {
  return [x = 47.0, way = 0](double u) mutable {
    const double pull = u - x;
    if (way <= 0 && pull > 4) way = 1;
    if (way >= 0 && -pull > 4) way = -1;
    if (way * pull > 1.5) x = u - way * 1.5;
    return x;
  };
}

// A limit cycle at a constant setpoint.
SetpointLoop cycling() {
  SetpointLoop loop;
  loop.samples = 2400;
  loop.setpoint_moves = false;
  loop.valve = sticking();
  return loop;
}

std::string first_of(const Recording& recording) {
  const Fitter fitter(recording, Column::y);
  Identified identified({recording});
  const Exploration found =
      explore(fitter, fitter.start({}), standard_catalogue(), identified, {}, 1e300);
  const Candidate* best = found.result.best();
  std::string out = best != nullptr ? best->effect : "";
  if (best == nullptr) return out;
  for (const std::string& other : best->with) out += " " + other;
  return out;
}

TEST(Pairs, AStemIsLookedForBesideTheRampThatHidesIt) {
  SetpointLoop loop = cycling();
  loop.load = [](std::size_t k) { return k < 400 ? 0.0 : 0.003 * double(k - 400); };
  EXPECT_EQ(first_of(simulated(loop)), "valve.stiction disturbance.ramp");
}

TEST(Pairs, AStemIsLookedForBesideTheSwingThatHidesIt) {
  SetpointLoop loop = cycling();
  loop.load = [](std::size_t k) {
    return std::sin(2 * std::numbers::pi * double(k) / 47);
  };
  EXPECT_EQ(first_of(simulated(loop)), "valve.stiction disturbance.sinusoid");
}

TEST(Pairs, ALimitIsLookedForBesideTheRampThatHidesIt) {
  SetpointLoop loop;
  loop.samples = 1500;
  loop.valve = [](double u) { return std::min(u, 52.0); };
  loop.load = [](std::size_t k) { return k < 900 ? 0.0 : 0.03 * double(k - 900); };
  EXPECT_EQ(first_of(simulated(loop)), "valve.saturation disturbance.ramp");
}

TEST(Pairs, AStemAloneNeedsNone) {
  EXPECT_EQ(first_of(simulated(cycling())), "valve.stiction");
}

}  // namespace
}  // namespace workbench
