#include "firmware/daemon.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace firmware {
namespace {

constexpr std::int64_t kStepEvery_us = 100'000;       // at least
constexpr std::int64_t kRefreshEvery_us = 10'000;     // at most
constexpr std::int64_t kBroadcastApart_us = 100'000;  // on change, at least
constexpr std::uint32_t kExtendedBit = std::uint32_t{1} << 31;
constexpr std::uint32_t kErrorBusOff = 0x40;  // of linux/can/error.h
constexpr std::uint32_t kErrorRestarted = 0x100;

std::uint32_t key_of(std::uint32_t id, bool extended) {
  return extended ? id | kExtendedBit : id;
}

}  // namespace

Daemon::Daemon(const config::Gateway& configuration, Random& random, const char* version)
    : configuration_(configuration),
      random_(random),
      status_(configuration.loops.size()),
      memories_(configuration.loops.size()),
      buses_(configuration.buses.size()),
      bus_off_(configuration.buses.size()),
      sent_us_(configuration.loops.size()),
      changed_(configuration.loops.size(), true) {
  gateway_.name.assign(configuration.name);
  gateway_.software_version.assign(version);
  gateway_.config_crc32 = configuration.crc32;
  for (std::size_t k = 0; k < status_.size(); ++k) {
    loops_.push_back(
        std::make_unique<MonitoredLoop>(configuration.loops[k], status_[k], swaps_));
    configured_.push_back(configuration.loops[k].parameters);
    flags_[k] = configuration.loops[k].flag && configuration.loops[k].flag->fail_safe;
  }
  build_routes();
  if (const auto& uds = configuration.uds) {
    const wire::IsoTpSettings link{.request_id = uds->request_id,
                                   .response_id = uds->response_id,
                                   .functional_id = uds->functional_id,
                                   .extended_ids = uds->extended_ids,
                                   .block_size = uds->block_size,
                                   .st_min = uds->st_min};
    const wire::UdsSettings settings{
        .writes = uds->writes, .has_key = uds->has_key, .key = uds->key};
    wire::UdsActions& actions = *this;
    uds_ = std::make_unique<wire::UdsConnection>(link, settings, gateway_, status_, dtcs_,
                                                 actions);
  }
}

void Daemon::build_routes() {
  for (std::size_t k = 0; k < loops_.size(); ++k) {
    for (std::size_t r = 0; r < kRoles; ++r) {
      const auto role = static_cast<Role>(r);
      const config::Source* source = source_of(configuration_.loops[k], role);
      if (!source) continue;
      if (source->kind == config::SourceKind::kCan) {
        const wire::FrameSignal& signal = source->signal;
        routes_.push_back({source->bus, signal.ignored,
                           key_of(signal.frame_id, signal.extended), k, role});
        if (std::ranges::find(ignored_, signal.ignored) == ignored_.end()) {
          ignored_.push_back(signal.ignored);
        }
      } else {
        points_.push_back({k, role});
      }
    }
  }
  std::ranges::sort(routes_, [](const Route& a, const Route& b) {
    return std::tie(a.bus, a.ignored, a.key, a.loop, a.role) <
           std::tie(b.bus, b.ignored, b.key, b.loop, b.role);
  });
}

std::vector<hal::CanFilter> Daemon::filters(std::size_t bus) const {
  std::vector<hal::CanFilter> filters;
  for (const Route& route : routes_) {
    const hal::CanFilter filter{route.key & ~kExtendedBit,
                                (route.key & kExtendedBit) != 0,
                                wire::kMaxExtendedId & ~route.ignored};
    const bool repeated = !filters.empty() && filters.back().id == filter.id &&
                          filters.back().mask == filter.mask &&
                          filters.back().extended == filter.extended;
    if (route.bus == bus && !repeated) filters.push_back(filter);
  }
  const auto& uds = configuration_.uds;
  if (uds && uds->bus == bus) {
    for (const wire::IsoTpFilter& filter : uds_->link().filters()) {
      filters.push_back({filter.id, filter.extended, filter.mask});
    }
  }
  return filters;
}

Notice& Daemon::notify(NoticeKind kind, std::size_t index) {
  Notice& notice = notices_[notice_count_];
  if (notice_count_ < kMostNotices) ++notice_count_;
  return notice = {.kind = kind, .t_us = now_.us, .index = index};
}

void Daemon::send(std::size_t bus, const wire::CanFrame& frame) {
  if (frame_count_ < kMostFrames) frames_[frame_count_++] = {bus, frame};
}

void Daemon::take_bus(std::size_t bus, const BusState& state) {
  BusState& known = buses_[bus];
  if (state.up != known.up) {
    notify(state.up ? NoticeKind::kBusUp : NoticeKind::kBusDown, bus);
    if (!state.up && uds_ && configuration_.uds->bus == bus) uds_->reset();
  }
  const std::uint64_t lost = state.drops - known.drops;
  if (lost > 0) {
    // Whose frames they were cannot be known: every loop on the bus may miss some.
    std::size_t newest = loops_.size();
    for (const Route& route : routes_) {
      if (route.bus != bus || route.loop == newest) continue;
      newest = route.loop;
      loops_[newest]->input().take_drops(
          now_.us, static_cast<std::uint32_t>(std::min<std::uint64_t>(lost, 1U << 30)));
    }
  }
  known = state;
}

