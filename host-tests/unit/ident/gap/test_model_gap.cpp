// A loop whose model lacks one effect: what the watch makes of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

#include "ident/gap/model_gap.hpp"
#include "support/ident/loop.hpp"

namespace ident {
namespace {

using Signal = std::vector<double>;

constexpr std::size_t kGapSamples = 1600;
constexpr double kPeriod = 100;

// A stem that moves between two levels and along a slow sinusoid, a process with one lag.
struct GapScene {
  explicit GapScene(double noise, unsigned seed = 5) {
    test::Random random(seed);
    for (std::size_t t = 0; t < kGapSamples; ++t) {
      const double time = static_cast<double>(t);
      const double x = 0.5 + 0.35 * std::tanh(3 * std::sin(2 * M_PI * time / kPeriod)) +
                       0.1 * std::sin(2 * M_PI * time / 370);
      stem.push_back(x);
      ascending.push_back(std::cos(2 * M_PI * time / kPeriod) > 0);
      error.push_back(noise * test::normal(random));
    }
    window.poles = {0.93, 0};
    window.fit.gain_a = 2;
    window.fit.offset = -1;
    window.period = kPeriod;
    window.swing = 0.7;
    window.observations = kGapSamples;
    simulated = response(stem);
    y = simulated;
    for (std::size_t t = 0; t < kGapSamples; ++t) y[t] += error[t];
  }
  [[nodiscard]] Signal response(const Signal& x) const {
    Signal out;
    double state = x[0];
    for (const double value : x) {
      state = 0.93 * state + 0.07 * value;
      out.push_back(2 * state - 1);
    }
    return out;
  }
  void change_stem(const std::function<double(double, double)>& f) {
    Signal x;
    for (std::size_t t = 0; t < kGapSamples; ++t) {
      x.push_back(f(stem[t], static_cast<double>(t) / kGapSamples));
    }
    y = response(x);
    for (std::size_t t = 0; t < kGapSamples; ++t) y[t] += error[t];
  }
  ModelGapReport<double> report() {
    window.stem = stem;
    window.y = y;
    window.simulated = simulated;
    window.ascending = ascending;
    ModelGap<double> gap;
    gap.start(window);
    int steps = 0;
    int cost = 0;
    do {
      ++steps;
      cost = std::max(cost, gap.cost_of_step());
    } while (!gap.step());
    const int pieces = static_cast<int>(kGapSamples) / 224 + 1;
    EXPECT_LT(steps, (static_cast<int>(kGapSamples) / 24 + 80) * pieces);
    EXPECT_LE(cost, 110);
    return gap.report();
  }

  Signal stem, simulated, y, error;
  std::vector<unsigned char> ascending;
  GapWindow<double> window;
};

TEST(ModelGap, NoiseAloneIsNoSuspect) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    GapScene scene(0.1, seed);
    EXPECT_EQ(scene.report().suspect, EffectCode::kNone);
  }
}

TEST(ModelGap, NothingAtAllIsNoSuspect) {
  GapScene scene(0);
  const auto report = scene.report();
  EXPECT_EQ(report.suspect, EffectCode::kNone);
  EXPECT_EQ(report.residual, 0);
  EXPECT_EQ(report.views.ascending, 0);
}

TEST(ModelGap, SuspectsWhatIsMissing) {
  const double noise = 0.05;
  {
    GapScene scene(noise);
    scene.change_stem([](double x, double) { return std::min(x, 0.75); });
    EXPECT_EQ(scene.report().suspect, EffectCode::kValveSaturation);
  }
  {
    GapScene scene(noise);
    scene.change_stem([](double x, double time) { return x + 0.6 * (x - 0.5) * time; });
    EXPECT_EQ(scene.report().suspect, EffectCode::kProcessGainDrift);
  }
  {
    GapScene scene(noise);
    scene.change_stem([](double x, double time) { return x + (time > 0.4 ? 0.2 : 0); });
    const auto report = scene.report();
    EXPECT_EQ(report.suspect, EffectCode::kDisturbanceStep);
    EXPECT_GT(report.share_of_error, 0.8);
  }
  {
    GapScene scene(noise);
    scene.change_stem([](double x, double time) { return x + 0.3 * time; });
    EXPECT_EQ(scene.report().suspect, EffectCode::kDisturbanceRamp);
  }
  {
    GapScene scene(noise);
    for (std::size_t t = 0; t < kGapSamples; ++t) {
      scene.y[t] += 0.15 * std::sin(2 * M_PI * static_cast<double>(t) / 61);
    }
    const auto report = scene.report();
    EXPECT_EQ(report.suspect, EffectCode::kDisturbanceSinusoid);
    EXPECT_NEAR(report.views.line_period, 61, 2);
    EXPECT_GT(report.views.line, 0.6);
  }
  {
    GapScene scene(noise);
    for (double& value : scene.y) value = std::min(value, 0.4);
    EXPECT_EQ(scene.report().suspect, EffectCode::kProcessOverflow);
  }
  {
    GapScene scene(0.01);
    for (double& value : scene.y) value = 0.3 * std::round(value / 0.3);
    scene.window.y_step = 0.3;
    EXPECT_EQ(scene.report().suspect, EffectCode::kSensorQuantisation);
  }
}

