// Long work: one at a time, with progress, that can be stopped.
#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <stdexcept>

#include "workbench/serve/worker.hpp"

namespace workbench {
namespace {

using std::chrono::milliseconds;

void wait(const Worker& worker) {
  while (worker.progress()) std::this_thread::sleep_for(milliseconds(1));
}

TEST(ServeWorker, TellsHowFarItIsAndTakesOnePieceAtATime) {
  Worker worker;
  std::promise<void> there;
  std::promise<void> go_on;
  ASSERT_TRUE(
      worker.start("explain", [&](const Worker::Report& report, const std::stop_token&) {
        report("valve.stiction", 3, 17);
        there.set_value();
        go_on.get_future().wait();
      }));
  there.get_future().wait();
  const std::optional<WorkProgress> progress = worker.progress();
  ASSERT_TRUE(progress);
  EXPECT_EQ(progress->task, "explain");
  EXPECT_EQ(progress->detail, "valve.stiction");
  EXPECT_EQ(progress->number, 3);
  EXPECT_EQ(progress->of, 17);
  EXPECT_GE(progress->seconds, 0);
  EXPECT_FALSE(
      worker.start("add", [](const Worker::Report&, const std::stop_token&) { FAIL(); }));
  go_on.set_value();
  wait(worker);
  EXPECT_EQ(worker.failure(), nullptr);
}

TEST(ServeWorker, KeepsWhatWentWrongUntilTheNextWork) {
  Worker worker;
  ASSERT_TRUE(worker.start("add", [](const Worker::Report&, const std::stop_token&) {
    throw std::invalid_argument("nothing looks like it");
  }));
  wait(worker);
  EXPECT_THROW(std::rethrow_exception(worker.failure()), std::invalid_argument);
  ASSERT_TRUE(worker.start("add", [](const Worker::Report&, const std::stop_token&) {}));
  wait(worker);
  EXPECT_EQ(worker.failure(), nullptr);
}

TEST(ServeWorker, StopsBetweenParts) {
  Worker worker;
  std::atomic<int> parts = 0;
  ASSERT_TRUE(
      worker.start("explain", [&](const Worker::Report& report, const std::stop_token&) {
        for (;; ++parts) report("valve.backlash", parts, 0);
      }));
  while (parts < 3) std::this_thread::sleep_for(milliseconds(1));
  worker.cancel();
  EXPECT_FALSE(worker.progress());
  EXPECT_EQ(worker.failure(), nullptr);
  EXPECT_TRUE(
      worker.start("explain", [](const Worker::Report&, const std::stop_token&) {}));
}

TEST(ServeWorker, EndsItsWorkWithItself) {
  std::atomic<bool> unwound = false;
  {
    Worker worker;
    ASSERT_TRUE(worker.start("explain",
                             [&](const Worker::Report& report, const std::stop_token&) {
                               struct Guard {
                                 std::atomic<bool>& flag;
                                 ~Guard() { flag = true; }
                               } guard{unwound};
                               for (;;) report("", 0, 0);
                             }));
  }
  EXPECT_TRUE(unwound);
}

}  // namespace
}  // namespace workbench
