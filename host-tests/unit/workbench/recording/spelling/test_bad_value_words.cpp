#include <gtest/gtest.h>

#include <string>

#include "workbench/recording/spelling/bad_value.hpp"

namespace workbench {
namespace {

TEST(WordCounts, ListsWordsAsTheyCame) {
  WordCounts words;
  for (const char* word : {"Stale", "Last Known", "Stale"}) words.add(word);
  EXPECT_EQ(words.total(), 3U);
  EXPECT_EQ(words.list(), "'Stale' 2, 'Last Known' 1");
}

TEST(WordCounts, CountsTogetherWhatIsTooMuchToList) {
  WordCounts words;
  for (std::size_t i = 0; i < WordCounts::kMostWords + 2; ++i) {
    words.add("w" + std::to_string(i));
  }
  EXPECT_NE(words.list().find("'w7' 1, others 2"), std::string::npos) << words.list();
  EXPECT_EQ(WordCounts().list(), "");
}

}  // namespace
}  // namespace workbench
