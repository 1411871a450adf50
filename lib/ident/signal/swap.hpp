// Whether the columns u and y were exchanged.
#pragma once

#include <span>

namespace ident {

/// Whether the column called y is the controller output: nearly certain where it is true.
///
/// A controller answers what it reads within the same sample, by its law and exactly; a
/// process answers its input through lag, delay and load. So the law
///
///   Δout(t) = a·Δin(t) + b·in(t) + c·Δsp(t) + d·sp(t) + const,   a·b > 0
///
/// is fitted in both readings by least squares. The columns are exchanged where the
/// reading (out = y, in = u) explains nearly everything and leaves a fraction of what the
/// reading as labelled leaves, with proportional and integral part of one sign: the
/// inverse of a PI law, which a process can look like, has them opposed. Samples at the
/// lowest and highest `out` are left out: there a controller may be saturated.
///
/// It stays silent where the controller's law cannot be seen: u recorded later than y,
/// coarse resolution (an output that rests for three samples of four), compression,
/// manual mode, a controller with derivative action or filter. `sp` may be empty, and in
/// the unit of either column: its coefficients are free, for after an exchange nobody
/// knows its scale. Offset and scale do not matter.
///
/// Equal lengths. Cost: six passes.
[[nodiscard]] bool are_swapped(std::span<const double> u, std::span<const double> y,
                               std::span<const double> sp);

}  // namespace ident
