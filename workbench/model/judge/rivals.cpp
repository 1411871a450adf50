#include "workbench/model/judge/rivals.hpp"

#include <limits>

#include "workbench/effects/effects.hpp"
#include "workbench/model/judge/merit.hpp"

namespace workbench {
namespace {

// True where `play` is not told from `stuck`, searched from this deadband with its jumps
// held.
bool slips_unseen(const Fitter& fitter, Fit stuck, double deadband, double jump,
                  const Fit& play) {
  const Effect& stiction = effects::valve_stiction();
  std::vector<FreeRun::Held> held;
  for (std::size_t i = 0; i < stuck.p.size(); ++i) {
    const FreeRun::Slot& slot = stuck.slots[i];
    if (slot.effect != &stiction) continue;
    const std::string name(slot.parameter.name);
    if (name == "deadband") stuck.p[i] = deadband;
    if (!name.starts_with("slip_jump")) continue;
    stuck.p[i] = jump;
    held.push_back({&stiction, name, jump});
  }
  const Fit slipping = fitter.refine(stuck, held);
  // Under a load that is all but foretold, one sample ahead tells nothing but how exactly
  // the moment of a slip is met.
  const bool closer = slipping.error <= play.error &&
                      fitter.rmse_on(slipping, false) <= fitter.rmse_on(play, false);
  return closer || as_good(fitter, slipping, play);
}

bool may_slip(const Fitter& fitter, const Fit& fit, const Fit& rest, const Effect& effect,
              const Effect& other) {
  if (!lacks_slip(effect, other)) return false;
  const std::optional<Fit> stuck = fitter.extend(rest, other, Effort::kScreen);
  return stuck && leaves_slip_open(fitter, fit, *stuck);
}

}  // namespace

bool lacks_slip(const Effect& effect, const Effect& other) {
  return &effect == &effects::valve_backlash() && &other == &effects::valve_stiction();
}

bool leaves_slip_open(const Fitter& fitter, const Fit& play, const Fit& stuck) {
  constexpr double kSlip = 0.5;  // of the deadband; measured slip jumps are of that order
  const double deadband = play.searched_of(effects::valve_backlash()).front();
  const double jump = kSlip * deadband;
  // What play calls its deadband may be that of the stem, or its stick band.
  return slips_unseen(fitter, stuck, deadband, jump, play) ||
         slips_unseen(fitter, stuck, deadband - jump, jump, play);
}

std::optional<Fit> replaced(const Fitter& fitter, const Fit& fit, const Fit& rest,
                            const Effect& other) {
  constexpr double kNearby = 1.2;  // of the error, to be searched to the end
  if (contains(fit.effects, other)) return std::nullopt;
  constexpr double kAny = std::numeric_limits<double>::infinity();
  ScreenedStarts seen;
  std::optional<Fit> next = fitter.extend(rest, other, Effort::kScreen, kAny, &seen);
  if (!next || next->error > kNearby * fit.error) return std::nullopt;
  if (!as_good(fitter, *next, fit)) {
    next = fitter.extend(rest, other, Effort::kThorough, kAny, &seen);
    if (!next || !as_good(fitter, *next, fit)) return std::nullopt;
  }
  const NoiseColour colour = colour_of(fit.residual);
  if (score_of(*next, colour) > score_of(fit, colour) + kTooRich) return std::nullopt;
  if (!is_possible(fitter, *next, other)) return std::nullopt;
  return next;
}

std::vector<std::string> rivals_of(const Fitter& fitter, const Fit& fit,
                                   const Effect& effect, const Catalogue& catalogue) {
  std::vector<std::string> out;
  const Fit rest = fitter.without(fit, effect);
  const auto others = catalogue.effects();
  std::vector<unsigned char> is_rival(others.size(), 0);
  // Levels and repeats are in the readings themselves, whatever else moves y.
  const bool is_fact = effect.description().place == Place::kRecord;
  fitter.work().for_each(others.size(), [&](std::size_t i) {
    if (is_fact && others[i]->description().place != Place::kRecord) return;
    is_rival[i] = replaced(fitter, fit, rest, *others[i]).has_value() ||
                  may_slip(fitter, fit, rest, effect, *others[i]);
  });
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (is_rival[i]) out.emplace_back(others[i]->code());
  }
  return out;
}

std::optional<Fit> simplified(const Fitter& fitter, const Fit& fit, const Effect& effect,
                              const Catalogue& catalogue) {
  if (effect.description().place != Place::kFriction) return std::nullopt;
  const Situation here = fitter.situation(fit);
  const Fit rest = fitter.without(fit, effect);
  for (const Effect* other : catalogue.effects()) {
    const bool simpler = other->description().place == Place::kFriction &&
                         other->searched(here).size() < effect.searched(here).size();
    if (!simpler) continue;
    if (auto next = replaced(fitter, fit, rest, *other)) return next;
  }
  return std::nullopt;
}

}  // namespace workbench
