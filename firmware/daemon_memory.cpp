// What the daemon keeps over a restart, and takes back.
#include <algorithm>
#include <cstdlib>

#include "firmware/daemon.hpp"
#include "wire/crc32.hpp"

namespace firmware {
namespace {

constexpr std::int64_t kSameOffset_us = 1'000'000;

}  // namespace

std::size_t Daemon::save(std::span<std::uint8_t> out) const {
  for (std::size_t k = 0; k < loops_.size(); ++k) memories_[k] = loops_[k]->memory();
  return wire::write_state(status_, configured_, memories_, dtcs_, out);
}

wire::StateError Daemon::restore(std::span<const std::uint8_t> image, const Now& now) {
  std::vector<wire::LoopParameters> parameters = configured_;
  std::vector<wire::LoopMemory> memories;
  for (const auto& loop : loops_) memories.push_back(loop->memory());
  std::vector<wire::LoopStatus> status = status_;
  const wire::StateError error =
      wire::read_state(image, status, parameters, memories, dtcs_);
  if (error != wire::StateError::kNone) return error;
  for (std::size_t k = 0; k < loops_.size(); ++k) {
    if (parameters[k] != configured_[k]) loops_[k]->set_parameters(parameters[k]);
    if (!memories[k].judged) continue;
    status[k].parameters = status_[k].parameters;
    status_[k] = status[k];
    loops_[k]->restore(memories[k], now);
    dtcs_.resume(status_[k]);
    set_flag(k);
    if (!status_[k].flag) continue;
    Notice& notice = notify(NoticeKind::kFlagKept, k);
    notice.t_us = now.us;
    notice.age_s = status_[k].age_s;
  }
  return error;
}

std::size_t Daemon::save_windows(const Now& now, double least_period_s,
                                 std::span<std::uint8_t> out) {
  std::size_t at = wire::kWindowsHeaderBytes;
  std::size_t windows = 0;
  for (const auto& loop : loops_) {
    const config::Loop& configuration = loop->configuration();
    if (configuration.sample_period_s < least_period_s ||
        // Samples of before a fault would be looked at after the restart.
        kept_.take(configuration.id, loop->monitor(), now, loop->monitor().usable()) ==
            0) {
      continue;
    }
    const std::size_t end = at + wire::kWindowMarkBytes + kept_.size();
    if (end + wire::kChecksumBytes > out.size()) return 0;
    wire::encode_window_mark(loop->window_mark(),
                             out.subspan(at).first<wire::kWindowMarkBytes>());
    kept_.read(0, out.subspan(at + wire::kWindowMarkBytes, kept_.size()));
    at = end;
    ++windows;
  }
  if (windows == 0) return 0;
  wire::encode_windows_header(windows, now.epoch_us - now.us,
                              out.first<wire::kWindowsHeaderBytes>());
  return at;
}

Daemon::Resumed Daemon::restore_windows(std::span<const std::uint8_t> image,
                                        const Now& now, bool calendar) {
  wire::WindowReader windows(image);
  Resumed out{.error = windows.check()};
  if (out.error != wire::StateError::kNone) return out;
  // A clock that went on without a step since then shows the same difference to the
  // calendar: the machine was not started anew.
  const std::int64_t offset_us = now.epoch_us - now.us;
  const bool same_run = std::abs(offset_us - windows.offset_us()) < kSameOffset_us;
  if (!same_run && !calendar) return out;
  while (windows.next()) {
    const wire::RecordingHeader& window = windows.header();
    const std::int64_t length_us =
        (static_cast<std::int64_t>(window.samples) - 1) * window.period_us;
    std::int64_t first_us = static_cast<std::int64_t>(window.first_ms) * 1000 -
                            (same_run ? windows.offset_us() : offset_us);
    // The clock began with the machine: what is older came before that.
    if (!same_run) first_us = std::min(first_us, -length_us);
    for (const auto& loop : loops_) {
      if (loop->configuration().id != window.loop ||
          loop->configuration().tag != windows.mark().tag.view() ||
          !loop->resume(windows, first_us, now)) {
        continue;
      }
      const double age_s = static_cast<double>(now.us - first_us - length_us) * 1e-6;
      out.age_s = out.loops == 0 ? age_s : std::min(out.age_s, age_s);
      ++out.loops;
    }
  }
  return out;
}

}  // namespace firmware
