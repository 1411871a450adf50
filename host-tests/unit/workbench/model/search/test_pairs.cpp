// Two effects of which none explains much without the other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <numbers>
#include <random>
#include <string>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/model/search/candidates.hpp"
#include "workbench/model/search/ladder.hpp"

namespace workbench {
namespace {

using test::SetpointLoop;
using test::simulated;

// Stays where it is, away from u at first, until u is 4 ahead; then follows 1.5 behind
// until u turns.
std::function<double(double)> stuck_at_first() {
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
  loop.valve = stuck_at_first();
  return loop;
}

std::string named_first(const Recording& recording) {
  const Fitter fitter(recording, Column::y);
  Identified identified({recording});
  const Catalogue catalogue = standard_catalogue().with(recording.loads);
  const Exploration found =
      explore(fitter, fitter.start({}), catalogue, identified, {}, 1e300);
  const Candidate* best = found.result.best();
  std::string out = best != nullptr ? best->effect : "";
  if (best == nullptr) return out;
  for (const std::string& other : best->with) out += " " + other;
  return out;
}

TEST(Pairs, AStemIsLookedForBesideTheRampThatHidesIt) {
  SetpointLoop loop = cycling();
  loop.load = [](std::size_t k) { return k < 400 ? 0.0 : 0.003 * double(k - 400); };
  EXPECT_EQ(named_first(simulated(loop)), "valve.stiction disturbance.ramp");
}

TEST(Pairs, AStemIsLookedForBesideTheSwingThatHidesIt) {
  SetpointLoop loop = cycling();
  loop.load = [](std::size_t k) {
    return std::sin(2 * std::numbers::pi * double(k) / 47);
  };
  EXPECT_EQ(named_first(simulated(loop)), "valve.stiction disturbance.sinusoid");
}

TEST(Pairs, ALimitIsLookedForBesideTheRampThatHidesIt) {
  SetpointLoop loop;
  loop.samples = 1500;
  loop.valve = [](double u) { return std::min(u, 52.0); };
  loop.load = [](std::size_t k) { return k < 900 ? 0.0 : 0.03 * double(k - 900); };
  EXPECT_EQ(named_first(simulated(loop)), "valve.saturation disturbance.ramp");
}

// A tank under PI, with the flow out of it recorded.
Recording tank() {
  constexpr double kArea = 60;
  std::mt19937_64 random(82);
  std::normal_distribution<double> normal(0, 0.1);
  Recording out;
  out.name = "tank.csv";
  out.period_s = 1;
  std::vector<double> outflow;
  double level = 50;
  double integral = 0;
  for (std::size_t k = 0; k < 1500; ++k) {
    outflow.push_back(k < 150    ? 30
                      : k < 420  ? 36
                      : k < 700  ? 27
                      : k < 900  ? 33
                      : k < 1250 ? 25
                                 : 30);
    const double setpoint = k < 500 ? 50 : k < 1000 ? 54 : 48;
    const double y = level + normal(random);
    integral += 1.5 / 120 * (setpoint - y);
    out.t.push_back(static_cast<double>(k));
    out.u.push_back(40 + 1.5 * (setpoint - y) + integral);
    out.y.push_back(y);
    level += (out.u.back() - 40 - (outflow.back() - 30)) / kArea;
  }
  out.loads = {{"outflow", "m3/h", outflow}};
  return out;
}

TEST(Pairs, AStorageIsTriedBesideTheRecordedLoadThatItHolds) {
  EXPECT_EQ(named_first(tank()), "process.integrating disturbance.measured:outflow");
}

TEST(Pairs, ALoadIntoAStorageIsToldPerSecond) {
  const Recording recording = tank();
  const ExplainResult result = explain(
      recording, start_model(recording, Column::y, {"process.integrating"}).model);
  ASSERT_NE(result.best(), nullptr);
  EXPECT_EQ(result.best()->effect, "disturbance.measured:outflow");
  EXPECT_NE(result.best()->evidence.find("y per second"), std::string::npos);
  const std::vector<Parameter>& parameters = result.best()->parameters;
  EXPECT_EQ(parameters.front().name, "load_second_lag");
  EXPECT_EQ(parameters.back().unit, "y/s per unit");
  EXPECT_NEAR(parameters.back().value, -1.0 / 60, 0.001);
}

// Two heaters beside each other in steps: the far one is a recorded load, and the probe
// is slow.
Recording heaters() {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal(0, 0.1);
  const auto at = [](std::size_t k, std::initializer_list<double> levels) {
    return *(levels.begin() + std::min(k / 62, levels.size() - 1));
  };
  Recording out;
  out.name = "heaters.csv";
  out.period_s = 4;
  std::vector<double> far;
  double block = 0;
  double neighbour = 0;
  double probe = 0;
  for (std::size_t k = 0; k < 250; ++k) {
    out.t.push_back(4.0 * static_cast<double>(k));
    out.u.push_back(at(k + 30, {40, 95, 25, 100, 60}));
    out.y.push_back(20 + probe + normal(random));
    far.push_back(at(k + 50, {0, 80, 20, 70, 50}));
    for (int i = 0; i < 40; ++i) {
      block += 0.1 / 140 * (0.3 * out.u.back() - block);
      neighbour += 0.1 / 155 * (0.1 * far.back() - neighbour);
      probe += 0.1 / 18 * (block + neighbour - probe);
    }
  }
  out.loads = {{"far", "%", far}};
  return out;
}

TEST(Pairs, ALagIsLookedForBesideTheRecordedLoadThatHidesIt) {
  const std::string found = named_first(heaters());
  EXPECT_NE(found.find("disturbance.measured:far"), std::string::npos) << found;
  EXPECT_NE(found.find("lag"), std::string::npos) << found;
}

// Two lags in series are the same either way round, and so is who has the second.
TEST(Pairs, EachOfAPairIsToldWithItsNumbersAndWhatItMayAsWellBe) {
  const Recording recording = heaters();
  const ExplainResult result =
      explain(recording, start_model(recording, Column::y).model);
  const Candidate* best = result.best();
  ASSERT_NE(best, nullptr);
  ASSERT_EQ(best->with.size(), 1U);
  ASSERT_EQ(best->partners.size(), 1U);
  EXPECT_EQ(best->partners[0].effect, best->with[0]);
  EXPECT_FALSE(best->partners[0].parameters.empty());
  EXPECT_FALSE(best->indistinguishable_from.empty());
  for (const std::string& member : members_of(*best)) {
    EXPECT_EQ(std::count(best->indistinguishable_from.begin(),
                         best->indistinguishable_from.end(), member),
              0)
        << member;
  }
}

// A storage whose pump runs into its limits: neither shows without the other.
TEST(Pairs, AStorageIsTriedBesideTheLimitThatHoldsItBack) {
  Recording recording = heaters();
  recording.loads.clear();
  double level = 10;
  for (std::size_t k = 0; k < recording.size(); ++k) {
    const double swing = 90 * std::sin(0.1 * static_cast<double>(k));
    recording.u[k] = swing + 8 * std::sin(0.37 * static_cast<double>(k));
    recording.y[k] = level;
    level += 0.02 * std::clamp(recording.u[k], -25.0, 65.0) - 0.2;
  }
  const std::string found = named_first(recording);
  EXPECT_NE(found.find("process.integrating"), std::string::npos) << found;
}

// The position of a drive: what stores turns behind a lag.
TEST(Pairs, AStorageIsTriedBesideTheLagOfTheDrive) {
  Recording recording = heaters();
  recording.loads.clear();
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise(0, 0.02);
  double speed = 0;
  double position = 0;
  for (std::size_t k = 0; k < recording.size(); ++k) {
    const auto t = static_cast<double>(k);
    recording.u[k] = 2 * std::sin(0.03 * t + 2e-5 * t * t) + std::sin(0.011 * t);
    recording.y[k] = position + noise(random);
    speed += (recording.u[k] - speed) / 12;
    position += 0.1 * speed;
  }
  const std::string found = named_first(recording);
  EXPECT_NE(found.find("process.integrating"), std::string::npos) << found;
  EXPECT_NE(found.find("process.second_lag"), std::string::npos) << found;
}

TEST(Pairs, AStemAloneNeedsNone) {
  EXPECT_EQ(named_first(simulated(cycling())), "valve.stiction");
}

}  // namespace
}  // namespace workbench
