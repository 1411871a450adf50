#include <gtest/gtest.h>

#include <memory>

#include "support/gateway/sample_status.hpp"
#include "wire/dtc_store.hpp"

namespace wire {
namespace {

constexpr std::uint8_t kUntested = kDtcNotCompletedSinceClear | kDtcNotCompletedThisCycle;

struct Memory {
  Memory() { loop.id = 9; }
  void window(LoopVerdict newest, LoopVerdict published, bool confirmed) {
    loop.input = InputStatus::kGood;
    loop.window_verdict = newest;
    loop.verdict = published;
    loop.confirmed = confirmed;
    store->update(loop);
  }
  void input(InputStatus status) {
    loop.input = status;
    store->update(loop);
  }
  const DtcStore::Entry& entry(FailureType type) const {
    return *store->find(DtcStore::number_of(9, type));
  }
  int status(FailureType type) const { return entry(type).status; }

  std::unique_ptr<DtcStore> store = std::make_unique<DtcStore>();
  LoopStatus loop;
};

TEST(DtcStore, NumbersAreThoseOfTheSpecification) {
  EXPECT_EQ(DtcStore::number_of(9, FailureType::kStuck), 0x510971U);
  EXPECT_EQ(DtcStore::number_of(31, FailureType::kMessageMissing), 0x511F87U);
}

TEST(DtcStore, KnowsOnlyLoopsItWasTold) {
  const auto store = std::make_unique<DtcStore>();
  EXPECT_EQ(store->size(), 0U);
  for (const LoopStatus& loop : support::sample_loops()) store->update(loop);
  ASSERT_EQ(store->size(), 2 * DtcStore::kKinds);
  EXPECT_EQ(store->at(0).number, 0x510118U);
  EXPECT_EQ(store->at(DtcStore::kKinds).number, 0x511F18U);
  for (std::size_t i = 0; i < store->size(); ++i) {
    EXPECT_NE(store->at(i).number, 0U);
    EXPECT_EQ(store->find(store->at(i).number), store->at(i).entry);
    if (i > 0) {
      EXPECT_GT(store->at(i).number, store->at(i - 1).number);
    }
  }
  EXPECT_EQ(store->at(store->size()).entry, nullptr);
  for (const std::uint32_t absent :
       {0U, 0x000171U, 0x510071U, 0x510271U, 0x512071U, 0x510170U, 0x1510171U}) {
    EXPECT_EQ(store->find(absent), nullptr) << absent;
  }
  store->forget(1);
  EXPECT_EQ(store->size(), DtcStore::kKinds);
  EXPECT_EQ(store->at(0).number, 0x511F18U);
}

TEST(DtcStore, LoopsOutOfRangeAreNotKept) {
  const auto store = std::make_unique<DtcStore>();
  LoopStatus loop;
  for (const int id : {0, 32, 255}) {
    loop.id = static_cast<std::uint8_t>(id);
    store->update(loop);
  }
  EXPECT_EQ(store->size(), 0U);
}

TEST(DtcStore, WithoutExcitationTheTestIsNotCompleted) {
  Memory m;
  m.window(LoopVerdict::kUndecided, LoopVerdict::kUndecided, false);
  EXPECT_EQ(m.status(FailureType::kStuck), kUntested);
  EXPECT_EQ(m.status(FailureType::kOtherOscillation), kUntested);
  EXPECT_EQ(m.status(FailureType::kMessageMissing), 0);
  m.window(LoopVerdict::kNoStiction, LoopVerdict::kNoStiction, false);
  EXPECT_EQ(m.status(FailureType::kStuck), 0);
}

TEST(DtcStore, StictionFromSuspicionToHistory) {
  Memory m;
  m.window(LoopVerdict::kStiction, LoopVerdict::kUndecided, false);
  EXPECT_EQ(m.status(FailureType::kStuck),
            kDtcFailsNow | kDtcSuspected | kDtcFailedSinceClear);
  EXPECT_FALSE(m.entry(FailureType::kStuck).has_snapshot);

  m.window(LoopVerdict::kStiction, LoopVerdict::kStiction, true);
  EXPECT_EQ(m.status(FailureType::kStuck),
            kDtcFailsNow | kDtcSuspected | kDtcConfirmed | kDtcFailedSinceClear);
  EXPECT_EQ(m.entry(FailureType::kStuck).occurrences, 1);
  EXPECT_EQ(m.status(FailureType::kBacklash), 0);

  m.window(LoopVerdict::kUndecided, LoopVerdict::kStiction, true);
  EXPECT_TRUE(m.status(FailureType::kStuck) & kDtcFailsNow) << "says nothing new";

  m.window(LoopVerdict::kNoStiction, LoopVerdict::kStiction, true);
  EXPECT_EQ(m.status(FailureType::kStuck),
            kDtcSuspected | kDtcConfirmed | kDtcFailedSinceClear)
      << "until the off-delay is over";

  m.window(LoopVerdict::kNoStiction, LoopVerdict::kNoStiction, false);
  EXPECT_EQ(m.status(FailureType::kStuck), kDtcConfirmed | kDtcFailedSinceClear);

  m.window(LoopVerdict::kStiction, LoopVerdict::kStiction, true);
  EXPECT_EQ(m.entry(FailureType::kStuck).occurrences, 2);
}

TEST(DtcStore, SnapshotIsThatOfTheFirstConfirmation) {
  Memory m;
  m.loop = support::sticking_loop();
  m.loop.id = 9;
  m.store->update(m.loop);
  std::array<std::uint8_t, DtcStore::kSnapshotBytes> expected{};
  const std::span<std::uint8_t> out(expected);
  ASSERT_EQ(encode_loop_object(0, m.loop, out.first(kStateBytes)), kStateBytes);
  ASSERT_EQ(encode_loop_object(3, m.loop, out.subspan(kStateBytes)), kWindowBytes);

  m.window(LoopVerdict::kNoStiction, LoopVerdict::kNoStiction, false);
  m.loop.stick_band_pct = {9, 9};
  m.window(LoopVerdict::kStiction, LoopVerdict::kStiction, true);
  EXPECT_TRUE(m.entry(FailureType::kStuck).has_snapshot);
  EXPECT_EQ(m.entry(FailureType::kStuck).snapshot, expected);
}

TEST(DtcStore, InputFaultsAreConfirmedAtOnce) {
  const struct {
    InputStatus input;
    FailureType type;
  } kCases[] = {
      {InputStatus::kMissing, FailureType::kMessageMissing},
      {InputStatus::kCurrentLow, FailureType::kCurrentLow},
      {InputStatus::kCurrentHigh, FailureType::kCurrentHigh},
      {InputStatus::kFrozen, FailureType::kImplausible},
      {InputStatus::kClipped, FailureType::kImplausible},
      {InputStatus::kOutOfRange, FailureType::kImplausible},
      {InputStatus::kNotConfigured, FailureType::kNotConfigured},
  };
  for (const auto& c : kCases) {
    Memory m;
    m.input(InputStatus::kGood);
    for (std::size_t i = 0; i < m.store->size(); ++i) {
      EXPECT_EQ(m.store->at(i).entry->status & kDtcFailsNow, 0);
    }
    m.input(c.input);
    std::size_t failing = 0;
    for (std::size_t i = 0; i < m.store->size(); ++i) {
      failing += m.store->at(i).entry->status & kDtcFailsNow;
    }
    EXPECT_EQ(failing, 1U);
    EXPECT_EQ(m.status(c.type),
              kDtcFailsNow | kDtcSuspected | kDtcConfirmed | kDtcFailedSinceClear);
    m.input(InputStatus::kUncertain);
    EXPECT_EQ(m.status(c.type), kDtcConfirmed | kDtcFailedSinceClear);
  }
}

TEST(DtcStore, ClearForgetsAndFindsAgain) {
  Memory m;
  m.window(LoopVerdict::kStiction, LoopVerdict::kStiction, true);
  m.store->clear_all();
  EXPECT_EQ(m.status(FailureType::kStuck), kUntested);
  EXPECT_FALSE(m.entry(FailureType::kStuck).has_snapshot);
  EXPECT_EQ(m.store->size(), DtcStore::kKinds) << "the loop itself stays";
  m.store->update(m.loop);
  EXPECT_TRUE(m.status(FailureType::kStuck) & kDtcConfirmed);
  EXPECT_EQ(m.entry(FailureType::kStuck).occurrences, 1);
}

TEST(DtcStore, ClearOfOneLeavesTheOthers) {
  Memory m;
  m.window(LoopVerdict::kStiction, LoopVerdict::kStiction, true);
  m.window(LoopVerdict::kBacklash, LoopVerdict::kBacklash, true);
  EXPECT_TRUE(m.store->clear(0x510971));
  EXPECT_FALSE(m.store->clear(0x510871));
  EXPECT_EQ(m.status(FailureType::kStuck), kUntested);
  EXPECT_TRUE(m.status(FailureType::kBacklash) & kDtcConfirmed);
}

TEST(DtcStore, SimulationLeavesNoTrace) {
  Memory m;
  m.window(LoopVerdict::kNoStiction, LoopVerdict::kNoStiction, false);
  m.loop.simulated = true;
  m.window(LoopVerdict::kStiction, LoopVerdict::kStiction, true);
  EXPECT_EQ(m.status(FailureType::kStuck), 0);
}

TEST(DtcStore, StatusBitsStayWithinTheMask) {
  Memory m;
  for (int input = 0; input <= 8; ++input) {
    for (const int newest : {0, 1, 2, 3, 4, 5, 7}) {
      for (const bool confirmed : {false, true}) {
        m.loop.input = static_cast<InputStatus>(input);
        m.loop.window_verdict = m.loop.verdict = static_cast<LoopVerdict>(newest);
        m.loop.confirmed = confirmed;
        m.store->update(m.loop);
        for (std::size_t i = 0; i < m.store->size(); ++i) {
          ASSERT_EQ(m.store->at(i).entry->status & ~kDtcStatusMask, 0);
        }
      }
    }
  }
}

TEST(DtcStore, WhatARestoredAlarmConfirmsIsNotCountedAgain) {
  for (const int id : {1, 9, static_cast<int>(kMostLoops)}) {
    LoopStatus loop = support::sticking_loop();
    loop.id = static_cast<std::uint8_t>(id);
    const auto before = std::make_unique<DtcStore>();
    before->update(loop);
    const std::uint32_t stuck = DtcStore::number_of(id, FailureType::kStuck);
    ASSERT_EQ(before->find(stuck)->occurrences, 1);
    for (const bool resumed : {false, true}) {
      const auto after = std::make_unique<DtcStore>();
      after->restore(id, *before->entries(id));
      if (resumed) after->resume(loop);
      after->update(loop);
      EXPECT_EQ(after->find(stuck)->occurrences, resumed ? 1 : 2) << id;
    }
  }
}

TEST(DtcStore, ResumesOnlyWhatWasConfirmedBefore) {
  Memory m;
  m.window(LoopVerdict::kStiction, LoopVerdict::kStiction, true);
  m.window(LoopVerdict::kNoStiction, LoopVerdict::kNoStiction, false);
  const auto after = std::make_unique<DtcStore>();
  after->restore(9, *m.store->entries(9));
  after->resume(m.loop);
  m.loop.window_verdict = m.loop.verdict = LoopVerdict::kBacklash;
  m.loop.confirmed = true;
  after->resume(m.loop);
  after->update(m.loop);
  EXPECT_EQ(after->find(DtcStore::number_of(9, FailureType::kBacklash))->occurrences, 1)
      << "a new alarm";
  m.loop.window_verdict = m.loop.verdict = LoopVerdict::kStiction;
  after->update(m.loop);
  EXPECT_EQ(after->find(DtcStore::number_of(9, FailureType::kStuck))->occurrences, 2)
      << "the first one was over";
  for (const int id : {0, kMostLoops + 1, 255}) {
    m.loop.id = static_cast<std::uint8_t>(id);
    after->resume(m.loop);
  }
  EXPECT_EQ(after->size(), DtcStore::kKinds);
}

TEST(DtcStore, AnInputThatIsNotConfiguredIsNotTested) {
  Memory m;
  m.input(InputStatus::kNotConfigured);
  EXPECT_EQ(m.status(FailureType::kMessageMissing), kUntested);
  m.input(InputStatus::kGood);
  EXPECT_EQ(m.status(FailureType::kMessageMissing), 0);
}

}  // namespace
}  // namespace wire
