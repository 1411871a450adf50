#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "firmware/write_budget.hpp"
#include "support/ident/microseconds.hpp"

namespace firmware {
namespace {

using test::kSecond;
constexpr std::int64_t kHour = 3600 * kSecond;

// Most in any hour.
std::size_t most_an_hour(const std::vector<std::int64_t>& times) {
  std::size_t most = 0;
  for (std::size_t first = 0, last = 0; last < times.size(); ++last) {
    while (times[last] - times[first] >= kHour) ++first;
    most = std::max(most, last - first + 1);
  }
  return most;
}

TEST(WriteBudget, GivesNoMoreThanItsNumberInAnyHour) {
  for (const int an_hour : {10, 60, 600}) {
    // Quiet spells save up what is spent at once.
    for (const std::int64_t busy : {kHour, 600 * kSecond, 7 * kSecond}) {
      WriteBudget budget(an_hour);
      std::vector<std::int64_t> times;
      for (std::int64_t now = 0; now < 5 * kHour; now += kSecond) {
        const bool wanted = now % (2 * busy) < busy;
        for (const Written file :
             {Written::kState, Written::kWindows, Written::kHistory}) {
          if (budget.may_write(file, wanted ? Haste::kNow : Haste::kNone, now)) {
            times.push_back(now);
          }
        }
      }
      EXPECT_LE(most_an_hour(times), static_cast<std::size_t>(an_hour));
      EXPECT_GE(times.size(), busy == kHour ? 2U * static_cast<unsigned>(an_hour) : 10U);
    }
  }
}

TEST(WriteBudget, KeepsSomeForWhatIsUrgent) {
  WriteBudget budget(60);
  // The other two want to write all the time.
  for (std::int64_t now = 0; now < kHour; now += kSecond) {
    (void)budget.may_write(Written::kWindows, Haste::kSoon, now);
    (void)budget.may_write(Written::kHistory, Haste::kLater, now);
  }
  EXPECT_TRUE(budget.may_write(Written::kState, Haste::kNow, kHour));
  EXPECT_TRUE(budget.may_write(Written::kState, Haste::kNow, kHour + kSecond));
}

TEST(WriteBudget, NobodyKeepsTheOthersFromWriting) {
  WriteBudget budget(60);
  constexpr std::int64_t kEvery = kHour / 55;
  std::vector<std::int64_t> windows;
  std::vector<std::int64_t> history;
  for (std::int64_t now = 0; now < 5 * kHour; now += kSecond) {
    (void)budget.may_write(Written::kState, Haste::kNow, now);
    if (budget.may_write(Written::kWindows, Haste::kSoon, now)) windows.push_back(now);
    if (budget.may_write(Written::kHistory, Haste::kLater, now)) history.push_back(now);
  }
  const auto longest = [](const std::vector<std::int64_t>& times) {
    std::int64_t gap = times.at(0);
    for (std::size_t k = 1; k < times.size(); ++k) {
      gap = std::max(gap, times[k] - times[k - 1]);
    }
    return gap;
  };
  EXPECT_LE(longest(windows), 5 * kEvery);
  EXPECT_LE(longest(history), 8 * kEvery);
}

TEST(WriteBudget, AQuietOneWritesWhenItHasWaited) {
  WriteBudget budget(60);
  EXPECT_FALSE(budget.may_write(Written::kHistory, Haste::kLater, 0)) << "for the flag";
  std::int64_t now = 0;
  while (!budget.may_write(Written::kHistory, Haste::kLater, now)) now += kSecond;
  EXPECT_LE(now, 200 * kSecond);
  EXPECT_TRUE(budget.may_write(Written::kState, Haste::kNow, now));
}

TEST(WriteBudget, WhatWasNotWrittenIsGivenBack) {
  WriteBudget budget(60);
  for (int k = 0; k < 100; ++k) {
    ASSERT_TRUE(budget.may_write(Written::kState, Haste::kNow, 0));
    budget.give_back(1);
  }
  budget.give_back(1000);
  int left = 0;
  while (budget.may_write(Written::kState, Haste::kNow, 0)) ++left;
  EXPECT_EQ(left, WriteBudget::kMost);
}

TEST(WriteBudget, WhoWaitsNoMoreIsForgotten) {
  WriteBudget budget(60);
  while (budget.may_write(Written::kState, Haste::kNow, 0)) {
  }
  EXPECT_FALSE(budget.may_write(Written::kHistory, Haste::kNow, kSecond));
  budget.set(60);  // there is no history any more
  EXPECT_TRUE(budget.may_write(Written::kState, Haste::kNow, 100 * kSecond));
}

}  // namespace
}  // namespace firmware
