// Each column against the change that its effect really makes.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string_view>
#include <vector>

#include "ident/gap/gap_column.hpp"

namespace ident {
namespace {

using Signal = std::vector<double>;

constexpr std::size_t kSamples = 600;

struct Scene {
  Scene() {
    for (std::size_t t = 0; t < kSamples; ++t) {
      stem.push_back(0.5 + 0.5 * std::sin(0.05 * static_cast<double>(t)));
    }
    window.poles = {0.9, 0.4};
    window.fit.gain_a = 1.5;
    window.fit.gain_b = 0.5;
    window.fit.delay = 3;
    window.period = 125;
    simulated = response(stem);
    window.stem = stem;
    window.simulated = simulated;
  }
  // The process worked sample by sample, from rest.
  [[nodiscard]] Signal response(const Signal& x) const {
    Signal out;
    Signal z;
    double slow = 0;
    double fast = 0;
    for (std::size_t t = 0; t < x.size(); ++t) {
      slow = 0.9 * slow + 0.1 * x[t];
      fast = 0.4 * fast + 0.6 * slow;
      z.push_back(fast);
      out.push_back((t >= 3 ? 1.5 * z[t - 3] : 0) + (t >= 4 ? 0.5 * z[t - 4] : 0));
    }
    return out;
  }
  [[nodiscard]] Signal column(const GapCandidate& candidate, double line = 0) const {
    GapColumn<double> column(candidate, window, line);
    Signal out;
    for (std::size_t t = 0; t < kSamples; ++t) out.push_back(column.at(t)[0]);
    return out;
  }

