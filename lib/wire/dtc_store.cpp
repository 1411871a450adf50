#include "wire/dtc_store.hpp"

#include <limits>

namespace wire {
namespace {

constexpr std::array<FailureKind, DtcStore::kKinds> kKinds = {{
    {FailureType::kCurrentLow, "current below range"},
    {FailureType::kCurrentHigh, "current above range"},
    {FailureType::kNotConfigured, "not configured"},
    {FailureType::kImplausible, "signal implausible: frozen, clipped or out of range"},
    {FailureType::kStuck, "actuator stuck: stiction"},
    {FailureType::kBacklash, "actuator slack: backlash"},
    {FailureType::kMessageMissing, "message missing"},
    {FailureType::kOtherOscillation, "oscillation of another cause"},
}};

// What the state of a loop says about one of its DTCs.
struct Finding {
  bool completed = false;
  bool fails = false;
  bool confirmed = false;
};

bool decided(LoopVerdict verdict) {
  return verdict == LoopVerdict::kNoStiction ||
         verdict == LoopVerdict::kOtherOscillation || verdict == LoopVerdict::kStiction ||
         verdict == LoopVerdict::kBacklash;
}

Finding valve_finding(const LoopStatus& loop, LoopVerdict sought) {
  return {decided(loop.window_verdict), loop.window_verdict == sought,
          loop.confirmed && loop.verdict == sought};
}

Finding input_finding(const LoopStatus& loop, bool fails) {
  return {loop.input != InputStatus::kNotConfigured, fails, fails};
}

Finding finding_of(const LoopStatus& loop, FailureType type) {
  const InputStatus input = loop.input;
  switch (type) {
    case FailureType::kStuck:
      return valve_finding(loop, LoopVerdict::kStiction);
    case FailureType::kBacklash:
      return valve_finding(loop, LoopVerdict::kBacklash);
    case FailureType::kOtherOscillation:
      return valve_finding(loop, LoopVerdict::kOtherOscillation);
    case FailureType::kCurrentLow:
      return input_finding(loop, input == InputStatus::kCurrentLow);
    case FailureType::kCurrentHigh:
      return input_finding(loop, input == InputStatus::kCurrentHigh);
    case FailureType::kMessageMissing:
      return input_finding(loop, input == InputStatus::kMissing);
    case FailureType::kImplausible:
      return input_finding(loop, input == InputStatus::kFrozen ||
                                     input == InputStatus::kClipped ||
                                     input == InputStatus::kOutOfRange);
    case FailureType::kNotConfigured: {
      const bool fails = input == InputStatus::kNotConfigured;
      return {true, fails, fails};
    }
  }
  return {};
}

void set(std::uint8_t& status, std::uint8_t bit, bool on) {
  status = static_cast<std::uint8_t>(on ? status | bit : status & ~bit);
}

void take(DtcStore::Entry& entry, const Finding& finding) {
  std::uint8_t& status = entry.status;
  if (finding.completed) {
    set(status, kDtcNotCompletedSinceClear | kDtcNotCompletedThisCycle, false);
    set(status, kDtcFailsNow, finding.fails);
    set(status, kDtcSuspected, finding.fails || finding.confirmed);
  }
  if (finding.fails || finding.confirmed) set(status, kDtcFailedSinceClear, true);
  if (finding.confirmed) set(status, kDtcConfirmed, true);
}

}  // namespace

std::span<const FailureKind> failure_kinds() {
  return kKinds;
}

void DtcStore::update(const LoopStatus& loop) {
  if (loop.id < 1 || loop.id > kMostLoops || loop.simulated) return;
  LoopMemory& memory = loops_[loop.id - 1U];
  memory.known = true;
  for (std::size_t i = 0; i < DtcStore::kKinds; ++i) {
    const Finding finding = finding_of(loop, wire::kKinds[i].type);
    Entry& entry = memory.entries[i];
    take(entry, finding);
    if (finding.confirmed && !entry.confirmed_now) {
      if (entry.occurrences < std::numeric_limits<std::uint16_t>::max()) {
        ++entry.occurrences;
      }
      if (!entry.has_snapshot) {
        const std::span<std::uint8_t> snapshot(entry.snapshot);
        entry.has_snapshot =
            encode_loop_object(0, loop, snapshot.first(kStateBytes)) == kStateBytes &&
            encode_loop_object(3, loop, snapshot.subspan(kStateBytes)) == kWindowBytes;
      }
    }
    entry.confirmed_now = finding.confirmed;
  }
}

void DtcStore::forget(int loop) {
  if (loop >= 1 && loop <= kMostLoops) loops_[static_cast<std::size_t>(loop) - 1] = {};
}

const DtcStore::LoopEntries* DtcStore::entries(int loop) const {
  if (loop < 1 || loop > kMostLoops) return nullptr;
  const LoopMemory& memory = loops_[static_cast<std::size_t>(loop) - 1];
  return memory.known ? &memory.entries : nullptr;
}

void DtcStore::restore(int loop, const LoopEntries& entries) {
  if (loop < 1 || loop > kMostLoops) return;
  LoopMemory& memory = loops_[static_cast<std::size_t>(loop) - 1];
  memory.known = true;
  memory.entries = entries;
  for (Entry& entry : memory.entries) {
    entry.status &= kDtcStatusMask;
    set(entry.status, kDtcFailsNow, false);
    set(entry.status, kDtcNotCompletedThisCycle, true);
    entry.confirmed_now = false;
  }
}

void DtcStore::resume(const LoopStatus& loop) {
  if (loop.id < 1 || loop.id > kMostLoops) return;
  LoopMemory& memory = loops_[loop.id - 1U];
  for (std::size_t i = 0; i < DtcStore::kKinds; ++i) {
    Entry& entry = memory.entries[i];
    entry.confirmed_now = (entry.status & kDtcConfirmed) != 0 &&
                          finding_of(loop, wire::kKinds[i].type).confirmed;
  }
}

std::size_t DtcStore::size() const {
  std::size_t count = 0;
  for (const LoopMemory& memory : loops_) count += memory.known ? kKinds : 0;
  return count;
}

DtcStore::Dtc DtcStore::at(std::size_t index) const {
  std::size_t left = index / kKinds;
  for (std::size_t i = 0; i < loops_.size(); ++i) {
    if (!loops_[i].known || left-- > 0) continue;
    const std::size_t kind = index % kKinds;
    return {number_of(static_cast<int>(i) + 1, wire::kKinds[kind].type),
            &loops_[i].entries[kind]};
  }
  return {};
}

const DtcStore::Entry* DtcStore::find(std::uint32_t number) const {
  const int loop = static_cast<int>(number >> 8 & 0xFF);
  const LoopEntries* const known = entries(loop);
  for (std::size_t i = 0; known != nullptr && i < kKinds; ++i) {
    if (number_of(loop, wire::kKinds[i].type) == number) return &(*known)[i];
  }
  return nullptr;
}

void DtcStore::clear_all() {
  for (LoopMemory& memory : loops_) memory.entries = {};
}

bool DtcStore::clear(std::uint32_t number) {
  const Entry* entry = find(number);
  if (entry == nullptr) return false;
  LoopEntries& of_loop = loops_[(number >> 8 & 0xFF) - 1].entries;
  of_loop[static_cast<std::size_t>(entry - of_loop.data())] = {};
  return true;
}

}  // namespace wire
