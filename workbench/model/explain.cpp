#include "workbench/model/explain.hpp"

#include "workbench/model/candidates.hpp"
#include "workbench/model/thinned.hpp"

namespace workbench {

std::string_view name_of(CandidateStatus status) {
  switch (status) {
    case CandidateStatus::kAccepted:
      return "accepted";
    case CandidateStatus::kRejected:
      return "rejected";
    case CandidateStatus::kNotExcited:
      return "not_excited";
    case CandidateStatus::kUndecided:
      return "undecided";
  }
  return "undecided";
}

const Candidate* ExplainResult::best() const {
  const bool any =
      !candidates.empty() && candidates.front().status == CandidateStatus::kAccepted;
  return any ? &candidates.front() : nullptr;
}

ExplainResult explain(const Recording& recording, const Model& model,
                      const ExplainProgress& progress, const Catalogue& known,
                      const Work& work) {
  const Catalogue catalogue = known.with(recording.loads);
  const Fitter fitter(recording, model.output, work);
  const std::size_t thinning = thinning_of(recording.size(), fitter.memory_samples());
  if (thinning == 1) {
    const Fit base = fitter.refine(fitter.apply(model, catalogue));
    return explore(fitter, base, catalogue, progress).result;
  }
  const Recording fewer = thinned(recording, thinning);
  const Fitter quick(fewer, model.output, work);
  const Fit base = quick.taken_over(fitter.apply(model, catalogue));
  return explore(quick, base, catalogue, progress).result;
}

}  // namespace workbench
