#include <gtest/gtest.h>

#include "hal/fake_io.hpp"

namespace hal {
namespace {

TEST(FakeOutput, CountsTheChangesOfItsLevel) {
  FakeOutput line;
  EXPECT_FALSE(line.set(true));
  ASSERT_TRUE(line.open(false));
  EXPECT_TRUE(line.set(true));
  EXPECT_TRUE(line.set(true));
  EXPECT_EQ(line.changes, 1);
  line.present = false;
  EXPECT_FALSE(line.set(false));
}

}  // namespace
}  // namespace hal
