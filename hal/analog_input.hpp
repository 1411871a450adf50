// One analog value, in the unit of the channel.
#pragma once

namespace hal {

/// Life: new → (start) → open → read. Reading blocks for one conversion at most
/// (milliseconds). One thread; read() does not allocate.
class AnalogInput {
 public:
  virtual ~AnalogInput() = default;

  /// Begins what open() would wait for, where it waits for anything.
  virtual void start() {}
  /// Finds the device. False when it is not there now; error() says why.
  [[nodiscard]] virtual bool open() = 0;
  /// The value now: mV of a voltage channel, mA of a current channel. False when the
  /// device does not answer: open() again.
  [[nodiscard]] virtual bool read(double& value) = 0;
  /// What went wrong last, one printable line.
  [[nodiscard]] virtual const char* error() const = 0;
};

}  // namespace hal
