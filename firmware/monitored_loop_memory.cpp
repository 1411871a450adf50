// What a loop keeps over a restart, and takes back.
#include <algorithm>
#include <cmath>

#include "firmware/monitored_loop.hpp"

namespace firmware {

wire::LoopMemory MonitoredLoop::memory() const {
  return {.judged = remembered_ && dated_,
          .configuration = configuration_crc_,
          .ended_ms = ended_ms_,
          .evidence_ms = evidence_ms_,
          .standing = standing_,
          .standing_samples = static_cast<std::uint16_t>(judged_),
          .told_bands = bands_.told(),
          .monitor = monitor_->memory()};
}

void MonitoredLoop::restore(const wire::LoopMemory& memory, const Now& now) {
  const std::int64_t now_ms = now.epoch_us / 1000;
  const double passed_s = static_cast<double>(now_ms - memory.evidence_ms) * 1e-3;
  const double window_s = loop_.sample_period_s * static_cast<double>(Monitor::kCapacity);
  monitor_->restore(memory.monitor,
                    static_cast<float>(std::max(passed_s, 0.0) / window_s));
  remembered_ = dated_ = true;
  ended_ms_ = memory.ended_ms;
  evidence_ms_ = std::max(memory.evidence_ms, now_ms);
  standing_ = memory.standing;
  judged_ = memory.standing_samples;
  bands_.restore(memory.told_bands);
  const ident::MonitorReport<float> report = monitor_->report();
  status_.age_s = age_of(report, now);
  show_verdict(report);
}

wire::WindowMark MonitoredLoop::window_mark() const {
  return {.tag = status_.tag,
          .configuration = configuration_crc_,
          .judged_ms = remembered_ ? ended_ms_ : 0,
          .unjudged = static_cast<std::uint32_t>(monitor_->unjudged())};
}

bool MonitoredLoop::resume(const wire::WindowReader& kept, std::int64_t first_us,
                           const Now& now) {
  using Window = ident::SampleWindow<float, Monitor::kCapacity>;
  const wire::RecordingHeader& window = kept.header();
  const std::int64_t newest_us =
      first_us + (static_cast<std::int64_t>(window.samples) - 1) * window.period_us;
  if (kept.mark().configuration != configuration_crc_ || window.samples == 0 ||
      newest_us > now.us) {
    return false;
  }
  for (std::uint32_t k = 0; k < window.samples; ++k) {
    const wire::RecordingSample values = kept.sample(k);
    ident::Sample<float> sample;
    sample.t_us = first_us + static_cast<std::int64_t>(k) * window.period_us;
    sample.u = values.u;
    sample.y = values.y;
    sample.has_sp = std::isfinite(values.sp);
    sample.sp = sample.has_sp ? values.sp : 0.0F;
    (void)monitor_->push(sample);
  }
  const std::int64_t gap_us = now.us - newest_us;
  if (gap_us < Window::kDefaultHold * monitor_->window().period_us()) {
    input_.resume(newest_us);
  }
  // An evidence of another time knows an unknown part of the samples: all of them, then.
  const bool same = kept.mark().judged_ms == (remembered_ ? ended_ms_ : 0);
  const std::size_t all = remembered_ ? 0 : window.samples;
  monitor_->resume(same ? kept.mark().unjudged : all);
  return true;
}

}  // namespace firmware
