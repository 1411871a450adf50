#include "workbench/model/tell/reconciled.hpp"

#include "workbench/model/tell/harm.hpp"

namespace workbench {
namespace {

bool lacks_in_valve(const Candidate* missing) {
  return missing != nullptr &&
         (missing->effect == "valve.stiction" || missing->effect == "valve.backlash");
}

bool gains_from(const Model& model, std::string_view effect) {
  return model.has(effect) && harm_of(model, effect) == nullptr;
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
                 : "The verdict names the valve, and the model has none that sticks: "
                   "that "
                   "speaks against it where the model follows the recording closely, and "
                   "says nothing where it does not. The verdict also asks from one "
                   "sample "
                   "to the next, which tells loads from valves; confirm it in manual "
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
  return misleads ? std::string(ident::sentence(found.reason))
                  : reconciled(found.verdict, model, missing);
}

}  // namespace workbench
