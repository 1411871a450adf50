#include "hal/sysfs_adc.hpp"

#include <dirent.h>
#include <fcntl.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <string_view>
#include <vector>

#include "wire/decimal.hpp"

namespace hal {
namespace {

using Text = std::array<char, 64>;

// The content of a short file, without its line end; empty when it cannot be read.
std::string_view read_text(int file, Text& text) {
  const ssize_t count = pread(file, text.data(), text.size(), 0);
  std::string_view line(text.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
  while (!line.empty() && (line.back() == '\n' || line.back() == ' ')) {
    line.remove_suffix(1);
  }
  return line;
}

Descriptor open_file(const std::string& path) {
  return Descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
}

}  // namespace

SysfsAdc::SysfsAdc(AdcKind kind, std::string sysfs_root, std::string name,
                   std::string channel, unsigned index, AdcFactors factors)
    : kind_(kind),
      root_(std::move(sysfs_root)),
      name_(std::move(name)),
      channel_(std::move(channel)),
      index_(index),
      factors_(factors) {}

bool SysfsAdc::fail(const char* what, const char* advice) {
  error_.set("%s %s of %s: %s: %s; %s", kind_ == AdcKind::kIio ? "iio" : "hwmon",
             channel_.c_str(), name_.c_str(), what, std::strerror(errno), advice);
  raw_.reset();
  return false;
}

std::string SysfsAdc::find_device() {
  const bool iio = kind_ == AdcKind::kIio;
  const std::string folder = root_ + (iio ? "/bus/iio/devices/" : "/class/hwmon/");
  const std::string_view prefix = iio ? "iio:device" : "hwmon";
  std::vector<std::string> found;
  const std::unique_ptr<DIR, int (*)(DIR*)> entries(opendir(folder.c_str()), closedir);
  while (const dirent* entry = entries ? readdir(entries.get()) : nullptr) {
    if (!std::string_view(entry->d_name).starts_with(prefix)) continue;
    Text text;
    const Descriptor file = open_file(folder + entry->d_name + "/name");
    if (file.valid() && read_text(file.get(), text) == name_) {
      found.push_back(folder + entry->d_name + '/');
    }
  }
  std::sort(found.begin(), found.end(), [](const std::string& a, const std::string& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  });
  errno = ENOENT;
  return index_ < found.size() ? found[index_] : std::string();
}

bool SysfsAdc::read_factor(const std::string& folder, const char* what, double& value) {
  const std::string kind = channel_.substr(0, channel_.find_first_of("0123456789"));
  for (const std::string& channel : {channel_, kind}) {
    Text text;
    const Descriptor file = open_file(folder + "in_" + channel + '_' + what);
    if (file.valid()) return wire::parse_decimal(read_text(file.get(), text), value);
  }
  return true;
}

bool SysfsAdc::open() {
  raw_.reset();
  scale_ = factors_.scale.value_or(1);
  offset_ = factors_.offset.value_or(0);
  const std::string folder = find_device();
  if (folder.empty()) {
    return fail("no such device", "its name stands in the file `name` of the device");
  }
  const bool iio = kind_ == AdcKind::kIio;
  raw_ = open_file(folder + (iio ? "in_" + channel_ + "_raw" : channel_ + "_input"));
  if (!raw_.valid()) return fail("no such channel", "list the files of the device");
  errno = EINVAL;
  if (iio && ((!factors_.scale && !read_factor(folder, "scale", scale_)) ||
              (!factors_.offset && !read_factor(folder, "offset", offset_)))) {
    return fail("the driver does not tell scale or offset",
                "configure scale (mV or mA for each count) and offset");
  }
  error_.clear();
  return true;
}

bool SysfsAdc::read(double& value) {
  if (!raw_.valid()) return false;
  Text text;
  errno = EIO;
  double raw = 0;
  if (!wire::parse_decimal(read_text(raw_.get(), text), raw)) {
    return fail("no value", "is the device still there?");
  }
  value = (raw + offset_) * scale_;
  return true;
}

}  // namespace hal
