#include "workbench/model/search/unsupported.hpp"

#include <string>

#include "workbench/model/judge/merit.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

constexpr double kDoubt = 0.05;     // above it a candidate is rejected
constexpr double kMuch = 0.1;       // of the squared validation error …
constexpr double kMuchDoubt = 0.3;  // … which is no chance below this

// Why a gain that is hardly chance by its p-value is not enough.
const char* doubt_in_gain(const Trial& trial) {
  if (trial.p_family > kDoubt) {
    return "It takes away {0} of the squared error on samples that were not fitted, but "
           "this recording is too short to tell that from chance.";
  }
  if (!is_significant(trial)) {
    return "It takes away {0} of the squared error on samples that were not fitted, "
           "which chance among so many candidates could do, too.";
  }
  if (!trial.own && !beyond_doubt(trial) && !(trial.ratio.high < 1)) {
    return "It takes away {0} of the squared error on samples that were not fitted, but "
           "owes that to a few stretches of the recording: without them it may be none.";
  }
  return "It takes away {0} of the squared error on samples that were not fitted, too "
         "little for the parameters that it brings.";
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

std::string evidence_of(const Fitter& fitter, const Trial& trial) {
  const Situation here = fitter.situation(*trial.fit);
  std::string out;
  for (const Effect* member : members_of(trial)) {
    out +=
        (out.empty() ? "" : " ") + member->evidence(here, trial.fit->searched_of(*member),
                                                    trial.fit->solved_of(*member));
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
                        {evidence_of(fitter, trial)});
  } else if (share > 0 && trial.p_family <= most_doubt(trial, share)) {
    c.status = CandidateStatus::kUndecided;
    c.evidence = filled(doubt_in_gain(trial), {percent(share)});
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
