// The part of the search for a valve that remembers where it stopped or slipped.
#include <algorithm>
#include <cmath>

#include "ident/base/sort_few.hpp"
#include "ident/valve/valve_search.hpp"

namespace ident {
namespace {

// A beam of candidates is polished on the first cycles, then on more and more of them.
constexpr double kGrowth = 1.6;

}  // namespace

// From the first cycles to the whole window.
template <class Real>
void ValveSearch<Real>::remember() {
  constexpr Real kFar = Real(ValvePolish<Real>::kFarJumps);
  switch (stage_) {
    case Stage::kRememberingScreened:
      prune_beam(kBeam);
      return polish_all(Trials::kBeam, 0, kFar,
                        motion_ == SlipMotion::kStops ? Stage::kStopsPolished
                                                      : Stage::kResticksPolished);
    case Stage::kStopsPolished:
      pass_.fit(best_of_all(), true);
      return begin(Trials::kOne, Stage::kCompared);
    case Stage::kCompared:
      keep_stopping();
      return screen(SlipMotion::kResticks, Stage::kRememberingScreened);
    case Stage::kResticksPolished:
      join_stopping();
      if constexpr (kSlipTracker) {
        placed_ = 0;
        if (pass_.used() < whole()) {
          first_used_ = pass_.used();
          index_ = 0;
          return sift();
        }
      }
      [[fallthrough]];
    case Stage::kGrown:
      if (pass_.used() < whole()) {
        see_more_cycles();
        return polish_all(Trials::kBeam, 0, kFar, Stage::kGrown);
      }
      prune_beam(kGrown);
      return kSlipTracker && placed_ > 0
                 ? place(0, Stage::kPlaced)
                 : polish_all(Trials::kJobs, 0, Real(ValvePolish<Real>::kGrownJumps),
                              Stage::kRemembered);
    default:
      if constexpr (kSlipTracker) {
        track();
      }
  }
}

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
  sort_few(beam_.begin(), beam_.end(),
           [](const auto& a, const auto& b) { return better(a, b); });
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
void ValveSearch<Real>::see_more_cycles() {
  prune_beam(kSlipTracker ? kBeam : kPolished);
  pass_.use(std::min(whole(), static_cast<std::size_t>(static_cast<Real>(pass_.used()) *
                                                       Real(kGrowth))));
}

// Whether the valves that stop do better on the first cycles than the best sliding valve,
// which was fitted to all of them: then the best of them wait for those that restick.
template <class Real>
void ValveSearch<Real>::keep_stopping() {
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
}

// The valves that stop join those that restick.
template <class Real>
void ValveSearch<Real>::join_stopping() {
  prune_beam(kGrown - stopping_);
  for (int k = 0; k < stopping_; ++k) {
    beam_[beam_size_++] = tracked_[k].model;
  }
  sort_beam();
}

#define STICKBAND_INSTANTIATE(Real)                                            \
  template void ValveSearch<Real>::remember();                                 \
  template bool ValveSearch<Real>::alike(const ValveModel<Real>&,              \
                                         const ValveModel<Real>&) const;       \
  template void ValveSearch<Real>::keep_in_beam(int, const ValveModel<Real>&); \
  template void ValveSearch<Real>::prune_beam(int);
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)

}  // namespace ident
