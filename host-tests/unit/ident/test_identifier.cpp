// What the identifier answers, and that nothing it is fed makes it invent a number.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "ident/base/configurations.hpp"
#include "ident/identifier.hpp"
#include "ident/verdict/judge.hpp"
#include "support/ident/expect_verdict.hpp"
#include "support/ident/loop.hpp"

namespace ident {
namespace {

using test::expect_verdict;

using Standard = Identifier<double, kStandardWindow>;
using Signal = std::vector<double>;

template <class Real>
bool finite(const Estimate<Real>& e) {
  return std::isfinite(e.value) && std::isfinite(e.low) && std::isfinite(e.high);
}

// Every number is finite; bands and jumps come with a fault only, inside their intervals,
// without jumps where only the ladder found it. That a valve follows is said of a band
// that would have shown.
template <class Real>
void expect_sound(const Identification<Real>& r) {
  for (const Real number : {r.cycles,
                            r.fit_percent,
                            r.fit_linear_percent,
                            r.fit_valve_percent,
                            r.aic,
                            r.aic_linear,
                            r.controller.proportional,
                            r.controller.integral,
                            r.controller.r_squared,
                            r.evidence.error_ratio,
                            r.evidence.jump_ratio,
                            r.evidence.observations,
                            r.evidence.score,
                            r.evidence.consistency,
                            r.evidence.band_over_swing,
                            r.evidence.slip_over_band,
                            r.evidence.fit_percent,
                            r.evidence.fit_linear_percent,
                            r.evidence.time_constant,
                            r.evidence.stem_nats,
                            r.evidence.ladder.nats,
                            r.evidence.ladder.band,
                            r.evidence.ladder.low,
                            r.evidence.ladder.high,
                            r.evidence.ladder.detectable_band,
                            r.detectable_band,
                            r.model.process.d,
                            r.valve.friction.deadband,
                            r.valve.friction.slip_ascending,
                            r.valve.friction.slip_descending,
                            r.oscillation.period_samples,
                            r.oscillation.amplitude}) {
    EXPECT_TRUE(std::isfinite(number));
  }
  for (int i = 0; i < kMaxNa; ++i) {
    EXPECT_TRUE(std::isfinite(r.model.process.a[i]));
    EXPECT_TRUE(std::isfinite(r.model.process.b[i]));
  }
  for (int k = 0; k < kMaxKnots; ++k) {
    EXPECT_TRUE(std::isfinite(r.model.ascending.x[k]));
    EXPECT_TRUE(std::isfinite(r.model.descending.knots[k]));
  }
  const bool fault = r.verdict == Verdict::kStiction || r.verdict == Verdict::kBacklash;
  // A stem that was searched has bands alone.
  const bool fitted = fault && r.reason != Reason::kSticksUnderLoad;
  const bool jumps =
      fitted && (r.slip_jump.ascending.known || !searched_stem_sticks(r.evidence));
  EXPECT_EQ(r.stick_band.ascending.known, fault) << name(r.verdict);
  EXPECT_EQ(r.stick_band.descending.known, fault) << name(r.verdict);
  EXPECT_EQ(r.slip_jump.ascending.known, jumps) << name(r.verdict);
  EXPECT_EQ(r.slip_jump.descending.known, jumps) << name(r.verdict);
  if (r.verdict == Verdict::kNoStiction && r.reason != Reason::kBandDoesNotMatter &&
      r.evidence.ladder.predicted > 0) {
    EXPECT_GT(r.detectable_band, 0);
    EXPECT_LE(r.evidence.ladder.detectable_band, Real(0.35));
  }
  for (const Estimate<Real>& e : {r.stick_band.ascending, r.stick_band.descending,
                                  r.slip_jump.ascending, r.slip_jump.descending}) {
    EXPECT_TRUE(finite(e));
    if (e.known) {
      EXPECT_LE(e.low, e.value);
      EXPECT_GE(e.high, e.value);
      EXPECT_GE(e.low, 0);
    } else {
      EXPECT_EQ(e.value, 0);
    }
  }
  EXPECT_FALSE(sentence(r.reason).empty());
}

// The simulations answer whatever came before, with finite numbers.
template <class Identifier, class Real>
void expect_simulations(const Identifier& identifier, std::size_t n) {
  std::vector<Real> values(n, std::numeric_limits<Real>::quiet_NaN());
  const auto check = [&] {
    for (const Real value : values) {
      ASSERT_TRUE(std::isfinite(value));
    }
    std::fill(values.begin(), values.end(), std::numeric_limits<Real>::quiet_NaN());
  };
  identifier.simulate_two_path(values);
  check();
  identifier.simulate_valve(values);
  check();
  identifier.stem_positions(values);
  check();
}

template <class Real = double, std::size_t Capacity = kStandardWindow>
Identification<Real> identify(const std::vector<Real>& u, const std::vector<Real>& y,
                              const std::vector<Real>& sp = {}) {
  const auto identifier = std::make_unique<Identifier<Real, Capacity>>();
  const auto result = identifier->run(u, y, sp);
  EXPECT_TRUE(identifier->done());
  expect_sound(result);
  const std::size_t n = std::min({u.size(), y.size(), Capacity});
  expect_simulations<Identifier<Real, Capacity>, Real>(*identifier, n);
  return result;
}

// Stick bands 5 on both strokes, u swings by about 6.
test::Window make_sticking_loop(std::uint64_t seed) {
  test::Random random(seed);
  test::LoopSettings settings;
  settings.friction = {1, 4, 4, SlipMotion::kSlides};
  return test::simulate_loop(settings, 1200, random);
}

const test::Window& sticking_loop() {
  static const test::Window window = make_sticking_loop(5);
  return window;
}

// As much of it as shows whether numbers stay finite on all ways through the identifier.
const test::Window& few_cycles() {
  static const test::Window window = [] {
    test::Window first = sticking_loop();
    first.u.resize(500);
    first.y.resize(500);
    first.ascending.resize(500);
    return first;
  }();
  return window;
}

Signal scaled(Signal values, double factor, double offset = 0) {
  for (double& value : values) {
    value = factor * value + offset;
  }
  return values;
}

TEST(Identifier, FindsAStickingValve) {
  const test::Window& w = sticking_loop();
  const auto result = identify(w.u, w.y);
  expect_verdict(result, Reason::kSticksBothStrokes);
  EXPECT_EQ(result.gain_sign, 1);
  EXPECT_TRUE(result.oscillation.detected);
  EXPECT_GT(result.fit_percent, result.fit_linear_percent);
  EXPECT_GT(result.evidence.reversals, 5);
}

// Single loops are off by up to 14 %: where the search takes a valve that stops or
// resticks.
TEST(Identifier, FindsTheBandWithin5PercentInTheMedianOfSevenLoops) {
  std::vector<double> errors;
  for (const std::uint64_t seed : {5, 6, 7, 100, 101, 102, 103}) {
    const test::Window w = make_sticking_loop(seed);
    const auto result = identify(w.u, w.y);
    EXPECT_EQ(name(result.verdict), name(Verdict::kStiction)) << seed;
    errors.push_back(std::max(std::abs(result.stick_band.ascending.value / 5 - 1),
                              std::abs(result.stick_band.descending.value / 5 - 1)));
  }
  std::sort(errors.begin(), errors.end());
  EXPECT_LT(errors[3], 0.05);
  EXPECT_LT(errors[6], 0.2);
}

// In the units of the recording: what is returned as fit is what the simulation gives.
TEST(Identifier, SimulatesTheFitsThatItReports) {
  const test::Window& w = sticking_loop();
  const auto identifier = std::make_unique<Standard>();
  const auto& result = identifier->run(w.u, w.y, {});
  Signal simulated(w.y.size());
  identifier->simulate_two_path(simulated);
  EXPECT_NEAR(test::fit_percent<double>(simulated, w.y), result.fit_percent, 1e-6);
  identifier->simulate_valve(simulated);
  EXPECT_NEAR(test::fit_percent<double>(simulated, w.y), result.fit_valve_percent, 1);
  identifier->stem_positions(simulated);
  const double half = result.valve.friction.deadband / 2;
  for (std::size_t t = 0; t < w.u.size(); ++t) {
    EXPECT_LT(std::abs(simulated[t] - w.u[t]),
              half +
                  std::max(result.valve.friction.slip_ascending,
                           result.valve.friction.slip_descending) +
                  1e-9);
  }
}

// Powers of two, so that scaling is exact.
TEST(Identifier, ReportsTheModelInTheUnitsOfTheRecording) {
  const test::Window& w = sticking_loop();
  const auto identifier = std::make_unique<Standard>();
  const Identification<double> plain = identifier->run(w.u, w.y, {});
  constexpr double kU = 8;
  constexpr double kY = 1024;
  const Signal u = scaled(w.u, kU, 128);
  const auto& found = identifier->run(u, scaled(w.y, kY, -64), {});
  // Equation (8): N ln of the squared error.
  const double more = 2 * static_cast<double>(u.size()) * std::log(kY);
  EXPECT_NEAR(found.aic, plain.aic + more, 1e-6 * more);
  EXPECT_NEAR(found.aic_linear, plain.aic_linear + more, 1e-6 * more);
  ASSERT_EQ(found.model.ascending.segments, plain.model.ascending.segments);
  for (int k = 0; k <= plain.model.ascending.segments; ++k) {
    EXPECT_NEAR(found.model.ascending.knots[k], kU * plain.model.ascending.knots[k] + 128,
                1e-6);
    EXPECT_NEAR(found.model.ascending.x[k], kY * plain.model.ascending.x[k], 1e-3);
  }
  Signal stem(u.size());
  identifier->stem_positions(stem);
  const auto& friction = found.valve.friction;
  const double most = friction.deadband / 2 +
                      std::max(friction.slip_ascending, friction.slip_descending) + 1e-9;
  for (std::size_t t = 0; t < u.size(); ++t) {
    ASSERT_LT(std::abs(stem[t] - u[t]), most) << t;
  }
}

TEST(Identifier, GivesTheSameInSlices) {
  const test::Window& w = sticking_loop();
  const auto whole = identify(w.u, w.y);
  for (const int budget : {1, 20}) {
    const auto identifier = std::make_unique<Standard>();
    identifier->start(w.u, w.y, {});
    int slices = 0;
    while (!identifier->step(budget)) {
      ++slices;
    }
    EXPECT_GT(slices, 100);
    const auto& sliced = identifier->result();
    EXPECT_EQ(sliced.verdict, whole.verdict);
    EXPECT_EQ(sliced.stick_band.ascending.value, whole.stick_band.ascending.value);
    EXPECT_EQ(sliced.stick_band.descending.low, whole.stick_band.descending.low);
    EXPECT_EQ(sliced.slip_jump.ascending.high, whole.slip_jump.ascending.high);
    EXPECT_EQ(sliced.fit_percent, whole.fit_percent);
    EXPECT_EQ(sliced.fit_valve_percent, whole.fit_valve_percent);
    EXPECT_EQ(sliced.aic, whole.aic);
    EXPECT_TRUE(identifier->step(budget));
  }
}

TEST(Identifier, TakesASignThatItIsTold) {
  const test::Window& w = sticking_loop();
  const auto identifier = std::make_unique<Standard>();
  EXPECT_EQ(identifier->run(w.u, w.y, {}, 1).gain_sign, 1);
  EXPECT_EQ(identifier->result().verdict, Verdict::kStiction);
  const Signal mirrored = scaled(w.y, -1);
  EXPECT_EQ(identifier->run(w.u, mirrored, {}, -1).gain_sign, -1);
  EXPECT_EQ(identifier->result().verdict, Verdict::kStiction);
}

TEST(Identifier, RefusesConstants) {
  const test::Window& w = sticking_loop();
  for (const double level : {0.0, 3.0, -1e9, 1e-300}) {
    const Signal constant(w.u.size(), level);
    expect_verdict(identify(constant, w.y), Reason::kConstant);
    expect_verdict(identify(w.u, constant), Reason::kConstant);
    expect_verdict(identify(constant, constant), Reason::kConstant);
  }
}

TEST(Identifier, RefusesARamp) {
  Signal ramp(300);
  for (std::size_t t = 0; t < ramp.size(); ++t) {
    ramp[t] = static_cast<double>(t);
  }
  expect_verdict(identify(ramp, ramp), Reason::kOneStroke);
  const Signal y(sticking_loop().y.begin(), sticking_loop().y.begin() + 300);
  expect_verdict(identify(ramp, y), Reason::kOneStroke);
}

// Up and down by one every sample, and y one sample later.
TEST(Identifier, BearsEqualSteps) {
  for (const std::size_t n : {60u, 500u}) {
    Signal u(n), y(n);
    for (std::size_t t = 0; t < n; ++t) {
      u[t] = static_cast<double>(t % 2);
      y[t] = 1 - u[t];
    }
    const auto result = identify(u, y);
    EXPECT_NE(result.verdict, Verdict::kBadData);
    EXPECT_FALSE(result.stick_band.ascending.known);
  }
}

// A single step of both: one level, then another.
TEST(Identifier, RefusesASingleStep) {
  Signal u(200, 0);
  std::fill(u.begin() + 100, u.end(), 1);
  const auto result = identify(u, u);
  expect_verdict(result, Reason::kOneStroke);
}

TEST(Identifier, RefusesFewerThan60Samples) {
  const test::Window& w = sticking_loop();
  for (const std::size_t n : {0u, 1u, 2u, 59u}) {
    const Signal u(w.u.begin(), w.u.begin() + n);
    const Signal y(w.y.begin(), w.y.begin() + n);
    expect_verdict(identify(u, y), Reason::kTooShort);
    expect_verdict(identify(w.u, y), Reason::kTooShort);
  }
  const Signal u(w.u.begin(), w.u.begin() + 60);
  const Signal y(w.y.begin(), w.y.begin() + 60);
  EXPECT_NE(identify(u, y).reason, Reason::kTooShort);
}

TEST(Identifier, RefusesWhatIsNotFinite) {
  const test::Window& w = sticking_loop();
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()}) {
    for (const std::size_t at : {std::size_t{0}, w.u.size() / 2, w.u.size() - 1}) {
      Signal u = w.u;
      Signal y = w.y;
      u[at] = bad;
      expect_verdict(identify(u, w.y), Reason::kNotFinite);
      y[at] = bad;
      expect_verdict(identify(w.u, y), Reason::kNotFinite);
    }
  }
}

