// Columns that tell whose row it is.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "workbench/recording/columns/long_format.hpp"

namespace workbench {
namespace {

using Keys = std::vector<std::size_t>;

// Rows of `loops` in turn, `apart` of a second after one another.
std::string in_turn(const std::string& head, const std::vector<std::string>& loops,
                    int apart) {
  std::string text = head + '\n';
  for (int k = 0; k < 60; ++k) {
    for (std::size_t i = 0; i < loops.size(); ++i) {
      text += std::to_string(10 * k + apart * static_cast<int>(i)) + ',' + loops[i] +
              ',' + std::to_string(50 + k % 7) + ',' + std::to_string(60 + k % 5) + '\n';
    }
  }
  return text;
}

Keys keys_of(const std::string& text, const Keys& given = {}) {
  return row_keys(layout_of(text, "a.csv", {}), {0}, given);
}

TEST(RowKeys, TellLoopsThatTakeTurnsWithTheirTimesOrBetweenThem) {
  for (const int apart : {0, 3}) {
    EXPECT_EQ(keys_of(in_turn("time,device,op,pv", {"FIC1", "TIC2"}, apart)), Keys{1});
    EXPECT_EQ(keys_of(in_turn("time,x9,op,pv", {"FIC1", "TIC2", "LIC3"}, apart)),
              Keys{1});
  }
  EXPECT_EQ(keys_of(in_turn("time,device,op,pv", {"FIC1"}, 0)), Keys{});
}

TEST(RowKeys, AreNoStatesOrQualities) {
  std::string text = "time,state,op,pv\n";
  std::string rated = "time,note,op,pv\n";
  for (int k = 0; k < 120; ++k) {
    const std::string rest = ',' + std::to_string(k % 7) + ',' + std::to_string(k % 5);
    const std::string time = std::to_string(k) + ',';
    text += time + (k * k % 11 < 5 ? "UP" : "DOWN") + rest + '\n';
    rated += time + (k % 2 == 0 ? "Good" : "Bad") + rest + '\n';
  }
  EXPECT_EQ(keys_of(text), Keys{});
  EXPECT_EQ(keys_of(rated), Keys{});
}

TEST(RowKeys, NameThePartLastBesideWhatIsGiven) {
  std::string text = "time,attribute,element,value\n";
  for (int k = 0; k < 40; ++k) {
    for (const char* element : {"FIC1", "TIC2"}) {
      for (const char* part : {"OP", "PV"}) {
        text += std::to_string(k) + ',' + part + ',' + element + ",5\n";
      }
    }
  }
  EXPECT_EQ(keys_of(text, {1}), (Keys{2, 1}));
  EXPECT_EQ(keys_of(text, {2, 1}), (Keys{2, 1}));
}

}  // namespace
}  // namespace workbench
