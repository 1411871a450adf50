// Laws of the whole identifier, over simulated loops: what a change of the recording may
// change in the answer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "ident/base/configurations.hpp"
#include "ident/identifier.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace {

using Identifier = ident::Identifier<double, ident::kLargeWindow>;
using Identification = ident::Identification<double>;
using Signal = std::vector<double>;

struct Case {
  const char* scenario;
  std::uint64_t seed;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.scenario << ' ' << c.seed;
}

Identification identify(std::span<const double> u, std::span<const double> y,
                        std::span<const double> sp) {
  const auto identifier = std::make_unique<Identifier>();
  return identifier->run(u, y, sp);
}

Signal mapped(Signal values, double factor, double offset) {
  for (double& value : values) {
    value = factor * value + offset;
  }
  return values;
}

// The larger difference of both strokes, as a share of the larger band: a stroke that
// hardly sticks is not held to a share of itself.
double band_difference(const Identification& a, const Identification& b,
                       double factor = 1) {
  const double ascending = b.stick_band.ascending.value / factor;
  const double descending = b.stick_band.descending.value / factor;
  const double larger =
      std::max(a.stick_band.ascending.value, a.stick_band.descending.value);
  return std::max(std::abs(ascending - a.stick_band.ascending.value),
                  std::abs(descending - a.stick_band.descending.value)) /
         larger;
}

void expect_same_band(const Identification& a, const Identification& b, double factor) {
  ASSERT_EQ(a.stick_band.ascending.known, b.stick_band.ascending.known);
  if (a.stick_band.ascending.known) {
    EXPECT_LT(band_difference(a, b, factor), 0.05);
  }
}

class IdentifierLaw : public testing::TestWithParam<Case> {
 protected:
  IdentifierLaw() : loop(*workbench::simulate(GetParam().scenario, GetParam().seed)) {}

  // Of the recording as it is; identified once for all laws.
  const Identification& plain() {
    static std::map<std::string, Identification> known;
    const std::string key = testing::PrintToString(GetParam());
    if (!known.contains(key)) {
      known.emplace(key, identify(loop.u, loop.y, loop.sp));
    }
    return known.at(key);
  }

  workbench::SimulatedLoop loop;
};

// Powers of two, so that scaling is exact but for the shift.
TEST_P(IdentifierLaw, UnitsChangeNothingButUnits) {
  const Identification moved = identify(mapped(loop.u, 4, 128), mapped(loop.y, 0.25, -64),
                                        mapped(loop.sp, 0.25, -64));
  EXPECT_EQ(ident::name(plain().verdict), ident::name(moved.verdict));
  EXPECT_EQ(plain().gain_sign, moved.gain_sign);
  EXPECT_NEAR(plain().fit_percent, moved.fit_percent, 1);
  EXPECT_NEAR(plain().controller.integral * 16, moved.controller.integral,
              1e-6 * std::abs(moved.controller.integral));
  expect_same_band(plain(), moved, 4);
}

// Bit for bit, also from an object that has seen another window.
TEST_P(IdentifierLaw, TheSameDataGiveTheSameAnswer) {
  const auto identifier = std::make_unique<Identifier>();
  const Identification& first = plain();
  const std::span<const double> u(loop.u);
  const std::span<const double> y(loop.y);
  identifier->start(u.first(u.size() / 2), y.first(u.size() / 2), {});
  identifier->step(50);
  const Identification second = identifier->run(loop.u, loop.y, loop.sp);
  EXPECT_EQ(first.verdict, second.verdict);
  EXPECT_EQ(first.reason, second.reason);
  EXPECT_EQ(first.fit_percent, second.fit_percent);
  EXPECT_EQ(first.fit_linear_percent, second.fit_linear_percent);
  EXPECT_EQ(first.fit_valve_percent, second.fit_valve_percent);
  EXPECT_EQ(first.aic, second.aic);
  EXPECT_EQ(first.model.process.a, second.model.process.a);
  EXPECT_EQ(first.model.ascending.x, second.model.ascending.x);
  EXPECT_EQ(first.evidence.score, second.evidence.score);
  EXPECT_EQ(first.stick_band.ascending.value, second.stick_band.ascending.value);
  EXPECT_EQ(first.stick_band.ascending.low, second.stick_band.ascending.low);
  EXPECT_EQ(first.stick_band.descending.high, second.stick_band.descending.high);
  EXPECT_EQ(first.slip_jump.descending.value, second.slip_jump.descending.value);
}

// −u and −y: what ascended descends.
TEST_P(IdentifierLaw, AMirrorImageHasTheSameVerdict) {
  const Identification mirror =
      identify(mapped(loop.u, -1, 0), mapped(loop.y, -1, 0), mapped(loop.sp, -1, 0));
  EXPECT_EQ(ident::name(plain().verdict), ident::name(mirror.verdict));
  EXPECT_EQ(plain().gain_sign, mirror.gain_sign);
}

