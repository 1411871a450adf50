#include <gtest/gtest.h>

#include <barrier>
#include <limits>
#include <stdexcept>
#include <thread>
#include <vector>

#include "workbench/model/base/work.hpp"

namespace workbench {
namespace {

TEST(Work, DoesEveryPartOnceWithAnyNumberOfThreads) {
  for (const unsigned threads : {1U, 2U, 5U}) {
    const Work work({.threads = threads});
    std::vector<int> done(100, 0);
    work.for_each(done.size(), [&](std::size_t i) { ++done[i]; });
    EXPECT_EQ(done, std::vector<int>(100, 1)) << threads;
  }
}

TEST(Work, ThrowsWhatTheFirstPartThrew) {
  for (const unsigned threads : {1U, 3U}) {
    const Work work({.threads = threads});
    EXPECT_THROW(work.for_each(8, [](std::size_t) { throw std::runtime_error("part"); }),
                 std::runtime_error);
  }
}

TEST(Work, SharesOutThePartsOfAPart) {
  const Work work({.threads = 2});
  std::barrier both(2);  // which one thread would never pass
  work.for_each(2, [&](std::size_t i) {
    if (i == 0) return;
    work.for_each(2, [&](std::size_t) { both.arrive_and_wait(); });
  });
}

TEST(Work, CountsWhatWasSpentWhateverTheNumberOfThreads) {
  std::vector<std::vector<std::uint64_t>> seen;
  for (const unsigned threads : {1U, 4U}) {
    const Work work({.threads = threads});
    const std::uint64_t before = Work::spent();
    std::vector<std::uint64_t> in_part(6);
    work.for_each(in_part.size(), [&](std::size_t i) {
      Work::spend(i + 1);
      work.for_each(2, [](std::size_t) { Work::spend(10); });
      in_part[i] = Work::spent() - before;
    });
    EXPECT_EQ(Work::spent() - before, 21 + 6 * 20);
    seen.push_back(in_part);
  }
  EXPECT_EQ(seen[0], seen[1]);
  EXPECT_EQ(seen[0][0], 21);  // no part sees what another one spends
}

TEST(Work, TakesAnyTimeForALimit) {
  for (const double seconds : {1e300, std::numeric_limits<double>::infinity()}) {
    const Work work({.seconds = seconds});
    EXPECT_FALSE(work.out_of_time()) << seconds;
    work.check();
  }
}

TEST(Work, EndsAtTheTimeLimitButWhileThingsAreWrittenDown) {
  const Work work({.seconds = 1e-9});
  std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_TRUE(work.out_of_time());
  EXPECT_THROW(work.check(), OutOfTime);
  {
    const Work::WritingDown last(work);
    EXPECT_NO_THROW(work.check());
  }
  EXPECT_THROW(work.check(), OutOfTime);
  EXPECT_NO_THROW(Work::unlimited().check());
}

TEST(Work, EndsWhenAStopIsAskedFor) {
  std::stop_source source;
  const Work work({.stop = source.get_token()});
  EXPECT_NO_THROW(work.check());
  source.request_stop();
  const Work::WritingDown last(work);
  EXPECT_THROW(work.check(), Stopped);
}

}  // namespace
}  // namespace workbench
