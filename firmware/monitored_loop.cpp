#include "firmware/monitored_loop.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "wire/big_endian.hpp"
#include "wire/crc32.hpp"

namespace firmware {
namespace {

using wire::InputStatus;
using wire::LoopVerdict;

constexpr int kSettled = 2;  // windows with the same verdict

EvaluationPace pace_of(const config::Loop& loop) {
  const auto every = static_cast<std::size_t>(loop.evaluate_every_pct);
  return {Monitor::kCapacity * every / 100, loop.evaluate_steady_pct};
}

// The one that the alarm looks at, too.
double larger_band(const wire::HistoryRow& row) {
  const wire::StrokeValues& band = row.stick_band_pct;
  return std::fmax(band.ascending, band.descending);  // the known one of two
}

// CRC-32 of what the memory of a loop holds for: span, sampling, and what is measured.
class Fingerprint {
 public:
  Fingerprint& add(double value) {
    std::array<std::uint8_t, 8> bytes{};
    wire::put_big_endian(std::bit_cast<std::uint64_t>(value), bytes);
    crc_ = wire::crc32(bytes, crc_);
    return *this;
  }
  Fingerprint& add(std::string_view text) {
    for (const char c : text) {
      const auto byte = static_cast<std::uint8_t>(c);
      crc_ = wire::crc32({&byte, 1}, crc_);
    }
    return add(static_cast<double>(text.size()));
  }
  Fingerprint& add(const config::Source& source) {
    const wire::Signal& signal = source.signal.signal;
    add(source.description)
        .add(source.signal.frame_id)
        .add(signal.start)
        .add(signal.length);
    add(signal.scale).add(signal.offset);
    add(source.scale.value_or(0)).add(source.offset.value_or(0)).add(source.shunt_ohm);
    add(source.in[0]).add(source.in[1]);
    add(static_cast<double>(source.modbus.type)).add(source.modbus.low_word_first);
    return add(source.out[0]).add(source.out[1]);
  }
  [[nodiscard]] std::uint32_t crc() const { return crc_; }

