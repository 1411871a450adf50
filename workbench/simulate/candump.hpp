// A simulated loop as traffic on a CAN bus.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>

#include "workbench/simulate/simulated_loop.hpp"

namespace workbench {

/// Identifiers, 11 bits.
inline constexpr std::uint32_t kSetpointFrame = 0x18D;  ///< LoopSP.SP
inline constexpr std::uint32_t kOutputFrame = 0x18E;   ///< LoopOP.OP, controller output u
inline constexpr std::uint32_t kProcessFrame = 0x18F;  ///< LoopPV.PV, process output y
/// Unit of the last digit of OP and PV: signed 32 bits reach ±21474.83647. Every
/// scenario stays inside, with noise of at least several units on y.
inline constexpr double kSignalScale = 1e-5;

/// Writes the recording as `candump -L` lines on can0, starting at
/// 1700000000 s. PV (Motorola byte order) leaves up to 0.4 ms after the sampling
/// instant, OP (Intel) 1.5 to 1.9 ms after it, SP (IEEE float) 2.5 ms after it
/// where it changed and with every tenth sample. Sample periods above 5 ms.
/// Throws std::out_of_range where a value does not fit its signal.
void write_candump(const SimulatedLoop& loop, std::ostream& out);

/// The DBC file that describes these frames.
[[nodiscard]] std::string dbc_text();

}  // namespace workbench
