// How well `regularity` tells oscillating controller outputs from others:
// on simulated signals and on labelled recordings, then where the limit comes from:
// both errors against it. The recordings had a part in setting it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "ident/signal/oscillation_detector.hpp"
#include "oscillation_signals.hpp"

namespace {

using oscillation_signals::Random;
using oscillation_signals::Signal;
using Detector = ident::OscillationDetector<float>;

struct Judged {
  bool oscillating;
  double regularity;
};

ident::OscillationReport<float> judge(const std::vector<double>& values) {
  Detector detector;
  for (double v : values) detector.push(static_cast<float>(v));
  return detector.report();
}

/// Chance that an oscillating signal ranks above one that is not; ties half.
double area_under_curve(const std::vector<Judged>& all) {
  double wins = 0.0, pairs = 0.0;
  for (const Judged& yes : all) {
    if (!yes.oscillating) continue;
    for (const Judged& no : all) {
      if (no.oscillating) continue;
      pairs += 1.0;
      if (yes.regularity > no.regularity) wins += 1.0;
      if (yes.regularity == no.regularity) wins += 0.5;
    }
  }
  return pairs > 0.0 ? wins / pairs : 0.0;
}

struct Errors {
  int right = 0, false_alarms = 0, misses = 0;
};

Errors count_errors(const std::vector<Judged>& all, double limit) {
  Errors e;
  for (const Judged& j : all) {
    const bool detected = j.regularity > limit;
    e.right += detected == j.oscillating;
    e.false_alarms += detected && !j.oscillating;
    e.misses += !detected && j.oscillating;
  }
  return e;
}

std::vector<Judged> simulated() {
  constexpr std::size_t kCount = 4000;
  constexpr std::uint64_t kSeeds = 2;
  struct Kind {
    int count = 0, detected = 0;
    bool oscillating = false;
    std::vector<double> period_errors;
  };
  std::map<std::string, Kind> kinds;
  std::vector<Judged> all;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    for (const Signal& s : oscillation_signals::simulated_set(kCount, seed)) {
      const auto r = judge(s.values);
      all.push_back({s.oscillating, static_cast<double>(r.regularity)});
      Kind& kind = kinds[s.kind];
      kind.oscillating = s.oscillating;
      ++kind.count;
      kind.detected += r.detected;
      if (s.oscillating && r.detected) {
        kind.period_errors.push_back(
            std::fabs(static_cast<double>(r.period_samples) / s.period - 1.0));
      }
    }
  }
  std::printf("Simulated signals (%zu, half of them oscillating)\n", all.size());
  std::printf("  %-18s %6s %10s %22s\n", "kind", "number", "detected",
              "median period error");
  for (auto& [name, kind] : kinds) {
    std::printf("  %-18s %6d %8.1f %%", name.c_str(), kind.count,
                100.0 * kind.detected / kind.count);
    if (!kind.period_errors.empty()) {
      std::sort(kind.period_errors.begin(), kind.period_errors.end());
      std::printf(" %19.1f %%",
                  100.0 * kind.period_errors[kind.period_errors.size() / 2]);
    }
    std::printf("\n");
  }
  std::printf("  AUC of regularity %.3f (first 2000)\n\n",
              area_under_curve({all.begin(), all.begin() + 2000}));
  return all;
}

/// What a monitor that runs for years lives with: starts and ends out of noise.
void endless_noise() {
  struct Case {
    const char* name;
    double pole;     // one pole, or
    double damping;  // a pole pair of 20 samples per cycle
  };
  constexpr Case kCases[] = {
      {"white noise", 0.0, 0.0},          {"one pole 0.9", 0.9, 0.0},
      {"one pole 0.99", 0.99, 0.0},       {"random walk", 1.0, 0.0},
      {"resonance, damping 0.3", 0, 0.3}, {"resonance, damping 0.2", 0, 0.2},
      {"resonance, damping 0.1", 0, 0.1}};
  constexpr int kSamples = 1000000;
  std::printf("Endless noise, 1e6 samples\n  %-24s %20s %12s %12s\n", "noise",
              "starts per 1e5", "time on", "regularity");
  for (const Case& c : kCases) {
    Random random(77);
    Detector detector;
    const double w = 2.0 * std::numbers::pi / 20.0;
    const double radius =
        std::exp(-c.damping * w / std::sqrt(1.0 - c.damping * c.damping));
    const double a1 = c.damping > 0.0 ? 2.0 * radius * std::cos(w) : c.pole;
    const double a2 = c.damping > 0.0 ? -radius * radius : 0.0;
    double x = 0.0, before = 0.0;
    int starts = 0, on = 0;
    bool last = false;
    for (int i = 0; i < kSamples; ++i) {
      const double next = a1 * x + a2 * before + random.normal();
      before = x;
      x = next;
      detector.push(static_cast<float>(x));
      const bool now = detector.present().oscillating;
      starts += now && !last;
      on += now;
      last = now;
    }
    std::printf("  %-24s %20.2f %10.2f %% %12.2f\n", c.name, starts / 10.0, on / 1e4,
                static_cast<double>(detector.report().regularity));
  }
  std::printf("\n");
}

