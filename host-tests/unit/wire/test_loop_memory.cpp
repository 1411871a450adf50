#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "support/gateway/sample_status.hpp"
#include "wire/big_endian.hpp"
#include "wire/loop_memory.hpp"

namespace wire {
namespace {

using LoopMemoryBytes = std::array<std::uint8_t, kLoopMemoryBytes>;

LoopMemory memory() {
  ident::EvidencePool::Memory evidence{.windows = 3.5F, .predicted = 1234};
  evidence.quarter_nats.front() = -32767;
  evidence.quarter_nats.back() = 401;
  return {
      .judged = true,
      .configuration = 0xCBF43926,
      .ended_ms = 1'436'509'052'249,
      .evidence_ms = 1'436'509'999'999,
      .standing = LoopVerdict::kStiction,
      .standing_samples = 2048,
      .told_bands = {{{4.5, 5.5}, {kNotAvailable, kNotAvailable}}},
      .monitor = {.pool = ident::EvidencePool(evidence),
                  .alarm = {true, 5},
                  .alike_windows = 17,
                  .alike_verdict = ident::Verdict::kStiction,
                  .alike_oscillation = true,
                  .earlier = {.friction = {1.5F, 0.25F, 0.5F, ident::SlipMotion::kStops},
                              .slow = 160,
                              .fast = -1,
                              .unexplained = 0.125F,
                              .trusted = 7}}};
}

LoopMemoryBytes bytes() {
  LoopMemoryBytes out{};
  encode_loop_memory(memory(), support::sticking_loop(), out);
  return out;
}

TEST(LoopMemory, IsReadAsItWasWritten) {
  LoopMemory back;
  LoopStatus status;
  ASSERT_TRUE(decode_loop_memory(bytes(), back, status));
  EXPECT_TRUE(back.judged);
  EXPECT_EQ(back.configuration, memory().configuration);
  EXPECT_EQ(back.ended_ms, memory().ended_ms);
  EXPECT_EQ(back.evidence_ms, memory().evidence_ms);
  EXPECT_EQ(back.standing_samples, 2048);
  EXPECT_EQ(back.told_bands[0], memory().told_bands[0]);
  EXPECT_TRUE(back.monitor.alarm.raised);
  EXPECT_EQ(back.monitor.alarm.windows, 5);
  EXPECT_EQ(back.monitor.alike_windows, 17);
  EXPECT_EQ(back.monitor.pool.memory().quarter_nats.back(), 401);
  EXPECT_EQ(back.monitor.pool.memory().quarter_nats.front(), -32767);
  EXPECT_EQ(back.monitor.pool.memory().predicted, 1234);
  EXPECT_EQ(back.monitor.earlier.friction.slip_descending, 0.5F);
  EXPECT_EQ(back.monitor.earlier.friction.motion, ident::SlipMotion::kStops);
  EXPECT_EQ(back.monitor.earlier.fast, -1);
  EXPECT_EQ(back.monitor.earlier.trusted, 7);
  EXPECT_EQ(status.window_verdict, LoopVerdict::kStiction);
  EXPECT_EQ(status.changed_ms, 1'436'509'052'249);
  EXPECT_EQ(status.verdict, LoopVerdict::kNotEvaluated) << "decided elsewhere";

  LoopMemoryBytes again{};
  encode_loop_memory(back, status, again);
  EXPECT_EQ(again, bytes()) << "every number is kept";
}

TEST(LoopMemory, ReadsAllOfItsNumbersAsTheyAreShown) {
  LoopMemory back;
  LoopStatus status;
  ASSERT_TRUE(decode_loop_memory(bytes(), back, status));
  const LoopStatus was = support::sticking_loop();
  for (const LoopField& field : loop_fields()) {
    if (field.object != 3 && field.object != 4) continue;
    EXPECT_EQ(shown(field, status), shown(field, was)) << field.name;
  }
}

TEST(LoopMemory, RefusesWhatIsOutOfRange) {
  const auto refused = [](std::size_t at, std::size_t size, std::uint64_t value) {
    LoopMemoryBytes bad = bytes();
    put_big_endian(value, std::span(bad).subspan(at, size));
    LoopMemory memory;
    LoopStatus status;
    return !decode_loop_memory(bad, memory, status);
  };
  constexpr std::size_t kNumbersAt = 34;
  constexpr std::size_t kMonitorAt = kNumbersAt + 4 * (kKeptNumbers + 4);
  EXPECT_TRUE(refused(0, 1, 2)) << "judged";
  EXPECT_TRUE(refused(29, 1, 6)) << "verdict";
  EXPECT_TRUE(refused(30, 1, 9)) << "verdict";
  EXPECT_TRUE(refused(kNumbersAt, 4, 0x7F800000)) << "infinite number";
  EXPECT_TRUE(refused(kMonitorAt, 1, 7)) << "raised";
  EXPECT_TRUE(refused(kMonitorAt + 1, 2, 1001)) << "windows";
  EXPECT_TRUE(refused(kMonitorAt + 3, 2, 1001)) << "windows alike";
  EXPECT_TRUE(refused(kMonitorAt + 5, 1, 5)) << "their verdict";
  EXPECT_TRUE(refused(kMonitorAt + 7, 4, 0x7FC00000)) << "no number of windows";
  EXPECT_TRUE(refused(kMonitorAt + 11, 4, 0xBF800000)) << "negative samples";
  constexpr std::size_t kValveAt = kLoopMemoryBytes - 6 * 4 - 2;
  EXPECT_TRUE(refused(kValveAt, 4, 0xBF800000)) << "negative dead band";
  EXPECT_TRUE(refused(kValveAt + 12, 4, 0x7FC00000)) << "no time constant";
  EXPECT_TRUE(refused(kValveAt + 24, 1, 3)) << "motion";
  EXPECT_TRUE(refused(kValveAt + 25, 1, ident::kTrustedWindows + 1)) << "trusted";
  EXPECT_FALSE(refused(kNumbersAt, 4, 0x7FC00000)) << "not available";
}

TEST(LoopMemory, AStateThatNeverChangedStaysSo) {
  for (const double changed : {kNotAvailable, 0.0, 1.0}) {
    LoopStatus was = support::sticking_loop();
    was.changed_ms = changed;
    LoopMemoryBytes out{};
    encode_loop_memory(memory(), was, out);
    LoopMemory back;
    LoopStatus status;
    ASSERT_TRUE(decode_loop_memory(out, back, status));
    EXPECT_EQ(std::isnan(status.changed_ms), std::isnan(changed));
    if (!std::isnan(changed)) {
      EXPECT_EQ(status.changed_ms, changed);
    }
  }
}

}  // namespace
}  // namespace wire
