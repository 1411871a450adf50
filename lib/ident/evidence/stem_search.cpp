#include "ident/evidence/stem_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ident/valve/valve_grid.hpp"

namespace ident {
namespace {

constexpr double kFirstStep = 0.04;  // of the polish, as a share of the swing
constexpr double kLastStep = 0.002;
// Stick bands nearer than this share of the swing are alike.
constexpr double kAlike = 0.05;

}  // namespace

template <class Real>
void StemSearch<Real>::start(Real swing, Real first_u, Real worth) {
  swing_ = swing;
  first_u_ = first_u;
  worth_ = worth;
  best_ = {};
  grid_ = {};
  index_ = 0;
  doing_ = Doing::kGrid;
  propose();
}

template <class Real>
bool StemSearch<Real>::lay_of_grid() {
  ValveForm form;
  ++index_;  // the first one of the grid follows u
  if (!sliding_start(index_, swing_, form, tried_.friction)) {
    return false;
  }
  tried_.start = resting_range(tried_.friction, first_u_).at(Real(0.5));
  return true;
}

template <class Real>
void StemSearch<Real>::lay_polished() {
  const auto point = pattern_.propose();
  tried_.friction.deadband = std::max(point[0], Real(0));
  tried_.friction.slip_ascending = std::max(point[1], Real(0));
  tried_.friction.slip_descending = std::max(point[2], Real(0));
  tried_.start = point[5];
}

template <class Real>
void StemSearch<Real>::propose() {
  if (doing_ == Doing::kGrid && lay_of_grid()) {
    return;
  }
  while (doing_ == Doing::kGrid || (doing_ == Doing::kPolish && pattern_.done())) {
    go_on();
  }
  if (doing_ == Doing::kPolish) {
    lay_polished();
  }
}

// From the grid to the best of it, and from one of these to the next.
template <class Real>
void StemSearch<Real>::go_on() {
  const bool over_grid = doing_ == Doing::kGrid;
  index_ = over_grid ? 0 : index_ + 1;
  const bool more =
      over_grid ? grid_[0].nats > worth_
                : index_ < kUnlike && grid_[static_cast<std::size_t>(index_)].known;
  doing_ = more ? Doing::kPolish : Doing::kDone;
  if (more) {
    begin_polish(grid_[static_cast<std::size_t>(index_)]);
  }
}

template <class Real>
void StemSearch<Real>::begin_polish(const FoundStem<Real>& from) {
  const ValveFriction<Real>& f = from.friction;
  pattern_.start({f.deadband, f.slip_ascending, f.slip_descending, 0, 0, from.start},
                 -from.nats, kPolishes);
  const Real step = Real(kFirstStep) * swing_;
  const Real least = Real(kLastStep) * swing_;
  pattern_.add_direction({1, 0, 0, 0, 0, 0}, step, least);
  pattern_.add_direction({0, 1, 0, 0, 0, 0}, step, least);
  pattern_.add_direction({0, 0, 1, 0, 0, 0}, step, least);
  pattern_.add_direction({0, 0, 0, 0, 0, 1}, step, least);
  pattern_.add_direction({-1, 1, 1, 0, 0, 0}, step, least);
}

template <class Real>
void StemSearch<Real>::report(Real nats, int strokes) {
  tried_.nats = nats;
  tried_.strokes = strokes;
  tried_.known = strokes >= kFewestStrokes;
  if (tried_.known) {
    widen(tried_);
  }
  const ValveFriction<Real>& f = tried_.friction;
  if (doing_ == Doing::kGrid) {
    keep(tried_);
  } else {
    pattern_.report({f.deadband, f.slip_ascending, f.slip_descending, 0, 0, tried_.start},
                    tried_.known ? -nats : Real(0));
  }
  propose();
}

// The best of the grid whose bands are unlike.
template <class Real>
void StemSearch<Real>::keep(const FoundStem<Real>& stem) {
  FoundStem<Real> carried = stem;
  const auto near = [&](Real a, Real b) {
    return std::abs(a - b) < Real(kAlike) * swing_;
  };
  for (FoundStem<Real>& kept : grid_) {
    if (!carried.known) {
      return;
    }
    const ValveFriction<Real>& a = kept.friction;
    const ValveFriction<Real>& b = carried.friction;
    const bool same = kept.known && near(a.stick_ascending(), b.stick_ascending()) &&
                      near(a.stick_descending(), b.stick_descending());
    if (!kept.known || carried.nats > kept.nats) {
      std::swap(kept, carried);
    }
    if (same) {
      return;
    }
  }
}

// Both strokes' reach, begun anew where a stem leaves all before it far behind.
template <class Real>
void StemSearch<Real>::widen(const FoundStem<Real>& stem) {
  const Real up = stem.friction.stick_ascending();
  const Real down = stem.friction.stick_descending();
  if (!best_.known || stem.nats > best_.nats + Real(kNearNats)) {
    ascending_ = {up, up};
    descending_ = {down, down};
  } else if (stem.nats > best_.nats - Real(kNearNats)) {
    ascending_ = {std::min(ascending_.low, up), std::max(ascending_.high, up)};
    descending_ = {std::min(descending_.low, down), std::max(descending_.high, down)};
  }
  if (!best_.known || stem.nats > best_.nats) {
    best_ = stem;
  }
}

template class StemSearch<float>;
template class StemSearch<double>;

}  // namespace ident
