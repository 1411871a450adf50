#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "ident/signal/oscillation_detector.hpp"
#include "score/oscillation_signals.hpp"

namespace {

using oscillation_signals::Random;
using Detector = ident::OscillationDetector<float>;

double sine(double i, double period) {
  return std::sin(2.0 * std::numbers::pi * i / period);
}

void feed(Detector& detector, int n, const std::function<double(int)>& signal) {
  for (int i = 0; i < n; ++i) detector.push(static_cast<float>(signal(i)));
}

ident::OscillationReport<float> after(int n, const std::function<double(int)>& signal) {
  Detector detector;
  feed(detector, n, signal);
  return detector.report();
}

TEST(OscillationDetector, FindsPeriodAndAmplitudeOfASinusoid) {
  for (double period = 4.3; period < 500.0; period *= 1.13) {
    const int n = static_cast<int>(40.0 * period);
    const auto r = after(n, [&](int i) { return 50.0 + 3.0 * sine(i, period); });
    EXPECT_TRUE(r.detected) << period;
    EXPECT_TRUE(r.oscillating) << period;
    EXPECT_NEAR(r.period_samples, period, 0.02 * period);
    EXPECT_NEAR(r.amplitude, 3.0, 0.15) << period;
    EXPECT_NEAR(r.cycles, 40, 3) << period;
    EXPECT_GT(r.regularity, 5.0f) << period;
  }
}

TEST(OscillationDetector, RhythmIsTheCheapPartOfPresent) {
  Random random(7);
  Detector detector;
  EXPECT_FALSE(detector.rhythm().oscillating);
  EXPECT_EQ(detector.rhythm().period_samples, 0);
  bool seen = false;
  for (int i = 0; i < 4000; ++i) {
    const double wave = i > 1000 && i < 3000 ? 3.0 * sine(i, 40.0) : 0.0;
    detector.push(static_cast<float>(wave + random.normal()));
    const auto present = detector.present();
    const auto rhythm = detector.rhythm();
    ASSERT_EQ(rhythm.oscillating, present.oscillating) << i;
    ASSERT_EQ(rhythm.period_samples, rhythm.oscillating ? present.period_samples : 0)
        << i;
    seen = seen || rhythm.oscillating;
  }
  EXPECT_TRUE(seen);
}

TEST(OscillationDetector, RhythmKnowsTheShortestPeriods) {
  for (const double period : {5.0, 300.0}) {
    Detector detector;
    feed(detector, static_cast<int>(40 * period),
         [&](int i) { return 3.0 * sine(i, period); });
    EXPECT_TRUE(detector.rhythm().oscillating) << period;
    EXPECT_NEAR(detector.rhythm().period_samples, period, 0.05 * period);
  }
}

TEST(OscillationDetector, SaysWhenThereIsNews) {
  Random random(8);
  Detector detector;
  auto before = detector.present();
  int news = 0;
  for (int i = 0; i < 4000; ++i) {
    const bool told = detector.push(static_cast<float>(sine(i, 40.0) + random.normal()));
    const auto now = detector.present();
    if (!told) {
      ASSERT_EQ(now.oscillating, before.oscillating) << i;
      ASSERT_EQ(now.period_samples, before.period_samples) << i;
      ASSERT_EQ(now.regularity, before.regularity) << i;
      ASSERT_EQ(now.cycles, before.cycles) << i;
    }
    news += told ? 1 : 0;
    before = now;
  }
  EXPECT_GT(news, 100);
  EXPECT_LT(news, 2000);
}

TEST(OscillationDetector, FindsAFewSlowCyclesUnderNoise) {
  Random random(1);
  const auto r =
      after(2800, [&](int i) { return sine(i, 280.0) + 0.3 * random.normal(); });
  EXPECT_TRUE(r.detected);
  EXPECT_NEAR(r.period_samples, 280.0, 0.02 * 280.0);
  EXPECT_NEAR(r.amplitude, 1.0, 0.05);
}

TEST(OscillationDetector, FindsAFastWaveOnASlowDrift) {
  Random random(2);
  double drift = 0.0;
  const auto r = after(3000, [&](int i) {
    drift += 0.05 * random.normal();
    return 0.02 * i + drift + sine(i, 17.0);
  });
  EXPECT_TRUE(r.detected);
  EXPECT_NEAR(r.period_samples, 17.0, 0.02 * 17.0);
}

TEST(OscillationDetector, ReportsTheFundamentalOfASquareWave) {
  const auto r = after(4000, [](int i) { return i % 100 < 50 ? 1.0 : -1.0; });
  EXPECT_TRUE(r.detected);
  EXPECT_NEAR(r.period_samples, 100.0, 2.0);
  EXPECT_NEAR(r.amplitude, 4.0 / std::numbers::pi, 0.1);
}

TEST(OscillationDetector, ReportsTheFundamentalOfATriangle) {
  const auto r = after(4000, [](int i) { return std::fabs(i % 80 - 40) / 20.0 - 1.0; });
  EXPECT_TRUE(r.detected);
  EXPECT_NEAR(r.period_samples, 80.0, 1.6);
  EXPECT_NEAR(r.amplitude, 8.0 / (std::numbers::pi * std::numbers::pi), 0.05);
}

TEST(OscillationDetector, SeesNothingInAConstant) {
  for (double level : {0.0, 1e-30, 99.7, -1e30}) {
    const auto r = after(5000, [&](int) { return level; });
    EXPECT_FALSE(r.detected);
    EXPECT_FALSE(r.oscillating);
    EXPECT_EQ(r.regularity, 0.0f);
    EXPECT_EQ(r.amplitude, 0.0f);
    EXPECT_EQ(r.period_samples, 0.0f);
    EXPECT_EQ(r.cycles, 0);
  }
}

TEST(OscillationDetector, SeesNothingInAStepARampOrASpike) {
  EXPECT_FALSE(after(100000, [](int i) { return i < 1000 ? 0.0 : 1e5; }).detected);
  EXPECT_FALSE(after(100000, [](int i) { return 0.1 * i; }).detected);
  EXPECT_FALSE(after(100000, [](int i) { return i == 777 ? 1e9 : 1.0; }).detected);
}

TEST(OscillationDetector, AnswersFromTheFirstSampleOn) {
  Detector detector;
  EXPECT_FALSE(detector.report().detected);
  detector.push(1.0f);
  EXPECT_FALSE(detector.report().detected);
  detector.push(-1.0f);
  EXPECT_FALSE(detector.report().detected);
  EXPECT_EQ(detector.report().period_samples, 0.0f);
}

TEST(OscillationDetector, SurvivesWhatIsNotANumber) {
  Detector detector, plain;
  for (int i = 0; i < 2000; ++i) {
    const auto x = static_cast<float>(sine(i, 25.0));
    detector.push(x);
    plain.push(x);
    if (i % 7 == 0) detector.push(std::numeric_limits<float>::quiet_NaN());
    if (i % 11 == 0) detector.push(std::numeric_limits<float>::infinity());
  }
  EXPECT_EQ(detector.report().period_samples, plain.report().period_samples);
  EXPECT_EQ(detector.report().regularity, plain.report().regularity);
}

TEST(OscillationDetector, SurvivesTheLargestAndTheSmallestNumbers) {
  for (float size :
       {std::numeric_limits<float>::max(), 1e30f, std::numeric_limits<float>::min(),
        std::numeric_limits<float>::denorm_min()}) {
    Detector detector;
    for (int i = 0; i < 3000; ++i) detector.push(i % 20 < 10 ? size : -size);
    const auto r = detector.report();
    EXPECT_TRUE(std::isfinite(r.period_samples) && std::isfinite(r.amplitude) &&
                std::isfinite(r.regularity));
  }
}

TEST(OscillationDetector, SeesNoOscillationInNoise) {
  int detected = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    detected += after(20000, [&](int) { return random.normal(); }).detected;
    double walk = 0.0;
    detected += after(20000, [&](int) { return walk += random.normal(); }).detected;
    double pole = 0.0;
    detected +=
        after(20000, [&](int) { return pole = 0.95 * pole + random.normal(); }).detected;
  }
  EXPECT_EQ(detected, 0);
}

