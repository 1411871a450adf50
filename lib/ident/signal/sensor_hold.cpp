#include "ident/signal/sensor_hold.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace ident {
namespace {

constexpr double kJumps = 0.6;
constexpr double kDriven = 0.8;
constexpr double kAnswered = 0.8;
// The levels must move from cycle to cycle, by this share of the jumps and so many steps
// of the resolution, which must be fine beside the jumps.
constexpr double kWander = 0.03;
constexpr double kWanderSteps = 2;
constexpr double kFine = 0.1;
// The smallest jump, in mean jumps and in steps of the resolution.
constexpr double kSmallestJump = 0.1;
constexpr double kJumpSteps = 2;
// What may follow a jump, in jumps, for it to stand alone.
constexpr double kRest = 0.1;
// Share of the samples of a hold that may bend.
constexpr std::size_t kBendsOneIn = 5;

}  // namespace

template <class Real>
void SensorHoldSearch<Real>::start(std::span<const Real> u, std::span<const Real> y) {
  *this = SensorHoldSearch();
  u_ = u;
  y_ = y;
  stage_ = u.size() < kFewestForHolds ? Stage::kDone : Stage::kResolution;
}

template <class Real>
Real SensorHoldSearch<Real>::bend(std::size_t t) const {
  return std::abs(u_[t] - Real(2) * u_[t - 1] + u_[t - 2]);
}

// The readings [first, end) are equal.
template <class Real>
void SensorHoldSearch<Real>::take_hold(std::size_t first, std::size_t end) {
  const Real level = y_[first];
  for (const Real other : {level_, before_}) {
    const Real away = std::abs(level - other);
    if (hold_.holds > 1 && away > same_) {
      smallest_ = std::min(smallest_, away);
    }
  }
  if (hold_.holds > 1) {
    wander_ += std::abs(level - before_);
  }
  before_ = level_;
  level_ = level;
  ++hold_.holds;
  samples_ += end - first;
  // u has answered the reading of `first`, and runs on with the next.
  Real travel = 0;
  std::size_t bends = 0;
  for (std::size_t t = first + 1; t < end; ++t) {
    travel += std::abs(u_[t] - u_[t - 1]);
    bends += t > first + 1 && bend(t) > straight_ ? 1 : 0;
  }
  const Real way = std::abs(u_[end - 1] - u_[first]);
  driven_ += way > Real(0.9) * travel && kBendsOneIn * bends < end - first ? 1 : 0;
  if (end == y_.size()) {
    return;
  }
  ++ends_;
  const Real jump = std::abs(y_[end] - level);
  const Real after = end + 1 < y_.size() ? std::abs(y_[end + 1] - y_[end]) : Real(0);
  jump_ += jump;
  smallest_jump_ = std::min(smallest_jump_, jump);
  if (after < Real(kRest) * jump) {
    ++jumps_;
    answered_ += bend(end) > straight_ ? 1 : 0;
  }
}

template <class Real>
void SensorHoldSearch<Real>::find_holds() {
  std::size_t first = 0;
  for (std::size_t t = 1; t <= y_.size(); ++t) {
    if (t < y_.size() && std::abs(y_[t] - y_[t - 1]) <= same_) {
      continue;
    }
    if (t - first >= kShortestHold) {
      take_hold(first, t);
    }
    first = t;
  }
}

template <class Real>
void SensorHoldSearch<Real>::judge() {
  const auto share = [](std::size_t part, std::size_t whole) {
    return whole > 0 ? static_cast<Real>(part) / static_cast<Real>(whole) : Real(0);
  };
  hold_.held = share(samples_, y_.size());
  hold_.jumps = share(jumps_, ends_);
  hold_.driven = share(driven_, hold_.holds);
  hold_.answered = share(answered_, jumps_);
  if (ends_ > 0 && hold_.holds > 2) {
    const Real jump = jump_ / static_cast<Real>(ends_);
    hold_.wander = wander_ / (jump * static_cast<Real>(hold_.holds - 2));
    hold_.resolution = smallest_ / jump;
    hold_.smallest_jump = smallest_jump_ / jump;
  }
  hold_.sticks = hold_.holds >= kFewestHolds && hold_.held >= Real(kLeastHeld) &&
                 hold_.jumps >= Real(kJumps) && hold_.driven >= Real(kDriven) &&
                 hold_.answered >= Real(kAnswered) && hold_.wander >= Real(kWander) &&
                 hold_.wander >= Real(kWanderSteps) * hold_.resolution &&
                 hold_.resolution <= Real(kFine) &&
                 hold_.smallest_jump >= Real(kSmallestJump) &&
                 hold_.smallest_jump >= Real(kJumpSteps) * hold_.resolution;
}

template <class Real>
bool SensorHoldSearch<Real>::step() {
  switch (stage_) {
    case Stage::kResolution:
      straight_ = measure_differences<Real>(u_).straight;
      same_ = measure_differences<Real>(y_).same;
      smallest_ = smallest_jump_ = std::numeric_limits<Real>::max();  // of nothing yet
      stage_ = Stage::kHolds;
      break;
    case Stage::kHolds:
      find_holds();
      judge();
      stage_ = Stage::kDone;
      break;
    case Stage::kDone:
      break;
  }
  return stage_ == Stage::kDone;
}

template <class Real>
SensorHold<Real> find_sensor_hold(std::span<const Real> u, std::span<const Real> y) {
  SensorHoldSearch<Real> search;
  search.start(u, y);
  while (!search.step()) {
  }
  return search.hold();
}

#define STICKBAND_INSTANTIATE(Real)                                       \
  template class SensorHoldSearch<Real>;                                  \
  template SensorHold<Real> find_sensor_hold<Real>(std::span<const Real>, \
                                                   std::span<const Real>);
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)
#undef STICKBAND_INSTANTIATE

}  // namespace ident
