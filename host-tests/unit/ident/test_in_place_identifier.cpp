// In the caller's memory: the answer of Identifier, and a way back to the samples.
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "ident/base/configurations.hpp"
#include "ident/identifier.hpp"
#include "ident/valve/stick_slip_valve.hpp"
#include "support/ident/published_valves.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace ident {
namespace {

using InPlace = InPlaceIdentifier<double, kStandardWindow>;
using Copying = Identifier<double, kStandardWindow>;

struct Window {
  explicit Window(double gain) {
    const auto loop = workbench::simulate("paper-example-1", 3).value();
    for (std::size_t k = 0; k < 800; ++k) {
      u.push_back(loop.u[k]);
      y.push_back(gain * loop.y[k] + 300);
    }
  }
  std::vector<double> u, y;
};

void run(InPlace& identifier, std::vector<double>& u, std::vector<double>& y,
         const WindowOptions& options = {}) {
  identifier.start(u, y, {}, 0, options);
  while (!identifier.step(1000)) {
  }
}

TEST(InPlaceIdentifier, AnswersAsTheOneThatCopies) {
  for (const double gain : {1.0, -2.0}) {
    Window window(gain);
    const auto copying = std::make_unique<Copying>();
    const Identification<double>& expected = copying->run(window.u, window.y, {});
    const auto identifier = std::make_unique<InPlace>();
    Window scaled = window;
    run(*identifier, scaled.u, scaled.y);
    const Identification<double>& found = identifier->result();
    EXPECT_EQ(found.verdict, expected.verdict);
    EXPECT_EQ(found.stick_band.ascending.value, expected.stick_band.ascending.value);
    EXPECT_EQ(found.fit_percent, expected.fit_percent);
    EXPECT_EQ(found.gain_sign, gain > 0 ? 1 : -1);
    const auto& of_u = identifier->scale_of_u();
    const auto& of_y = identifier->scale_of_y();
    for (std::size_t k = 0; k < window.u.size(); ++k) {
      ASSERT_GE(scaled.u[k], 0);
      ASSERT_LE(scaled.u[k], 1);
      ASSERT_NEAR(scaled.u[k] * of_u.factor + of_u.offset, window.u[k], 1e-9);
      ASSERT_NEAR(scaled.y[k] * of_y.factor + of_y.offset, window.y[k], 1e-9);
    }
  }
}

// Verdict, bands and the fit behind a linear valve do not rest on it.
TEST(InPlaceIdentifier, AnswersTheSameWithoutTheTwoPathModel) {
  Window window(1);
  Window again = window;
  const auto identifier = std::make_unique<InPlace>();
  run(*identifier, window.u, window.y);
  const Identification<double> whole = identifier->result();
  WindowOptions options;
  options.two_path = false;
  run(*identifier, again.u, again.y, options);
  const Identification<double>& without = identifier->result();
  EXPECT_EQ(without.verdict, whole.verdict);
  EXPECT_EQ(without.stick_band.ascending.value, whole.stick_band.ascending.value);
  EXPECT_EQ(without.fit_valve_percent, whole.fit_valve_percent);
  EXPECT_EQ(without.fit_linear_percent, whole.fit_linear_percent);
  EXPECT_EQ(without.aic_linear, whole.aic_linear);
  EXPECT_GT(whole.fit_percent, 0);
  EXPECT_EQ(without.fit_percent, 0);
  EXPECT_EQ(without.aic, 0);
}

// Two curves of u do there what a stem does: no fault without having asked them.
TEST(InPlaceIdentifier, AsksTheTwoPathModelOfFewTurnsWhateverTheOptions) {
  for (const double band : {0.0, 4.0}) {
    Window window(1);
    window.u.clear();
    window.y.clear();
    StickSlipValve<double> valve(test::from_he<double>(0.75 * band, 0.25 * band), 50);
    double y = 50;
    for (int k = 0; k < 100; ++k) {
      const double u = 50 + 6 * std::sin(0.055 * k);
      y += (valve.step(u) - y) / 5;
      window.u.push_back(u);
      window.y.push_back(y + 0.02 * std::sin(91.0 * k * k));
    }
    Window again = window;
    Window once_more = window;
    const auto identifier = std::make_unique<InPlace>();
    run(*identifier, window.u, window.y);
    const Identification<double> whole = identifier->result();
    ASSERT_LE(whole.evidence.reversals, 2);
    ASSERT_GT(whole.fit_percent, 0);
    run(*identifier, again.u, again.y, {.two_path = false});
    EXPECT_EQ(identifier->result().reason, whole.reason);
    EXPECT_EQ(identifier->result().fit_percent, whole.fit_percent);
    run(*identifier, once_more.u, once_more.y, {.verdict_only = true});
    EXPECT_EQ(identifier->result().reason, whole.reason);
    EXPECT_EQ(identifier->result().fit_percent, whole.fit_percent);
  }
}

TEST(InPlaceIdentifier, LeavesWhatItRefusesAsItWas) {
  Window window(1);
  window.y[7] = std::numeric_limits<double>::infinity();
  const std::vector<double> u = window.u;
  const auto identifier = std::make_unique<InPlace>();
  run(*identifier, window.u, window.y);
  EXPECT_EQ(identifier->result().verdict, Verdict::kBadData);
  EXPECT_EQ(identifier->scale_of_u().factor, 1);
  EXPECT_EQ(window.u, u);

  std::vector<double> constant(200, 4.0);
  std::vector<double> y = window.u;
  y.resize(200);
  run(*identifier, constant, y);
  EXPECT_EQ(identifier->result().reason, Reason::kConstant);
  EXPECT_EQ(constant, std::vector<double>(200, 4.0));
}

// A wave of slowly changing height through a valve and one lag, behind it a negative
// gain.
struct DrivenValve {
  static constexpr double kNoise = 0.1;
  static constexpr double kLag = 12;  // times `slower`
  ValveFriction<double> valve;
  std::vector<double> u, y, stem;

