// The identifier in float against itself in double, on simulated loops of every scenario.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "ident/base/configurations.hpp"
#include "ident/identifier.hpp"
#include "support/ident/problems.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace {

using ident::Verdict;

constexpr std::uint64_t kSeeds = 2;

struct Pair {
  std::string loop;
  ident::Identification<float> in_float;
  ident::Identification<double> in_double;

  [[nodiscard]] bool agree() const { return in_float.verdict == in_double.verdict; }
  [[nodiscard]] bool both(Verdict verdict) const {
    return agree() && in_float.verdict == verdict;
  }
};

template <class Real>
ident::Identification<Real> identify(const workbench::SimulatedLoop& loop) {
  const auto identifier =
      std::make_unique<ident::Identifier<Real, ident::kLargeWindow>>();
  return identifier->run(test::as<Real>(loop.u), test::as<Real>(loop.y),
                         test::as<Real>(loop.sp));
}

const std::vector<Pair>& pairs() {
  static const std::vector<Pair> all = [] {
    std::vector<Pair> list;
    for (const workbench::ScenarioInfo& scenario : workbench::scenarios()) {
      for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const auto loop = *workbench::simulate(scenario.name, seed);
        list.push_back({std::string(scenario.name) + ' ' + std::to_string(seed),
                        identify<float>(loop), identify<double>(loop)});
      }
    }
    return list;
  }();
  return all;
}

// The larger difference of both strokes, as a share of the larger band.
double band_difference(const Pair& pair) {
  const auto& f = pair.in_float.stick_band;
  const auto& d = pair.in_double.stick_band;
  const double larger = std::max(d.ascending.value, d.descending.value);
  return std::max(
             std::abs(static_cast<double>(f.ascending.value) - d.ascending.value),
             std::abs(static_cast<double>(f.descending.value) - d.descending.value)) /
         larger;
}

// Not on every one: in float the solved error can come out far below that of the
// simulation, and then a healthy loop is called sticking.
TEST(Precision, FloatAndDoubleGiveTheSameSignAndOn90PercentOfTheLoopsTheSameVerdict) {
  ASSERT_GE(pairs().size(), 38u);
  std::size_t same = 0;
  std::string others;
  for (const Pair& pair : pairs()) {
    EXPECT_EQ(pair.in_float.gain_sign, pair.in_double.gain_sign) << pair.loop;
    if (pair.agree()) {
      ++same;
    } else {
      others += ' ' + pair.loop + ": " + std::string(ident::name(pair.in_float.verdict)) +
                " in float, " + std::string(ident::name(pair.in_double.verdict)) + ';';
    }
  }
  EXPECT_GE(10 * same, 9 * pairs().size()) << same << " agree; not:" << others;
}

// On the rest the two searches end at different valves.
TEST(Precision, FloatAndDoubleFindTheSameBandWithin5PercentOnHalfOfTheStickingLoops) {
  std::size_t compared = 0;
  std::size_t same = 0;
  std::string others;
  for (const Pair& pair : pairs()) {
    if (!pair.both(Verdict::kStiction)) {
      continue;
    }
    ++compared;
    if (band_difference(pair) < 0.05) {
      ++same;
    } else {
      others += ' ' + pair.loop + ';';
    }
  }
  EXPECT_GE(compared, 12u);
  EXPECT_GE(2 * same, compared) << same << " of " << compared << " agree; not:" << others;
}

}  // namespace
