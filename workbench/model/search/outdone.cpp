#include "workbench/model/search/outdone.hpp"

#include <algorithm>

#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

constexpr double kFarLess = 0.25;  // of the squared error on samples not fitted

bool outdoes(const Trial& other, const Trial& named) {
  const auto left = [](const Trial& trial) {
    return 100 - trial.candidate.error_reduction_percent;
  };
  return other.too_few && other.partner == nullptr && !other.edge &&
         other.objection.empty() && left(other) < kFarLess * left(named) &&
         other.fit->error < named.fit->error;
}

}  // namespace

void leave_outdone_open(std::vector<Trial>& trials) {
  for (Trial& named : trials) {
    if (!accepted(named) || named.partner != nullptr || named.own) continue;
    const auto other = std::ranges::find_if(
        trials, [&](const Trial& trial) { return outdoes(trial, named); });
    if (other == trials.end()) continue;
    leave_in_doubt(
        named,
        filled("{0} would take away {1}, far more, and this recording has too few moves "
               "to tell the two apart: record more of them",
               {std::string(other->effect->code()),
                number(other->candidate.error_reduction_percent, 3) + " %"}));
  }
}

}  // namespace workbench
