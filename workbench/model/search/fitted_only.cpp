#include "workbench/model/search/fitted_only.hpp"

#include <algorithm>

#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

bool is_open(const Trial& trial) {
  constexpr double kNothing = 1;  // %
  return trial.partner == nullptr && trial.fit && trial.visible && !trial.edge &&
         trial.objection.empty() && trial.candidate.error_reduction_percent < kNothing &&
         trial.candidate.status == CandidateStatus::kRejected;
}

}  // namespace

void leave_fitted_only_open(const Fitter& fitter, const Fit& base,
                            std::vector<Trial>& trials) {
  constexpr double kHalf = 0.5;
  constexpr double kAgainst = 1.05;  // of the error on samples that were not fitted
  const auto helps = [](const Trial& trial) {
    return trial.candidate.status == CandidateStatus::kAccepted ||
           trial.candidate.status == CandidateStatus::kUndecided;
  };
  if (std::ranges::any_of(trials, helps)) return;
  Trial* most = nullptr;
  for (Trial& trial : trials) {
    if (is_open(trial) && (most == nullptr || fits_better(&trial, most))) most = &trial;
  }
  if (most == nullptr || !(most->fit->error < kHalf * base.error) ||
      fitter.rmse_on(*most->fit, false) > kAgainst * fitter.rmse_on(base, false)) {
    return;
  }
  most->candidate.status = CandidateStatus::kUndecided;
  most->candidate.evidence = filled(
      "It takes away {0} of the squared error on the samples that were fitted, and "
      "nothing on the others, which hardly show it: another recording of the loop would "
      "judge, --validate.",
      {number(100 * (1 - most->fit->error / base.error), 3) + " %"});
}

}  // namespace workbench
