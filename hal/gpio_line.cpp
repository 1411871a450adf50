// What both generations of libgpiod share.
#include "hal/gpio_line.hpp"

#include <cerrno>
#include <cstring>

namespace hal {

bool GpioLine::fail(const char* what, const char* advice) {
  error_.set("%s line %u: %s: %s; %s", chip_.c_str(), line_, what, std::strerror(errno),
             advice);
  return false;
}

}  // namespace hal