TEST(Identifier, BearsASetpointThatIsNotFinite) {
  const test::Window& w = few_cycles();
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    Signal sp(w.u.size(), 0.7);
    sp[w.u.size() / 2] = bad;
    identify(w.u, w.y, sp);
  }
}

TEST(Identifier, BearsNumbersNearOverflowAndUnderflow) {
  const test::Window& w = few_cycles();
  for (const double factor : {1e300, 1e-300, 1e150, 1e-150}) {
    identify(scaled(w.u, factor), w.y);
    identify(w.u, scaled(w.y, factor));
  }
  const test::FloatWindow f(w);
  for (const float factor : {1e30f, 1e-30f}) {
    std::vector<float> u = f.u;
    std::vector<float> y = f.y;
    for (std::size_t t = 0; t < u.size(); ++t) {
      u[t] *= factor;
      y[t] *= factor;
    }
    identify<float>(u, f.y);
    identify<float>(f.u, y);
  }
}

// Finite, but not their differences. Only the answer is held to be finite here, not what
// the simulations give after the refusal.
TEST(Identifier, RefusesARangeThatOverflows) {
  const test::Window& w = sticking_loop();
  Signal jumps(w.u.size(), std::numeric_limits<double>::max());
  for (std::size_t t = 0; t < jumps.size(); t += 2) {
    jumps[t] = std::numeric_limits<double>::lowest();
  }
  const auto identifier = std::make_unique<Standard>();
  Signal simulated(w.u.size());
  using Signals = std::pair<const Signal*, const Signal*>;
  for (const auto& [u, y] : {Signals(&jumps, &w.y), Signals(&w.u, &jumps)}) {
    const auto& result = identifier->run(*u, *y, {});
    expect_verdict(result, Reason::kConstant);
    expect_sound(result);
    identifier->simulate_two_path(simulated);
    identifier->simulate_valve(simulated);
    identifier->stem_positions(simulated);
  }
}

