#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "support/gateway/sample_status.hpp"
#include "wire/history_row.hpp"

namespace wire {
namespace {

using HistoryRowBytes = std::array<std::uint8_t, kHistoryRowBytes>;

HistoryRow sample(std::uint32_t time_s = 1'763'857'000) {
  HistoryRow row = history_row(support::sticking_loop());
  row.sequence = 65'535;
  row.time_s = time_s;
  return row;
}

HistoryRowBytes bytes_of(const HistoryRow& row) {
  HistoryRowBytes out{};
  encode_history_row(row, out);
  return out;
}

TEST(HistoryRow, IsReadAsItWasWritten) {
  HistoryRow back;
  ASSERT_TRUE(decode_history_row(bytes_of(sample()), back));
  EXPECT_EQ(back.sequence, 65'535);
  EXPECT_EQ(back.verdict, LoopVerdict::kStiction);
  EXPECT_TRUE(back.flag);
  EXPECT_EQ(back.time_s, 1'763'857'000U);
  EXPECT_DOUBLE_EQ(back.stick_band_pct.ascending, 5.01);
  EXPECT_DOUBLE_EQ(back.stick_band_high_pct.descending, 5.15);
  EXPECT_DOUBLE_EQ(back.detectable_band_pct, 0.63);
  EXPECT_DOUBLE_EQ(back.evidence_nats, 213.4);
  EXPECT_DOUBLE_EQ(back.confidence_pct, 97.5);
  EXPECT_DOUBLE_EQ(back.period_s, 140.3);
  EXPECT_EQ(bytes_of(back), bytes_of(sample()));
}

TEST(HistoryRow, WhatIsNotKnownStaysSo) {
  HistoryRow back;
  ASSERT_TRUE(decode_history_row(bytes_of(history_row(support::new_loop())), back));
  EXPECT_TRUE(std::isnan(back.stick_band_pct.ascending));
  EXPECT_TRUE(std::isnan(back.evidence_nats));
  EXPECT_TRUE(std::isnan(back.period_s));
}

TEST(HistoryRow, EveryDamagedBitIsNoticedAndZerosAreNoRow) {
  const HistoryRowBytes good = bytes_of(sample());
  HistoryRow row;
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    HistoryRowBytes bad = good;
    bad[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
    EXPECT_FALSE(decode_history_row(bad, row)) << bit;
    EXPECT_FALSE(decode_history_head(bad, row)) << bit;
  }
  EXPECT_FALSE(decode_history_row(HistoryRowBytes{}, row));
  HistoryRowBytes ones;
  ones.fill(0xFF);
  EXPECT_FALSE(decode_history_row(ones, row));
}

TEST(HistoryRow, ItsHeadIsReadAlone) {
  HistoryRow head;
  ASSERT_TRUE(decode_history_head(bytes_of(sample()), head));
  EXPECT_EQ(head.sequence, 65'535);
  EXPECT_EQ(head.verdict, LoopVerdict::kStiction);
  EXPECT_TRUE(head.flag);
  EXPECT_EQ(head.time_s, 1'763'857'000U);
  EXPECT_TRUE(std::isnan(head.evidence_nats)) << "not what follows";
}

TEST(HistoryRow, RingsAreReadByTimeEachWindowOnce) {
  std::vector<std::uint8_t> rings(5 * kHistoryRowBytes);
  const auto put = [&](std::size_t at, const HistoryRow& row) {
    const HistoryRowBytes bytes = bytes_of(row);
    std::copy(bytes.begin(), bytes.end(),
              rings.begin() + static_cast<std::ptrdiff_t>(at * kHistoryRowBytes));
  };
  HistoryRow mark;
  mark.time_s = 200;
  put(0, mark);
  put(1, sample(300));
  put(2, sample(200));
  put(4, sample(300));
  std::vector<HistoryRow> rows(5);
  rows.resize(read_history(rings, rows));
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].time_s, 200U);
  EXPECT_EQ(rows[0].verdict, LoopVerdict::kStiction);
  EXPECT_EQ(rows[1].verdict, LoopVerdict::kNotEvaluated) << "the mark after it";
  EXPECT_EQ(rows[2].time_s, 300U);
}

TEST(HistoryRow, NoMoreRowsAreReadThanThereIsRoomFor) {
  std::vector<std::uint8_t> rings;
  for (const std::uint32_t time_s : {100U, 200U, 300U}) {
    const HistoryRowBytes bytes = bytes_of(sample(time_s));
    rings.insert(rings.end(), bytes.begin(), bytes.end());
  }
  std::array<HistoryRow, 3> rows;
  EXPECT_EQ(read_history(rings, std::span(rows).first(2)), 2U);
  EXPECT_EQ(rows[2].time_s, 0U);
}

TEST(HistoryRow, TheHeaderOfAnUploadSaysHowManyCome) {
  std::array<std::uint8_t, kHistoryHeaderBytes> header{};
  EXPECT_EQ(decode_history_header(header), 0);
  encode_history_header(7, 5904, header);
  EXPECT_EQ(decode_history_header(header), 5904);
  header[4] = 2;
  EXPECT_EQ(decode_history_header(header), 0) << "another version";
}

}  // namespace
}  // namespace wire
