// One line that is either active or not.
#pragma once

namespace hal {

/// Life: new → open → set; the line is given back by the destructor. One thread.
class DigitalOutput {
 public:
  virtual ~DigitalOutput() = default;

  /// Takes the line and drives it to `active`. False when that is not possible now.
  [[nodiscard]] virtual bool open(bool active) = 0;
  /// Drives the line. False when it is gone: open() again.
  [[nodiscard]] virtual bool set(bool active) = 0;
  /// What went wrong last, one printable line.
  [[nodiscard]] virtual const char* error() const = 0;
};

}  // namespace hal