TEST(Identifier, KnowsNoUnits) {
  const test::Window& w = sticking_loop();
  const auto plain = identify(w.u, w.y);
  for (const double factor : {1e6, 1e-6}) {
    const auto of_y = identify(w.u, scaled(w.y, factor));
    EXPECT_EQ(name(of_y.verdict), name(plain.verdict));
    EXPECT_NEAR(of_y.stick_band.ascending.value, plain.stick_band.ascending.value, 0.1);
    const auto of_u = identify(scaled(w.u, factor), w.y);
    EXPECT_EQ(name(of_u.verdict), name(plain.verdict));
    EXPECT_NEAR(of_u.stick_band.ascending.value / factor,
                plain.stick_band.ascending.value, 0.1);
  }
}

// At 1e6 the signals are still there; at 1e9 a swing of 6 is below their resolution.
TEST(Identifier, BearsHugeOffsets) {
  const test::Window& w = sticking_loop();
  for (const double offset : {1e6, -1e6}) {
    const auto result =
        identify(scaled(w.u, 1, offset), scaled(w.y, 1, 1000 * offset / 1e6));
    EXPECT_EQ(name(result.verdict), name(Verdict::kStiction));
  }
  for (const double offset : {1e9, -1e9, 1e15}) {
    expect_verdict(identify(scaled(w.u, 1, offset), w.y), Reason::kConstant);
    expect_verdict(identify(w.u, scaled(w.y, 1, offset)), Reason::kConstant);
  }
}

