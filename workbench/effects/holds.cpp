#include "workbench/effects/holds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "ident/signal/differences.hpp"
#include "ident/signal/sensor_hold.hpp"
#include "ident/signal/storage.hpp"

namespace workbench::effects {
namespace {

constexpr std::size_t kLeastFrozen = 12;  // samples; gaps of up to ten are filled

// How often u bends: within the holds of y, and where y jumps out of one.
struct Bends {
  double within = 0;   // share of the samples
  double at_jump = 0;  // share of the jumps
  bool moves = false;  // u does, within the holds
};

Bends bends_of(std::span<const double> u, std::span<const double> y, double same) {
  constexpr std::size_t kInside = 2;  // samples after a jump, which u still answers
  const double straight = ident::measure_differences(u).straight;
  Bends out;
  double inner = 0;
  double jumps = 0;
  double travel = 0;
  std::size_t since = 0;
  for (std::size_t t = 2; t < y.size(); ++t) {
    const bool bends = std::abs(u[t] - 2 * u[t - 1] + u[t - 2]) > straight;
    if (std::abs(y[t] - y[t - 1]) <= same) {
      if (++since <= kInside) continue;
      ++inner;
      out.within += bends;
      travel += std::abs(u[t] - u[t - 1]);
      continue;
    }
    if (since > kInside) {
      ++jumps;
      out.at_jump += bends;
    }
    since = 0;
  }
  out.moves = travel > 0;
  out.within /= std::max(inner, 1.0);
  out.at_jump /= std::max(jumps, 1.0);
  return out;
}

std::size_t length_of(const SampleRange& range) {
  return range.last - range.first;
}

// How the reading moves outside `stretches`.
struct Motion {
  double repeats = 0;  // share of the samples that are as the one before
  double turns = 0;    // share of the moves that go back
  double usual = 0;    // what one that moves usually moves by
  double least = 0;    // least move: the last digit
};

Motion motion_outside(std::span<const double> y, std::span<const SampleRange> stretches,
                      double same) {
  std::vector<double> moves;
  double pairs = 0;
  double turns = 0;
  double before = 0;
  auto next = stretches.begin();
  for (std::size_t k = 1; k < y.size(); ++k) {
    while (next != stretches.end() && next->last < k) ++next;
    // The jumps into a stretch and out of it are not counted either.
    if (next != stretches.end() && k >= next->first && k <= next->last) {
      before = 0;
      continue;
    }
    ++pairs;
    const double move = y[k] - y[k - 1];
    if (std::abs(move) <= same) continue;
    moves.push_back(std::abs(move));
    turns += before * move < 0;
    before = move;
  }
  if (moves.empty()) return {1, 0, 0, 0};
  const auto count = static_cast<double>(moves.size());
  return {1 - count / pairs, turns / count, quantile(moves, 0.5),
          *std::ranges::min_element(moves)};
}

bool stands_still(std::span<const double> u, const SampleRange& range) {
  for (std::size_t k = range.first + 1; k < range.last; ++k) {
    if (u[k] != u[k - 1]) return false;
  }
  return true;
}

// Noise is as large just before a reading freezes as anywhere; what comes to rest slows.
bool comes_to_rest(std::span<const double> y, std::size_t first, double usual) {
  constexpr std::size_t kBefore = 4;
  double most = 0;
  for (std::size_t k = first > kBefore ? first - kBefore : 1; k <= first; ++k) {
    most = std::max(most, std::abs(y[k] - y[k - 1]));
  }
  return most < usual / 2;
}

// Moved by hand, now and then: that its values repeat tells nothing of the record.
bool rests(std::span<const double> u) {
  constexpr std::size_t kRarely = 50;  // samples a move
  std::size_t moves = 0;
  for (std::size_t k = 1; k < u.size(); ++k) moves += u[k] != u[k - 1];
  return kRarely * moves < u.size();
}

// A converter's steps, which a file of two decimals writes as 0.32 here and 0.33 there:
// the usual move is one step.
bool moves_in_steps(std::span<const double> y, double same) {
  constexpr double kNearlyAll = 0.98;
  constexpr double kFew = 2;  // steps
  const Lattice lattice = lattice_of(y);
  return lattice.share >= kNearlyAll &&
         motion_outside(y, {}, same).usual < kFew * lattice.step;
}

}  // namespace

Holder who_holds(std::span<const double> u, std::span<const double> y) {
  constexpr double kQuiet = 0.2;
  constexpr double kBusy = 0.5;
  constexpr double kAnswers = 0.8;
  if (ident::find_sensor_hold(u, y).sticks) return Holder::kSensor;
  const auto [low, high] = std::ranges::minmax_element(y);
  const double same = same_reading(*low, *high);
  if (ident::find_storage(y).storage != ident::Storage::kHeld ||
      moves_in_steps(y, same)) {
    return Holder::kNobody;
  }
  if (rests(u)) return Holder::kEither;
  if (ident::find_storage(u).storage != ident::Storage::kEverySample) {
    return Holder::kHistorian;
  }
  const Bends bends = bends_of(u, y, same);
  if (bends.within > kBusy) return Holder::kHistorian;
  if (bends.moves && bends.within < kQuiet && bends.at_jump > kAnswers) {
    return Holder::kSensor;
  }
  return Holder::kEither;
}

double same_reading(double low, double high) {
  return 4 * std::numeric_limits<double>::epsilon() *
         std::max(std::abs(low), std::abs(high));
}

bool is_scanned_slowly(std::span<const double> reading, double same, std::size_t most) {
  constexpr double kHardlyAny = 0.02;  // of the readings
  std::size_t readings = 0;
  std::size_t longer = 0;
  std::size_t run = 1;
  for (std::size_t k = 1; k <= reading.size(); ++k) {
    if (k < reading.size() && std::abs(reading[k] - reading[k - 1]) <= same) {
      ++run;
      continue;
    }
    ++readings;
    longer += run > most;
    run = 1;
  }
  return static_cast<double>(longer) <= kHardlyAny * static_cast<double>(readings);
}

void hold_like(std::span<const double> reading, double same, std::span<double> signal) {
  if (signal.empty()) return;
  // A choice of values, not of ways: holds come as they like.
  double last = signal[0];
  for (std::size_t k = 1; k < signal.size(); ++k) {
    const bool holds = std::abs(reading[k] - reading[k - 1]) <= same;
    last = holds ? last : signal[k];
    signal[k] = last;
  }
}

std::vector<SampleRange> standing_still(std::span<const double> y, std::size_t least,
                                        double low, double high) {
  const double same = same_reading(low, high);
  std::vector<SampleRange> out;
  double largest = 0;  // move but out of a long run
  std::size_t first = 0;
  for (std::size_t k = 1; k <= y.size(); ++k) {
    const double move = k < y.size() ? std::abs(y[k] - y[k - 1]) : 0;
    if (k < y.size() && move <= same) continue;
    if (k - first >= least && first > 0) out.push_back({first, k});
    if (k - first < kLeastFrozen) largest = std::max(largest, move);
    first = k;
  }
  // What is cut off at the end of a range comes back as it went.
  std::erase_if(out, [&](const SampleRange& range) {
    constexpr double kFarther = 2;
    const double value = y[range.first];
    const bool at_end = value <= low + same || value >= high - same;
    return at_end && (range.last == y.size() ||
                      std::abs(y[range.last] - value) < kFarther * largest);
  });
  return out;
}

// (W21)
Frozen frozen_in(std::span<const double> u, std::span<const double> y) {
  constexpr std::size_t kApart = 4;     // times as long as any other repeat
  constexpr double kMostRepeats = 0.1;  // elsewhere
  constexpr double kNoise = 0.2;        // of the moves turn back; two thirds if white
  constexpr double kDigits = 8;         // of the last digit, in a usual move
  if (y.size() < kLeastFrozen) return {};
  const auto [low, high] = std::ranges::minmax_element(y);
  std::vector<SampleRange> all = standing_still(y, 2, *low, *high);
  std::ranges::stable_sort(
      all, [](const auto& a, const auto& b) { return length_of(a) > length_of(b); });
  std::size_t count = 0;
  for (std::size_t i = 0; i < all.size() && length_of(all[i]) >= kLeastFrozen; ++i) {
    const std::size_t next = i + 1 < all.size() ? length_of(all[i + 1]) : 1;
    if (kApart * next <= length_of(all[i])) count = i + 1;
  }
  all.resize(count);
  if (all.empty()) return {};
  Frozen out{length_of(all.back()), count, 0, all[0].first, length_of(all[0])};
  std::ranges::sort(all, [](const auto& a, const auto& b) { return a.first < b.first; });
  const double same = same_reading(*low, *high);
  const Motion motion = motion_outside(y, all, same);
  if (motion.repeats > kMostRepeats || motion.turns < kNoise ||
      motion.usual < kDigits * motion.least) {
    return {};
  }
  const bool u_moves = motion_outside(u, all, 0).repeats < 0.5;
  for (const SampleRange& range : all) {
    if (comes_to_rest(y, range.first, motion.usual)) return {};
    if (u_moves && stands_still(u, range)) return {};
    out.samples += length_of(range);
  }
  return out;
}

Held held_in(std::span<const double> reading, double same) {
  constexpr double kSmall = 0.05;
  std::vector<double> jumps;
  for (std::size_t k = 1; k < reading.size(); ++k) {
    const double jump = std::abs(reading[k] - reading[k - 1]);
    if (jump > same) jumps.push_back(jump);
  }
  const auto n = static_cast<double>(reading.size());
  const double share = 1 - static_cast<double>(jumps.size()) / std::max(n, 1.0);
  if (jumps.empty()) return {0, share, 0, 0};
  return {jumps.size(), share, quantile(jumps, kSmall), quantile(jumps, 0.5)};
}

bool are_filled_in(const Situation& situation, double repeated) {
  constexpr double kMost = 0.5;
  return situation.filled_share > kMost * repeated;
}

}  // namespace workbench::effects
