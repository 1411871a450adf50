#include "ident/signal/sensor_hold.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ident/signal/differences.hpp"

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

class SensorHoldSearch {
 public:
  // At least 3 samples.
  SensorHoldSearch(std::span<const double> u, std::span<const double> y)
      : u_(u),
        y_(y),
        straight_(measure_differences(u).straight),
        same_(measure_differences(y).same) {}

  [[nodiscard]] SensorHold found() {
    find_holds();
    judge();
    return hold_;
  }

 private:
  void find_holds();
  void take_hold(std::size_t first, std::size_t end);
  void judge();
  [[nodiscard]] double bend(std::size_t t) const;

  std::span<const double> u_;
  std::span<const double> y_;
  SensorHold hold_;
  double straight_;    // second difference of u that counts as none
  double same_;        // readings closer than this are equal
  double level_ = 0;   // of the latest hold
  double before_ = 0;  // of the one before
  double smallest_ = std::numeric_limits<double>::max();  // difference of two levels
  double wander_ = 0;                                     // sums over the holds
  double jump_ = 0;
  double smallest_jump_ = std::numeric_limits<double>::max();
  std::size_t samples_ = 0;  // in holds
  std::size_t driven_ = 0;
  std::size_t ends_ = 0;  // of holds, before the last sample
  std::size_t jumps_ = 0;
  std::size_t answered_ = 0;
};

double SensorHoldSearch::bend(std::size_t t) const {
  return std::abs(u_[t] - 2 * u_[t - 1] + u_[t - 2]);
}

// The readings [first, end) are equal.
void SensorHoldSearch::take_hold(std::size_t first, std::size_t end) {
  const double level = y_[first];
  for (const double other : {level_, before_}) {
    const double away = std::abs(level - other);
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
  double travel = 0;
  std::size_t bends = 0;
  for (std::size_t t = first + 1; t < end; ++t) {
    travel += std::abs(u_[t] - u_[t - 1]);
    bends += t > first + 1 && bend(t) > straight_ ? 1 : 0;
  }
  const double way = std::abs(u_[end - 1] - u_[first]);
  driven_ += way > 0.9 * travel && kBendsOneIn * bends < end - first ? 1 : 0;
  if (end == y_.size()) {
    return;
  }
  ++ends_;
  const double jump = std::abs(y_[end] - level);
  const double after = end + 1 < y_.size() ? std::abs(y_[end + 1] - y_[end]) : 0.0;
  jump_ += jump;
  smallest_jump_ = std::min(smallest_jump_, jump);
  if (after < kRest * jump) {
    ++jumps_;
    answered_ += bend(end) > straight_ ? 1 : 0;
  }
}

void SensorHoldSearch::find_holds() {
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

void SensorHoldSearch::judge() {
  const auto share = [](std::size_t part, std::size_t whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
  };
  hold_.held = share(samples_, y_.size());
  hold_.jumps = share(jumps_, ends_);
  hold_.driven = share(driven_, hold_.holds);
  hold_.answered = share(answered_, jumps_);
  if (ends_ > 0 && hold_.holds > 2) {
    const double jump = jump_ / static_cast<double>(ends_);
    hold_.wander = wander_ / (jump * static_cast<double>(hold_.holds - 2));
    hold_.resolution = smallest_ / jump;
    hold_.smallest_jump = smallest_jump_ / jump;
  }
  hold_.sticks = hold_.holds >= kFewestHolds && hold_.held >= kLeastHeld &&
                 hold_.jumps >= kJumps && hold_.driven >= kDriven &&
                 hold_.answered >= kAnswered && hold_.wander >= kWander &&
                 hold_.wander >= kWanderSteps * hold_.resolution &&
                 hold_.resolution <= kFine && hold_.smallest_jump >= kSmallestJump &&
                 hold_.smallest_jump >= kJumpSteps * hold_.resolution;
}

}  // namespace

SensorHold find_sensor_hold(std::span<const double> u, std::span<const double> y) {
  return u.size() < kFewestForHolds ? SensorHold{} : SensorHoldSearch(u, y).found();
}

}  // namespace ident
