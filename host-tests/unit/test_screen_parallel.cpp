#include <gtest/gtest.h>

#include <stdexcept>

#include "workbench/screen/parallel.hpp"

namespace workbench {
namespace {

TEST(ForEachParallel, EachOnceByAnyNumberOfThreads) {
  for (const unsigned threads : {0U, 1U, 3U, 64U}) {
    std::vector<std::atomic<int>> done(50);
    for_each_parallel(done.size(), threads, [&done](std::size_t i) { ++done[i]; });
    for (const auto& count : done) EXPECT_EQ(count, 1);
  }
  for_each_parallel(0, 4, [](std::size_t) { ADD_FAILURE(); });
}

TEST(ForEachParallel, WhatOneThrowsIsThrown) {
  EXPECT_THROW(for_each_parallel(100, 4,
                                 [](std::size_t i) {
                                   if (i == 7) throw std::runtime_error("seven");
                                 }),
               std::runtime_error);
}

}  // namespace
}  // namespace workbench
