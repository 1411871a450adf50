#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "workbench/recording/input_error.hpp"
#include "workbench/recording/tag_stream.hpp"

namespace workbench {
namespace {

// Samples at `t`, their values ten times that.
Stream stream_at(const std::vector<double>& t) {
  SignalRows rows;
  Stream stream(std::move(rows), TimeColumn(TimeForm::kNumber, 1, false, {}));
  stream.t = t;
  for (const double time : t) {
    stream.signal.values.push_back(10 * time);
    stream.line.push_back(static_cast<std::uint32_t>(stream.line.size() + 2));
  }
  return stream;
}

std::vector<double> rising(double first, std::size_t count, double step = 1) {
  std::vector<double> out;
  for (std::size_t i = 0; i < count; ++i) {
    out.push_back(first + step * static_cast<double>(i));
  }
  return out;
}

// The note, or what was refused; values follow their times.
std::string put(const std::vector<double>& t) {
  Stream stream = stream_at(t);
  ResampleReport report;
  try {
    put_in_order(stream, {}, "f.csv", report);
  } catch (const InputError& error) {
    return error.what();
  }
  EXPECT_TRUE(std::is_sorted(stream.t.begin(), stream.t.end()));
  for (std::size_t i = 0; i < t.size(); ++i) {
    EXPECT_EQ(stream.signal.values[i], 10 * stream.t[i]);
  }
  return report.notes.empty() ? "" : report.notes.at(0);
}

std::vector<double> joined(std::vector<double> a, const std::vector<double>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(StreamOrder, RisingTimesStay) {
  EXPECT_EQ(put(rising(0, 50)), "");
}

TEST(StreamOrder, PartsThatDoNotOverlapAreSorted) {
  EXPECT_NE(put(joined(rising(100, 100), rising(0, 100))).find("another order"),
            std::string::npos);
}

TEST(StreamOrder, AFewRowsAstrayAreSorted) {
  std::vector<double> t = rising(0, 100);
  std::swap(t[40], t[43]);
  EXPECT_NE(put(t).find("a few rows"), std::string::npos);
}

TEST(StreamOrder, ATableWithoutAnOrderIsSorted) {
  std::vector<double> t;
  for (int i = 0; i < 100; ++i) t.push_back(i * 37 % 101);
  EXPECT_NE(put(t).find("no order"), std::string::npos);
}

TEST(StreamOrder, StretchesThatComeTwiceAreSorted) {
  EXPECT_NE(put(joined(rising(0, 100), rising(60, 100))).find("come twice"),
            std::string::npos);
}

TEST(StreamOrder, AClockSetBackIsRefused) {
  const std::string error = put(joined(rising(0, 100), rising(60.5, 100)));
  EXPECT_EQ(error.rfind("f.csv:102", 0), 0U) << error;
  EXPECT_NE(error.find("a time not before 99 s"), std::string::npos) << error;
  EXPECT_NE(error.find("60.5 s"), std::string::npos) << error;
}

TEST(StreamOrder, SaysItOnce) {
  ResampleReport report;
  for (int i = 0; i < 2; ++i) {
    Stream stream = stream_at(joined(rising(100, 50), rising(0, 50)));
    put_in_order(stream, {}, "f.csv", report);
  }
  EXPECT_EQ(report.notes.size(), 1U);
}

}  // namespace
}  // namespace workbench
