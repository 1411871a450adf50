// A digital output in memory.
#pragma once

#include "hal/digital_output.hpp"

namespace hal {

class FakeOutput final : public DigitalOutput {
 public:
  [[nodiscard]] bool open(bool active) override {
    is_open = present;
    return is_open && set(active);
  }
  [[nodiscard]] bool set(bool active) override {
    if (!present) is_open = false;
    if (!is_open) return false;
    changes += active != level;
    level = active;
    return true;
  }
  [[nodiscard]] const char* error() const override { return "the fake line is absent"; }

  bool present = true;
  bool is_open = false;
  bool level = false;
  int changes = 0;
};

}  // namespace hal
