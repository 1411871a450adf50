#include "firmware/state_keeper.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <vector>

#include "hal/message.hpp"

namespace firmware {

StateKeeper::StateKeeper(const config::State& settings, Log& log)
    : file_(settings.path),
      log_(log),
      period_us_(std::llround(settings.period_s * 1e6)) {}

void StateKeeper::restore(Daemon& daemon, std::int64_t now_us) {
  next_us_ = now_us + period_us_;
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
  const wire::StateError error = daemon.restore(image);
  if (error != wire::StateError::kNone) {
    text.set("%s: expected a saved state, found %s; started without it, kept as .bad",
             path, wire::describe(error));
    log_.write(now_us, Priority::kError, text.c_str());
    file_.set_aside();
    return;
  }
  remember(image);
}

void StateKeeper::remember(std::span<const std::uint8_t> image) {
  std::copy(image.end() - saved_.size(), image.end(), saved_.begin());
}

std::span<const std::uint8_t> StateKeeper::news(const Daemon& daemon) {
  const auto image = std::span(image_).first(daemon.save(image_));
  if (image.empty() ||
      std::equal(saved_.begin(), saved_.end(), image.end() - saved_.size()))
    return {};
  return image;
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
  const auto image = news(daemon);
  if (!image.empty() && file_.save(image)) remember(image);
}

void StateKeeper::finish(const Daemon& daemon) {
  const auto image = news(daemon);
  if (!image.empty()) file_.finish(image);
}

}  // namespace firmware
