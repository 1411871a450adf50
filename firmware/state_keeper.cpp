#include "firmware/state_keeper.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

#include "wire/big_endian.hpp"
#include "wire/calendar.hpp"
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
      period_us_(std::llround(gateway.state->period_s * 1e6)),
      slow_(std::ranges::any_of(
          gateway.loops,
          [](const config::Loop& loop) { return loop.sample_period_s >= kSlow_s; })),
      pause_us_(period_us_) {}

void StateKeeper::restore(Daemon& daemon, const Now& now) {
  next_us_ = now.us + period_us_;
  samples_us_ = now.us + kMinute_us;
  restore_state(daemon, now);
  restore_windows(daemon, now);
}

void StateKeeper::restore_windows(Daemon& daemon, const Now& now) {
  const char* path = file_.windows_path().c_str();
  std::vector<std::uint8_t> image;
  bool exists = false;
  if (!file_.read_windows(image, exists)) {
    log_.print(now.us, Priority::kError, "%s: cannot be read: %s; windows begin anew",
               path, std::strerror(errno));
    return;
  }
  if (!exists) return;
  const Daemon::Resumed found =
      daemon.restore_windows(image, now, calendar_goes_on(sysfs_root_));
  if (found.error != wire::StateError::kNone) {
    log_.print(now.us, Priority::kError,
               "%s: expected windows, found %s; they begin anew, kept as .bad", path,
               wire::describe(found.error));
    file_.set_windows_aside();
    return;
  }
  if (found.loops == 0) {
    log_.print(now.us, Priority::kNotice,
               "%s: of another configuration or of unknown age; windows begin anew",
               path);
  } else {
    log_.print(now.us, Priority::kNotice,
               "windows of samples that are back: %d; the newest sample is %.1f s old",
               found.loops, found.age_s);
  }
}

void StateKeeper::restore_state(Daemon& daemon, const Now& now) {
  const std::int64_t now_us = now.us;
  const char* path = file_.path().c_str();
  std::vector<std::uint8_t> image;
  bool exists = false;
  if (!file_.read(image, exists)) {
    log_.print(now_us, Priority::kError, "%s: cannot be read: %s; started without it",
               path, std::strerror(errno));
    return;
  }
  if (!exists) {
    log_.print(now_us, Priority::kNotice, "%s: no saved state; DTCs begin anew", path);
    return;
  }
  const wire::StateError error = daemon.restore(image, now);
  if (error != wire::StateError::kNone) {
    log_.print(now_us, Priority::kError,
               "%s: expected a saved state, found %s; started without it, kept as .bad",
               path, wire::describe(error));
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

Haste StateKeeper::haste_of(const Daemon& daemon) {
  size_ = daemon.save(image_);
  if (size_ == 0) return Haste::kNone;
  const Checksums now = checksums(std::span(image_).first(size_), daemon.loops().size());
  if (now.urgent != saved_.urgent) return Haste::kNow;
  return now.all != saved_.all ? Haste::kLater : Haste::kNone;
}

bool StateKeeper::save(const Daemon& daemon) {
  if (haste_of(daemon) == Haste::kNone) return false;
  const auto image = std::span(image_).first(size_);
  if (!file_.save(image)) return false;
  saved_ = checksums(image, daemon.loops().size());
  return true;
}

void StateKeeper::keep(Daemon& daemon, const Now& now, WriteBudget& budget) {
  keep_state(daemon, now.us, budget);
  if (slow_) keep_windows(daemon, now, budget);
}

void StateKeeper::keep_windows(Daemon& daemon, const Now& now, WriteBudget& budget) {
  const bool due = now.us >= samples_us_ && !file_.room_for_windows().empty();
  if (!budget.may_write(Written::kWindows, due ? Haste::kSoon : Haste::kNone, now.us)) {
    return;
  }
  const std::size_t size = save_windows(daemon, now, kSlow_s);
  if (size == 0) budget.give_back(1);
  constexpr double kDay_us = 1e6 * wire::kDayS;
  samples_us_ =
      now.us + std::max<std::int64_t>(kMinute_us, std::llround(static_cast<double>(size) /
                                                               kMostDaily * kDay_us));
}

std::size_t StateKeeper::save_windows(Daemon& daemon, const Now& now,
                                      double least_period_s) {
  const std::size_t size =
      daemon.save_windows(now, least_period_s, file_.room_for_windows());
  if (size > 0) file_.save_windows(size);
  return size;
}

void StateKeeper::tell_failure(std::int64_t now_us, const char* consequence) {
  log_.print(now_us, Priority::kError, "%s: cannot be written: %s; %s",
             file_.path().c_str(), std::strerror(file_.error()), consequence);
}

void StateKeeper::take_failures(std::int64_t now_us, WriteBudget& budget) {
  const std::uint32_t failures = file_.failures() - failures_;
  failures_ += failures;
  const std::uint32_t writes = file_.writes();
  if (std::exchange(writes_, writes) == writes) return;
  if (failures > 0 && !failing_) {
    tell_failure(now_us, "it stays as it was");
  }
  failing_ = failures > 0;
  if (!failing_) {
    pause_us_ = period_us_;
    return;
  }
  saved_ = {};  // which is not in the file: once more
  budget.give_back(static_cast<int>(failures));
  pause_us_ = std::max(period_us_, std::min(2 * pause_us_, kMinute_us));
}

void StateKeeper::keep_state(const Daemon& daemon, std::int64_t now_us,
                             WriteBudget& budget) {
  const bool look = now_us >= next_us_;
  const bool saving = (look || haste_ != Haste::kNone) && file_.saving();
  if (look && !saving) {
    take_failures(now_us, budget);
    next_us_ = now_us + pause_us_;
    haste_ = haste_of(daemon);
  }
  if (!budget.may_write(Written::kState, saving ? Haste::kNone : haste_, now_us)) return;
  if (!save(daemon)) budget.give_back(1);
  haste_ = Haste::kNone;
}

void StateKeeper::finish(Daemon& daemon, const Now& now) {
  file_.settle();
  const std::uint32_t failures = file_.failures();
  (void)save(daemon);
  (void)save_windows(daemon, now, 0);
  file_.settle();
  if (file_.failures() != failures) {
    tell_failure(now.us, "the next start goes on from what was saved before");
  }
}

}  // namespace firmware
