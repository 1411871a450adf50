#include "workbench/model/search/verdict_against.hpp"

#include <algorithm>

#include "workbench/model/judge/derived.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

// The stem that a trial adds; null where it adds none.
const Effect* stem_of(const Trial& trial) {
  for (const Effect* effect : {trial.effect, trial.partner}) {
    if (effect != nullptr && effect->description().place == Place::kFriction) {
      return effect;
    }
  }
  return nullptr;
}

// The wider one of both strokes; that of play is its deadband.
double stick_band_of(const Fit& fit, const Effect& stem) {
  double band = 0;
  for (const DerivedValue& derived : derived_of(fit)) {
    if (derived.effect == &stem) band = std::max(band, derived.value);
  }
  return band > 0 ? band : fit.searched_of(stem).front();
}

}  // namespace

std::optional<double> VerdictAgainst::excluded_from() const {
  if (fitter_->output() != Column::y) return std::nullopt;
  const Identification& found = identified_->result(fitter_->work());
  const bool no_fault = found.verdict == ident::Verdict::kNoStiction ||
                        found.verdict == ident::Verdict::kUndecided;
  const bool speaks = ident::nats_of_stems(found.evidence, 0.0) > 0;
  if (!no_fault || speaks || !(found.detectable_band > 0)) return std::nullopt;
  return found.detectable_band;
}

void VerdictAgainst::refute(Trial& trial) const {
  const Effect* stem = stem_of(trial);
  if (stem == nullptr || !accepted(trial)) return;
  const std::optional<double> excluded = excluded_from();
  if (!excluded || !(stick_band_of(*trial.fit, *stem) > *excluded)) return;
  trial.candidate.status = CandidateStatus::kUndecided;
  trial.candidate.evidence = filled(
      "It takes away {0} of the squared error on samples that were not fitted, but from "
      "one sample to the next a stick band above {1} in u would have shown, and did not.",
      {number(trial.candidate.error_reduction_percent, 3) + " %", number(*excluded, 3)});
}

}  // namespace workbench
