// The fault memory: DTCs of ISO 14229-1 with status bits and snapshots.
//
// Life: new → update() with the state of a loop whenever it changes or a window was
// judged (at least once a second is simplest) → the UDS server reads and clears.
//
// DTC: 0x51, loop, failure type. Status bits: 0 fails now; 2 suspected; 3 confirmed,
// after the on-delay, kept until cleared; 4 and 6 test not completed: not enough
// excitation, or no input; 5 failed since cleared.
//
// No heap, clock or exceptions. Memory: 31 loops × 8 DTCs × 36 bytes. Cost: constant.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "wire/diagnostics.hpp"

namespace wire {

enum class FailureType : std::uint8_t {
  kCurrentLow = 0x18,
  kCurrentHigh = 0x19,
  kNotConfigured = 0x55,
  kImplausible = 0x64,
  kStuck = 0x71,
  kBacklash = 0x72,
  kMessageMissing = 0x87,
  kOtherOscillation = 0x92,
};

/// Name for people, and the failure types in the order of their DTCs.
struct FailureKind {
  FailureType type;
  std::string_view name;
};
[[nodiscard]] std::span<const FailureKind> failure_kinds();

inline constexpr std::uint8_t kDtcFailsNow = 0x01;
inline constexpr std::uint8_t kDtcSuspected = 0x04;
inline constexpr std::uint8_t kDtcConfirmed = 0x08;
inline constexpr std::uint8_t kDtcNotCompletedSinceClear = 0x10;
inline constexpr std::uint8_t kDtcFailedSinceClear = 0x20;
inline constexpr std::uint8_t kDtcNotCompletedThisCycle = 0x40;
inline constexpr std::uint8_t kDtcStatusMask = 0x7D;  ///< bits that are supported

class DtcStore {
 public:
  static constexpr std::size_t kKinds = 8;
  static constexpr std::size_t kSnapshotBytes = kStateBytes + kWindowBytes;  ///< +0, +3

  struct Entry {
    std::uint8_t status = kDtcNotCompletedSinceClear | kDtcNotCompletedThisCycle;
    bool has_snapshot = false;
    bool confirmed_now = false;     ///< at the newest update
    std::uint16_t occurrences = 0;  ///< confirmations since cleared, saturated
    std::array<std::uint8_t, kSnapshotBytes> snapshot{};  ///< at the first of them
  };
  struct Dtc {
    std::uint32_t number = 0;  ///< 24 bits
    const Entry* entry = nullptr;
  };

  /// Loops without a DTC memory of their own are those that were never passed here.
  void update(const LoopStatus& loop);
  /// A loop is no longer configured.
  void forget(int loop);

  /// DTCs of a loop, in the order of failure_kinds().
  using LoopEntries = std::array<Entry, kKinds>;
  /// nullptr: the loop is not known.
  [[nodiscard]] const LoopEntries* entries(int loop) const;
  /// What was remembered over a restart: a new operation cycle, nothing fails yet.
  void restore(int loop, const LoopEntries& entries);
  /// What `loop` has confirmed has been counted: its alarm, too, was restored.
  void resume(const LoopStatus& loop);

  [[nodiscard]] static constexpr std::uint32_t number_of(int loop, FailureType type) {
    return 0x510000U | static_cast<std::uint32_t>(loop) << 8 |
           static_cast<std::uint32_t>(type);
  }
  /// The DTCs of the known loops, by index 0 … size() − 1.
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] Dtc at(std::size_t index) const;
  [[nodiscard]] const Entry* find(std::uint32_t number) const;

  void clear_all();
  /// False: no such DTC.
  [[nodiscard]] bool clear(std::uint32_t number);

 private:
  struct LoopMemory {
    bool known = false;
    LoopEntries entries{};
  };

  std::array<LoopMemory, kMostLoops> loops_{};
};

static_assert(sizeof(DtcStore) <= 10 * 1024, "31 loops, 8 DTCs with snapshot each");

}  // namespace wire