  DrivenValve(SlipMotion motion, std::size_t samples, double slower)
      : DrivenValve({1.2, 3, 2, motion}, samples, slower) {}
  DrivenValve(const ValveFriction<double>& friction, std::size_t samples, double slower)
      : valve(friction) {
    std::mt19937 random(2);
    std::normal_distribution<double> normal;
    StickSlipValve<double> moved(valve, 50);
    double state = 50;
    for (std::size_t t = 0; t < samples; ++t) {
      const double time = static_cast<double>(t) / slower;
      const double height = 4.5 + 0.4 * std::sin(time / 77);
      u.push_back(50 + height * std::sin(time * 0.157) + 0.02 * normal(random));
      y.push_back(200 - 1.7 * state + kNoise * normal(random));
      stem.push_back(moved.step(u.back()));
      state += (stem.back() - state) / (kLag * slower);
    }
  }
};

// Standard deviation of the difference.
double apart(const std::vector<double>& a, const std::vector<double>& b) {
  const double n = static_cast<double>(a.size());
  double sum = 0;
  double square = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    sum += (a[k] - b[k]) / n;
    square += (a[k] - b[k]) * (a[k] - b[k]) / n;
  }
  return std::sqrt(square - sum * sum);
}
double fit_of(const std::vector<double>& simulated, const std::vector<double>& y) {
  return 100 * (1 - apart(simulated, y) / apart(y, std::vector<double>(y.size())));
}

void expect_encloses(const Estimate<double>& found, double value, double share) {
  EXPECT_TRUE(found.known);
  EXPECT_NEAR(found.value, value, share * value);
  EXPECT_LE(found.low, value);
  EXPECT_GE(found.high, value);
  EXPECT_LT(found.high - found.low, 0.5 * value);
}

