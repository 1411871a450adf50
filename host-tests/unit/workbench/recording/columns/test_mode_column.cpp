// The column of modes: found by its name, its cells, what its numbers mean.
#include <gtest/gtest.h>

#include <string>

#include "workbench/recording/columns/mode_column.hpp"
#include "workbench/recording/csv.hpp"

namespace workbench {
namespace {

// 100 rows, those from 30 to 49 in manual, where u rests.
std::string text_with(const std::string& mode, const std::string& automatic,
                      const std::string& manual) {
  std::string text = "t,FIC101.OP,FIC101.PV," + mode + "\n";
  for (int k = 0; k < 100; ++k) {
    const bool by_hand = k >= 30 && k < 50;
    text += std::to_string(k) + ',' + std::to_string(by_hand ? 50 : k % 7) + ',' +
            std::to_string(k % 5) + ',' + (by_hand ? manual : automatic) + '\n';
  }
  return text;
}

std::vector<SampleRange> manual_in(const std::string& text) {
  return parse_csv(text, "a.csv").manual;
}

void expect_found(const std::string& text) {
  const std::vector<SampleRange> found = manual_in(text);
  ASSERT_EQ(found.size(), 1U) << text.substr(0, 60);
  EXPECT_EQ(found[0].first, 30U);
  EXPECT_EQ(found[0].last, 50U);
}

TEST(ModeColumn, IsFoundByItsName) {
  for (const char* name : {"FIC101.MODE", "FIC101.A/M", "FIC101/MODE.ACTUAL", "MODE",
                           "Betriebsart", "FIC101.AUTO/MAN"}) {
    expect_found(text_with(name, "AUTO", "MAN"));
  }
  EXPECT_TRUE(manual_in(text_with("TIC205.MODE", "AUTO", "MAN")).empty());
  EXPECT_TRUE(manual_in(text_with("FIC101.MODEL", "AUTO", "MAN")).empty());
}

TEST(ModeColumn, KnowsTheWordsOfModes) {
  expect_found(text_with("FIC101.MODE", "CAS", "IMAN"));
  expect_found(text_with("FIC101.MODE", "a", "Hand"));
  EXPECT_EQ(mode_code(" Man "), kManual);
  EXPECT_EQ(mode_code("RCAS"), kAutomatic);
  EXPECT_EQ(mode_code("2"), 2);
  EXPECT_EQ(mode_code("-5"), kNoMode);
  EXPECT_EQ(mode_code("???"), kNoMode);
}

TEST(ModeColumn, TakesNumbersByTheNameOrByWhereURests) {
  expect_found(text_with("FIC101.AUTO", "1", "0"));
  expect_found(text_with("FIC101.MAN", "0", "1"));
  expect_found(text_with("FIC101.MODE", "1", "0"));
  expect_found(text_with("FIC101.MODE", "0", "1"));
  expect_found(text_with("FIC101.MODE", "16", "5"));
}

TEST(ModeColumn, SaysNothingWhereTheNumbersLeaveItOpen) {
  const std::vector<double> codes = {0, 0, 0, 0, 1, 1, 1, 1};
  const std::vector<double> moves = {1, 2, 3, 4, 5, 6, 7, 8};
  const std::vector<double> rests(8, 5.0);
  EXPECT_TRUE(manual_stretches(codes, moves, "MODE").empty());
  EXPECT_TRUE(manual_stretches(codes, rests, "MODE").empty());
}

TEST(ModeColumn, HoldsWhatStoodBefore) {
  std::string text = text_with("FIC101.MODE", "", "");
  const auto put = [&text](int row, const char* word) {
    const std::size_t at = text.find('\n' + std::to_string(row) + ',');
    text.insert(text.find('\n', at + 1), word);
  };
  put(50, "AUTO");
  put(30, "MAN");
  expect_found(text);
}

TEST(ModeColumn, IsNoLoadAndNoNote) {
  CsvOptions options;
  options.names.loads = {"all"};
  const Recording recording =
      parse_csv(text_with("FIC101.MODE", "AUTO", "MAN"), "a.csv", options);
  EXPECT_TRUE(recording.loads.empty());
  EXPECT_TRUE(recording.resampling.notes.empty());
  EXPECT_EQ(recording.size(), 100U);
}

}  // namespace
}  // namespace workbench
