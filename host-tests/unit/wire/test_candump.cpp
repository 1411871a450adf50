#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>

#include "wire/candump.hpp"

namespace wire {
namespace {

CandumpLine parsed(std::string_view text) {
  CandumpLine line;
  const CandumpStatus status = parse_candump(text, line);
  EXPECT_TRUE(status.ok()) << text << ": expected " << expected_at(status.error) << " at "
                           << status.column;
  return line;
}

CandumpStatus status_of(std::string_view text) {
  CandumpLine line;
  return parse_candump(text, line);
}

std::string formatted(const CandumpLine& line) {
  std::array<char, kMaxCandumpLine> out;
  return {out.data(), format_candump(line, out)};
}

TEST(Candump, ReadsTheManualsExample) {
  const CandumpLine line = parsed("(1436509052.249713) vcan0 044#2A366C2BBA");
  EXPECT_EQ(line.time_ns, 1436509052249713000);
  EXPECT_EQ(line.interface, "vcan0");
  EXPECT_EQ(line.frame.id, 0x44U);
  EXPECT_FALSE(line.frame.extended);
  EXPECT_EQ(line.frame.dlc, 5);
  EXPECT_EQ(line.frame.data,
            (std::array<std::uint8_t, 64>{0x2A, 0x36, 0x6C, 0x2B, 0xBA}));
  EXPECT_EQ(formatted(line), "(1436509052.249713) vcan0 044#2A366C2BBA");
}

TEST(Candump, LeavesNothingOfTheLineBefore) {
  CandumpLine line = parsed("(1.5) can0 1ff#0011223344556677");
  ASSERT_TRUE(parse_candump("(1.5) can0 1ff#00", line).ok());
  EXPECT_EQ(line.frame.data, (std::array<std::uint8_t, 64>{}));
}

TEST(Candump, TellsFrameKindsApart) {
  EXPECT_TRUE(parsed("(1.5) can0 00000044#").frame.extended);
  EXPECT_EQ(parsed("(1.5) can0 18DA10F1#").frame.id, 0x18DA10F1U);
  EXPECT_EQ(parsed("(1.5) can0 1ff#00").frame.id, 0x1FFU);
  EXPECT_TRUE(parsed("(1.5) can0 123#R").frame.remote);
  EXPECT_EQ(parsed("(1.5) can0 123#R8").frame.dlc, 8);
  const CanFrame error = parsed("(1.5) can0 20000004#0004000000000000").frame;
  EXPECT_TRUE(error.error);
  EXPECT_FALSE(error.extended);
  EXPECT_EQ(error.id, 4U);
}

TEST(Candump, AcceptsVariantsOfOtherVersions) {
  const CanFrame plain = parsed("(0000000001.500000) can0 123#1122").frame;
  for (const char* text : {"(1.5) can0 123#11.22", "(1.500000000)  can0  123#1122",
                           "  (1.5)\tcan0\t123#1122", "(1.5) can0 123#1122 R",
                           "(1.5) can0 123#1122 T", "(1.5) can0 123#1122 \r"}) {
    EXPECT_EQ(parsed(text).frame, plain) << text;
    EXPECT_EQ(parsed(text).time_ns, 1'500'000'000) << text;
  }
  EXPECT_EQ(parsed("(1.5) can0 123#1122334455667788_E").frame.dlc, 8);
  EXPECT_EQ(parsed("(7) can0 123#").time_ns, 7'000'000'000);
  EXPECT_EQ(parsed("(0.000000001) can0 123#").time_ns, 1);
}

TEST(Candump, ErrorsHaveANameAndAColumn) {
  struct Case {
    const char* text;
    CandumpError error;
    std::size_t column;
  };
  for (const Case& c : {
           Case{"", CandumpError::kTimeStart, 1},
           Case{"1.0 can0 123#", CandumpError::kTimeStart, 1},
           Case{"(x) can0 123#", CandumpError::kTime, 2},
           Case{"(-1.0) can0 123#", CandumpError::kTime, 2},
           Case{"(1.) can0 123#", CandumpError::kTime, 4},
           Case{"(1.1234567890) can0 123#", CandumpError::kTimeEnd, 13},
           Case{"(99999999999999999999.0) can0 123#", CandumpError::kTime, 11},
           Case{"(1.0)can0 123#", CandumpError::kTimeEnd, 6},
           Case{"(1.0) can0", CandumpError::kInterface, 11},
           Case{"(1.0) sixteen_letters_ 123#", CandumpError::kInterface, 23},
           Case{"(1.0) can0 12#00", CandumpError::kIdentifier, 12},
           Case{"(1.0) can0 800#00", CandumpError::kIdentifier, 12},
           Case{"(1.0) can0 40000000#00", CandumpError::kIdentifier, 12},
           Case{"(1.0) can0 123 00", CandumpError::kIdentifier, 15},
           Case{"(1.0) can0 123#0", CandumpError::kData, 17},
           Case{"(1.0) can0 123#0g", CandumpError::kData, 17},
           Case{"(1.0) can0 123#zz", CandumpError::kData, 16},
           Case{"(1.0) can0 123#00_9", CandumpError::kData, 19},
           Case{"(1.0) can0 123#112233445566778899", CandumpError::kTooLong, 32},
           Case{"(1.0) can0 123#R9", CandumpError::kTooLong, 17},
           Case{"(1.0) can0 123#00 x", CandumpError::kTrailing, 19},
           Case{"(1.0) can0 123#00 R R", CandumpError::kTrailing, 20},
           Case{"(1.0) can0 123##", CandumpError::kFdFlags, 17},
           Case{"(1.0) can0 20000004##1001122334455667788", CandumpError::kTooLong, 39},
           Case{"(1.0) can0 123##1001122334455667788", CandumpError::kFdLength, 36},
           Case{"(1.0) can0 123##10", CandumpError::kData, 19},
           Case{"(1.0) can0 123##1R", CandumpError::kData, 18},
           Case{"(1.0) can0 123#81:00:12345678#11", CandumpError::kXlFrame, 16},
       }) {
    const CandumpStatus status = status_of(c.text);
    EXPECT_EQ(status.error, c.error) << c.text << ' ' << expected_at(status.error);
    EXPECT_EQ(status.column, c.column) << c.text;
  }
}

TEST(Candump, ReadsTheScreenWithTimes) {
  const CandumpLine line =
      parsed(" (1436509052.249713)  vcan0  044   [5]  2A 36 6C 2B BA");
  EXPECT_EQ(line.time_ns, 1436509052249713000);
  EXPECT_EQ(line.interface, "vcan0");
  EXPECT_EQ(line.frame, parsed("(1.0) vcan0 044#2A366C2BBA").frame);
  EXPECT_FALSE(line.relative);
  EXPECT_TRUE(parsed(" (000.000102)  can0  18DA10F1   [2]  3E 00").relative);
  EXPECT_TRUE(parsed(" (000.000102)  can0  18DA10F1   [2]  3E 00").frame.extended);
  EXPECT_FALSE(parsed("(0.000102) can0 123#3E00").relative);
  EXPECT_TRUE(parsed(" (1.0)  can0  123   [3]  remote request").frame.remote);
  EXPECT_EQ(parsed(" (1.0)  can0  123   [0] ").frame.dlc, 0);
  EXPECT_EQ(parsed(" (1.0)  can0  123   [2]  41 42   'AB'").frame.dlc, 2);
  EXPECT_TRUE(parsed(" (1.0)  can0  20000004   [8]  00 04 00 00 00 00 00 00   ERRORFRAME")
                  .frame.error);
  EXPECT_EQ(parsed(" (1.0)  can0  123  [02]  11 22").frame,
            parsed("(1.0) can0 123##01122").frame);
  EXPECT_EQ(parsed(" (1.0)  can0  123  [12]  00 01 02 03 04 05 06 07 08 09 0A 0B").frame,
            parsed("(1.0) can0 123##0000102030405060708090A0B").frame);
  EXPECT_EQ(status_of(" (1.0)  can0  123  [09]  11 22").error, CandumpError::kFdLength);
  EXPECT_EQ(status_of(" (1.0)  can0  123  [99]  11 22").error, CandumpError::kFdLength);
  EXPECT_EQ(status_of(" (1.0)  can0  123   [9]  11 22").error, CandumpError::kTooLong);
  EXPECT_EQ(status_of(" (1.0)  can0  123   [2]  11").error, CandumpError::kData);
  EXPECT_EQ(status_of(" (1.0)  can0  123   [1]  11 22").error, CandumpError::kTrailing);
  EXPECT_EQ(status_of("  can0  123   [8]  11 22 33 44 55 66 77 88").error,
            CandumpError::kTimeStart)
      << "without times nothing can be said";
}

TEST(Candump, ReadsCanFd) {
  const CandumpLine line = parsed("(2.5) can1 123##3AABB");
  EXPECT_EQ(line.time_ns, 2'500'000'000);
  EXPECT_EQ(line.interface, "can1");
  EXPECT_TRUE(line.frame.fd);
  EXPECT_TRUE(line.frame.brs);
  EXPECT_TRUE(line.frame.esi);
  EXPECT_EQ(line.frame.dlc, 2);
  EXPECT_EQ(line.frame.data[1], 0xBB);
  EXPECT_EQ(formatted(line), "(0000000002.500000) can1 123##3AABB");
  EXPECT_EQ(parsed("(2.5) can1 123##0").frame.dlc, 0);
  const std::string longest = "(2.5) can1 18DA10F1##1" + std::string(128, 'A') + " R";
  EXPECT_EQ(parsed(longest).frame.dlc, 64);
  EXPECT_EQ(parsed(longest).frame.data[63], 0xAA);
  EXPECT_EQ(status_of("(2.5) can1 123##1" + std::string(130, 'A')).error,
            CandumpError::kTooLong);
}

TEST(Candump, XlLinesStillTellTimeAndInterface) {
  CandumpLine line;
  EXPECT_EQ(parse_candump("(2.5) can1 123#81:00:12345678#11", line).error,
            CandumpError::kXlFrame);
  EXPECT_EQ(line.time_ns, 2'500'000'000);
  EXPECT_EQ(line.interface, "can1");
}

TEST(Candump, FormatRefusesWhatItCouldNotReadBack) {
  CandumpLine line = parsed("(1.5) can0 123#11");
  EXPECT_EQ(formatted(line), "(0000000001.500000) can0 123#11");
  std::array<char, 30> small;
  EXPECT_EQ(format_candump(line, small), 0U);
  line.time_ns = -1;
  EXPECT_EQ(formatted(line), "");
  line.time_ns = 1;
  EXPECT_EQ(formatted(line), "(0000000000.000000001) can0 123#11");
  line.interface = "a b";
  EXPECT_EQ(formatted(line), "");
  line.interface = "";
  EXPECT_EQ(formatted(line), "");
  line.interface = "can0";
  line.frame.dlc = 9;
  EXPECT_EQ(formatted(line), "");
}

TEST(Candump, LongestLineFitsTheDocumentedBuffer) {
  CandumpLine line;
  line.time_ns = INT64_MAX;
  line.interface = "fifteen_letters";
  line.frame = {.id = 0x1FFFFFFF, .extended = true, .dlc = 64, .fd = true};
  EXPECT_GT(formatted(line).size(), 0U);
}

TEST(Candump, WritesEveryKindOfFrameAsItWasRead) {
  for (const std::string text :
       {"(0000000001.500000) can0 123#R", "(0000000001.500000) can0 123#R1",
        "(0000000001.500000) can0 123#R8", "(0000000001.500000) can0 18DA10F1#R2",
        "(0000000001.500000) can0 20000004#0004000000000000",
        "(0000000001.500000) can0 123##0AABB", "(0000000001.500000) can0 123##1AABB",
        "(0000000001.500000) can0 123##2AABB", "(0000000001.500000) can0 00000123##3"}) {
    EXPECT_EQ(formatted(parsed(text)), text);
  }
  EXPECT_EQ(formatted(parsed("(1.5) can0 123#R0")), "(0000000001.500000) can0 123#R");
}

TEST(Candump, ReadsTimesUpToTheLastNanosecondOf64Bits) {
  EXPECT_EQ(parsed("(9223372035.999999999) can0 123#").time_ns, 9223372035999999999);
  EXPECT_EQ(status_of("(9999999999.0) can0 123#").error, CandumpError::kTime);
}

TEST(Candump, AnXlIdentifierIsNamed) {
  EXPECT_EQ(status_of("(1.0) can0 12345#81:00:12345678#11").error,
            CandumpError::kXlFrame);
  EXPECT_EQ(status_of("(1.0) can0 12345 00").error, CandumpError::kIdentifier);
}

}  // namespace
}  // namespace wire
