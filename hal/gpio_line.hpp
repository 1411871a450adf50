// One line of a GPIO chip, through libgpiod.
//
// gpio_line_v1.cpp and gpio_line_v2.cpp are the same class on the two generations of the
// library; CMake builds one.
#pragma once

#include <memory>
#include <string>

#include "hal/digital_output.hpp"
#include "hal/message.hpp"

namespace hal {

class GpioLine final : public DigitalOutput {
 public:
  /// `chip`: name ("gpiochip0"), label or path.
  GpioLine(std::string chip, unsigned line, bool active_low);
  ~GpioLine() override;

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
  std::unique_ptr<Handles> handles_;
  Message error_;
};

}  // namespace hal
