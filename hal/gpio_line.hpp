// One line of a GPIO chip, through libgpiod.
//
// gpio_line_v1.cpp and gpio_line_v2.cpp are the same class on the two generations of the
// library; CMake builds one.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "hal/digital_output.hpp"
#include "hal/message.hpp"

namespace hal {

class GpioLine final : public DigitalOutput {
 public:
  /// `chip`: name ("gpiochip0"), label or path.
  GpioLine(std::string chip, unsigned line, bool active_low)
      : chip_(std::move(chip)), line_(line), active_low_(active_low) {}
  GpioLine(const GpioLine&) = delete;  // one holds the line
  GpioLine& operator=(const GpioLine&) = delete;

  [[nodiscard]] bool open(bool active) override;
  [[nodiscard]] bool set(bool active) override;
  [[nodiscard]] const char* error() const override { return error_.c_str(); }

  /// The generation of libgpiod it was built against, e.g. "libgpiod 2"; "none".
  [[nodiscard]] static const char* library();

 private:
  struct Handles;
  bool fail(const char* what, const char* advice);

  std::string chip_;
  unsigned line_;
  bool active_low_;
  std::shared_ptr<Handles> handles_;  // not known here, nor how to release them
  Message error_;
};

}  // namespace hal
