// A digital output and an analog input in memory.
#pragma once

#include "hal/analog_input.hpp"
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

class FakeInput final : public AnalogInput {
 public:
  [[nodiscard]] bool open() override {
    is_open = present;
    return is_open;
  }
  [[nodiscard]] bool read(double& out) override {
    if (!present) is_open = false;
    if (is_open) out = value;
    return is_open;
  }
  [[nodiscard]] const char* error() const override {
    return "the fake channel is absent";
  }

  double value = 0;
  bool present = true;
  bool is_open = false;
};

}  // namespace hal
