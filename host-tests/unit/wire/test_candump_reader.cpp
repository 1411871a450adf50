#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "wire/candump_reader.hpp"

namespace wire {
namespace {

std::vector<std::int64_t> times_ms(std::string_view log) {
  std::vector<std::int64_t> out;
  for (CandumpReader reader(log); reader.next();) {
    out.push_back(reader.line().time_ns / 1'000'000);
  }
  return out;
}

std::size_t cut_line(std::string_view log) {
  CandumpReader reader(log);
  while (reader.next()) EXPECT_TRUE(reader.status().ok()) << reader.text();
  return reader.cut_line();
}

bool is_refused(std::string_view log) {
  CandumpReader reader(log);
  while (reader.next()) {
    if (!reader.status().ok()) return true;
  }
  return false;
}

constexpr std::string_view kWhole = "(1700000124.000000) can0 18E#33\n";

TEST(CandumpReader, CountsEveryLineAndPassesOverBlankOnes) {
  CandumpReader reader(
      "\xEF\xBB\xBF(1.0) can0 123#\r\n\n \t\r\n(2.0) can1 124#\r(3.0) x");
  ASSERT_TRUE(reader.next());
  EXPECT_EQ(reader.text(), "(1.0) can0 123#");
  EXPECT_EQ(reader.number(), 1U);
  ASSERT_TRUE(reader.next());
  EXPECT_EQ(reader.line().interface, "can1");
  EXPECT_EQ(reader.number(), 4U);
  EXPECT_FALSE(reader.next());
  EXPECT_EQ(reader.cut_line(), 5U);
  EXPECT_FALSE(CandumpReader().next());
}

TEST(CandumpReader, SumsUpRelativeTimesThatGoBack) {
  EXPECT_EQ(times_ms(" (000.000000)  can0  123   [1]  11\n"
                     " (001.000100)  can0  123   [1]  11\n"
                     " (000.999900)  can0  123   [1]  11\n"),
            (std::vector<std::int64_t>{0, 1000, 2000}));
  EXPECT_EQ(times_ms(" (000.000000)  can0  123   [1]  11\n"
                     " (001.000100)  can0  123   [1]  11\r\n"
                     "(000.999900) can0 123#11"),
            (std::vector<std::int64_t>{0, 1000, 999}));
}

TEST(CandumpReader, ALineOfCanXlHasItsShareOfTheTime) {
  CandumpReader reader(
      " (000.000000)  can0  123   [1]  11\n"
      " (001.500000)  can0  242   [0002] (00|81:00:12345678) 11 22\n"
      " (000.500000)  can0  123   [1]  11\n");
  ASSERT_TRUE(reader.next());
  ASSERT_TRUE(reader.next());
  EXPECT_TRUE(reader.is_xl());
  EXPECT_EQ(reader.line().interface, "can0");
  ASSERT_TRUE(reader.next());
  EXPECT_EQ(reader.line().time_ns, 2'000'000'000);
}

TEST(CandumpReader, IsCutWhereverTheLastLineEnds) {
  for (const std::string_view line : {"(1700000125.000000) can0 18DAF110#551201",
                                      "(1700000125.000000) can0 18F##1001122",
                                      " (1700000125.500000)  can0  18E   [2]  33 44"}) {
    for (std::size_t length = 2; length < line.size(); ++length) {
      const std::string_view part = line.substr(0, length);
      CandumpLine parsed;
      const bool ok = parse_candump(part, parsed).ok();
      EXPECT_EQ(cut_line(std::string(kWhole) + std::string(part)), ok ? 0U : 2U) << part;
    }
  }
}

TEST(CandumpReader, IsNotCutWhereMoreFollowsOrNothingBegins) {
  const std::string whole(kWhole);
  EXPECT_TRUE(is_refused(whole + "t;u;y"));
  EXPECT_TRUE(is_refused(whole + "(1700000125.000000) can0 18Z#5512010000"));
  EXPECT_TRUE(is_refused(whole + "(1700000125.000000) can0 1\n"));
  EXPECT_TRUE(is_refused("(1700000125.000000) can0 1")) << "nothing came before";
}

TEST(CandumpReader, KnowsWhatToDoAboutALineThatIsNone) {
  CandumpReader foreign("t;u;y\n");
  ASSERT_TRUE(foreign.next());
  EXPECT_NE(std::string_view(foreign.cure()).find("convert"), std::string_view::npos);
  CandumpReader broken("(1.0) can0 123#\nt;u;y\n");
  ASSERT_TRUE(broken.next());
  ASSERT_TRUE(broken.next());
  EXPECT_NE(std::string_view(broken.cure()).find("remove"), std::string_view::npos);
}

}  // namespace
}  // namespace wire