TEST(OscillationDetector, NoticesTheStartAndTheEnd) {
  for (double period : {6.0, 30.0, 280.0}) {
    Random random(3);
    Detector detector;
    const int cycle = static_cast<int>(period);
    feed(detector, 60 * cycle, [&](int) { return 0.1 * random.normal(); });
    EXPECT_FALSE(detector.present().detected) << period;
    feed(detector, 14 * cycle,
         [&](int i) { return sine(i, period) + 0.1 * random.normal(); });
    EXPECT_TRUE(detector.present().detected) << period;
    feed(detector, 20 * cycle,
         [&](int i) { return sine(i, period) + 0.1 * random.normal(); });
    const auto during = detector.present();
    EXPECT_TRUE(during.oscillating) << period;
    EXPECT_NEAR(during.period_samples, period, 0.05 * period);
    EXPECT_NEAR(during.cycles, 34, 10) << period;
    feed(detector, 60 * cycle, [&](int) { return 0.1 * random.normal(); });
    EXPECT_FALSE(detector.present().detected) << period;
    EXPECT_FALSE(detector.report().oscillating) << period;
  }
}

TEST(OscillationDetector, NoticesTheEndInSilence) {
  Detector detector;
  feed(detector, 1200, [](int i) { return sine(i, 40.0); });
  EXPECT_TRUE(detector.present().detected);
  feed(detector, 1600, [](int) { return 0.0; });
  EXPECT_FALSE(detector.present().detected);
}

