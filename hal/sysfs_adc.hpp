// A channel of an analog-to-digital converter that the kernel shows under /sys: Linux IIO
// or hwmon.
//
// The device is found by its name, never by its number; the files stay open and are read
// with pread().
//   iio    iio:deviceN/name; in_<channel>_raw, _scale and _offset (its own, else that of
//          its kind, e.g. in_voltage_scale): (raw + offset)·scale, mV or mA
//   hwmon  hwmonN/name; <channel>_input, mV (inN) or mA (currN)
#pragma once

#include <optional>
#include <string>

#include "hal/analog_input.hpp"
#include "hal/descriptor.hpp"
#include "hal/message.hpp"

namespace hal {

enum class AdcKind : unsigned char { kIio, kHwmon };

/// Of an IIO channel whose driver does not tell them; what is absent is read.
struct AdcFactors {
  std::optional<double> scale;   ///< mV or mA for each count
  std::optional<double> offset;  ///< counts
};

class SysfsAdc final : public AnalogInput {
 public:
  /// `sysfs_root`: normally "/sys". `channel`: "voltage0", "current1"; hwmon: "in0",
  /// "curr1". Of several devices with one name, `index` counts by their numbers from 0.
  SysfsAdc(AdcKind kind, std::string sysfs_root, std::string name, std::string channel,
           unsigned index = 0, AdcFactors factors = {});

  [[nodiscard]] bool open() override;
  [[nodiscard]] bool read(double& value) override;
  [[nodiscard]] const char* error() const override { return error_.c_str(); }

 private:
  bool fail(const char* what, const char* advice);
  [[nodiscard]] std::string find_device();
  bool read_factor(const std::string& folder, const char* what, double& value);

  AdcKind kind_;
  std::string root_;
  std::string name_;
  std::string channel_;
  unsigned index_;
  AdcFactors factors_;
  Descriptor raw_;
  double scale_ = 1;
  double offset_ = 0;
  Message error_;
};

}  // namespace hal
