#include <gtest/gtest.h>

#include <string>

#include "workbench/recording/csv.hpp"
#include "workbench/recording/rows/restarts.hpp"

namespace workbench {
namespace {

// `rows` of a loop that goes on, from time `start` on.
std::string run(int rows, double start = 0, double step = 1, int first = 0) {
  std::string out;
  for (int k = 0; k < rows; ++k) {
    out += std::to_string(start + k * step) + ',' +
           std::to_string(40 + 7 * (first + k) % 23) + ',' +
           std::to_string(60 + 3 * (first + k) % 17) + '\n';
  }
  return out;
}

std::string refusal(const std::string& text) {
  try {
    (void)parse_csv(text, "a.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const std::string kHead = "Time [s],FIC101.OP,FIC101.PV\n";

TEST(Restarts, BeginAPieceBehindAGap) {
  for (const std::string& head : {std::string(), "\n\n" + kHead}) {
    const Recording r = parse_csv(kHead + run(80) + head + run(70, 0, 1, 80), "a.csv");
    ASSERT_EQ(r.size(), 150U + kOutage - 1);
    ASSERT_EQ(r.resampling.gaps.size(), 1U);
    EXPECT_EQ(r.resampling.gaps[0].first, 80U);
    EXPECT_EQ(r.resampling.gaps[0].last, 90U);
    EXPECT_EQ(r.resampling.missing, 0U);
    EXPECT_EQ(r.resampling.longest_gap_s, 1);
    EXPECT_EQ(r.u[90], 40 + 7 * 80 % 23);
    ASSERT_EQ(r.resampling.notes.size(), 1U);
    EXPECT_EQ(r.resampling.notes[0].rfind("the times begin anew after 79 s (line ", 0),
              0U)
        << r.resampling.notes[0];
  }
}

TEST(Restarts, AreReadInAPlainFileToo) {
  for (const char* head : {"", "t,u,y\n", "\nt,u,y\n"}) {
    const Recording r =
        parse_csv("t,u,y\n" + run(50) + head + run(50, 0, 1, 50), "a.csv");
    EXPECT_EQ(r.resampling.gaps.size(), 1U) << head;
  }
  CsvOptions counted;
  counted.ts = 1;
  EXPECT_THROW((void)parse_csv("t,u,y\n" + run(50) + "t,u,y\n" + run(50), "a", counted),
               InputError)
      << "nothing says whether it begins anew";
}

TEST(Restarts, MayBeSeveralAndBeginALittleLater) {
  const Recording r = parse_csv(
      kHead + run(80, 0.4) + run(72, 0.9, 1, 80) + run(5, 0.1, 1, 152), "a.csv");
  ASSERT_EQ(r.resampling.gaps.size(), 2U);
  EXPECT_EQ(r.resampling.notes[0].rfind("the times begin anew 2 times (first after", 0),
            0U);
}

TEST(Restarts, AreNoneWhereTheTimesStepBackElsewhere) {
  const std::string first = kHead + run(80);
  EXPECT_NE(refusal(first + kHead + run(80, 40)).find("a time not before"),
            std::string::npos)
      << "exports that overlap";
  EXPECT_NE(refusal(kHead + run(80, 500) + run(80, 0, 1, 80)), "") << "no head";
  EXPECT_EQ(refusal(kHead + run(80, 500) + kHead + run(80, 0, 1, 80)), "");
  EXPECT_NE(refusal(first + kHead + run(80)), "") << "the same rows twice";
  EXPECT_NE(refusal(first + kHead + run(80, 0, 2, 80)), "") << "another interval";
  EXPECT_NE(refusal(kHead + run(10) + run(80, 0, 1, 10)), "") << "a short run";
}

TEST(Restarts, AreNoneWhereACounterIsFull) {
  EXPECT_NE(refusal(kHead + run(60) + run(40, 0, 1, 60)), "") << "seconds of a minute";
  EXPECT_NE(refusal(kHead + run(70) + run(70, 0, 1, 70) + run(30, 0, 1, 140)), "");
  EXPECT_EQ(refusal(kHead + run(60) + kHead + run(40, 0, 1, 60)), "");
}

TEST(Restarts, LeaveTimesThatRunOnAsTheyAre) {
  std::vector<double> t(50);
  for (std::size_t k = 0; k < t.size(); ++k) t[k] = static_cast<double>(k);
  RowTable table;
  table.line.resize(t.size());
  EXPECT_FALSE(run_on(t, {}, table));
}

}  // namespace
}  // namespace workbench
