#include <gtest/gtest.h>

#include "workbench/recording/stopped.hpp"

namespace workbench {
namespace {

TEST(Stopped, IsThrownOnceAStopWasAskedFor) {
  std::stop_source source;
  EXPECT_NO_THROW(check_stop(source.get_token()));
  EXPECT_NO_THROW(check_stop({}));
  source.request_stop();
  EXPECT_THROW(check_stop(source.get_token()), Stopped);
}

}  // namespace
}  // namespace workbench