std::vector<double> read_u(const std::filesystem::path& path) {
  std::ifstream in(path);
  std::string line;
  std::getline(in, line);
  std::vector<double> u;
  while (std::getline(in, line)) {
    const std::size_t comma = line.find(',');
    if (comma != std::string::npos)
      u.push_back(std::strtod(line.c_str() + comma + 1, nullptr));
  }
  return u;
}

std::vector<Judged> recorded(const std::filesystem::path& folder) {
  std::ifstream file(folder / "labels.json");
  if (!file) {
    std::printf("SKIPPED: no recordings in %s\n", folder.string().c_str());
    return {};
  }
  const nlohmann::json labels = nlohmann::json::parse(file);
  std::vector<Judged> all;
  std::printf("Recordings\n  %-8s %8s %12s %11s %11s %8s %9s\n", "name", "samples",
              "label", "detected", "regularity", "period", "amplitude");
  for (const auto& [name, label] : labels.items()) {
    const std::vector<double> u = read_u(folder / (name + ".csv"));
    const auto r = judge(u);
    const bool oscillating = label.at("oscillating").get<bool>();
    all.push_back({oscillating, static_cast<double>(r.regularity)});
    std::printf("  %-8s %8zu %12s %11s %11.2f %8.1f %9.3g%s\n", name.c_str(), u.size(),
                oscillating ? "oscillating" : "not", r.detected ? "oscillating" : "not",
                static_cast<double>(r.regularity), static_cast<double>(r.period_samples),
                static_cast<double>(r.amplitude),
                r.detected == oscillating ? "" : "  wrong");
  }
  const Errors e = count_errors(all, 1.0);
  std::printf("\n  right %d of %zu = %.1f %% (goal 85), false alarms %d, misses %d\n",
              e.right, all.size(), 100.0 * e.right / static_cast<double>(all.size()),
              e.false_alarms, e.misses);
  std::printf("  AUC of regularity %.3f (goal 0.90)\n", area_under_curve(all));
  std::printf("  published autocovariance index, for comparison: 68.5 %%, AUC 0.853\n");
  return all;
}

/// False alarms of the signals that do not oscillate, misses of those that do, %.
struct ErrorRates {
  double false_alarms = 0, misses = 0;
};

ErrorRates error_rates(const std::vector<Judged>& all, double limit) {
  const Errors e = count_errors(all, limit);
  double yes = 0.0;
  for (const Judged& j : all) yes += j.oscillating;
  const double no = static_cast<double>(all.size()) - yes;
  return {no > 0.0 ? 100.0 * e.false_alarms / no : 0.0,
          yes > 0.0 ? 100.0 * e.misses / yes : 0.0};
}

/// Where the limit comes from: both kinds of signals weigh the same, and the two errors
/// of their mean meet.
void thresholds(const std::vector<Judged>& simulated,
                const std::vector<Judged>& recorded) {
  const int in_force =
      static_cast<int>(std::lround(100.0f * Detector::kIrregularityLimit));
  std::printf(
      "\nLimit of the irregularity against both errors, %% false alarms / misses\n");
  std::printf("  %-8s %18s %18s %18s\n", "limit", "simulated", "recorded", "mean");
  for (int percent = 30; percent <= 60; percent += 2) {
    const double limit =
        static_cast<double>(Detector::kIrregularityLimit) / (0.01 * percent);
    const ErrorRates s = error_rates(simulated, limit);
    const ErrorRates r = error_rates(recorded, limit);
    std::printf("  %-8.2f %10.1f / %5.1f %10.1f / %5.1f %10.1f / %5.1f%s\n",
                0.01 * percent, s.false_alarms, s.misses, r.false_alarms, r.misses,
                0.5 * (s.false_alarms + r.false_alarms), 0.5 * (s.misses + r.misses),
                percent == in_force ? "   <- in force" : "");
  }
}

}  // namespace

int main() {
  std::printf("OscillationDetector<float>: %zu bytes, <double>: %zu bytes\n\n",
              sizeof(ident::OscillationDetector<float>),
              sizeof(ident::OscillationDetector<double>));
  const std::vector<Judged> of_simulated = simulated();
  endless_noise();
  const std::vector<Judged> of_recorded =
      recorded(std::filesystem::path(STICKBAND_RECORDINGS) / "oscillation");
  thresholds(of_simulated, of_recorded);
  return 0;
}