// All that an identification says of one valve, and what the next ones make of it.
template <std::size_t Capacity>
void expect_tells(const DrivenValve& driven, double slower, int decimation,
                  std::initializer_list<int> trusted_after) {
  const auto identifier = std::make_unique<InPlaceIdentifier<double, Capacity>>();
  EarlierValve earlier;
  double unexplained = 0;
  for (const int trusted : trusted_after) {
    DrivenValve window = driven;
    const WindowOptions options{.earlier = &earlier};
    identifier->start(window.u, window.y, {}, 0, options);
    while (!identifier->step(1000)) {
    }
    const Identification<double>& found = identifier->result();
    ASSERT_EQ(found.verdict, Verdict::kStiction);
    EXPECT_EQ(found.decimation, decimation);
    EXPECT_EQ(found.gain_sign, -1);
    expect_encloses(found.stick_band.ascending, driven.valve.stick_ascending(), 0.05);
    expect_encloses(found.stick_band.descending, driven.valve.stick_descending(), 0.05);
    // All that is told of the valve is in the units of u.
    const ValveFriction<double>& friction = found.valve.friction;
    EXPECT_NEAR(friction.deadband, driven.valve.deadband, 0.6);
    EXPECT_DOUBLE_EQ(friction.stick_ascending(), found.stick_band.ascending.value);
    EXPECT_DOUBLE_EQ(friction.stick_descending(), found.stick_band.descending.value);
    EXPECT_DOUBLE_EQ(friction.slip_ascending, found.slip_jump.ascending.value);
    EXPECT_DOUBLE_EQ(friction.slip_descending, found.slip_jump.descending.value);
    EXPECT_LE(found.slip_jump.ascending.low, friction.slip_ascending);
    EXPECT_GE(found.slip_jump.descending.high, friction.slip_descending);
    // So does each cycle, and the closed loop.
    const double cycles = static_cast<double>(driven.u.size()) / slower * 0.157 / 6.283;
    const Evidence<double>& evidence = found.evidence;
    EXPECT_NEAR(found.cycles, cycles, 1);
    EXPECT_NEAR(evidence.cycles, std::min(cycles, 1.0 * CycleComparison<double>::kMost),
                2);
    EXPECT_GE(evidence.cycles_better, evidence.cycles - 1);
    EXPECT_NEAR(evidence.reversals, 2 * cycles, 2);
    EXPECT_NEAR(evidence.stem_strokes, 2 * cycles, 3);
    EXPECT_GT(evidence.stem_nats, evidence.ladder.nats);
    EXPECT_GT(evidence.pace.strokes, 8);
    // Simulations say what the result does.
    std::vector<double> simulated(driven.u.size());
    identifier->stem_positions(simulated);
    EXPECT_LT(apart(simulated, driven.stem), 0.25);
    identifier->simulate_valve(simulated);
    EXPECT_NEAR(apart(simulated, driven.y), driven.kNoise, 0.15 * driven.kNoise);
    EXPECT_NEAR(fit_of(simulated, driven.y), found.fit_valve_percent, 0.2);
    EXPECT_NEAR(found.residual_rms, apart(simulated, driven.y), 0.02 * driven.kNoise);
    identifier->simulate_two_path(simulated);
    EXPECT_NEAR(fit_of(simulated, driven.y), found.fit_percent, 0.2);
    // Only a valve that was found again is trusted.
    EXPECT_EQ(identifier->searched(), trusted != 7);
    earlier = identifier->next_start();
    EXPECT_EQ(earlier.trusted, trusted);
    EXPECT_NEAR(earlier.friction.stick_ascending(), driven.valve.stick_ascending(), 0.25);
    EXPECT_NEAR(earlier.slow, driven.kLag * slower, 0.15 * driven.kLag * slower);
    if (trusted == 0) {
      unexplained = static_cast<double>(earlier.unexplained);
    }
    EXPECT_NEAR(earlier.unexplained, unexplained, 0.05 * unexplained);
  }
}

TEST(InPlaceIdentifier, TellsAValveOfASmallWindow) {
  expect_tells<kSmallWindow>(DrivenValve(SlipMotion::kResticks, 480, 1), 1, 1, {0});
}

TEST(InPlaceIdentifier, GoesOnFromTheWindowBefore) {
  expect_tells<kSmallWindow>(DrivenValve(SlipMotion::kResticks, 480, 1), 1, 1, {0, 8, 7});
}

// What a monitor asks of each window: no valve is fitted where none sticks.
TEST(InPlaceIdentifier, EndsEarlyWhereNothingSticks) {
  const auto identifier = std::make_unique<InPlaceIdentifier<double, kSmallWindow>>();
  for (const bool sticks : {true, false}) {
    DrivenValve window(sticks ? ValveFriction<double>{1.2, 3, 2, SlipMotion::kResticks}
                              : ValveFriction<double>{},
                       480, 1);
    identifier->start(window.u, window.y, {}, 0, {.ends_early = true, .two_path = false});
    while (!identifier->step(1000)) {
    }
    const Identification<double>& found = identifier->result();
    EXPECT_EQ(found.verdict, sticks ? Verdict::kStiction : Verdict::kNoStiction);
    EXPECT_EQ(found.valve.known, sticks);
    EXPECT_EQ(found.stick_band.ascending.known, sticks);
    EXPECT_EQ(identifier->searched(), true);
  }
}

// Means of three samples, that no fewer than 600 are left.
TEST(InPlaceIdentifier, TellsAValveOfASlowLoop) {
  expect_tells<kStandardWindow>(DrivenValve(SlipMotion::kStops, 1800, 5), 5, 3, {0});
}

// The valve is searched on the newest 2000 samples; where the stem stood before is found,
// too.
TEST(InPlaceIdentifier, TellsAValveOfALongWindow) {
  expect_tells<kLargeWindow>(DrivenValve(SlipMotion::kStops, 2400, 1), 1, 1, {0});
}

}  // namespace
}  // namespace ident
