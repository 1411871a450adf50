#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "firmware/history_file.hpp"
#include "support/base/temporary_folder.hpp"

namespace firmware {
namespace {

using Opened = HistoryFile::Opened;

wire::HistoryRow row_at(std::uint32_t time_s, double band = 5) {
  wire::HistoryRow row;
  row.verdict = wire::LoopVerdict::kStiction;
  row.time_s = time_s;
  row.stick_band_pct = {band, band};
  return row;
}

class HistoryFiles : public testing::Test {
 protected:
  // Opens, adds a row every `step_s` over the time, closes.
  void live(std::uint32_t from_s, std::uint32_t to_s, std::uint32_t step_s) {
    HistoryFile file(path);
    (void)file.open(loops);
    for (std::uint32_t t = from_s; t < to_s; t += step_s) {
      file.add(1, row_at(t));
      if (t / step_s % 100 == 0) file.finish();
    }
    file.finish();
    EXPECT_EQ(file.failures(), 0U);
  }
  [[nodiscard]] std::vector<wire::HistoryRow> rows(int loop = 1) const {
    HistoryFile file(path);
    EXPECT_TRUE(file.open_to_read());
    return file.rows(loop);
  }
  TemporaryFolder folder;
  std::string path = folder.file("history");
  std::vector<HistoryLoop> loops = {{1, "FIC-1", 7}, {3, "PIC-3", 8}};
};

TEST_F(HistoryFiles, KeepsRowsOverARestart) {
  {
    HistoryFile file(path);
    ASSERT_EQ(file.open(loops), Opened::kNew);
    file.add(1, row_at(1000, 2.5));
    file.add(3, row_at(1001));
    file.finish();
  }
  HistoryFile file(path);
  ASSERT_EQ(file.open(loops), Opened::kGood);
  ASSERT_EQ(file.rows(1).size(), 1U);
  EXPECT_EQ(file.rows(1)[0].stick_band_pct.ascending, 2.5);
  file.add(1, row_at(2000));
  file.finish();
  EXPECT_EQ(file.rows(1).size(), 2U);
  EXPECT_EQ(file.rows(3).size(), 1U);
  EXPECT_EQ(file.loops().size(), 2U);
}

TEST_F(HistoryFiles, WritesWhenItIsToldTo) {
  HistoryFile file(path);
  ASSERT_EQ(file.open(loops), Opened::kNew);
  file.add(1, row_at(1000));
  EXPECT_EQ(file.queued(), 4U) << "one in each ring";
  usleep(50'000);
  EXPECT_TRUE(file.rows(1).empty());
  EXPECT_TRUE(file.write());
  EXPECT_EQ(file.queued(), 0U);
  for (int k = 0; k < 100 && file.rows(1).empty(); ++k) usleep(10'000);
  EXPECT_EQ(file.rows(1).size(), 1U);
  file.finish();
  EXPECT_EQ(file.writes(), 1U);
}

TEST_F(HistoryFiles, AStartWithTheSameLoopsWritesNothing) {
  live(1000, 2000, 1000);
  const auto before = std::filesystem::last_write_time(path);
  usleep(20'000);
  {
    HistoryFile file(path);
    ASSERT_EQ(file.open(loops), Opened::kGood);
    file.finish();
  }
  EXPECT_EQ(std::filesystem::last_write_time(path), before);
}

TEST_F(HistoryFiles, AYearThinsOutAndItsSizeIsFixed) {
  constexpr std::uint32_t kYear_s = 365 * 86'400;
  constexpr std::uint32_t kBegin_s = 1'700'000'000;
  live(kBegin_s, kBegin_s + kYear_s, 2048);
  const auto all = rows();
  EXPECT_EQ(std::filesystem::file_size(path), kHistoryHeader + 3 * kHistoryLoopBytes);
  EXPECT_LE(kHistoryLoopBytes, 256U * 1024);
  EXPECT_LE(31 * kHistoryLoopBytes + kHistoryHeader, 8U * 1024 * 1024);
  EXPECT_NEAR(static_cast<double>(all.front().time_s), kBegin_s, 86'400)
      << "the year is there";
  std::uint32_t widest = 0;
  std::uint32_t widest_of_60_days = 0;
  for (std::size_t k = 1; k < all.size(); ++k) {
    const std::uint32_t apart = all[k].time_s - all[k - 1].time_s;
    widest = std::max(widest, apart);
    if (all[k].time_s > kBegin_s + kYear_s - 59 * 86'400) {
      widest_of_60_days = std::max(widest_of_60_days, apart);
    }
  }
  EXPECT_LE(widest, 21'600U + 2048);
  EXPECT_LE(widest_of_60_days, 3600U + 2048);
}

TEST_F(HistoryFiles, ADamagedRowIsLeftOutAndTheRingGoesOn) {
  live(1000, 11'000, 1000);
  {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(kHistoryHeader + 4 * 32 + 9));
    file.put('\x55');
  }
  EXPECT_EQ(rows().size(), 10U) << "ring 1 has it, or it is one less";
  live(20'000, 21'000, 1000);
  EXPECT_EQ(rows().back().time_s, 20'000U);
}

TEST_F(HistoryFiles, ADamagedHeaderIsSetAside) {
  live(1000, 2000, 1000);
  {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(20);
    file.put('\x55');
  }
  HistoryFile file(path);
  EXPECT_EQ(file.open(loops), Opened::kDamaged);
  EXPECT_TRUE(std::filesystem::exists(path + ".bad"));
  EXPECT_TRUE(file.rows(1).empty());
}

TEST_F(HistoryFiles, AnotherTagBeginsAnewAndAnotherConfigurationLeavesAMark) {
  live(1000, 2000, 1000);
  loops[0].configuration = 9;
  {
    HistoryFile file(path);
    ASSERT_EQ(file.open(loops), Opened::kGood);
    file.finish();
    ASSERT_EQ(file.rows(1).size(), 2U);
    EXPECT_EQ(file.rows(1)[1].verdict, wire::LoopVerdict::kNotEvaluated);
  }
  loops[0].tag = "FIC-2";
  HistoryFile file(path);
  ASSERT_EQ(file.open(loops), Opened::kGood);
  EXPECT_TRUE(file.rows(1).empty());
}

TEST_F(HistoryFiles, BelongsToOneProcessAndReadersKeepNobodyOut) {
  HistoryFile file(path);
  ASSERT_EQ(file.open(loops), Opened::kNew);
  HistoryFile second(path);
  EXPECT_EQ(second.open(loops), Opened::kTaken);
  HistoryFile reader(path);
  EXPECT_TRUE(reader.open_to_read());
}

TEST_F(HistoryFiles, SaysWhatCannotBeOpened) {
  HistoryFile none(folder.file("none/history"));
  EXPECT_EQ(none.open(loops), Opened::kFailed);
  EXPECT_FALSE(none.open_to_read());
  std::filesystem::create_symlink(path, folder.file("link"));
  HistoryFile link(folder.file("link"));
  EXPECT_EQ(link.open(loops), Opened::kFailed) << "never followed";
}

TEST_F(HistoryFiles, AFullQueueLosesRowsAndCounts) {
  HistoryFile file(path);
  ASSERT_EQ(file.open(loops), Opened::kNew);
  for (std::uint32_t k = 0; k < HistoryFile::kQueue + 10; ++k) file.add(1, row_at(k));
  EXPECT_GE(file.failures(), 10U);
}

}  // namespace
}  // namespace firmware
