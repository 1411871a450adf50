// Does single precision, which the device computes in, say what double precision says?
//
//   score_precision [SEEDS]
//
// Identifies SEEDS (default 3) loops of every simulated scenario, and the newest window
// of every labelled recording, in both precisions. Prints the loops whose verdict differs
// and how far the stick bands lie apart, as a Markdown table.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ident/base/configurations.hpp"
#include "ident/identifier.hpp"
#include "workbench/recording/csv.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace {

constexpr std::size_t kCapacity = ident::kLargeWindow;

struct Signals {
  std::vector<double> u, y, sp;
};

template <class Real>
std::vector<Real> newest(const std::vector<double>& values) {
  const std::size_t count = std::min(values.size(), kCapacity);
  return {values.end() - static_cast<std::ptrdiff_t>(count), values.end()};
}

template <class Real>
ident::Identification<Real> identify(const Signals& signals) {
  static const auto identifier = std::make_unique<ident::Identifier<Real, kCapacity>>();
  return identifier->run(newest<Real>(signals.u), newest<Real>(signals.y),
                         newest<Real>(signals.sp));
}

class Comparison {
 public:
  void add(const std::string& name, const Signals& signals) {
    const auto exact = identify<double>(signals);
    const auto quick = identify<float>(signals);
    ++loops_;
    if (exact.verdict != quick.verdict) {
      ++differing_;
      std::printf("| %s | %s | %s |\n", name.c_str(),
                  std::string(ident::name(exact.verdict)).c_str(),
                  std::string(ident::name(quick.verdict)).c_str());
      return;
    }
    const double band =
        std::max(exact.stick_band.ascending.value, exact.stick_band.descending.value);
    if (exact.verdict != ident::Verdict::kStiction || !(band > 0)) {
      return;
    }
    const auto apart = [](const auto& a, const auto& b) {
      return std::abs(a.value - static_cast<double>(b.value));
    };
    apart_.push_back(
        100 / band *
        std::max(apart(exact.stick_band.ascending, quick.stick_band.ascending),
                 apart(exact.stick_band.descending, quick.stick_band.descending)));
  }
  void tell() {
    std::sort(apart_.begin(), apart_.end());
    const auto quantile = [this](double share) {
      return apart_.empty() ? 0.0
                            : apart_[static_cast<std::size_t>(
                                  share * static_cast<double>(apart_.size() - 1))];
    };
    std::printf(
        "\nsame verdict on %d of %d loops; stick bands of %zu apart by %.2f %% "
        "(median), %.1f %% (90th percentile)\n",
        loops_ - differing_, loops_, apart_.size(), quantile(0.5), quantile(0.9));
  }

 private:
  int loops_ = 0;
  int differing_ = 0;
  std::vector<double> apart_;
};

void compare_recordings(const std::filesystem::path& folder, Comparison& comparison) {
  std::ifstream file(folder / "labels.json");
  if (!file) {
    std::printf("%s: SKIPPED, the recordings are not on this machine\n",
                folder.stem().c_str());
    return;
  }
  const nlohmann::json labels = nlohmann::json::parse(file);
  for (const auto& [name, label] : labels.items()) {
    try {
      const workbench::Recording recording =
          workbench::read_csv((folder / (name + ".csv")).string(), {});
      comparison.add(name, {recording.u, recording.y, recording.sp});
    } catch (const workbench::InputError&) {
      std::printf("| %s | NOT READ | |\n", name.c_str());
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int seeds = argc > 1 ? std::max(std::atoi(argv[1]), 1) : 3;
  std::printf("| loop | float64 | float32 |\n|---|---|---|\n");
  Comparison comparison;
  for (const auto& scenario : workbench::scenarios()) {
    for (int seed = 1; seed <= seeds; ++seed) {
      const std::string name(scenario.name);
      if (const auto loop = workbench::simulate(name, static_cast<std::uint64_t>(seed))) {
        comparison.add(name + " " + std::to_string(seed), {loop->u, loop->y, loop->sp});
      }
    }
  }
  const std::filesystem::path recordings(STICKBAND_RECORDINGS);
  for (const char* folder : {"isdb", "plant", "sacac"}) {
    compare_recordings(recordings / folder, comparison);
  }
  comparison.tell();
  return 0;
}