  Signal stem;
  Signal simulated;
  GapWindow<double> window;
};

// What another stem would add to the output.
void expect_change(const Scene& scene, const Signal& column, const Signal& changed) {
  const Signal with = scene.response(changed);
  for (std::size_t t = 0; t < kSamples; ++t) {
    ASSERT_NEAR(column[t], with[t] - scene.simulated[t], 1e-4) << t;
  }
}

TEST(GapColumn, OfLimitsIsWhatTheLimitedStemAdds) {
  const Scene scene;
  Signal upper = scene.stem;
  Signal lower = scene.stem;
  for (double& x : upper) x = std::min(x, 0.8);
  for (double& x : lower) x = std::max(x, 0.3);
  // 0.8 and 0.3 of a range that is 0 … 1 but for the sampling of the sinusoid.
  expect_change(
      scene, scene.column({EffectCode::kValveSaturation, GapKind::kUpper, 0.8F}), upper);
  expect_change(
      scene, scene.column({EffectCode::kValveSaturation, GapKind::kLower, 0.3F}), lower);
}

TEST(GapColumn, OfRatesFollowsTheStrokesThatAreSlow) {
  const Scene scene;
  const auto limited = [&](bool opening, bool closing) {
    Signal out{scene.stem[0]};
    const double most = 2.0 / 125;
    for (std::size_t t = 1; t < kSamples; ++t) {
      double move = scene.stem[t] - out.back();
      if (opening) move = std::min(move, most);
      if (closing) move = std::max(move, -most);
      out.push_back(out.back() + move);
    }
    return out;
  };
  using K = GapKind;
  const auto column = [&](K kind) {
    return scene.column({EffectCode::kValveRateLimit, kind, 2});
  };
  expect_change(scene, column(K::kRate), limited(true, true));
  expect_change(scene, column(K::kOpening), limited(true, false));
  expect_change(scene, column(K::kClosing), limited(false, true));
}

TEST(GapColumn, OfOverflowCutsTheSideThatSpills) {
  Scene scene;
  const auto [low, high] =
      std::minmax_element(scene.simulated.begin(), scene.simulated.end());
  const GapCandidate candidate{EffectCode::kProcessOverflow, GapKind::kOverflow, 0.75F};
  const Signal upright = scene.column(candidate);
  const double ceiling = *low + 0.75 * (*high - *low);
  const double floor = *high - 0.75 * (*high - *low);
  scene.window.upright = false;
  const Signal turned = scene.column(candidate);
  for (std::size_t t = 0; t < kSamples; ++t) {
    const double y = scene.simulated[t];
    ASSERT_NEAR(y + upright[t], std::min(y, ceiling), 1e-9);
    ASSERT_NEAR(y + turned[t], std::max(y, floor), 1e-9);
  }
}

TEST(GapColumn, OfALoadIsTheProcessOfAStep) {
  const Scene scene;
  const Signal column =
      scene.column({EffectCode::kDisturbanceStep, GapKind::kStep, 0.5F});
  Signal step(kSamples, 0.0);
  std::fill(step.begin() + kSamples / 2, step.end(), 1.0);
  const Signal expected = scene.response(step);
  for (std::size_t t = 0; t < kSamples; ++t) ASSERT_NEAR(column[t], expected[t], 1e-9);
}

TEST(GapColumn, OfALineHasBothPhases) {
  const Scene scene;
  const GapCandidate candidate{EffectCode::kDisturbanceSinusoid, GapKind::kLine, 0.25F};
  GapColumn<double> column(candidate, scene.window, 0.02);
  EXPECT_EQ(column.count(), 2);
  const double omega = 2 * M_PI * (0.02 + 0.25 / kSamples);
  for (std::size_t t = 0; t < kSamples; ++t) {
    const auto values = column.at(t);
    ASSERT_NEAR(values[0], std::cos(omega * static_cast<double>(t)), 1e-9);
    ASSERT_NEAR(values[1], std::sin(omega * static_cast<double>(t)), 1e-9);
  }
}

TEST(GapColumn, EveryCandidateIsFiniteAndHasAnEffect) {
  const Scene scene;
  std::set<std::string_view> effects;
  for (int k = 0; k < kGapCandidates; ++k) {
    const GapCandidate candidate = gap_candidate(k);
    effects.insert(name(candidate.effect));
    for (const double value : scene.column(candidate, 0.02)) {
      ASSERT_TRUE(std::isfinite(value));
    }
    EXPECT_GE(gap_spacing(candidate), 0);
  }
  EXPECT_FALSE(effects.contains(""));
  EXPECT_EQ(effects.size(), 11U);
}

TEST(GapColumn, StepsStandEvenlyInTheWindow) {
  std::vector<double> places;
  double spacing = 0;
  for (int k = 0; k < kGapCandidates; ++k) {
    const GapCandidate candidate = gap_candidate(k);
    if (candidate.kind != GapKind::kStep) continue;
    places.push_back(candidate.value);
    spacing = gap_spacing(candidate);
  }
  ASSERT_GT(places.size(), 8U);
  EXPECT_NEAR(places.front(), spacing, 1e-6) << "none at the beginning";
  EXPECT_NEAR(places.back(), 1 - spacing, 1e-6) << "none at the end";
  for (std::size_t k = 1; k < places.size(); ++k) {
    EXPECT_NEAR(places[k] - places[k - 1], spacing, 1e-6);
  }
}

// To first order around the mean of the stem: a square, a product with ŷ, a gain that
// grows from −1 to 1 over the window.
TEST(GapColumn, OfShapesIsTheProcessOfTheStemAroundItsMean) {
  const Scene scene;
  double mean = 0;
  for (const double x : scene.stem) mean += x / kSamples;
  Signal square;
  Signal drift;
  for (std::size_t t = 0; t < kSamples; ++t) {
    const double x = scene.stem[t] - mean;
    square.push_back(x * x);
    drift.push_back(x * (2.0 * static_cast<double>(t) / kSamples - 1));
  }
  const Signal of_square = scene.response(square);
  const Signal of_drift = scene.response(drift);
  const Signal squares =
      scene.column({EffectCode::kValveCharacteristic, GapKind::kSquare, 0});
  const Signal drifts = scene.column({EffectCode::kProcessGainDrift, GapKind::kDrift, 0});
  // From rest or from steady: the same after a few time constants.
  for (std::size_t t = 150; t < kSamples; ++t) {
    ASSERT_NEAR(squares[t], of_square[t], 1e-4) << t;
    ASSERT_NEAR(drifts[t], of_drift[t], 5e-3) << t;
  }
}

}  // namespace
}  // namespace ident
