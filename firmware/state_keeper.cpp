#include "firmware/state_keeper.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <vector>

#include "hal/message.hpp"
#include "wire/big_endian.hpp"
#include "wire/crc32.hpp"

namespace firmware {
namespace {

constexpr std::size_t kLoopsByte = 5;

// The kernel set its clock by one that goes on without power.
bool calendar_goes_on(const std::string& sysfs_root) {
  std::error_code error;
  const std::filesystem::directory_iterator clocks(sysfs_root + "/class/rtc", error);
  return !error && std::any_of(begin(clocks), end(clocks), [](const auto& clock) {
    std::ifstream file(clock.path() / "hctosys");
    int used = 0;
    return file >> used && used == 1;
  });
}

}  // namespace

StateKeeper::StateKeeper(const config::Gateway& gateway, Log& log)
    : file_(gateway.state->path,
            wire::windows_bytes(gateway.loops.size(), Monitor::kCapacity)),
      log_(log),
      sysfs_root_(gateway.sysfs_root),
      period_us_(std::llround(gateway.state->period_s * 1e6)) {}

void StateKeeper::restore(Daemon& daemon, const Now& now) {
  next_us_ = now.us + period_us_;
  windows_us_ = samples_us_ = now.us + kWindows_us;
  restore_state(daemon, now);
  restore_windows(daemon, now);
}

void StateKeeper::restore_windows(Daemon& daemon, const Now& now) {
  const char* path = file_.windows_path().c_str();
  hal::Message text;
  std::vector<std::uint8_t> image;
  bool exists = false;
  if (!file_.read_windows(image, exists)) {
    text.set("%s: cannot be read: %s; windows begin anew", path, std::strerror(errno));
    log_.write(now.us, Priority::kError, text.c_str());
    return;
  }
  if (!exists) return;
  const Daemon::Resumed found =
      daemon.restore_windows(image, now, calendar_goes_on(sysfs_root_));
  if (found.error != wire::StateError::kNone) {
    text.set("%s: expected windows, found %s; they begin anew, kept as .bad", path,
             wire::describe(found.error));
    log_.write(now.us, Priority::kError, text.c_str());
    file_.set_windows_aside();
    return;
  }
  if (found.loops == 0) {
    text.set("%s: of another configuration or of unknown age; windows begin anew", path);
  } else {
    text.set("windows of samples that are back: %d; the newest sample is %.1f s old",
             found.loops, found.age_s);
  }
  log_.write(now.us, Priority::kNotice, text.c_str());
}

void StateKeeper::restore_state(Daemon& daemon, const Now& now) {
  const std::int64_t now_us = now.us;
  const char* path = file_.path().c_str();
  hal::Message text;
  std::vector<std::uint8_t> image;
  bool exists = false;
  if (!file_.read(image, exists)) {
    text.set("%s: cannot be read: %s; started without it", path, std::strerror(errno));
    log_.write(now_us, Priority::kError, text.c_str());
    return;
  }
  if (!exists) {
    text.set("%s: no saved state; DTCs begin anew", path);
    log_.write(now_us, Priority::kNotice, text.c_str());
    return;
  }
  const wire::StateError error = daemon.restore(image, now);
  if (error != wire::StateError::kNone) {
    text.set("%s: expected a saved state, found %s; started without it, kept as .bad",
             path, wire::describe(error));
    log_.write(now_us, Priority::kError, text.c_str());
    file_.set_aside();
    return;
  }
  saved_ = checksums(image, image[kLoopsByte]);
}

StateKeeper::Checksums StateKeeper::checksums(std::span<const std::uint8_t> image,
                                              std::size_t loops) {
  return {wire::crc32(image.first(wire::urgent_bytes(loops))),
          static_cast<std::uint32_t>(wire::get_big_endian(image.last(4)))};
}

std::span<const std::uint8_t> StateKeeper::news(const Daemon& daemon, bool all) {
  const auto image = std::span(image_).first(daemon.save(image_));
  if (image.empty()) return {};
  const Checksums now = checksums(image, daemon.loops().size());
  const bool changed = now.urgent != saved_.urgent || (all && now.all != saved_.all);
  return changed ? image : std::span<const std::uint8_t>();
}

void StateKeeper::keep(Daemon& daemon, const Now& now) {
  keep_state(daemon, now.us);
  if (now.us < samples_us_) return;
  const auto bytes = static_cast<double>(save_windows(daemon, now, kSlow_s));
  constexpr double kDay_us = 86'400e6;
  samples_us_ = now.us + std::max<std::int64_t>(
                             kWindows_us, std::llround(bytes / kMostDaily * kDay_us));
}

std::size_t StateKeeper::save_windows(Daemon& daemon, const Now& now,
                                      double least_period_s) {
  const std::size_t size =
      daemon.save_windows(now, least_period_s, file_.room_for_windows());
  if (size > 0) file_.save_windows(size);
  return size;
}

void StateKeeper::keep_state(const Daemon& daemon, std::int64_t now_us) {
  if (now_us < next_us_) return;
  next_us_ = now_us + period_us_;
  if (file_.failures() != failures_) {
    failures_ = file_.failures();
    if (!failing_) {
      hal::Message text;
      text.set("%s: cannot be written: %s; it stays as it was", file_.path().c_str(),
               std::strerror(file_.error()));
      log_.write(now_us, Priority::kError, text.c_str());
    }
    failing_ = true;
    saved_ = {};  // which is not in the file: once more
  } else {
    failing_ = false;
  }
  const bool all = now_us >= windows_us_;
  const auto image = news(daemon, all);
  if (image.empty() || !file_.save(image)) return;
  saved_ = checksums(image, daemon.loops().size());
  windows_us_ = now_us + kWindows_us;
}

void StateKeeper::finish(Daemon& daemon, const Now& now) {
  const auto image = news(daemon, true);
  if (!image.empty()) file_.finish(image);
  file_.settle();
  (void)save_windows(daemon, now, 0);
  file_.settle();
}

}  // namespace firmware
