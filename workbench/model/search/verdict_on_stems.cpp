#include "workbench/model/search/verdict_on_stems.hpp"

#include <algorithm>
#include <cmath>

#include "workbench/analysis/uncut_parts.hpp"
#include "workbench/model/judge/derived.hpp"
#include "workbench/model/judge/fitted_model.hpp"
#include "workbench/model/judge/intervals.hpp"
#include "workbench/model/judge/merit.hpp"
#include "workbench/model/judge/off_profile.hpp"
#include "workbench/model/search/choice.hpp"
#include "workbench/model/search/known_first.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

// The stem that a trial adds; null where it adds none.
const Effect* stem_of(const Trial& trial) {
  for (const Effect* effect : members_of(trial)) {
    if (effect->description().is_stem()) return effect;
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

bool is_as_wide(double band, const Identification& found) {
  constexpr double kAlike = 2;
  const double ratio = band / found.stick_band.larger();
  return ratio > 1 / kAlike && ratio < kAlike;
}

// Less of the error, if not beyond chance, by what could be this stem.
bool may_be(const Trial& trial) {
  return trial.partner == nullptr && trial.fit && !trial.edge && trial.visible &&
         trial.objection.empty() && trial.candidate.error_reduction_percent > 0;
}

// It finds no fault, and nothing one sample ahead for a stem of its own.
bool says_nothing_for_stems(const Identification& found) {
  const bool no_fault = found.verdict == ident::Verdict::kNoStiction ||
                        found.verdict == ident::Verdict::kUndecided;
  return no_fault && ident::nats_of_stems(found.evidence, 0.0) <= 0;
}

// The smallest stick band that would have shown and did not; nothing where none is known.
std::optional<double> excluded_by(const Identification& found) {
  if (!says_nothing_for_stems(found) || !(found.detectable_band > 0)) return std::nullopt;
  return found.detectable_band;
}

// The band of the closest stem running free is not known to be none, but that stem does
// not foretell y.
bool is_unconfirmed(const Identification& found) {
  return found.verdict == ident::Verdict::kUndecided && says_nothing_for_stems(found) &&
         found.evidence.stem_weighed;
}

// What follows the setpoint explains the movement, and beside a process with dead time
// and lags no stem is closer.
bool is_unneeded(const Identification& found) {
  return found.reason == ident::Reason::kSetpointMoves && says_nothing_for_stems(found) &&
         found.evidence.form == ident::ValveForm::kLinear;
}

// A valve that is slow, or stops at an end, foretells y better than any that sticks.
bool is_outweighed(const Identification& found) {
  return found.reason == ident::Reason::kStemBounded;
}

// Why a stem is none: to be filled with what it takes away and the band that would have
// shown.
struct Objection {
  const char* words = nullptr;  // none: the identification does not say so
  bool is_known = false;        // that it is none, and not only that none was found
};

Objection objection_to(double band, const Identification& found) {
  const std::optional<double> excluded = excluded_by(found);
  if (excluded && band > *excluded) {
    return {
        "It takes away {0} of the squared error on samples that were not fitted, but "
        "from one sample to the next a stick band above {1} in u would have shown, "
        "and did not.",
        true};
  }
  if (is_outweighed(found)) {
    return {
        "It takes away {0} of the squared error on samples that were not fitted, but "
        "from one sample to the next a valve that moves slowly, or stops at an end, "
        "foretells the output better.",
        true};
  }
  if (is_unconfirmed(found)) {
    return {
        "It takes away {0} of the squared error on samples that were not fitted, but "
        "such a stem does not foretell the output from one sample to the next: a "
        "load, or a process of another shape, may look like a valve here."};
  }
  if (is_unneeded(found)) {
    return {
        "It takes away {0} of the squared error on samples that were not fitted, but "
        "beside a process with a dead time and two lags no sticking valve is closer "
        "to the output."};
  }
  return {};
}

bool slips(const Identification& found) {
  return found.verdict == ident::Verdict::kStiction &&
         (found.slip_jump.ascending.low > 0 || found.slip_jump.descending.low > 0);
}

}  // namespace

std::optional<double> VerdictOnStems::excluded_from() const {
  if (fitter_->output() != Column::y) return std::nullopt;
  return excluded_by(identified_->result(fitter_->work()));
}

// What the output would be without the loads of the model: what is known to move it hides
// no stem.
Identification VerdictOnStems::less_loads(const Fit& fit) const {
  Recording quiet = fitter_->recording();
  for (const Effect* effect : fit.effects) {
    if (effect->description().is_load()) fitter_->add_loads(fit, -1, quiet.y, effect);
  }
  Identified without(uncut_parts(quiet));
  return without.result(fitter_->work());
}

void VerdictOnStems::refute(Trial& trial) const {
  const Effect* stem = stem_of(trial);
  if (stem == nullptr || !accepted(trial) || fitter_->output() != Column::y) return;
  if (trial.p_ahead <= kBeyondDoubt) return;
  const double band = stick_band_of(*trial.fit, *stem);
  Identification found = identified_->result(fitter_->work());
  Objection objection = objection_to(band, found);
  if (objection.words == nullptr) return;
  if (has_load(trial.fit->effects)) {
    found = less_loads(*trial.fit);
    objection = objection_to(band, found);
    if (objection.words == nullptr) return;
  }
  const std::optional<double> excluded = excluded_by(found);
  trial.unconfirmed = !objection.is_known;
  trial.candidate.status = CandidateStatus::kUndecided;
  trial.candidate.spoken_against = true;
  trial.candidate.evidence =
      filled(objection.words, {number(trial.candidate.error_reduction_percent, 3) + " %",
                               excluded ? number(*excluded, 3) : ""});
}

void VerdictOnStems::confirm(std::vector<Trial>& trials) const {
  Trial* stem = nullptr;
  if (fitter_->output() != Column::y) return;
  for (Trial& trial : trials) {
    if (stem_of(trial) == nullptr) continue;
    if (accepted(trial)) return;
    if (may_be(trial) && (stem == nullptr || fits_better(&trial, stem))) stem = &trial;
  }
  if (stem == nullptr) return;
  const Identification& found = identified_->result(fitter_->work());
  const double nats = ident::nats_of_stems(found.evidence, 0.0);
  const bool fault = is_fault(found.verdict);
  if (!fault || !(nats >= ident::kAloneNats)) return;
  if (!is_as_wide(stick_band_of(*stem->fit, *stem->effect), found)) return;
  const FitIntervals intervals = intervals_of(*fitter_, *stem->fit);
  if (!excludes_off(*fitter_, *stem->fit, intervals, *stem->effect)) return;
  Candidate& c = stem->candidate;
  c.status = CandidateStatus::kAccepted;
  c.spoken_against = false;
  c.parameters = parameters_of(*stem->fit, intervals, stem->effect);
  stem->test.p_value = std::min(stem->test.p_value, std::exp(-nats));
  stem->p_family = std::min(stem->p_family, stem->test.p_value);
  c.p_value = stem->test.p_value;
  c.evidence = filled(
      "Running free it takes away {0} of the squared error on samples that were not "
      "fitted, which alone could be chance; from one sample to the next, where loads do "
      "not hide it, a sticking stem as wide stands beyond doubt.",
      {number(c.error_reduction_percent, 3) + " %"});
}

void VerdictOnStems::mark(std::vector<Trial>& trials) const {
  if (fitter_->output() != Column::y || std::ranges::none_of(trials, is_lone_load_step)) {
    return;
  }
  for (Trial& trial : trials) {
    const bool alone = trial.partner == nullptr && stem_of(trial) != nullptr;
    if (!alone || !accepted(trial)) continue;
    const Identification& found = identified_->result(fitter_->work());
    trial.identified = is_fault(found.verdict) &&
                       is_as_wide(stick_band_of(*trial.fit, *trial.effect), found);
  }
}

void VerdictOnStems::name_slip(std::vector<Trial>& trials, Trial& best) const {
  const Effect* const play = stem_of(best);
  if (play == nullptr || play->description().sticks || fitter_->output() != Column::y) {
    return;
  }
  const Identification& found = identified_->result(fitter_->work());
  if (!slips(found) || !is_as_wide(stick_band_of(*best.fit, *play), found)) return;
  for (Trial& trial : trials) {
    if (trial.partner == nullptr && trial.effect->description().sticks) {
      name_beside(trial, best);
    }
  }
}

}  // namespace workbench