 private:
  std::uint32_t crc_ = 0;
};

std::uint32_t fingerprint(const config::Loop& loop) {
  Fingerprint out;
  out.add(Monitor::kCapacity).add(loop.sample_period_s).add(loop.gain_sign);
  out.add(loop.span[0]).add(loop.span[1]).add(loop.y_span[0]).add(loop.y_span[1]);
  return out.add(loop.u).add(loop.y).crc();
}

}  // namespace

MonitoredLoop::MonitoredLoop(const config::Loop& loop, wire::LoopStatus& status,
                             SwapWatch& swaps)
    : loop_(loop),
      status_(status),
      swaps_(swaps),
      input_(loop),
      pace_(pace_of(loop)),
      configuration_crc_(fingerprint(loop)),
      span_(loop.span, Monitor::kCapacity) {
  status_.id = static_cast<std::uint8_t>(loop.id);
  status_.tag.assign(loop.tag);
  std::string mapping = "u " + loop.u.description + "; y " + loop.y.description;
  if (loop.sp) mapping += "; sp " + loop.sp->description;
  if (loop.mode) mapping += "; mode " + loop.mode->description;
  status_.mapping.assign(mapping);
  status_.parameters = loop.parameters;
  status_.input = InputStatus::kUncertain;
  monitor_.emplace(settings());
}

ident::MonitorSettings<float> MonitoredLoop::settings() const {
  ident::MonitorSettings<float> settings;
  settings.sample_period_us = std::llround(loop_.sample_period_s * 1e6);
  settings.span_low = static_cast<float>(loop_.span[0]);
  settings.span_high = static_cast<float>(loop_.span[1]);
  settings.gain_sign = loop_.gain_sign;
  settings.evaluate_every_pct = loop_.evaluate_every_pct;
  const wire::LoopParameters& parameters = status_.parameters;
  settings.alarm = {parameters.on_delay_windows, parameters.off_delay_windows,
                    static_cast<float>(parameters.band_min_pct),
                    static_cast<float>(loop_.band_hysteresis_pct)};
  return settings;
}

void MonitoredLoop::reset() {
  begin_anew();
  row_.emplace();  // a mark: what follows is another valve's
  row_->time_s = static_cast<std::uint32_t>(std::max<std::int64_t>(ended_ms_, 0) / 1000);
  trend_.clear();
  show_trend(0);
}

void MonitoredLoop::begin_anew() {
  evaluations_ = 0;
  standing_ = LoopVerdict::kNotEvaluated;
  filled_before_ = 0;
  monitor_.emplace(settings());
  pace_ = pace_of(loop_);
  evaluating_ = asked_ = answering_ = false;
  remembered_ = false;
  swapped_ = false;
  dated_ = true;
  bands_ = {};
  band_changed_ = false;
  counted_ = false;
  forget_windows();
}

// What is not named here was said by a window, and is as new.
void MonitoredLoop::forget_windows() {
  const wire::LoopStatus old = std::exchange(status_, {});
  status_.id = old.id;
  status_.tag = old.tag;
  status_.mapping = old.mapping;
  status_.verdict = old.verdict;
  status_.confirmed = old.confirmed;
  status_.flag = old.flag;
  status_.simulated = old.simulated;
  status_.input = old.input;
  status_.trend_pct_per_day = old.trend_pct_per_day;
  status_.trend_low_pct_per_day = old.trend_low_pct_per_day;
  status_.trend_high_pct_per_day = old.trend_high_pct_per_day;
  status_.days_to_limit = old.days_to_limit;
  status_.u_pct = old.u_pct;
  status_.y_pct = old.y_pct;
  status_.sp_pct = old.sp_pct;
  status_.mode = old.mode;
  status_.parameters = old.parameters;
  status_.changed_ms = old.changed_ms;
  status_.counters = old.counters;
}

void MonitoredLoop::set_parameters(const wire::LoopParameters& parameters) {
  status_.parameters = parameters;
  begin_anew();
}

void MonitoredLoop::advance(std::int64_t until_us) {
  ident::Sample<float> sample;
  while (input_.next(until_us, sample)) {
    const ident::PushResult result = monitor_->push(sample);
    if (result == ident::PushResult::kAccepted || result == ident::PushResult::kGap) {
      const auto u = static_cast<double>(sample.u);
      pace_.push(u, static_cast<double>(sample.y));
      if (span_.push(u) && !span_told_ && span_.doubted(monitor_->report().oscillating)) {
        span_told_ = true;
        doubted_by_ = span_.range();
      }
    }
  }
}

void MonitoredLoop::write_row() {
  const std::int64_t epoch_s = ended_ms_ / 1000;
  if (epoch_s < 0 || epoch_s > std::numeric_limits<std::uint32_t>::max()) return;
  row_ = wire::history_row(status_);
  row_->time_s = static_cast<std::uint32_t>(epoch_s);
  trend_.add(epoch_s, larger_band(*row_));
  show_trend(epoch_s);
}

void MonitoredLoop::recall(std::span<const wire::HistoryRow> rows) {
  for (const wire::HistoryRow& row : rows) {
    if (row.verdict == LoopVerdict::kNotEvaluated) {
      trend_.clear();
    } else {
      trend_.add(row.time_s, larger_band(row));
    }
  }
  if (rows.empty()) return;
  // What is told before the first window has ended stands behind what is recalled.
  ended_ms_ = std::max(ended_ms_, std::int64_t{1000} * rows.back().time_s);
  show_trend(rows.back().time_s);
  new_trend_.reset();  // it was told
}

EvaluationPace::Standing MonitoredLoop::standing() const {
  const ident::MonitorReport<float> report = monitor_->report();
  const LoopVerdict verdict = standing_;
  const int alike = std::max<int>(kSettled, status_.parameters.on_delay_windows);
  // A longer window may decide what a shorter one could not.
  const bool final = verdict != LoopVerdict::kUndecided || judged_ == Monitor::kCapacity;
  return {.settled = final && report.alike_windows >= alike &&
                     report.stiction_raised == (verdict == LoopVerdict::kStiction),
          .oscillating = report.oscillating,
          .interruptions = report.counters.input_faults + report.samples.restarts +
                           report.samples.overruns,
          .judged = judged_};
}

bool MonitoredLoop::has_work() {
  if (answering_) return false;
  if (!evaluating_ && monitor_->due()) {
    evaluating_ = !pace_.waits() && pace_.begins(standing());
  }
  return evaluating_;
}

bool MonitoredLoop::evaluate(int budget) {
  if (monitor_->step(budget)) return true;
  evaluating_ = false;
  show_finished();
  return false;
}

bool MonitoredLoop::answer(int budget) {
  if (!answering_) monitor_->request_evaluation();
  asked_ = false;
  answering_ = monitor_->step_asked(budget);
  if (!answering_) show_finished();
  return answering_;
}

void MonitoredLoop::end_recording() {
  monitor_->evaluate_now();
  evaluating_ = asked_ = answering_ = false;
  show_finished();
}

void MonitoredLoop::show_finished() {
  ident::MonitorReport<float> report = monitor_->report();
  if (report.counters.evaluations == evaluations_) return;
  evaluations_ = report.counters.evaluations;
  swapped_ = swaps_.exchanged(monitor_->window(), monitor_->usable());
  if (swapped_) {
    report.verdict = ident::Verdict::kUndecided;
    report.stick_band = report.slip_jump = {};
  }
  show_window(report);
}

// After an outage the flag waits for a window, or for as much of the input as makes one
// due: less could not change what is known of the valve, and an input that comes and goes
// would make the flag come and go with it.
void MonitoredLoop::follow_input(std::int64_t now_us) {
  if (!wire::is_usable(status_.input)) {
    returning_ = true;
    judged_since_ = false;
    returned_us_ = now_us;
    return;
  }
  const double share = 0.01 * loop_.evaluate_every_pct;
  const double hop_s =
      share * static_cast<double>(Monitor::kCapacity) * loop_.sample_period_s;
  if (judged_since_ || static_cast<double>(now_us - returned_us_) >= 1e6 * hop_s) {
    returning_ = false;
  }
}

bool MonitoredLoop::refresh(const Now& now) {
  const ident::MonitorReport<float> report = monitor_->report();
  const auto before = std::tuple(status_.verdict, status_.flag, status_.input);
  const LoopVerdict verdict_before = status_.verdict;
  show_live(report, now);
  status_.input = input_status(report, now.us);
  follow_input(now.us);
  show_verdict(report);
  if (std::exchange(counted_, false)) write_row();
  if (status_.verdict != verdict_before) {
    status_.changed_ms = static_cast<double>(now.epoch_us / 1000);
  }
  return before != std::tuple(status_.verdict, status_.flag, status_.input);
}

}  // namespace firmware
