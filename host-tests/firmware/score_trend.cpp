// Prints what the trend of the stick band is worth on simulated years of wear:
//   score_trend [years]   default 200; exit code 1 where it falls short
//
// A year has some windows a day, whose bands are the wear of that day, times what the
// plant does to it for days (dependent from day to day) and a noise of its own; some
// windows are far off; there are outages of days to weeks. Half of the years wear not at
// all, the others in five shapes. The true slope is that of the line through the wear.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "firmware/band_trend.hpp"

namespace {

using firmware::BandTrend;
using firmware::Trend;

constexpr int kYear = 365;
constexpr std::int64_t kDay_s = 86'400;
constexpr std::int64_t kStart_s = 1'700'000'000;
constexpr double kLimit = 20;
constexpr int kShapes = 5;
const char* const kNames[] = {"none",       "linear",   "accelerating",
                              "saturating", "in steps", "none, then linear"};

struct Score {
  int years = 0;
  int holds = 0;    // the interval of the year's end has the true slope
  int found = 0;    // at the end there is a trend
  int ever = 0;     // there was one on some day
  double days = 0;  // asked, and with a trend
  double trended = 0;
};

// Wear of a day of the year, 0 … 1.
double wear(int shape, double share, double luck) {
  switch (shape) {
    case 1:
      return share;
    case 2:
      return share * share;
    case 3:
      return 1 - std::exp(-3 * share);
    case 4:
      return std::floor(share * (4 + 8 * luck)) / (4 + 8 * luck);
    case 5:
      return std::max(share - luck, 0.0) / (1 - luck);
    default:
      return 0;
  }
}

void live(unsigned seed, int shape, Score& score) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform;
  std::normal_distribution<double> normal;
  const double start = 0.5 + 4 * uniform(random);
  const double growth = start * (0.2 + 2 * uniform(random));
  const double memory = 0.9 * uniform(random);  // from day to day
  const double sway = 0.01 + 0.07 * uniform(random);
  const double noise = 0.01 + 0.06 * uniform(random);
  const int windows = 1 + static_cast<int>(20 * uniform(random));
  const double luck = uniform(random) * 0.8;
  BandTrend trend;
  BandTrend truth;
  double plant = normal(random) * sway;
  int outage = 0;
  bool ever = false;
  Trend last;
  for (int day = 0; day < kYear; ++day) {
    plant = memory * plant + std::sqrt(1 - memory * memory) * sway * normal(random);
    if (outage > 0) --outage;
    if (uniform(random) < 0.01) outage = static_cast<int>(20 * uniform(random));
    if (outage > 0) continue;
    const double band = start + growth * wear(shape, day / double(kYear), luck);
    for (int k = 0; k < windows; ++k) {
      const double off = uniform(random) < 0.02 ? 0.6 * (uniform(random) - 0.5) : 0;
      trend.add(kStart_s + day * kDay_s,
                band * (1 + plant + off + noise * normal(random)));
      truth.add(kStart_s + day * kDay_s, band);
    }
    last = trend.find(kStart_s + day * kDay_s, kLimit);
    if (!last.fitted) continue;
    score.days += 1;
    score.trended += last.stands ? 1 : 0;
    ever = ever || last.stands;
  }
  const double slope = truth.find(kStart_s + (kYear - 1) * kDay_s, kLimit).slope;
  last = trend.find(kStart_s + (kYear - 1) * kDay_s, kLimit);
  ++score.years;
  score.holds += last.low <= slope && slope <= last.high ? 1 : 0;
  score.found += last.stands ? 1 : 0;
  score.ever += ever ? 1 : 0;
}

void print(const char* name, const Score& score) {
  std::printf("| %s | %d | %.1f %% | %.1f %% | %.1f %% | %.1f %% |\n", name, score.years,
              100.0 * score.holds / score.years, 100.0 * score.found / score.years,
              100.0 * score.trended / score.days, 100.0 * score.ever / score.years);
}

}  // namespace

int main(int argc, char** argv) {
  const int years = argc > 1 ? std::atoi(argv[1]) : 200;
  if (years < 2 * kShapes) {
    std::fprintf(stderr, "score_trend: expected %d years or more\n", 2 * kShapes);
    return 2;
  }
  std::printf(
      "| wear | years | interval holds | trend at the end | share of days with one | "
      "years "
      "with one on any day |\n|---|---|---|---|---|---|\n");
  Score all;
  Score idle;
  for (int shape = 0; shape <= kShapes; ++shape) {
    Score score;
    const int count = shape == 0 ? years / 2 : years / 2 / kShapes;
    for (int k = 0; k < count; ++k) {
      live(static_cast<unsigned>(1000 * shape + k), shape, score);
    }
    print(kNames[shape], score);
    if (shape == 0) idle = score;
    all.years += score.years;
    all.holds += score.holds;
    all.found += score.found;
    all.ever += score.ever;
    all.days += score.days;
    all.trended += score.trended;
  }
  print("all", all);
  const double holds = 100.0 * all.holds / all.years;
  const double found_false = 100.0 * idle.found / idle.years;
  const bool good = holds >= 90 && holds <= 98 && found_false <= 2;
  std::printf(
      "\nintervals hold in 90 to 98 %% of the years, at most 2 %% false trends: %s\n",
      good ? "yes" : "NO");
  return good ? 0 : 1;
}
