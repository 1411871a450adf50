#include "hal/gpio_line.hpp"

namespace hal {

const char* GpioLine::library() {
  return "none";
}

bool GpioLine::fail(const char* what, const char* advice) {
  error_.set("%s line %u%s: %s; %s", chip_.c_str(), line_, active_low_ ? " (low)" : "",
             what, advice);
  return false;
}

bool GpioLine::open(bool /*active*/) {
  return fail("this program was built without libgpiod",
              "install libgpiod-dev, build anew");
}

bool GpioLine::set(bool active) {
  return open(active);
}

}  // namespace hal
