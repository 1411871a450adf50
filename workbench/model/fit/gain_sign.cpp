#include "workbench/model/fit/gain_sign.hpp"

#include <algorithm>
#include <vector>

#include "ident/signal/controller_action.hpp"

namespace workbench {
namespace {

// A controller off its limits answers every move of y. Where u stands still beside most
// of them, what looks like its law is a y that follows u within the row.
bool is_moved_by_hand(std::span<const double> u, std::span<const double> y) {
  constexpr double kMost = 0.5;
  if (u.empty()) return false;
  const auto [low, high] = std::ranges::minmax(u);
  std::size_t moves = 0;
  std::size_t rests = 0;
  for (std::size_t k = 1; k < u.size(); ++k) {
    if (u[k] == low || u[k] == high || y[k] == y[k - 1]) continue;
    ++moves;
    if (u[k] == u[k - 1]) ++rests;
  }
  return static_cast<double>(rests) > kMost * static_cast<double>(moves);
}

// (W39) Sign with which y jumps in the rows in which u jumps, up and down, and stays: a
// process that is quicker than the rows. Of the two only u can be switched. 0 where they
// do not, or not always the same way.
int sign_of_jumps(std::span<const double> u, std::span<const double> y) {
  constexpr double kJump = 0.3;         // of the range
  constexpr std::ptrdiff_t kStays = 3;  // rows to either side
  constexpr int kFewest = 3;
  const auto jump = [](std::span<const double> signal, std::size_t k, double least) {
    const auto at = signal.begin() + static_cast<std::ptrdiff_t>(k);
    const auto [low, high] = std::minmax_element(at - kStays, at);
    const auto [low_then, high_then] = std::minmax_element(at, at + kStays);
    if (*low_then - *high > least) return 1;
    return *low - *high_then > least ? -1 : 0;
  };
  const auto least_of = [](std::span<const double> signal) {
    const auto [low, high] = std::ranges::minmax(signal);
    return kJump * (high - low);
  };
  if (u.size() < 2 * kStays) return 0;
  const double of_u = least_of(u);
  const double of_y = least_of(y);
  int same = 0;
  int opposite = 0;
  for (std::size_t k = kStays; k + kStays <= u.size(); ++k) {
    const int both = jump(u, k, of_u) * jump(y, k, of_y);
    same += both > 0;
    opposite += both < 0;
  }
  if (same >= kFewest && opposite == 0) return 1;
  return opposite >= kFewest && same == 0 ? -1 : 0;
}

}  // namespace

int gain_sign_of(const Recording& recording, std::span<const Piece> pieces) {
  int sign = 0;
  for (const Piece& piece : pieces) {
    const std::size_t count = piece.last - piece.first;
    const auto part = [&](const std::vector<double>& values) {
      return values.empty() ? std::span<const double>()
                            : std::span(values).subspan(piece.first, count);
    };
    if (is_moved_by_hand(part(recording.u), part(recording.y))) continue;
    const int here = ident::controller_action<double>(
                         part(recording.u), part(recording.y), part(recording.sp))
                         .sign;
    const int jumps = sign_of_jumps(part(recording.u), part(recording.y));
    if (here * sign < 0 || here * jumps < 0) return 0;
    if (here != 0) sign = here;
  }
  return sign;
}

}  // namespace workbench