TEST(ModelGap, NamesTheSlowStrokeOfARateLimit) {
  GapScene scene(0.05);
  double at = scene.stem[0];
  scene.change_stem([&at](double x, double) {
    at = x > at ? std::min(x, at + 0.012) : x;
    return at;
  });
  const auto report = scene.report();
  EXPECT_EQ(report.suspect, EffectCode::kValveRateLimit);
}

// A harmonic of the loop belongs to the valve, not to a load.
TEST(ModelGap, AHarmonicOfTheLoopIsNoLoad) {
  GapScene scene(0.05);
  for (std::size_t t = 0; t < kGapSamples; ++t) {
    scene.y[t] += 0.15 * std::sin(2 * M_PI * static_cast<double>(t) / (kPeriod / 3));
  }
  EXPECT_NE(scene.report().suspect, EffectCode::kDisturbanceSinusoid);
}

TEST(ModelGap, ViewsAreSharesOfTheError) {
  GapScene scene(0.05);
  for (std::size_t t = 0; t < kGapSamples; ++t) {
    if (scene.ascending[t]) scene.y[t] += 0.5 * std::sin(static_cast<double>(t));
  }
  const auto views = scene.report().views;
  EXPECT_GT(views.ascending, 0.95);
  const auto sum = [](const auto& group) {
    return std::accumulate(group.begin(), group.end(), 0.0);
  };
  EXPECT_NEAR(sum(views.travel), 1, 1e-9);
  EXPECT_NEAR(sum(views.level), 1, 1e-9);
  EXPECT_NEAR(sum(views.phase), 1, 1e-9);
  EXPECT_NEAR(sum(views.time), 1, 1e-9);
  EXPECT_GE(views.lag, -1);
  EXPECT_LE(views.lag, 1);
}

TEST(ModelGap, FitsTheDevice) {
  EXPECT_LE(sizeof(ModelGap<float>), 900U);
}

// One sample of error, and the bins that it stands in: u turns down at 26, 126, …
TEST(ModelGap, ViewsSayWhereTheErrorIs) {
  for (const std::size_t at : {30U, 77U, 456U, 812U, 1023U, 1599U}) {
    GapScene scene(0);
    scene.y[at] += 1;
    const auto views = scene.report().views;
    const auto expect_all_in = [&](const auto& group, double place) {
      const auto bin = static_cast<std::size_t>(place);
      for (std::size_t k = 0; k < group.size(); ++k) {
        EXPECT_EQ(group[k], k == bin ? 1 : 0) << at << ' ' << k;
      }
    };
    const auto turned_down = static_cast<double>((at - 26) % 100);
    expect_all_in(views.phase, turned_down / kPeriod * 8);
    expect_all_in(views.time, 4.0 * static_cast<double>(at) / kGapSamples);
    const auto [low, high] = std::minmax_element(scene.stem.begin(), scene.stem.end());
    expect_all_in(views.level, 4 * (scene.stem[at] - *low) / (*high - *low));
    std::size_t turn = at;
    while (scene.ascending[turn] == scene.ascending[turn - 1]) --turn;
    const double travel = std::abs(scene.stem[at] - scene.stem[turn]) / 0.7;
    expect_all_in(views.travel, travel > 1      ? 3
                                : travel > 0.5  ? 2
                                : travel > 0.25 ? 1
                                                : 0);
    EXPECT_EQ(views.ascending, scene.ascending[at] ? 1 : 0);
    EXPECT_EQ(views.lag, 0);
  }
  GapScene scene(0);
  for (const std::size_t at : {600U, 601U, 602U}) scene.y[at] += 0.5;
  EXPECT_NEAR(scene.report().views.lag, 2.0 / 3, 1e-9);
}

TEST(ModelGap, AnswersAsANewOneAfterAnotherWindow) {
  ModelGap<double> used;
  for (const bool line : {true, false, true}) {
    GapScene scene(0.05);
    if (line) {
      for (std::size_t t = 0; t < kGapSamples; ++t) {
        scene.y[t] += 0.15 * std::sin(2 * M_PI * static_cast<double>(t) / 61);
      }
    } else {
      scene.change_stem([](double x, double time) { return x + (time > 0.4 ? 0.2 : 0); });
    }
    const auto fresh = scene.report();
    used.start(scene.window);
    while (!used.step()) {
    }
    EXPECT_EQ(used.report().suspect, fresh.suspect);
    EXPECT_EQ(used.report().share_of_error, fresh.share_of_error);
    EXPECT_EQ(used.report().residual, fresh.residual);
    EXPECT_EQ(used.report().views.phase, fresh.views.phase);
    EXPECT_EQ(used.report().views.line, fresh.views.line);
    EXPECT_EQ(used.report().views.line_period, fresh.views.line_period);
  }
}

}  // namespace
}  // namespace ident
