#include "workbench/model/explain.hpp"

#include "workbench/model/candidates.hpp"

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
                      const ExplainProgress& progress, const Catalogue& catalogue,
                      const Work& work) {
  const Fitter fitter(recording, model.output, work);
  const Fit base = fitter.refine(fitter.apply(model, catalogue));
  return explore(fitter, base, catalogue, progress).result;
}

}  // namespace workbench
