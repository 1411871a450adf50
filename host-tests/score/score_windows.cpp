// Does one loop get one stick band, wherever its log is cut into windows?
//
//   score_windows [EVERY_S=20] [--list] [SCENARIO:SEED ...]
//
// Cuts the log of each loop (default: paper-example-1, paper-example-1-mixed and
// stiction-mixed, seed 1) into windows of half its length, one every EVERY_S seconds but
// at most kMostWindows, identifies each one by itself and again as a monitor does, with
// the valve of the window before as a start, and prints a Markdown table of the stick
// bands' errors and of the intervals that hold the true band. --list prints every window.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "ident/base/configurations.hpp"
#include "ident/identifier.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace {

using Identifier = ident::Identifier<double, ident::kLargeWindow>;
using ident::Verdict;
using workbench::SimulatedLoop;

constexpr std::size_t kMostWindows = 40;
constexpr int kBudget = 10;  // of a slice: a million instructions of a Cortex-M4F

struct Options {
  double every_s = 20;
  bool list = false;
  std::vector<std::string> loops;
};

struct Score {
  int windows = 0;
  double slices = 0;  // of kBudget
  int found = 0;
  int searched = 0;  // otherwise than near the valve of the window before
  int bands = 0;     // with a true band and an estimate
  int held = 0;
  std::vector<double> errors;  // percent of the wider true band

  void add(const SimulatedLoop& loop, const ident::Identification<double>& found_now) {
    ++windows;
    if (found_now.verdict != Verdict::kStiction) return;
    ++found;
    const double ascending = loop.truth.stick_band_ascending;
    const double descending = loop.truth.stick_band_descending;
    const double widest = std::max(ascending, descending);
    add(found_now.stick_band.ascending, ascending, widest);
    add(found_now.stick_band.descending, descending, widest);
  }
  void add(const ident::Estimate<double>& estimate, double truth, double widest) {
    if (!estimate.known || truth <= 0) return;
    ++bands;
    held += estimate.low <= truth && truth <= estimate.high ? 1 : 0;
    errors.push_back(100 * std::abs(estimate.value - truth) / widest);
  }
  [[nodiscard]] double quantile(double share) const {
    if (errors.empty()) return 0;
    std::vector<double> sorted = errors;
    std::sort(sorted.begin(), sorted.end());
    return sorted[static_cast<std::size_t>(share *
                                           static_cast<double>(sorted.size() - 1))];
  }
  void tell(const std::string& name, const char* how) const {
    std::printf(
        "| %s | %s | %d of %d | %d | %.1f | %.1f %% | %.1f %% | %.1f %% | %.0f %% of %d "
        "|\n",
        name.c_str(), how, found, windows, searched, slices / windows / 100,
        quantile(0.5), quantile(0.9), quantile(1),
        bands == 0 ? 0.0 : 100.0 * held / bands, bands);
  }
};

void list(const char* how, double at_s, const ident::Identification<double>& found) {
  const auto& up = found.stick_band.ascending;
  const auto& down = found.stick_band.descending;
  std::printf("  %s %7.0f s  %s  up %.3f [%.3f, %.3f]  down %.3f [%.3f, %.3f]\n", how,
              at_s, std::string(ident::name(found.verdict)).c_str(), up.value, up.low,
              up.high, down.value, down.low, down.high);
}

bool score(const std::string& words, const Options& options) {
  const std::size_t colon = words.find(':');
  const std::string name = words.substr(0, colon);
  const std::uint64_t seed = colon == std::string::npos
                                 ? 1
                                 : std::strtoull(words.c_str() + colon + 1, nullptr, 10);
  const auto loop = workbench::simulate(name, seed);
  if (!loop) {
    std::fprintf(stderr, "expected a scenario of `stickband simulate --list`, found %s\n",
                 name.c_str());
    return false;
  }
  const std::size_t length = std::min(loop->u.size() / 2, ident::kLargeWindow);
  const std::size_t room = loop->u.size() - length;
  const std::size_t stride =
      std::max({static_cast<std::size_t>(options.every_s / loop->period_s),
                std::size_t{1}, room / kMostWindows});
  static const auto identifier = std::make_unique<Identifier>();
  Score by_itself;
  Score in_a_row;
  ident::EarlierValve earlier;
  ident::WindowOptions after_another;
  after_another.earlier = &earlier;
  for (std::size_t first = 0; first <= room; first += stride) {
    const auto cut = [&](const std::vector<double>& values) {
      return std::span<const double>(values).subspan(first, length);
    };
    const auto look = [&](const ident::WindowOptions& how, const char* words_for_it,
                          Score& score_of_it) {
      identifier->start(cut(loop->u), cut(loop->y), cut(loop->sp), 0, how);
      do {
        score_of_it.slices += 1;
      } while (!identifier->step(kBudget));
      score_of_it.add(*loop, identifier->result());
      if (options.list) list(words_for_it, loop->t[first], identifier->result());
    };
    look({}, "alone", by_itself);
    ++by_itself.searched;
    look(after_another, "after", in_a_row);
    in_a_row.searched += identifier->searched() ? 1 : 0;
    earlier = identifier->next_start();
  }
  by_itself.tell(words, "by itself");
  in_a_row.tell(words, "after the one before");
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    if (word == "--list") {
      options.list = true;
    } else if (std::atof(argv[k]) > 0) {
      options.every_s = std::atof(argv[k]);
    } else {
      options.loops.push_back(word);
    }
  }
  if (options.loops.empty()) {
    options.loops = {"paper-example-1", "paper-example-1-mixed", "stiction-mixed"};
  }
  std::printf(
      "| log | window | sticking | searched | 10⁸ instructions | S error, median | 90th "
      "percentile | worst "
      "| intervals "
      "that hold |\n|---|---|---|---|---|---|---|---|---|\n");
  bool known = true;
  for (const std::string& loop : options.loops) known = score(loop, options) && known;
  return known ? 0 : 2;
}
