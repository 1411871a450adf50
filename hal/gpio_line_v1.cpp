#include <gpiod.h>

#include "hal/gpio_line.hpp"

namespace hal {

struct GpioLine::Handles {
  gpiod_chip* chip = nullptr;
  gpiod_line* line = nullptr;

  ~Handles() {
    if (line) gpiod_line_release(line);
    if (chip) gpiod_chip_close(chip);
  }
};

const char* GpioLine::library() {
  return "libgpiod 1";
}

bool GpioLine::open(bool active) {
  handles_.reset();
  auto handles = std::make_shared<Handles>();
  handles->chip = gpiod_chip_open_lookup(chip_.c_str());
  if (!handles->chip) return fail("no such chip", "`gpiodetect` lists those there are");
  handles->line = gpiod_chip_get_line(handles->chip, line_);
  if (!handles->line) return fail("no such line", "`gpioinfo` lists those there are");
  const int flags = active_low_ ? GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW : 0;
  if (gpiod_line_request_output_flags(handles->line, "stickbandd", flags, active) < 0) {
    return fail("cannot take the line", "`gpioinfo` tells who has it");
  }
  handles_ = std::move(handles);
  error_.clear();
  return true;
}

bool GpioLine::set(bool active) {
  if (!handles_) return false;
  if (gpiod_line_set_value(handles_->line, active) == 0) return true;
  (void)fail("cannot drive the line", "is the chip still there?");
  handles_.reset();
  return false;
}

}  // namespace hal
