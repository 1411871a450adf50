#include "workbench/model/fit/gain_sign.hpp"

#include <vector>

#include "ident/signal/controller_action.hpp"

namespace workbench {

int gain_sign_of(const Recording& recording, std::span<const Piece> pieces) {
  int sign = 0;
  for (const Piece& piece : pieces) {
    const std::size_t count = piece.last - piece.first;
    const auto part = [&](const std::vector<double>& values) {
      return values.empty() ? std::span<const double>()
                            : std::span(values).subspan(piece.first, count);
    };
    const int here = ident::controller_action<double>(
                         part(recording.u), part(recording.y), part(recording.sp))
                         .sign;
    if (here * sign < 0) return 0;
    if (here != 0) sign = here;
  }
  return sign;
}

}  // namespace workbench