// y drives u: a controller, not a process.
TEST(Identifier, BearsUAndYSwapped) {
  const test::Window& w = sticking_loop();
  const auto result = identify(w.y, w.u);
  EXPECT_NE(result.verdict, Verdict::kBadData);
}

TEST(Identifier, BearsNoise) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    test::Random random(seed);
    Signal u, y;
    for (int t = 0; t < 400; ++t) {
      u.push_back(test::normal(random));
      y.push_back(test::normal(random));
    }
    const auto result = identify(u, y);
    EXPECT_NE(result.verdict, Verdict::kStiction) << seed;
    EXPECT_NE(result.verdict, Verdict::kBacklash) << seed;
  }
}

// More than it holds: the oldest samples are identified, as if the rest were not there.
TEST(Identifier, CutsAWindowToItsCapacity) {
  const test::Window& w = sticking_loop();
  const test::FloatWindow f(w);
  ASSERT_GT(f.u.size(), kSmallWindow);
  const auto whole = identify<float, kSmallWindow>(f.u, f.y);
  const std::vector<float> u(f.u.begin(), f.u.begin() + kSmallWindow);
  const std::vector<float> y(f.y.begin(), f.y.begin() + kSmallWindow);
  const auto first = identify<float, kSmallWindow>(u, y);
  EXPECT_EQ(whole.verdict, first.verdict);
  EXPECT_EQ(whole.fit_percent, first.fit_percent);
  EXPECT_EQ(whole.stick_band.ascending.value, first.stick_band.ascending.value);
}

// A refusal leaves nothing of the recording before it.
TEST(Identifier, ForgetsTheWindowBefore) {
  const test::Window& w = sticking_loop();
  const auto identifier = std::make_unique<Standard>();
  identifier->run(w.u, w.y, {});
  ASSERT_EQ(identifier->result().verdict, Verdict::kStiction);
  const Signal few(10, 1);
  Signal bad = w.u;
  bad[3] = std::nan("");
  const Signal constant(100, 2);
  for (const Signal* u : {&few, static_cast<const Signal*>(&bad), &constant}) {
    const auto& result = identifier->run(*u, *u, {});
    EXPECT_NE(result.verdict, Verdict::kStiction);
    EXPECT_FALSE(result.stick_band.ascending.known);
    EXPECT_FALSE(result.valve.known);
    EXPECT_EQ(result.fit_percent, 0);
    expect_sound(result);
    expect_simulations<Standard, double>(*identifier, u->size());
  }
  EXPECT_EQ(identifier->run(w.u, w.y, {}).verdict, Verdict::kStiction);
}

}  // namespace
}  // namespace ident
