#include <gtest/gtest.h>

#include <thread>

#include "c/sample_queue.hpp"

namespace c {
namespace {

struct Pair {
  std::uint64_t count = 0;
  std::uint64_t square = 0;
};

TEST(SampleQueue, GivesBackInOrder) {
  SampleQueue<int, 4> queue;
  int item = 0;
  EXPECT_FALSE(queue.take(item));
  for (int k = 1; k <= 4; ++k) EXPECT_TRUE(queue.push(k));
  EXPECT_FALSE(queue.push(5));
  EXPECT_EQ(queue.refused(), 1U);
  EXPECT_EQ(queue.size(), 4U);
  for (int k = 1; k <= 4; ++k) {
    EXPECT_TRUE(queue.take(item));
    EXPECT_EQ(item, k);
  }
  EXPECT_FALSE(queue.take(item));
}

TEST(SampleQueue, LosesAndTearsNothingBetweenTwoThreads) {
  constexpr std::uint64_t kItems = 200'000;
  SampleQueue<Pair, 16> queue;
  std::thread pusher([&] {
    for (std::uint64_t k = 1; k <= kItems; ++k) {
      while (!queue.push({k, k * k})) std::this_thread::yield();
    }
  });
  std::uint64_t wrong = 0;
  for (std::uint64_t k = 1; k <= kItems; ++k) {
    Pair pair;
    while (!queue.take(pair)) std::this_thread::yield();
    wrong += pair.count != k || pair.square != k * k ? 1 : 0;
  }
  pusher.join();
  EXPECT_EQ(wrong, 0U);
}

}  // namespace
}  // namespace c
