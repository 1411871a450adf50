// What the backend says where the device is absent; where it is present it is tested in
// an emulator (host-tests/vm).
#include <gtest/gtest.h>

#include <string>

#include "hal/gpio_line.hpp"

namespace hal {
namespace {

TEST(GpioLine, AnAbsentChipIsNamedWithWhatToDo) {
  GpioLine line("gpiochip-absent", 3, false);
  EXPECT_FALSE(line.open(true));
  EXPECT_FALSE(line.set(true));
  const std::string error = line.error();
  EXPECT_NE(error.find("gpiochip-absent line 3"), std::string::npos) << error;
}

}  // namespace
}  // namespace hal
