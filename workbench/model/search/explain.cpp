#include "workbench/model/search/explain.hpp"

#include <algorithm>

#include "workbench/analysis/uncut_parts.hpp"
#include "workbench/model/judge/fitted_model.hpp"
#include "workbench/model/judge/rivals.hpp"
#include "workbench/model/search/candidates.hpp"
#include "workbench/model/search/choice.hpp"
#include "workbench/model/search/identified.hpp"
#include "workbench/model/search/unsupported.hpp"

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

std::vector<std::string> members_of(const Candidate& candidate) {
  std::vector<std::string> codes = candidate.with;
  codes.insert(codes.begin(), candidate.effect);
  return codes;
}

const Candidate* ExplainResult::best() const {
  const bool any =
      !candidates.empty() && candidates.front().status == CandidateStatus::kAccepted;
  return any ? &candidates.front() : nullptr;
}

const Candidate* ExplainResult::closest() const {
  const Candidate* doubted = nullptr;
  for (const Candidate& c : candidates) {
    // What may stand for an effect of the model would do nothing beside it.
    if (c.status != CandidateStatus::kUndecided || !(c.error_reduction_percent > 0) ||
        !c.indistinguishable_from.empty()) {
      continue;
    }
    if (!c.spoken_against) return &c;
    if (doubted == nullptr) doubted = &c;
  }
  return doubted;
}

Searched searched_in(const Shortened& fewer, const Fitter& quick) {
  return {fewer.recording.size(), fewer.recording.period_s,
          quick.pieces().front().start_s, fewer.is_excerpt};
}

namespace {

// Delays and lags, which differ in how fast y answers and little else.
bool is_of_answer(const Effect& effect) {
  const Place place = effect.description().place;
  return place == Place::kPositioner || place == Place::kRate ||
         place == Place::kProcess || place == Place::kSensor;
}

// What one of several that were found together may as well be; single effects were told
// apart when they were chosen.
void name_rivals_of_members(const Fitter& fitter, const Fit& fit,
                            const Catalogue& catalogue,
                            std::vector<Candidate>& candidates) {
  Candidate& best = candidates.front();
  Catalogue answers = catalogue;
  for (const Effect* effect : catalogue.effects()) {
    if (!is_of_answer(*effect)) answers = answers.without(*effect);
  }
  std::vector<std::string>& named = best.indistinguishable_from;
  for (const std::string& code : members_of(best)) {
    const Effect* member = answers.find(code);
    if (member == nullptr) continue;
    for (std::string& rival : rivals_of(fitter, fit, *member, answers)) {
      if (std::find(named.begin(), named.end(), rival) != named.end()) continue;
      const auto alone = std::ranges::find_if(candidates, [&rival](const Candidate& c) {
        return c.effect == rival && c.with.empty();
      });
      if (alone != candidates.end()) name_back(*alone, *member);
      named.push_back(std::move(rival));
      if (!best.would_split) best.would_split = member->description().split;
    }
  }
}

// What is named gets the intervals that it will have in a model, and its sentence the
// values that are told beside it.
void tell_best(const Fitter& fitter, const Fit& found, const Catalogue& catalogue,
               ExplainResult& result) {
  Candidate& best = result.candidates.front();
  const ToldFit told = told_of(fitter, found);
  Model model = model_of(fitter, told);
  std::vector<const Effect*> members;
  for (const std::string& code : members_of(best)) {
    members.push_back(catalogue.find(code));
    EffectTerm term = *std::ranges::find(model.effects, code, &EffectTerm::effect);
    if (code != best.effect) {
      best.partners.push_back(std::move(term));
    } else {
      best.parameters = std::move(term.parameters);
      best.untold = term.untold;
    }
  }
  if (told.fit.p != found.p) best.evidence = evidence_of(fitter, told.fit, members);
  const Situation here = fitter.situation(told.fit);
  best.harmless = true;
  for (const Effect* member : members) {
    best.cures.push_back(member->cure(here, told.fit.searched_of(*member)));
    best.harmless = best.harmless && member->description().harmless &&
                    best.cures.back() == member->description().cure;
  }
  result.with_best_quality = quality(fitter, told.fit);
  result.with_best = std::move(model);
}

// There is no answer without the model itself, however short the time.
template <class Make>
Fit whatever_it_takes(const Work& work, Make make) {
  const Work::WritingDown writing(work);
  return make();
}

}  // namespace

ExplainResult explain(const Recording& recording, const Model& model,
                      const ExplainProgress& progress, const Catalogue& known,
                      const Work& work, Identified* identified) {
  const Catalogue all = known.with(recording.loads);
  const Catalogue catalogue = judged_by(recording, all, {});
  const Fitter fitter(recording, model.output, work);
  std::optional<Identified> own;
  if (identified == nullptr) identified = &own.emplace(uncut_parts(recording));
  const auto concluded = [&](const Fitter& by, const Fit& base) {
    Exploration found = explore(by, base, catalogue, *identified, progress);
    if (found.best) {
      Candidate& best = found.result.candidates.front();
      if (!best.with.empty() && !work.out_of_time()) {
        try {
          name_rivals_of_members(by, *found.best, catalogue, found.result.candidates);
        } catch (const OutOfTime&) {  // it may have more than are named
        }
      }
      const Work::WritingDown writing(work);
      tell_best(by, *found.best, catalogue, found.result);
    }
    leave_open(recording, all, catalogue, model.effect_codes(), found.result);
    return std::move(found.result);
  };
  if (!is_long(recording)) {
    return concluded(fitter, whatever_it_takes(work, [&] {
                       return fitter.refine(fitter.apply(model, all));
                     }));
  }
  const Shortened fewer = shortened(recording, model.output);
  const Fitter quick(fewer.recording, model.output, work);
  ExplainResult out =
      concluded(quick, whatever_it_takes(work, [&] {
                  return quick.on_the_short(fitter.apply(model, all), fewer);
                }));
  out.searched = searched_in(fewer, quick);
  return out;
}

}  // namespace workbench
