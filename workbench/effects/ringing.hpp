// A process that rings by itself: a pair of complex poles behind lags or an integrator.
#pragma once

#include <span>

#include "workbench/effects/process_shape.hpp"

namespace workbench {

/// Response of the lags or the integrator of `shape` with its ringing pair, unit gain,
/// without dead time, fast part and bent storages. From rest in in[0] + shape.start (an
/// integrator from 0). Exact for an input that is constant between samples.
void ring_behind_lags(const ProcessShape& shape, double period_s,
                      std::span<const double> in, std::span<double> out);

/// What the ringing pair alone makes of a signal that is taken as constant, at its mean,
/// between samples; in place.
void ring(const ProcessShape& shape, double period_s, std::span<double> signal);

/// The two ways in which the pair rings off, as columns: an even and an odd one.
void ring_off(const ProcessShape& shape, double period_s, std::span<double> even,
              std::span<double> odd);

}  // namespace workbench
