// The search for a valve with a memory once more, from other cycles.
#include <array>
#include <cstddef>

#include "ident/valve/valve_search.hpp"

namespace ident {
namespace {

// (T9) Squared error over that of a linear valve below which what is left speaks of the
// valve, not of loads.
constexpr double kLeavesLittle = 0.5;
// The parts of the window that are searched begin at these shares of it, where they hold
// so many cycles.
template <class Real>
constexpr std::array kFrom = {Real(0.5), Real(0.25), Real(0.125)};
constexpr double kFewestCycles = 4;

}  // namespace

// Whether a valve with a memory was found that leaves little, and a part is left.
template <class Real>
bool ValveSearch<Real>::may_be_elsewhere() const {
  const ValveModel<Real>& best = best_of_all();
  return elsewhere_ != nullptr &&
         elsewhere_->parts < static_cast<int>(kFrom<Real>.size()) &&
         best.friction.motion != SlipMotion::kSlides &&
         best.fit.error < Real(kLeavesLittle) * this->best(ValveForm::kLinear).fit.error;
}

template <class Real>
void ValveSearch<Real>::take_elsewhere() {
  switch (stage_) {
    case Stage::kLeftExplained:
      if (pass_.structure() < Real(kWhiteResidual)) {
        stage_ = Stage::kDone;
        return;
      }
      return search_elsewhere();
    case Stage::kPartBegun:
      best_[static_cast<int>(ValveForm::kLinear)] = pass_.model();
      return screen(SlipMotion::kStops, Stage::kRememberingScreened);
    case Stage::kElsewherePlaced:
      return polish_tried(Real(ValvePolish<Real>::kNearJumps), Stage::kElsewherePolished);
    default:
      if (elsewhere_->from > 0) {
        return grow_back(polish_.best());
      }
      return best_of_all().fit.error < rival_ ? search_nearby(SlipMotion::kStops) : end();
  }
}

// The window from a sample of y of the whole one on.
template <class Real>
void ValveSearch<Real>::use_from(std::size_t from) {
  SearchWindow<Real> part = window();
  const auto decimation = static_cast<std::size_t>(part.decimation);
  const Real* const y = part.y.data() - elsewhere_->from + from;
  const Real* const u = part.u.data() - elsewhere_->from * decimation + from * decimation;
  const Real* const y_end = part.y.data() + part.y.size();
  const Real* const u_end = part.u.data() + part.u.size();
  part.y = {y, y_end};
  part.u = {u, u_end};
  part.warm_up = from > 0 ? 0 : elsewhere_->warm_up;
  elsewhere_->from = static_cast<std::uint32_t>(from);
  pass_.start(part, x_, scratch_);
}

template <class Real>
void ValveSearch<Real>::search_elsewhere() {
  const Real share = kFrom<Real>[static_cast<std::size_t>(elsewhere_->parts++)];
  const auto from = static_cast<std::size_t>(share * static_cast<Real>(whole()));
  if (static_cast<Real>(whole() - from) < Real(kFewestCycles) * window().period) {
    return end();
  }
  elsewhere_->best = best_;
  elsewhere_->warm_up = static_cast<std::uint32_t>(window().warm_up);
  const ValveModel<Real> linear = best(ValveForm::kLinear);
  best_ = {};
  use_from(from);
  pass_.fit(linear, true);
  begin(Trials::kOne, Stage::kPartBegun);
}

// With what was found there, if it is a valve.
template <class Real>
void ValveSearch<Real>::come_back() {
  const ValveModel<Real> found = best_of_all();
  if (found.friction.motion != SlipMotion::kSlides) {
    return grow_back(found);
  }
  use_from(0);
  best_ = elsewhere_->best;
  end();
}

// The part grows towards the start of the window, and the stem is placed anew each time:
// a stem that is slightly wrong loses step within some cycles.
template <class Real>
void ValveSearch<Real>::grow_back(const ValveModel<Real>& found) {
  const std::size_t from = elsewhere_->from / 2;
  use_from(static_cast<Real>(from) < window().period ? 0 : from);
  best_ = {};
  if (elsewhere_->from == 0) {
    best_ = elsewhere_->best;
    rival_ = best_of_all().fit.error;
  }
  tracked_[0].model = found;
  tracked_[0].start = resting_range(found.friction, window().u[0]).at(Real(0.5));
  place(0, Stage::kElsewherePlaced);
}

#define STICKBAND_INSTANTIATE(Real)                          \
  template bool ValveSearch<Real>::may_be_elsewhere() const; \
  template void ValveSearch<Real>::take_elsewhere();         \
  template void ValveSearch<Real>::come_back();
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)

}  // namespace ident
