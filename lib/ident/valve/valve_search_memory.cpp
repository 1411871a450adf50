// The part of the search for a valve that remembers where it stopped or slipped.
#include <algorithm>
#include <cmath>

#include "ident/base/sort_few.hpp"
#include "ident/valve/valve_search.hpp"

namespace ident {
namespace {

// A beam of candidates is polished on the first cycles, then on more and more of them.
constexpr double kGrowth = 1.6;
constexpr int kPlaces = 48;  // stem positions tried for a tracked valve

}  // namespace

template <class Real>
bool ValveSearch<Real>::alike(const ValveModel<Real>& a,
                              const ValveModel<Real>& b) const {
  const Real width = Real(0.04) * window().swing;
  const auto near = [&](Real one, Real other) { return std::abs(one - other) < width; };
  return a.friction.motion == b.friction.motion &&
         near(a.friction.stick_ascending(), b.friction.stick_ascending()) &&
         near(a.friction.stick_descending(), b.friction.stick_descending()) &&
         near(a.friction.deadband, b.friction.deadband);
}

// The best unlike candidates of each time constant: a slow process forgives a wrong
// valve, so it must not crowd out the others before they are polished.
template <class Real>
void ValveSearch<Real>::keep_in_beam(int time_constant, const ValveModel<Real>& model) {
  ValveModel<Real>* const slots = &beam_[kPerTimeConstant * time_constant];
  ValveModel<Real> carried = model;
  for (int k = 0; k < kPerTimeConstant; ++k) {
    if (!slots[k].known) {
      slots[k] = carried;
      return;
    }
    const bool same = alike(slots[k], carried);
    if (carried.fit.error < slots[k].fit.error) {
      std::swap(slots[k], carried);
    }
    if (same) {
      return;
    }
  }
}

template <class Real>
void ValveSearch<Real>::sort_beam() {
  sort_few(beam_.begin(), beam_.end(), [](const auto& a, const auto& b) {
    return a.known && (!b.known || a.fit.error < b.fit.error);
  });
}

// Sorts the beam and keeps the best unlike members, at most `most`.
template <class Real>
void ValveSearch<Real>::prune_beam(int most) {
  sort_beam();
  beam_size_ = 0;
  // The tracker will tell whether an integrating process is the better one.
  const int reserved = most / kIntegratingShare;
  int integrating = 0;
  for (int k = 0; k < kBeam && beam_[k].known && beam_size_ < most; ++k) {
    const bool integrates = !(beam_[k].poles.slow < Real(1));
    if (!integrates && most - beam_size_ <= reserved - integrating) {
      continue;
    }
    bool fresh = true;
    for (int other = 0; other < beam_size_; ++other) {
      fresh = fresh && !(alike(beam_[other], beam_[k]) &&
                         std::abs(beam_[other].start - beam_[k].start) <
                             Real(0.04) * window().swing);
    }
    if (fresh) {
      beam_[beam_size_++] = beam_[k];
      integrating += integrates ? 1 : 0;
    }
  }
  for (int k = beam_size_; k < kBeam; ++k) {
    beam_[k].known = false;
  }
}

template <class Real>
Real ValveSearch<Real>::jumps() const {
  return Real(kSlipTracker && placed_ < 0 ? ValvePolish<Real>::kNearJumps
                                          : ValvePolish<Real>::kFarJumps);
}

// The beam's next member on the present cycles, or all of them on more cycles.
template <class Real>
void ValveSearch<Real>::grow_next() {
  if (!polish_once()) {
    return;
  }
  beam_[index_] = polish_.best();
  if (++index_ < beam_size_) {
    begin_polish(ValveForm::kMixed, beam_[index_], jumps());
    return;
  }
  if (motion_ == SlipMotion::kStops) {
    stage_ = Stage::kCompare;
    return;
  }
  start_growth_stage();
}

// Whether the valves that stop do better on the first cycles than the best sliding valve,
// which was fitted to all of them: then the best of them wait for those that restick.
template <class Real>
void ValveSearch<Real>::compare_beam() {
  if (!answered()) {
    pass_.fit(best_of_all(), true);
    asked_ = true;
    return;
  }
  const Real error = pass_.model().fit.error;
  const bool promising = std::any_of(
      beam_.begin(), beam_.begin() + beam_size_,
      [&](const auto& member) { return member.fit.error < Real(kPromising) * error; });
  stopping_ = 0;
  if (promising) {
    prune_beam(kStopping);
    for (; stopping_ < beam_size_; ++stopping_) {
      tracked_[stopping_].model = beam_[stopping_];
    }
  }
  start_motion(SlipMotion::kResticks);
}

// The valves that stop join those that restick.
template <class Real>
void ValveSearch<Real>::join_stopping() {
  prune_beam(kGrown - stopping_);
  for (int k = 0; k < stopping_; ++k) {
    beam_[beam_size_++] = tracked_[k].model;
  }
  stopping_ = 0;
  sort_beam();
}

template <class Real>
void ValveSearch<Real>::start_growth_stage() {
  index_ = 0;
  if (!sifted_) {
    join_stopping();
  }
  if (pass_.used() == whole()) {
    prune_beam(kGrown);
    if (kSlipTracker && placed_ > 0) {
      stage_ = Stage::kPlace;
      round_ = 0;
      return;
    }
    stage_ = Stage::kPolish;
    next_polish();
    return;
  }
  if constexpr (kSlipTracker) {
    if (!sifted_) {
      start_tracking();
      return;
    }
    prune_beam(kBeam);
  } else {
    sifted_ = true;
    prune_beam(kPolished);
  }
  pass_.use(std::min(whole(), static_cast<std::size_t>(static_cast<Real>(pass_.used()) *
                                                       Real(kGrowth))));
  begin_polish(ValveForm::kMixed, beam_[0]);
}

// Where the stem of a tracked valve stood: the best of the places that its band allows.
// One of them; true after the last.
template <class Real>
bool ValveSearch<Real>::place(int tracked, ValveModel<Real>& kept) {
  if (answered()) {
    if (round_ == 0 || pass_.model().fit.error < kept.fit.error) {
      kept = pass_.model();
    }
    if (++round_ == kPlaces) {
      return true;
    }
  }
  ValveModel<Real> model = tracked_[tracked].model;
  const Real share = (static_cast<Real>(round_) + Real(0.5)) / Real(kPlaces);
  model.start = round_ == 0 ? tracked_[tracked].start
                            : resting_range(model.friction, window().u[0]).at(share);
  model.start_known = true;
  pass_.fit(model, true);
  asked_ = true;
  return false;
}

// A valve that slips at the same times as the best one but moves otherwise has narrower
// bands and starts elsewhere. True after the last.
template <class Real>
bool ValveSearch<Real>::vary_nearby() {
  constexpr int kBands = 12;
  constexpr Real kNarrowest = Real(0.7);
  constexpr Real kNarrower = Real(0.03);
  constexpr int kStarts = 10;
  if (answered()) {
    if (round_ == 0 || pass_.model().fit.error < tried_.fit.error) {
      tried_ = pass_.model();
    }
    if (++round_ == kBands * kStarts) {
      return true;
    }
  }
  const int band = round_ / kStarts;
  ValveModel<Real> model = tracked_[0].model;
  ValveFriction<Real>& friction = model.friction;
  const Real share = kNarrowest + kNarrower * static_cast<Real>(band);
  friction.slip_ascending = std::max(
      friction.slip_ascending - (Real(1) - share) * friction.stick_ascending(), Real(0));
  friction.slip_descending =
      std::max(friction.slip_descending - (Real(1) - share) * friction.stick_descending(),
               Real(0));
  const int start = round_ % kStarts;
  model.start = start == 0
                    ? tracked_[0].start
                    : resting_range(friction, window().u[0])
                          .at((static_cast<Real>(start) - Real(0.5)) / Real(kStarts - 1));
  model.start_known = true;
  pass_.fit(model, false);
  asked_ = true;
  return false;
}

// A valve that was tracked at length runs free, on the whole window; if it explains
// everything, only what is near the best valve so far is still tried.
template <class Real>
void ValveSearch<Real>::try_next() {
  if (placing_) {
    if (tries_nearby() ? vary_nearby() : place(index_, tried_)) {
      placing_ = false;
      begin_polish(ValveForm::kMixed, tried_,
                   Real(tries_nearby() ? ValvePolish<Real>::kFarJumps
                                       : ValvePolish<Real>::kNearJumps));
    }
    return;
  }
  if constexpr (kSlipTracker) {
    if (answered()) {
      take_tried();
      return;
    }
  }
  if (!take_polished()) {
    return;
  }
  if (!tries_nearby()) {
    pass_.explain(polish_.best());
    asked_ = true;
    return;
  }
  beam_[0] = polish_.best();
  stage_ = Stage::kPolish;
  index_ = kPolished;
  next_polish();
}

// Valves with a memory: the mixed valve from the beam, then the simpler forms from it.
template <class Real>
bool ValveSearch<Real>::memory_job(int job, ValveForm& form,
                                   ValveModel<Real>& from) const {
  if (job < kPolished) {
    form = ValveForm::kMixed;
    from = beam_[job];
    return true;
  }
  from = best(ValveForm::kMixed);
  if (nearby_ ? from.friction.motion != motion_
              : from.friction.motion == SlipMotion::kSlides) {
    from = beam_[0];
  }
  return simpler_job(job - kPolished, form, from.friction);
}

// The next polish. Where one stroke is set free of its deadband, the stem rests elsewhere
// after each stroke: its place is looked for first, or every trial loses step.
template <class Real>
void ValveSearch<Real>::begin_job(ValveForm form, const ValveModel<Real>& from) {
  const bool one_sided = form == ValveForm::kAscending || form == ValveForm::kDescending;
  if (!one_sided || !from.start_known) {
    begin_polish(form, from, jumps_);
    return;
  }
  form_ = form;
  tracked_[0].model = from;
  tracked_[0].start = from.start;
  round_ = 0;
  placing_ = true;
}

template <class Real>
void ValveSearch<Real>::place_one_sided() {
  if (place(0, tried_)) {
    placing_ = false;
    begin_polish(form_, tried_, Real(ValvePolish<Real>::kGrownJumps));
  }
}

#define STICKBAND_INSTANTIATE(Real)                                               \
  template Real ValveSearch<Real>::jumps() const;                                 \
  template bool ValveSearch<Real>::alike(const ValveModel<Real>&,                 \
                                         const ValveModel<Real>&) const;          \
  template void ValveSearch<Real>::keep_in_beam(int, const ValveModel<Real>&);    \
  template void ValveSearch<Real>::sort_beam();                                   \
  template void ValveSearch<Real>::prune_beam(int);                               \
  template void ValveSearch<Real>::grow_next();                                   \
  template void ValveSearch<Real>::compare_beam();                                \
  template void ValveSearch<Real>::join_stopping();                               \
  template void ValveSearch<Real>::start_growth_stage();                          \
  template bool ValveSearch<Real>::place(int, ValveModel<Real>&);                 \
  template bool ValveSearch<Real>::vary_nearby();                                 \
  template void ValveSearch<Real>::try_next();                                    \
  template void ValveSearch<Real>::begin_job(ValveForm, const ValveModel<Real>&); \
  template void ValveSearch<Real>::place_one_sided();                             \
  template bool ValveSearch<Real>::memory_job(int, ValveForm&, ValveModel<Real>&) const;
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)
#undef STICKBAND_INSTANTIATE

}  // namespace ident
