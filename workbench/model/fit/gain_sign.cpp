#include "workbench/model/fit/gain_sign.hpp"

#include <algorithm>
#include <vector>

#include "ident/signal/controller_action.hpp"
#include "workbench/recording/within_row.hpp"

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
