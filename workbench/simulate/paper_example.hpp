// Example 5.1 of the paper, and what it would be with other valves.
#pragma once

#include <cstdint>
#include <string_view>

#include "workbench/simulate/simulated_loop.hpp"

namespace workbench {

/// 2800 samples of 0.5 s: G(s) = 1.25 e^{-2s} / (80 s + 1), controller
/// 1.303 (1 + 1 / (10 s)), noise 1 / (1 + 0.5 q^-1) e(t) with var e = 0.001
/// added at y inside the loop, He's valve with the given friction. The seed draws
/// the noise only.
///
/// The paper does not give the setpoint, and with the paper's valve, which stands
/// near multiples of 5, the setpoint picks one of two limit cycles: close to
/// a standstill output the stem visits three positions and the period is the
/// paper's 280 samples; midway between two of them it visits two and the period
/// is about 300.
[[nodiscard]] SimulatedLoop paper_example(std::string_view scenario, std::uint64_t seed,
                                          const Friction& friction, double setpoint);

/// Three positions, the paper's period.
inline constexpr double kPaperSetpoint = 0.5;
/// Two positions: half of the output of a step of 5.
inline constexpr double kMidwaySetpoint = 1.25 * 2.5;

/// fs = 5, fd = 0 for both strokes, as in the paper.
inline constexpr Friction kPaperValve{5, 5, 0, 0};
/// Only the ascending stroke sticks.
inline constexpr Friction kPaperValveAscending{5, 0, 0, 0};
/// Only the descending stroke sticks.
inline constexpr Friction kPaperValveDescending{0, 5, 0, 0};
/// Both strokes stick, S = 6 and 3, J = 5 and 2.
inline constexpr Friction kPaperValveMixed{5, 3, 0, 1};

}  // namespace workbench
