#include <dirent.h>
#include <gpiod.h>

#include <cerrno>
#include <cstring>

#include "hal/gpio_line.hpp"

namespace hal {
namespace {

template <class T, void (*kFree)(T*)>
struct Freer {
  void operator()(T* object) const { kFree(object); }
};
template <class T, void (*kFree)(T*)>
using Owner = std::unique_ptr<T, Freer<T, kFree>>;

using Chip = Owner<gpiod_chip, gpiod_chip_close>;
using Info = Owner<gpiod_chip_info, gpiod_chip_info_free>;
using Settings = Owner<gpiod_line_settings, gpiod_line_settings_free>;
using LineConfig = Owner<gpiod_line_config, gpiod_line_config_free>;
using RequestConfig = Owner<gpiod_request_config, gpiod_request_config_free>;
using Request = Owner<gpiod_line_request, gpiod_line_request_release>;

// By path, else by name or label: this generation of the library has no such search.
Chip find_chip(const std::string& wanted) {
  if (wanted.find('/') != std::string::npos) return Chip(gpiod_chip_open(wanted.c_str()));
  const std::unique_ptr<DIR, int (*)(DIR*)> folder(opendir("/dev"), closedir);
  while (const dirent* entry = folder ? readdir(folder.get()) : nullptr) {
    if (std::strncmp(entry->d_name, "gpiochip", 8) != 0) continue;
    Chip chip(gpiod_chip_open((std::string("/dev/") + entry->d_name).c_str()));
    const Info info(chip ? gpiod_chip_get_info(chip.get()) : nullptr);
    if (info && (wanted == gpiod_chip_info_get_name(info.get()) ||
                 wanted == gpiod_chip_info_get_label(info.get()))) {
      return chip;
    }
  }
  errno = ENOENT;
  return nullptr;
}

}  // namespace

struct GpioLine::Handles {
  Request request;
};

const char* GpioLine::library() {
  return "libgpiod 2";
}

bool GpioLine::open(bool active) {
  handles_.reset();
  const Chip chip = find_chip(chip_);
  if (!chip) return fail("no such chip", "`gpiodetect` lists those there are");
  const Settings settings(gpiod_line_settings_new());
  const LineConfig lines(gpiod_line_config_new());
  const RequestConfig request(gpiod_request_config_new());
  if (!settings || !lines || !request) return fail("no memory", "free some");
  gpiod_line_settings_set_direction(settings.get(), GPIOD_LINE_DIRECTION_OUTPUT);
  gpiod_line_settings_set_active_low(settings.get(), active_low_);
  gpiod_line_settings_set_output_value(
      settings.get(), active ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE);
  gpiod_line_config_add_line_settings(lines.get(), &line_, 1, settings.get());
  gpiod_request_config_set_consumer(request.get(), "stickbandd");
  Request taken(gpiod_chip_request_lines(chip.get(), request.get(), lines.get()));
  if (!taken) return fail("cannot take the line", "`gpioinfo` tells who has it");
  handles_ = std::make_shared<Handles>(Handles{std::move(taken)});
  error_.clear();
  return true;
}

bool GpioLine::set(bool active) {
  if (!handles_) return false;
  const auto value = active ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE;
  if (gpiod_line_request_set_value(handles_->request.get(), line_, value) == 0)
    return true;
  (void)fail("cannot drive the line", "is the chip still there?");
  handles_.reset();
  return false;
}

}  // namespace hal
