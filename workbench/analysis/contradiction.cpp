#include "workbench/analysis/contradiction.hpp"

#include <algorithm>

#include "workbench/analysis/votes.hpp"
#include "workbench/analysis/wording.hpp"
#include "workbench/recording/listed.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

using Kind = Contradiction::Kind;

// What one recording says.
struct Says {
  std::size_t recording = 0;
  ident::Verdict verdict = ident::Verdict::kUndecided;
  ident::PerStroke<double> band;
  int gain_sign = 1;
};

Says said_by(std::size_t recording, const std::vector<WindowFinding>& findings) {
  Says says;
  says.recording = recording;
  Votes votes{};
  std::vector<ident::Estimate<double>> ascending, descending;
  for (const WindowFinding& window : findings) {
    if (window.recording != recording) continue;
    votes[static_cast<std::size_t>(window.verdict)] += window.to_s - window.from_s;
    if (!is_fault(window.verdict)) continue;
    ascending.push_back(window.stick_band.ascending);
    descending.push_back(window.stick_band.descending);
    says.gain_sign = window.gain_sign;
  }
  says.verdict = majority_of(votes);
  says.band = {median_of(ascending), median_of(descending)};
  return says;
}

bool exclude_each_other(const ident::Estimate<double>& a,
                        const ident::Estimate<double>& b) {
  return a.known && b.known && (a.low > b.high || b.low > a.high);
}

bool exclude_each_other(const Says& a, const Says& b) {
  return exclude_each_other(a.band.ascending, b.band.ascending) &&
         exclude_each_other(a.band.descending, b.band.descending);
}

std::string words_of(const Says& says) {
  const std::string where = " in recording " + std::to_string(says.recording + 1);
  if (!is_fault(says.verdict)) return "none" + where;
  const EstimateText up = text_of(says.band.ascending);
  const EstimateText down = text_of(says.band.descending);
  return up.value + " ascending and " + down.value + " descending" + where;
}

// "4.0 ascending and 3.9 descending in recording 1; none in recording 2".
std::string all_words(const std::vector<Says>& said) {
  return listed(said, "; ", words_of);
}

Contradiction between_faults(const std::vector<Says>& said) {
  const auto against = [&said](auto disagree) {
    return std::ranges::any_of(said, [&](const Says& a) {
      return std::ranges::any_of(said, [&](const Says& b) { return disagree(a, b); });
    });
  };
  if (against([](const Says& a, const Says& b) { return a.gain_sign != b.gain_sign; })) {
    return {.kind = Kind::kGains,
            .note =
                "u moves y up in one recording and down in another: they are not of "
                "one loop, or a column is turned round. Judge them one by one"};
  }
  if (against([](const Says& a, const Says& b) { return exclude_each_other(a, b); })) {
    return {.kind = Kind::kBands,
            .note = "the recordings want stick bands that exclude each other: " +
                    all_words(said) +
                    ". The valve changed in between, or they are of several loops; no "
                    "common band is told"};
  }
  return {};
}

}  // namespace

Contradiction contradiction_of(const std::vector<WindowFinding>& findings) {
  std::vector<Says> faults;
  std::vector<Says> decided;
  std::size_t recordings = 0;
  for (const WindowFinding& window : findings) {
    recordings = std::max(recordings, window.recording + 1);
  }
  for (std::size_t i = 0; i < recordings; ++i) {
    const Says says = said_by(i, findings);
    if (is_fault(says.verdict)) faults.push_back(says);
    if (is_fault(says.verdict) || says.verdict == ident::Verdict::kNoStiction) {
      decided.push_back(says);
    }
  }
  if (faults.empty() || decided.size() < 2) return {};
  if (faults.size() == decided.size()) return between_faults(faults);
  return {.kind = Kind::kRepaired,
          .mostly_sticks = 2 * faults.size() > decided.size(),
          .note = "stick bands: " + all_words(decided) +
                  ". The valve was repaired or began to stick in between, they are of "
                  "several loops, or a load hides it in one. Judge them one by one"};
}

std::string ended_note(const std::vector<WindowFinding>& findings) {
  constexpr std::ptrdiff_t kFewest = 2;
  const auto faulty = [](const WindowFinding& window) {
    return is_fault(window.verdict);
  };
  const auto shows_none = [](const WindowFinding& window) { return window.nats < 0; };
  const auto after = std::find_if(findings.rbegin(), findings.rend(), faulty).base();
  if (findings.end() - after < kFewest ||
      std::count_if(findings.begin(), after, faulty) < kFewest ||
      !std::all_of(after, findings.end(), shows_none)) {
    return "";
  }
  return "no window after " + number((after - 1)->to_s) +
         " s shows anything of it: the valve was repaired, the loop has rested since, or "
         "a load hides it. Judge what came later by itself";
}

}  // namespace workbench
