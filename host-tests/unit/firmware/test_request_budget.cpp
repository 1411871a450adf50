#include <gtest/gtest.h>

#include "firmware/request_budget.hpp"

namespace firmware {
namespace {

TEST(RequestBudget, LetsRequestsHaveTheirShareOfACore) {
  RequestBudget budget;
  constexpr std::int64_t kCost_us = 300'000;
  constexpr std::int64_t kSpan_us = 600'000'000;
  std::int64_t spent_us = 0;
  for (std::int64_t now_us = 5; now_us < kSpan_us; now_us += 3'000) {
    if (!budget.may_begin(now_us)) continue;
    budget.spend(kCost_us);
    spent_us += kCost_us;
  }
  EXPECT_LE(spent_us,
            kSpan_us / RequestBudget::kEarnEvery + RequestBudget::kMost_us + kCost_us);
  EXPECT_GE(spent_us, kSpan_us / RequestBudget::kEarnEvery - kCost_us);
}

TEST(RequestBudget, SavesUpLittle) {
  RequestBudget budget;
  EXPECT_TRUE(budget.may_begin(0));
  EXPECT_TRUE(budget.may_begin(3'600'000'000));
  budget.spend(RequestBudget::kMost_us);
  EXPECT_FALSE(budget.may_begin(3'600'000'000));
}

}  // namespace
}  // namespace firmware
