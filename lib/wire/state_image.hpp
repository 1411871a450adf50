// The bytes of what survives a restart: fault memory, written parameters, and what each
// loop has learned from its windows.
//
// Header, big-endian: "SBST", version u8 = 3, loops u8. For each loop: id u8, tag (32
// bytes, zero-padded), object +5 as configured, object +5 as in use, then for each of the
// eight failure types: type u8, status u8, confirmations u16, has a snapshot u8, snapshot
// (28 bytes). Then, loop by loop, what it remembers of its windows (loop_memory.hpp). At
// the end the CRC-32 of all before it. No heap, clock or exceptions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "wire/crc32.hpp"
#include "wire/diagnostics.hpp"
#include "wire/dtc_store.hpp"
#include "wire/loop_memory.hpp"

namespace wire {

enum class StateError : std::uint8_t {
  kNone,
  kForeign,   ///< does not begin as a state does
  kVersion,   ///< of another version
  kLength,    ///< cut off, or more than there should be
  kChecksum,  ///< the CRC-32 is another
  kContent,   ///< a value is out of range
};

/// What was found instead of a state, for "found …" messages.
[[nodiscard]] const char* describe(StateError error);

inline constexpr std::size_t kStateHeaderBytes = 6;
inline constexpr std::size_t kStateLoopBytes =
    1 + kTagBytes + 2 * kParameterBytes +
    DtcStore::kKinds * (5 + DtcStore::kSnapshotBytes);
inline constexpr std::size_t kMostStateBytes =
    kStateHeaderBytes + kMostLoops * (kStateLoopBytes + kLoopMemoryBytes) +
    kChecksumBytes;
static_assert(kMostStateBytes <= 24 * 1024, "one buffer of the daemon holds it");

/// Bytes at the begin of an image that change with DTCs and parameters only; the rest may
/// change with every window.
[[nodiscard]] std::size_t urgent_bytes(std::size_t loops);

/// Writes the state of `loops`; `configured` has their parameters as the configuration
/// says and `memories` what they remember, in the same order. Bytes written, 0 when `out`
/// is too small.
[[nodiscard]] std::size_t write_state(std::span<const LoopStatus> loops,
                                      std::span<const LoopParameters> configured,
                                      std::span<const LoopMemory> memories,
                                      const DtcStore& dtcs, std::span<std::uint8_t> out);

/// Reads it for `loops`, with the parameters that they have by configuration, and
/// memories that say which configuration they are of. Saved loops are known again by id
/// and tag, others are left out. Written parameters come back into `parameters` unless
/// the configuration has changed since: then it counts. A memory of the same
/// configuration comes back into `memories`, and what the window said into the status;
/// where there is none, neither changes. After an error nothing has changed.
[[nodiscard]] StateError read_state(std::span<const std::uint8_t> image,
                                    std::span<LoopStatus> loops,
                                    std::span<LoopParameters> parameters,
                                    std::span<LoopMemory> memories, DtcStore& dtcs);

}  // namespace wire
