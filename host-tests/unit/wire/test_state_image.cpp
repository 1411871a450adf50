#include <gtest/gtest.h>

#include <vector>

#include "wire/big_endian.hpp"
#include "wire/crc32.hpp"
#include "wire/state_image.hpp"

namespace wire {
namespace {

LoopStatus loop_of(int id, std::string_view tag) {
  LoopStatus loop;
  loop.id = static_cast<std::uint8_t>(id);
  loop.tag.assign(tag);
  loop.input = InputStatus::kGood;
  return loop;
}

// A gateway that has something to remember: loop 1 confirmed, loop 2 written.
struct Gateway {
  std::vector<LoopStatus> loops = {loop_of(1, "FIC-211"), loop_of(7, "PIC-7")};
  std::vector<LoopParameters> configured = std::vector<LoopParameters>(2);
  std::vector<LoopMemory> memories = std::vector<LoopMemory>(2);
  DtcStore dtcs;

  void fault() {
    loops[0].verdict = loops[0].window_verdict = LoopVerdict::kStiction;
    loops[0].confirmed = true;
    loops[0].stick_band_pct.ascending = 5;
    loops[1].parameters.on_delay_windows = 9;
    memories[0].judged = true;
    memories[0].configuration = 77;
    memories[0].monitor.alarm = {true, 2};
    for (const LoopStatus& loop : loops) dtcs.update(loop);
  }
  [[nodiscard]] std::vector<std::uint8_t> image() const {
    std::vector<std::uint8_t> out(kMostStateBytes);
    out.resize(write_state(loops, configured, memories, dtcs, out));
    return out;
  }
  StateError read(std::span<const std::uint8_t> image) {
    std::vector<LoopParameters> parameters = configured;
    const StateError error = read_state(image, loops, parameters, memories, dtcs);
    for (std::size_t k = 0; k < loops.size(); ++k) loops[k].parameters = parameters[k];
    return error;
  }
};

std::vector<std::uint8_t> saved() {
  Gateway gateway;
  gateway.fault();
  return gateway.image();
}

constexpr std::uint32_t kStuck = DtcStore::number_of(1, FailureType::kStuck);

TEST(StateImage, BringsBackWhatWasConfirmedAndWritten) {
  const auto image = saved();
  ASSERT_EQ(image.size(),
            kStateHeaderBytes + 2 * (kStateLoopBytes + kLoopMemoryBytes) + 4);
  Gateway gateway;
  gateway.memories[0].configuration = 77;
  ASSERT_EQ(gateway.read(image), StateError::kNone);
  const DtcStore::Entry* entry = gateway.dtcs.find(kStuck);
  ASSERT_NE(entry, nullptr);
  EXPECT_EQ(entry->status, kDtcConfirmed | kDtcSuspected | kDtcFailedSinceClear |
                               kDtcNotCompletedThisCycle)
      << "nothing fails yet in this cycle";
  EXPECT_EQ(entry->occurrences, 1);
  EXPECT_TRUE(entry->has_snapshot);
  EXPECT_EQ(entry->snapshot[0], 4) << "the verdict at the first confirmation";
  EXPECT_EQ(gateway.loops[1].parameters.on_delay_windows, 9);
  EXPECT_EQ(gateway.image(), image) << "nothing is lost when it is saved again";
}

TEST(StateImage, ALoopIsKnownByIdAndTag) {
  const auto image = saved();
  Gateway other;
  other.loops = {loop_of(1, "FIC-212"), loop_of(8, "PIC-7")};
  ASSERT_EQ(other.read(image), StateError::kNone);
  EXPECT_EQ(other.dtcs.size(), 0U);
  EXPECT_EQ(other.loops[1].parameters, LoopParameters{});
}

TEST(StateImage, MemoryIsThatOfOneConfiguration) {
  const auto image = saved();
  Gateway same;
  same.memories[0].configuration = 77;
  ASSERT_EQ(same.read(image), StateError::kNone);
  EXPECT_TRUE(same.memories[0].judged);
  EXPECT_TRUE(same.memories[0].monitor.alarm.raised);
  EXPECT_EQ(same.loops[0].stick_band_pct.ascending, 5);
  EXPECT_EQ(same.loops[0].window_verdict, LoopVerdict::kStiction);
  Gateway other;
  other.memories[0].configuration = 78;
  ASSERT_EQ(other.read(image), StateError::kNone);
  EXPECT_FALSE(other.memories[0].judged);
  EXPECT_TRUE(std::isnan(other.loops[0].stick_band_pct.ascending));
  EXPECT_EQ(other.dtcs.size(), 16U) << "DTCs come back all the same";
}

TEST(StateImage, OnlyTheBeginIsUrgent) {
  Gateway gateway;
  gateway.fault();
  const auto before = gateway.image();
  gateway.memories[1].judged = true;
  const auto after = gateway.image();
  const std::size_t urgent = urgent_bytes(2);
  EXPECT_NE(before, after);
  EXPECT_TRUE(std::equal(before.begin(),
                         before.begin() + static_cast<std::ptrdiff_t>(urgent),
                         after.begin()));
}

TEST(StateImage, AChangedConfigurationCountsMoreThanWhatWasWritten) {
  Gateway gateway;
  gateway.configured[1].off_delay_windows = 3;
  ASSERT_EQ(gateway.read(saved()), StateError::kNone);
  EXPECT_EQ(gateway.loops[1].parameters, gateway.configured[1]);
}

TEST(StateImage, UnwrittenParametersKeepTheDigitsOfTheConfiguration) {
  Gateway gateway;
  gateway.configured[0].band_min_pct = gateway.loops[0].parameters.band_min_pct = 1.0 / 3;
  const auto image = gateway.image();
  ASSERT_EQ(gateway.read(image), StateError::kNone);
  EXPECT_EQ(gateway.loops[0].parameters.band_min_pct, 1.0 / 3);
}

TEST(StateImage, EveryDamagedByteIsNoticedAndChangesNothing) {
  const auto good = saved();
  for (std::size_t at = 0; at < good.size(); ++at) {
    auto bad = good;
    bad[at] ^= 0x10;
    Gateway gateway;
    EXPECT_NE(gateway.read(bad), StateError::kNone) << at;
    EXPECT_EQ(gateway.dtcs.size(), 0U) << at;
  }
  for (std::size_t size = 0; size < good.size(); ++size) {
    Gateway gateway;
    EXPECT_NE(gateway.read(std::span(good).first(size)), StateError::kNone) << size;
  }
  auto longer = good;
  longer.push_back(0);
  EXPECT_EQ(Gateway().read(longer), StateError::kLength);
}

TEST(StateImage, SaysWhatItIsInstead) {
  const auto good = saved();
  const auto changed = [&](std::size_t at, std::uint8_t value, bool sum) {
    auto bad = good;
    bad[at] = value;
    const auto content = std::span(bad).first(bad.size() - 4);
    if (sum) put_big_endian(crc32(content), std::span(bad).last(4));
    return Gateway().read(bad);
  };
  EXPECT_EQ(changed(0, 'X', true), StateError::kForeign);
  EXPECT_EQ(changed(4, 1, true), StateError::kVersion);
  EXPECT_EQ(changed(5, 3, true), StateError::kLength);
  EXPECT_EQ(changed(40, 1, false), StateError::kChecksum);
  EXPECT_EQ(changed(6, 32, true), StateError::kContent) << "id";
  EXPECT_EQ(changed(6 + 33, 0xFF, true), StateError::kNone)
      << "configured: compared only";
  EXPECT_EQ(changed(6 + 43, 0xFF, true), StateError::kContent) << "parameters in use";
  EXPECT_EQ(changed(6 + 53, 0x20, true), StateError::kContent) << "failure type";
  EXPECT_EQ(changed(6 + 54, 0x80, true), StateError::kContent) << "status";
}

TEST(StateImage, NeedsRoom) {
  Gateway gateway;
  std::vector<std::uint8_t> small(kStateHeaderBytes +
                                  2 * (kStateLoopBytes + kLoopMemoryBytes) + 3);
  EXPECT_EQ(write_state(gateway.loops, gateway.configured, gateway.memories, gateway.dtcs,
                        small),
            0U);
}

}  // namespace
}  // namespace wire