// −y alone: a reverse acting process, the same valve.
TEST_P(IdentifierLaw, AReverseActingProcessHasTheSameValve) {
  const Identification reverse =
      identify(loop.u, mapped(loop.y, -1, 0), mapped(loop.sp, -1, 0));
  EXPECT_EQ(ident::name(plain().verdict), ident::name(reverse.verdict));
  EXPECT_EQ(plain().gain_sign, -reverse.gain_sign);
  expect_same_band(plain(), reverse, 1);
}

INSTANTIATE_TEST_SUITE_P(Loops, IdentifierLaw,
                         testing::Values(Case{"paper-example-1-midway", 3},
                                         Case{"paper-example-1-ascending", 2},
                                         Case{"stiction", 4},
                                         Case{"external-sinusoid", 1},
                                         Case{"setpoint", 2}));

// The search does not visit mirrored candidates in mirrored order and may end at another
// valve, so not every band is the same.
TEST(MirrorImage, SwapsTheStrokesOfTwoThirdsOfTheBandsWithin5Percent) {
  const char* const scenarios[] = {"paper-example-1",           "paper-example-1-midway",
                                   "paper-example-1-ascending", "stiction",
                                   "stiction-one-sided",        "stiction-setpoint"};
  std::size_t same = 0;
  std::string others;
  for (const char* scenario : scenarios) {
    const auto loop = *workbench::simulate(scenario, 1);
    const Identification plain = identify(loop.u, loop.y, loop.sp);
    Identification mirror =
        identify(mapped(loop.u, -1, 0), mapped(loop.y, -1, 0), mapped(loop.sp, -1, 0));
    EXPECT_EQ(ident::name(plain.verdict), ident::name(mirror.verdict)) << scenario;
    std::swap(mirror.stick_band.ascending, mirror.stick_band.descending);
    if (band_difference(plain, mirror) < 0.05) {
      ++same;
    } else {
      others += std::string(" ") + scenario;
    }
  }
  EXPECT_GE(3 * same, 2 * std::size(scenarios)) << same << " agree; not:" << others;
}

// Two thirds from the start, two thirds to the end, of one loop of each kind of stiction.
// Not every pair agrees on the band: the search may end at another valve.
TEST(TwoWindows, OfOneRecordAgreeOnTheVerdictAndOnTwoThirdsOfTheBandsWithin5Percent) {
  const char* const scenarios[] = {
      "paper-example-1",           "paper-example-1-midway",
      "paper-example-1-ascending", "paper-example-1-descending",
      "paper-example-1-mixed",     "stiction",
      "stiction-one-sided"};
  std::size_t same = 0;
  std::string others;
  for (const char* scenario : scenarios) {
    const auto loop = *workbench::simulate(scenario, 1);
    const std::size_t part = loop.u.size() * 2 / 3;
    const auto first = [&](const Signal& s) { return std::span(s).first(part); };
    const auto last = [&](const Signal& s) { return std::span(s).last(part); };
    const Identification a = identify(first(loop.u), first(loop.y), first(loop.sp));
    const Identification b = identify(last(loop.u), last(loop.y), last(loop.sp));
    EXPECT_EQ(ident::name(a.verdict), ident::name(b.verdict)) << scenario;
    if (band_difference(a, b) < 0.05) {
      ++same;
    } else {
      others += std::string(" ") + scenario;
    }
  }
  EXPECT_GE(3 * same, 2 * std::size(scenarios)) << same << " agree; not:" << others;
}

TEST(OneStroke, ThatSlidesIsToldNoBandBesideOneThatSticks) {
  for (const std::uint64_t seed : {2, 3, 4, 5, 12}) {
    const auto loop = *workbench::simulate("paper-example-1-ascending", seed);
    const Identification found = identify(loop.u, loop.y, loop.sp);
    EXPECT_EQ(ident::name(found.verdict), "stiction") << seed;
    EXPECT_NEAR(found.stick_band.ascending.value, 5, 0.1) << seed;
    EXPECT_LT(found.stick_band.descending.value, 0.1) << seed;
  }
}

// The valve is searched at the end of such a window only.
TEST(LongWindow, OfAFastLoopIsExplainedFromItsStart) {
  const auto loop = *workbench::simulate("stiction-mixed", 20);
  const Identification found = identify(loop.u, loop.y, loop.sp);
  ASSERT_EQ(found.decimation, 1);
  EXPECT_EQ(ident::name(found.verdict), "stiction");
  EXPECT_NEAR(found.fit_valve_percent, found.evidence.fit_percent, 3);
  EXPECT_GT(found.evidence.stem_nats, 100);
}

}  // namespace
