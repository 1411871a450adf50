#include "workbench/recording/within_row.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace workbench {

int sign_of_jumps(std::span<const double> u, std::span<const double> y) {
  constexpr double kJump = 0.3;         // of the range
  constexpr std::ptrdiff_t kStays = 3;  // rows to either side
  constexpr double kClear = 2;          // of what moves on either side
  constexpr int kFewest = 3;
  const auto jump = [](std::span<const double> signal, std::size_t k, double least) {
    const auto at = signal.begin() + static_cast<std::ptrdiff_t>(k);
    const auto [low, high] = std::minmax_element(at - kStays, at);
    const auto [low_then, high_then] = std::minmax_element(at, at + kStays);
    const double clear =
        std::max(least, kClear * std::max(*high - *low, *high_then - *low_then));
    if (*low_then - *high > clear) return 1;
    return *low - *high_then > clear ? -1 : 0;
  };
  const auto least_of = [](std::span<const double> signal) {
    const auto [low, high] = std::ranges::minmax(signal);
    return kJump * (high - low);
  };
  if (u.size() < 2 * kStays || y.size() != u.size()) return 0;
  const double of_u = least_of(u);
  const double of_y = least_of(y);
  const auto [off, full] = std::ranges::minmax(u);
  // Off, or full on: a controller that a sticking sensor makes jump rests at neither.
  const auto rests_at_end = [&, off = off, full = full](std::size_t first) {
    const auto [low, high] = std::ranges::minmax(u.subspan(first, kStays));
    return low == high && (low == off || high == full);
  };
  int same = 0;
  int opposite = 0;
  for (std::size_t k = kStays; k + kStays <= u.size(); ++k) {
    const int both = jump(u, k, of_u) * jump(y, k, of_y);
    if (both == 0 || !(rests_at_end(k - kStays) || rests_at_end(k))) continue;
    same += both > 0;
    opposite += both < 0;
  }
  if (same >= kFewest && opposite == 0) return 1;
  return opposite >= kFewest && same == 0 ? -1 : 0;
}

namespace {

// What y does out of its way where u moves out of rest, in the row of the move and in the
// two that follow, with the moves as weights.
struct Answers {
  std::array<double, 3> rows{};
  double squares = 0;  // of the moves
  double noise = 0;    // mean square of what y does out of its way where u rests
};

Answers answers_of(std::span<const double> u, std::span<const double> y) {
  constexpr double kMove = 0.05;  // of the range of u
  constexpr std::size_t kRest = 3;
  Answers out;
  const auto [low, high] = std::ranges::minmax(u);
  const double least = kMove * (high - low);
  std::size_t rest = 1;  // rows for which u has had its value
  double resting = 0;
  for (std::size_t k = 1; k + 3 < u.size(); ++k) {
    const double move = u[k] - u[k - 1];
    const bool stays = u[k + 1] == u[k] && u[k + 2] == u[k];
    if (rest >= kRest) {
      const double way = y[k - 1] - y[k - 2];
      const double off = y[k] - y[k - 1] - way;
      if (move == 0) {
        out.noise += off * off;
        ++resting;
      } else if (std::abs(move) > least && stays) {
        for (std::size_t i = 0; i < out.rows.size(); ++i) {
          out.rows[i] += move * (y[k + i] - y[k + i - 1] - way);
        }
        out.squares += move * move;
      }
    }
    rest = move == 0 ? rest + 1 : 1;
  }
  out.noise = resting > 0 ? out.noise / resting : 0;
  return out;
}

// Behind one lag y moves most in the row of the move, or as much in the next; behind two
// it moves more from row to row at first.
bool begins_at_once(const Answers& seen) {
  constexpr double kClear = 5;  // standard deviations
  constexpr double kOneLag = 0.6;
  constexpr double kTwoLags = 0.2;
  constexpr double kGrows = 1.3;
  const auto [first, second, third] = seen.rows;
  if (first * second <= 0 ||
      first * first < kClear * kClear * seen.squares * seen.noise) {
    return false;
  }
  const double share = first / second;
  return share > kOneLag || (share > kTwoLags && third / second > kGrows);
}

}  // namespace

bool answers_within_row(std::span<const double> u, std::span<const double> y) {
  if (y.size() != u.size() || u.empty()) return false;
  return sign_of_jumps(u, y) != 0 || begins_at_once(answers_of(u, y));
}

void note_within_row(Recording& recording) {
  if (!answers_within_row(recording.u, recording.y)) return;
  recording.resampling.notes.emplace_back(
      "y answers in the row of the u that moves it: the log wrote y after u had acted, "
      "or "
      "its rows are means. Models take u one row earlier; what happens within a row "
      "needs "
      "a faster log");
}

}  // namespace workbench
