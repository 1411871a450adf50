// Which sign the gain of the process has.
#pragma once

#include <span>

#include "workbench/recording/recording.hpp"

namespace workbench {

/// (W11) The sign that negative feedback needs, from the controller's law in u and y,
/// ident::controller_action(): that of the pieces that show it. 0 where none does, as in
/// a step test, or where u rests beside most moves of y, or two disagree, or u and y jump
/// together the other way (W39). Eight passes.
[[nodiscard]] int gain_sign_of(const Recording& recording, std::span<const Piece> pieces);

}  // namespace workbench
