#include "workbench/analysis/votes.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "workbench/recording/statistics.hpp"

namespace workbench {

ident::Verdict majority_of(const Votes& votes) {
  const auto count = [&votes](ident::Verdict v) { return votes[static_cast<int>(v)]; };
  // First whether the valve is at fault, then how: windows that disagree on the slip jump
  // agree on the fault.
  const double sticking = count(ident::Verdict::kStiction);
  const double playing = count(ident::Verdict::kBacklash);
  const double faulty = sticking + playing;
  const double healthy = count(ident::Verdict::kNoStiction);
  const double all = std::accumulate(votes.begin(), votes.end(), 0.0);
  constexpr double kFault = 0.25;  // of the time
  constexpr double kAbsence = 0.5;
  const bool found = faulty > healthy && faulty >= kFault * all;
  const bool absent = healthy > faulty && healthy >= kAbsence * all;
  if (!found && !absent) return ident::Verdict::kUndecided;
  return absent               ? ident::Verdict::kNoStiction
         : playing > sticking ? ident::Verdict::kBacklash
                              : ident::Verdict::kStiction;
}

ident::Estimate<double> median_of(const std::vector<ident::Estimate<double>>& estimates) {
  std::vector<double> value, low, high;
  for (const ident::Estimate<double>& estimate : estimates) {
    if (!estimate.known) continue;
    value.push_back(estimate.value);
    low.push_back(estimate.low);
    high.push_back(estimate.high);
  }
  if (value.empty()) return {};
  return {true, median(value), median(low), median(high)};
}

std::string listed(const VoteCounts& votes) {
  std::string text;
  using V = ident::Verdict;
  for (const auto& [v, verdict] : {std::pair(V::kStiction, "stiction"),
                                   {V::kBacklash, "backlash"},
                                   {V::kNoStiction, "no stiction"},
                                   {V::kUndecided, "undecided"},
                                   {V::kBadData, "bad data"}}) {
    const int count = votes[static_cast<int>(v)];
    if (count == 0) continue;
    text += (text.empty() ? " " : ", ") + std::to_string(count) + ' ' + verdict;
  }
  return text;
}

}  // namespace workbench