void Daemon::take_frame(const BusFrame& in) {
  if (in.frame.error) {
    const bool off = (in.frame.id & kErrorBusOff) != 0;
    if (off && !bus_off_[in.bus]) {
      notify(NoticeKind::kBusOff, in.bus).t_us = in.t_us;
    }
    bus_off_[in.bus] = off && (in.frame.id & kErrorRestarted) == 0;
    return;
  }
  bus_off_[in.bus] = false;
  if (uds_ && configuration_.uds->bus == in.bus) uds_->on_frame(in.frame, now_.us);
  for (const std::uint32_t ignored : ignored_) {
    take_signals(in, ignored, key_of(in.frame.id, in.frame.extended) & ~ignored);
  }
}

void Daemon::take_signals(const BusFrame& in, std::uint32_t ignored, std::uint32_t key) {
  const auto first = std::lower_bound(
      routes_.begin(), routes_.end(), std::tuple(in.bus, ignored, key),
      [](const Route& route,
         const std::tuple<std::size_t, std::uint32_t, std::uint32_t>& sought) {
        return std::tuple(route.bus, route.ignored, route.key) < sought;
      });
  for (auto route = first; route != routes_.end() && route->bus == in.bus &&
                           route->ignored == ignored && route->key == key;
       ++route) {
    MonitoredLoop& loop = *loops_[route->loop];
    loop.advance(in.t_us - 1);
    loop.input().take_frame(route->role, in.t_us, in.frame);
  }
}

void Daemon::take_reading(const AnalogReading& reading) {
  const AnalogPoint& point = points_[reading.point];
  MonitoredLoop& loop = *loops_[point.loop];
  loop.advance(reading.t_us - 1);
  loop.input().take_reading(point.role, reading.t_us, reading.ok, reading.value);
}

void Daemon::tell_mode(std::size_t index, wire::LoopMode before) {
  const wire::LoopMode mode = status_[index].mode;
  const bool suspended = mode == wire::LoopMode::kManual;
  if (suspended == (before == wire::LoopMode::kManual)) return;
  notify(suspended ? NoticeKind::kSuspended : NoticeKind::kResumed, index).mode =
      loops_[index]->live(Role::kMode);
}

void Daemon::tell_findings(std::size_t index) {
  MonitoredLoop& loop = *loops_[index];
  if (const auto trend = loop.new_trend()) {
    notify(NoticeKind::kTrend, index).trend = *trend;
  }
  if (const auto slow = loop.new_slow_signal()) {
    notify(NoticeKind::kSlowSignal, index).slow = *slow;
  }
  if (const auto senders = loop.new_two_senders()) {
    notify(NoticeKind::kTwoSenders, index).senders = *senders;
  }
  if (const auto range = loop.span_doubted()) {
    notify(NoticeKind::kSpanDoubted, index).u_range = *range;
  }
  if (loop.signals_swapped()) {
    notify(NoticeKind::kSignalsSwapped, index);
  }
  if (loop.band_changed()) {
    Notice& notice = notify(NoticeKind::kBandChanged, index);
    notice.band_low_pct = status_[index].stick_band_low_pct;
    notice.band_high_pct = status_[index].stick_band_high_pct;
    changed_[index] = true;
  }
}

void Daemon::refresh(std::size_t index) {
  MonitoredLoop& loop = *loops_[index];
  const wire::LoopStatus& status = status_[index];
  const wire::InputStatus input_before = status.input;
  const bool flag_before = status.flag;
  const wire::LoopMode mode_before = status.mode;
  loop.advance(now_.us);
  const bool changed = loop.refresh(now_);
  while (const auto event = loop.poll()) {
    // The loop's own view of its inputs includes that of its monitor.
    if (event->kind == ident::EventKind::kInputFault ||
        event->kind == ident::EventKind::kInputRestored) {
      continue;
    }
    Notice& notice = notify(NoticeKind::kMonitor, index);
    notice.t_us = event->t_us;
    notice.event = *event;
  }
  if (wire::is_usable(status.input) != wire::is_usable(input_before)) {
    const bool restored = wire::is_usable(status.input);
    Notice& notice =
        notify(restored ? NoticeKind::kInputRestored : NoticeKind::kInputFault, index);
    notice.input = restored ? input_before : status.input;
    if (status.input == wire::InputStatus::kOutOfRange) notice.far = loop.far_signal();
  }
  tell_mode(index, mode_before);
  if (const auto row = loop.take_row()) rows_[row_count_++] = {status.id, *row};
  tell_findings(index);
  if (status.flag != flag_before) {
    notify(!status.flag             ? NoticeKind::kFlagLowered
           : loop.rests_on_before() ? NoticeKind::kFlagKept
                                    : NoticeKind::kFlagRaised,
           index)
        .age_s = status.age_s;
  }
  if (changed) changed_[index] = true;
  dtcs_.update(status);
  set_flag(index);
}

