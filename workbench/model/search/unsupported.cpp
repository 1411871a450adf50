#include "workbench/model/search/unsupported.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "workbench/model/judge/merit.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

constexpr double kDoubt = 0.05;     // above it a candidate is rejected
constexpr double kMuch = 0.1;       // of the squared validation error …
constexpr double kMuchDoubt = 0.3;  // … which is no chance below this

// Normal deviate that is exceeded with probability `p`; 0 from one half on.
double score_beyond(double p) {
  constexpr int kHalvings = 40;
  double low = 0;
  double high = 40;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = (low + high) / 2;
    (normal_tail(middle) > p ? low : high) = middle;
  }
  return low;
}

// How many times as much of the same a recording takes to be significant: a score grows
// with the root of its length. Nothing where no length would do.
std::optional<double> times_as_long(const Trial& trial) {
  constexpr double kMost = 10;
  if (!(trial.test.p_value > 0) || !(trial.p_family > 0)) return std::nullopt;
  const double asked = trial.test.p_value * kSignificance / trial.p_family;
  const double score = score_beyond(trial.test.p_value);
  const double times = score > 0 ? std::pow(score_beyond(asked) / score, 2) : kMost + 1;
  if (times > kMost) return std::nullopt;
  return std::max(std::ceil(2 * times) / 2, 1.5);
}

// Why a gain that is hardly chance by its p-value is not enough, and what would be.
std::string doubt_in_gain(const Trial& trial, double share) {
  const std::string away = percent(share);
  if (!is_significant(trial)) {
    const std::optional<double> times = times_as_long(trial);
    if (times) {
      return filled(
          trial.p_family > kDoubt
              ? "It takes away {0} of the squared error on samples that were not fitted, "
                "which may be chance; {1} times as long a recording of such moves would "
                "tell."
              : "It takes away {0} of the squared error on samples that were not fitted, "
                "which chance among so many candidates could do, too; {1} times as long "
                "a recording of such moves would tell.",
          {away, number(*times, 2)});
    }
    const std::string split(trial.effect->description().split);
    return filled(
        split.ends_with('?')
            ? "It takes away {0} of the squared error on samples that were not fitted, "
              "which may be chance, and more of the same would hardly tell. What would: "
              "{1}"
            : "It takes away {0} of the squared error on samples that were not fitted, "
              "which may be chance, and more of the same would hardly tell. What would: "
              "{1}.",
        {away, split});
  }
  if (!trial.own && !beyond_doubt(trial) && !(trial.ratio.high < 1)) {
    return filled(
        "It takes away {0} of the squared error on samples that were not fitted, but "
        "owes that to a few stretches of the recording: without them it may be none. "
        "Record until the same happens again.",
        {away});
  }
  return filled(
      "It takes away {0} of the squared error on samples that were not fitted, too "
      "little for the parameters that it brings.",
      {away});
}

// Of a gain that weighs nothing: slow errors of the free run weigh little from one sample
// to the next.
const char* chance_of(double share) {
  if (share >= kMuch) {
    return "It takes away {0} of the squared error on samples that were not fitted, but "
           "from one sample to the next no more than chance: something else moves as "
           "slowly.";
  }
  return share > 0.001
             ? "It takes away {0} of the squared error on samples that were not fitted, "
               "no more than chance."
             : "It does not lower the error on samples that were not fitted.";
}

// A limit that takes much away was passed, however seldom.
double most_doubt(const Trial& trial, double share) {
  if (share < kMuch) return kDoubt;
  return trial.effect->description().limits ? 1 : kMuchDoubt;
}

}  // namespace

bool beyond_doubt(const Trial& trial) {
  return trial.p_family <= kBeyondDoubt && !has_load(members_of(trial));
}

bool is_excited(const Trial& trial) {
  return is_excited(*trial.effect, trial.excitation,
                    has_load(members_of(trial)) ? 1 : trial.p_family);
}

std::string evidence_of(const Fitter& fitter, const Fit& fit,
                        const std::vector<const Effect*>& members) {
  const Situation here = fitter.situation(fit);
  std::string out;
  for (const Effect* member : members) {
    out += (out.empty() ? "" : " ") +
           member->evidence(here, fit.searched_of(*member), fit.solved_of(*member));
  }
  return out;
}

void conclude_unsupported(const Fitter& fitter, double share, Trial& trial) {
  Candidate& c = trial.candidate;
  if (!trial.visible) {
    c.status = CandidateStatus::kNotExcited;
    c.evidence =
        share_of_u(fitter, *trial.fit) < kMuch
            ? "In this recording u explains hardly more of the output than a constant "
              "would, so that effects between them do not show; change the setpoint a "
              "few times."
            : "In this recording what u explains of the output may be chance, so that "
              "effects between them are not told from others; record longer, or change "
              "the setpoint a few times.";
  } else if (!is_excited(trial) && trial.excitation.events > 0 && share >= kMuch &&
             trial.p_family <= kDoubt) {
    // It shows: that its own values make its events few says that they are not sure.
    trial.too_few = true;
    c.status = CandidateStatus::kUndecided;
    c.spoken_against = true;
    c.evidence = filled(
        "It takes away {0} of the squared error on samples that were not fitted, but "
        "with these values the recording has too few {2} to tell it from chance: {1}.",
        {percent(share), std::to_string(trial.excitation.events),
         std::string(trial.excitation.what)});
  } else if (!is_excited(trial)) {
    c.status = CandidateStatus::kNotExcited;
    c.evidence = filled(
        "It would not show: it takes {2} {1}, and the recording has {0}.",
        {std::to_string(trial.excitation.events), std::string(trial.excitation.what),
         std::to_string(trial.excitation.least)});
  } else if (trial.own && is_significant(trial)) {
    c.status = CandidateStatus::kRejected;
    c.evidence = filled("{0} But hardly any of the error is its doing.",
                        {evidence_of(fitter, *trial.fit, members_of(trial))});
  } else if (share > 0 && trial.p_family <= most_doubt(trial, share)) {
    c.status = CandidateStatus::kUndecided;
    c.evidence = doubt_in_gain(trial, share);
  } else if (trial.effect->description().limits) {
    c.status = CandidateStatus::kNotExcited;
    c.evidence = trial.effect->out_of_reach(fitter.situation(*trial.fit));
    if (c.evidence.empty()) {
      c.evidence =
          "No such limit was reached: wherever one is put within what the recording "
          "covers, the error stays. It may lie beyond.";
    }
  } else {
    c.status = CandidateStatus::kRejected;
    c.evidence = filled(chance_of(share), {percent(share)});
  }
}

}  // namespace workbench
