#include "workbench/model/tell/reconciled.hpp"

#include <algorithm>

#include "workbench/model/tell/harm.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

using Estimate = ident::Estimate<double>;
using PerStroke = ident::PerStroke<double>;

bool lacks_in_valve(const Candidate* missing) {
  return missing != nullptr &&
         (missing->effect == "valve.stiction" || missing->effect == "valve.backlash");
}

bool gains_from(const Model& model, std::string_view effect) {
  return model.has(effect) && harm_of(model, effect) == nullptr;
}

// Of the stem that the model lacks, or else has; null where neither is.
const Parameter* band_of(const Model& model, const Candidate* missing,
                         std::string_view name) {
  constexpr std::string_view kStem = "valve.stiction";
  if (missing != nullptr && missing->effect == kStem) {
    return find(missing->parameters, name);
  }
  const auto term = std::ranges::find(model.effects, kStem, &EffectTerm::effect);
  return term == model.effects.end() ? nullptr : find(term->parameters, name);
}

// Where no stick band is in the intervals of both.
std::string bands_apart(const PerStroke& seen, const Model& model,
                        const Candidate* missing) {
  const auto apart = [](const Estimate& a, const Parameter* b) {
    return a.known && b != nullptr && (a.low > b->high || a.high < b->low);
  };
  const Parameter* const up = band_of(model, missing, "stick_band_ascending");
  const Parameter* const down = band_of(model, missing, "stick_band_descending");
  const bool of_up = apart(seen.ascending, up);
  if (!of_up && !apart(seen.descending, down)) return {};
  const Estimate& verdict = of_up ? seen.ascending : seen.descending;
  const Parameter& fitted = of_up ? *up : *down;
  return filled(
      "The verdict puts the stick band at {0} to {1} in u, the model at {2} to {3}: what "
      "the model still lacks bends one of them. Small steps of u in manual tell.",
      {number(verdict.low, 3), number(verdict.high, 3), number(fitted.low, 3),
       number(fitted.high, 3)});
}

}  // namespace

bool lacks_stem(ident::Verdict verdict, const Model& model, const Candidate* missing) {
  return is_fault(verdict) && !gains_from(model, "valve.stiction") &&
         !gains_from(model, "valve.backlash") && !lacks_in_valve(missing);
}

std::string reconciled(ident::Verdict verdict, const Model& model,
                       const Candidate* missing) {
  const bool lacks = lacks_in_valve(missing);
  const bool slips = gains_from(model, "valve.stiction");
  const bool plays = gains_from(model, "valve.backlash");
  const bool has = slips || plays;
  const bool lacks_slip = lacks && missing->effect == "valve.stiction";
  const bool found_slip = verdict == ident::Verdict::kStiction;
  const bool agree = found_slip ? slips || (!has && lacks_slip)
                                : plays || (!has && lacks && !lacks_slip);
  switch (verdict) {
    case ident::Verdict::kStiction:
    case ident::Verdict::kBacklash:
      // Which of the two it is: a model may have both.
      if ((has || lacks) && !agree) {
        return "Both find that the stem does not follow every move of u; they differ in "
               "whether it slips as it breaks loose. Move u in small steps in manual and "
               "watch the stem: in play it takes up the way evenly, with stiction it "
               "jumps.";
      }
      if (has || lacks) return {};
      return missing != nullptr
                 ? "The valve is at fault and the model lacks something else first: both "
                   "can be true. Add what is missing and see whether stiction follows."
                 : "The verdict is a sticking valve; this model needs none. Where the "
                   "model follows the recording closely, doubt the verdict; where it "
                   "does not, the verdict has seen more: it also looks from one sample "
                   "to the next, which tells loads from valves. Confirm it in manual "
                   "before work on the valve.";
    case ident::Verdict::kNoStiction:
      if (!has && !lacks) return {};
      return "The model gains from a sticking valve, but from one sample to the next "
             "nothing speaks for one: take it as a description of this recording, not as "
             "a finding about the valve.";
    case ident::Verdict::kUndecided:
    case ident::Verdict::kBadData:
      if (!has && !lacks) return {};
      return "The model gains from a sticking valve, but the verdict asks for more than "
             "that and is not sure: take it as a suspicion, and record what the verdict "
             "asks for.";
  }
  return {};
}

std::string reconciled(const ident::Identification<double>& found, const Model& model,
                       const Candidate* missing) {
  const bool misleads = found.reason == ident::Reason::kSignalsSwapped ||
                        found.reason == ident::Reason::kSeam;
  if (misleads) return std::string(ident::sentence(found.reason));
  std::string said = reconciled(found.verdict, model, missing);
  if (!said.empty() || found.verdict != ident::Verdict::kStiction) return said;
  return bands_apart(found.stick_band, model, missing);
}

}  // namespace workbench