TEST(OscillationDetector, AShortBurstIsNotTheRecord) {
  Random random(4);
  const auto r = after(20000, [&](int i) {
    return (i > 8000 && i < 9000 ? sine(i, 50.0) : 0.0) + 0.3 * random.normal();
  });
  EXPECT_FALSE(r.detected);
}

TEST(OscillationDetector, CountersHoldInALongRun) {
  Detector detector;
  feed(detector, 700000, [](int i) { return i % 10 < 5 ? 1.0 : 0.0; });
  const auto r = detector.report();
  EXPECT_TRUE(r.detected);
  EXPECT_EQ(r.cycles, 65535);
  EXPECT_NEAR(r.period_samples, 10.0, 0.2);
}

TEST(OscillationDetector, AgreesWithTheLabelsOfRecordedLoops) {
  const std::filesystem::path folder =
      std::filesystem::path(STICKBAND_RECORDINGS) / "oscillation";
  std::ifstream file(folder / "labels.json");
  if (!file) GTEST_SKIP() << "no recordings in " << folder;
  const nlohmann::json labels = nlohmann::json::parse(file);
  int right = 0;
  for (const auto& [name, label] : labels.items()) {
    std::ifstream in(folder / (name + ".csv"));
    std::string line;
    std::getline(in, line);
    Detector detector;
    while (std::getline(in, line)) {
      detector.push(std::strtof(line.c_str() + line.find(',') + 1, nullptr));
    }
    right += detector.report().detected == label.at("oscillating").get<bool>();
  }
  EXPECT_GE(right, 0.85 * static_cast<double>(labels.size()));
}

TEST(OscillationDetector, ResetForgets) {
  Detector detector;
  feed(detector, 1000, [](int i) { return sine(i, 20.0); });
  detector.reset();
  EXPECT_FALSE(detector.report().detected);
  EXPECT_EQ(detector.report().cycles, 0);
}

}  // namespace