void Daemon::set_flag(std::size_t index) {
  const wire::LoopStatus& status = status_[index];
  const auto& flag = configuration_.loops[index].flag;
  const bool unknown = status.verdict == wire::LoopVerdict::kNotEvaluated ||
                       status.verdict == wire::LoopVerdict::kInputInvalid;
  flags_[index] = status.flag || (flag && flag->fail_safe && unknown);
}

void Daemon::serve() {
  if (!uds_) return;
  const std::size_t bus = configuration_.uds->bus;
  if (!may_send(bus)) {
    uds_->wait(now_.us);
    return;
  }
  while (frame_count_ < kMostFrames) {
    const auto frame = uds_->poll(now_.us);
    if (!frame) return;
    send(bus, *frame);
  }
}

void Daemon::broadcast() {
  if (!configuration_.broadcast) return;
  const config::Broadcast& settings = *configuration_.broadcast;
  if (!may_send(settings.bus)) return;
  const std::int64_t period_us = std::llround(settings.period_s * 1e6);
  const std::size_t frames = settings.detail_base_id ? wire::kBroadcastFrames : 1;
  for (std::size_t k = 0; k < loops_.size() && frame_count_ + frames <= kMostFrames;
       ++k) {
    const std::int64_t age_us = now_.us - sent_us_[k];
    if (age_us < (changed_[k] ? std::min(period_us, kBroadcastApart_us) : period_us)) {
      continue;
    }
    sent_us_[k] = now_.us;
    changed_[k] = false;
    broadcast_loop(k);
  }
}

void Daemon::broadcast_loop(std::size_t index) {
  const config::Broadcast& settings = *configuration_.broadcast;
  const wire::LoopStatus& status = status_[index];
  send(settings.bus, wire::broadcast_frame(status, settings.base_id));
  if (!settings.detail_base_id) return;
  for (int frame = 2; frame <= wire::kBroadcastFrames; ++frame) {
    send(settings.bus, wire::detail_frame(frame, status, *settings.detail_base_id));
  }
}

const Outputs& Daemon::step(const Now& now, const Inputs& inputs) {
  now_ = now;
  const bool first = !started_;  // what restore() has to tell is told with it
  if (first) {
    started_ = true;
    start_us_ = now.us;
    refreshed_us_ = now.us - kRefreshEvery_us;
    std::ranges::fill(sent_us_, now.us - kBroadcastApart_us);
  }
  frame_count_ = row_count_ = 0;
  if (!first) notice_count_ = 0;
  gateway_.textfile_failures = inputs.failures.textfile;
  gateway_.state_failures = inputs.failures.state;
  gateway_.history_failures = inputs.failures.history;
  gateway_.uptime_s = static_cast<double>(now.us - start_us_) * 1e-6;
  for (std::size_t k = 0; k < buses_.size() && k < inputs.buses.size(); ++k) {
    take_bus(k, inputs.buses[k]);
  }
  for (const BusFrame& frame : inputs.frames) take_frame(frame);
  for (const AnalogReading& reading : inputs.readings) take_reading(reading);
  if (now.us >= refreshed_us_ + kRefreshEvery_us || !inputs.readings.empty()) {
    refreshed_us_ = now.us;
    for (std::size_t k = 0; k < loops_.size(); ++k) refresh(k);
  }
  serve();
  broadcast();
  outputs_.frames = std::span(frames_).first(frame_count_);
  outputs_.flags = flags();
  outputs_.notices = std::span(notices_).first(notice_count_);
  outputs_.rows = std::span(rows_).first(row_count_);
  outputs_.next_us = now.us + kStepEvery_us;
  // Without room nothing is due: who has the bus looks again soon.
  if (uds_ && may_send(configuration_.uds->bus)) {
    if (const auto next = uds_->next_us())
      outputs_.next_us = std::min(outputs_.next_us, *next);
  }
  return outputs_;
}

bool Daemon::work(int budget) {
  charged_ = false;
  const bool answering = loops_[asked_turn_]->answering();
  for (std::size_t tried = 0; tried < loops_.size() && !answering; ++tried) {
    if (loops_[turn_]->has_work()) {
      (void)loops_[turn_]->evaluate(budget);
      return true;
    }
    turn_ = turn_ + 1 < loops_.size() ? turn_ + 1 : 0;
  }
  if (!answering && !next_request()) return false;
  charged_ = true;
  (void)loops_[asked_turn_]->answer(budget);
  return true;
}

bool Daemon::next_request() {
  for (std::size_t tried = 0; tried < loops_.size(); ++tried) {
    asked_turn_ = asked_turn_ + 1 < loops_.size() ? asked_turn_ + 1 : 0;
    if (loops_[asked_turn_]->asked()) return requests_.may_begin(now_.us);
  }
  return false;
}

void Daemon::charge(std::int64_t us) {
  if (charged_) requests_.spend(us);
}

void Daemon::evaluate_all() {
  for (const auto& loop : loops_) loop->end_recording();
}

}  // namespace firmware
