#include <gtest/gtest.h>

#include <array>
#include <fstream>

#include "hal/candump_file.hpp"
#include "support/base/temporary_folder.hpp"

namespace hal {
namespace {

class Log : public testing::Test {
 protected:
  void write(const std::string& text) const { std::ofstream(path) << text; }
  TemporaryFolder own;
  std::string path = own.file("frames.log");
  FakeClock clock;
  std::array<ReceivedFrame, 8> frames;
  std::size_t count = 0;
};

constexpr const char* kThree =
    "(100.000000) can0 18E#0011\n"
    "(100.500000) can1 18F#22\n"
    "(101.000000) can0 18F##12233\n"
    "(101.500000) can0 18F#81:00:12345678#11\n"
    "\n"
    "(102.000000) can0 0000018F#33\n";

TEST_F(Log, GivesTheFramesOfItsInterfaceAsFastAsTheyAreRead) {
  write(kThree);
  CandumpFile bus(path, "can0", ReplayPace::kFast, clock);
  ASSERT_TRUE(bus.open()) << bus.error();
  ASSERT_EQ(bus.read(frames, count), CanStatus::kOk);
  ASSERT_EQ(count, 3U);
  EXPECT_EQ(frames[0].time_us, 100'000'000);
  EXPECT_EQ(frames[0].frame.id, 0x18EU);
  EXPECT_TRUE(frames[1].frame.fd);
  EXPECT_TRUE(frames[2].frame.extended);
  EXPECT_EQ(bus.drops(), 1U) << "the CAN XL frame";
  EXPECT_EQ(bus.read(frames, count), CanStatus::kEnded);
  EXPECT_EQ(count, 0U);
  EXPECT_TRUE(bus.open()) << "from the start again";
}

TEST_F(Log, KnowsTheInterfacesOfAllItsLines) {
  write(kThree);
  CandumpFile bus(path, "can1", ReplayPace::kFast, clock);
  ASSERT_TRUE(bus.open()) << bus.error();
  EXPECT_EQ(bus.interfaces(), (std::vector<std::string>{"can0", "can1"}));
}

TEST_F(Log, InRealTimeAFrameComesWhenItsTimeHasCome) {
  write(kThree);
  CandumpFile bus(path, "", ReplayPace::kRealTime, clock);
  ASSERT_TRUE(bus.open()) << bus.error();
  const std::int64_t start_us = clock.realtime_us();
  EXPECT_EQ(bus.read(frames, count), CanStatus::kOk);
  EXPECT_EQ(count, 1U);
  EXPECT_EQ(frames[0].time_us, start_us);
  EXPECT_EQ(bus.read(frames, count), CanStatus::kWait);
  clock.now_us += 600'000;
  ASSERT_EQ(bus.read(frames, count), CanStatus::kOk);
  ASSERT_EQ(count, 1U);
  EXPECT_EQ(frames[0].time_us, start_us + 500'000);
}

TEST_F(Log, SumsUpTheTimesOfAScreenWithDeltas) {
  write(
      " (000.000000)  can0  18E   [1]  11\n (001.000100)  can1  18F   [1]  22\n"
      " (000.250000)  can0  18E   [0001] (00|81:00:12345678) 11\n"
      " (000.250000)  can0  18E   [1]  33\n");
  CandumpFile bus(path, "can0", ReplayPace::kFast, clock);
  ASSERT_TRUE(bus.open()) << bus.error();
  ASSERT_EQ(bus.read(frames, count), CanStatus::kOk);
  ASSERT_EQ(count, 2U);
  EXPECT_EQ(frames[1].time_us, 1'500'100);
  EXPECT_EQ(bus.drops(), 1U) << "the CAN XL frame, which has its share of the time";
}

TEST_F(Log, ABrokenLineIsNamedAndWhatCameBeforeItIsGiven) {
  write("(1.0) can0 18E#00\n(1.1) can0 18E#0\n");
  CandumpFile bus(path, "", ReplayPace::kFast, clock);
  ASSERT_TRUE(bus.open());
  EXPECT_EQ(bus.read(frames, count), CanStatus::kOk);
  EXPECT_EQ(count, 1U);
  EXPECT_EQ(bus.read(frames, count), CanStatus::kEnded);
  EXPECT_NE(std::string(bus.error()).find(":2:"), std::string::npos) << bus.error();
}

TEST_F(Log, ALastLineThatWasCutIsLeftOutAndNamed) {
  for (const char* cut : {"(1.2) can0 18E#0", "(1.2) can0 ", "(1."}) {
    write(std::string("(1.0) can0 18E#00\n(1.1) can0 18E#01\n") + cut);
    CandumpFile bus(path, "", ReplayPace::kFast, clock);
    ASSERT_TRUE(bus.open()) << bus.error();
    EXPECT_EQ(bus.read(frames, count), CanStatus::kOk);
    EXPECT_EQ(count, 2U);
    EXPECT_EQ(bus.cut_line(), 3U);
    EXPECT_EQ(bus.read(frames, count), CanStatus::kEnded);
    EXPECT_NE(std::string(bus.error()).find("line 3, its last, is cut"),
              std::string::npos)
        << bus.error();
  }
  write("(1.0) can0 18E#00\n(1.1) can0 18E#01");
  CandumpFile whole(path, "", ReplayPace::kFast, clock);
  ASSERT_TRUE(whole.open());
  EXPECT_EQ(whole.read(frames, count), CanStatus::kOk);
  EXPECT_EQ(count, 2U);
  EXPECT_EQ(whole.cut_line(), 0U);
  write("(1.0) can0 1");
  CandumpFile nothing(path, "", ReplayPace::kFast, clock);
  EXPECT_FALSE(nothing.open()) << "no frame at all";
}

TEST_F(Log, AFileThatIsMissingOrHasNoFrameCannotBeOpened) {
  CandumpFile missing(path + ".none", "", ReplayPace::kFast, clock);
  EXPECT_FALSE(missing.open());
  write(kThree);
  CandumpFile other(path, "can7", ReplayPace::kFast, clock);
  EXPECT_FALSE(other.open());
  EXPECT_NE(std::string(other.error()).find("can7"), std::string::npos);
  CandumpFile folder(own.path(), "", ReplayPace::kFast, clock);
  EXPECT_FALSE(folder.open());
}

}  // namespace
}  // namespace hal
