#include <gtest/gtest.h>

#include "wire/big_endian.hpp"
#include "wire/monitor_bytes.hpp"

namespace wire {
namespace {

ident::MonitorMemory monitor_memory() {
  ident::EvidencePool::Memory evidence{.windows = 2.25F, .predicted = 987};
  evidence.quarter_nats.front() = -32767;
  evidence.quarter_nats.back() = 77;
  return {.pool = ident::EvidencePool(evidence),
          .alarm = {true, 3},
          .alike_windows = 1000,
          .alike_verdict = ident::Verdict::kBadData,
          .alike_oscillation = true,
          .earlier = {}};
}

TEST(MonitorBytes, AreReadAsTheyWereWritten) {
  const auto bytes = encode_monitor(monitor_memory());
  ident::MonitorMemory back;
  ASSERT_TRUE(decode_monitor(bytes, back));
  EXPECT_TRUE(back.alarm.raised);
  EXPECT_EQ(back.alarm.windows, 3);
  EXPECT_EQ(back.alike_windows, 1000);
  EXPECT_EQ(back.alike_verdict, ident::Verdict::kBadData);
  EXPECT_TRUE(back.alike_oscillation);
  EXPECT_EQ(back.pool.memory().windows, 2.25F);
  EXPECT_EQ(back.pool.memory().predicted, 987);
  EXPECT_EQ(back.pool.memory().quarter_nats, monitor_memory().pool.memory().quarter_nats);
  EXPECT_EQ(encode_monitor(back), bytes);
}

TEST(MonitorBytes, OutOfRangeAreRefused) {
  const auto refused = [](std::size_t at, std::size_t size, std::uint64_t value) {
    auto bytes = encode_monitor(monitor_memory());
    put_big_endian(value, std::span(bytes).subspan(at, size));
    ident::MonitorMemory back;
    return !decode_monitor(bytes, back);
  };
  EXPECT_TRUE(refused(0, 1, 2)) << "raised";
  EXPECT_TRUE(refused(1, 2, 1001)) << "windows of the alarm";
  EXPECT_TRUE(refused(3, 2, 1001)) << "windows alike";
  EXPECT_TRUE(refused(5, 1, 5)) << "verdict";
  EXPECT_TRUE(refused(6, 1, 2)) << "oscillation";
  EXPECT_TRUE(refused(7, 4, 0x7F800000)) << "windows of the evidence";
  EXPECT_TRUE(refused(11, 4, 0xBF800000)) << "samples of the evidence";
  EXPECT_FALSE(refused(11, 4, 0x4F9502F9)) << "5e9 samples, two months at 1 kHz";
  EXPECT_FALSE(refused(15, 2, 5)) << "any sum is one";
}

}  // namespace
}  // namespace wire
