#include "firmware/state_keeper.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <vector>

#include "hal/message.hpp"
#include "wire/big_endian.hpp"
#include "wire/crc32.hpp"

namespace firmware {
namespace {

constexpr std::size_t kLoopsByte = 5;

}  // namespace

StateKeeper::StateKeeper(const config::State& settings, Log& log)
    : file_(settings.path),
      log_(log),
      period_us_(std::llround(settings.period_s * 1e6)) {}

void StateKeeper::restore(Daemon& daemon, const Now& now) {
  const std::int64_t now_us = now.us;
  next_us_ = now_us + period_us_;
  windows_us_ = now_us + kWindows_us;
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

void StateKeeper::keep(const Daemon& daemon, std::int64_t now_us) {
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

void StateKeeper::finish(const Daemon& daemon) {
  const auto image = news(daemon, true);
  if (!image.empty()) file_.finish(image);
}

}  // namespace firmware
