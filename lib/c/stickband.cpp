// The C interface: ident::Monitor in storage of the caller, behind a queue.
#include "c/stickband.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <new>
#include <optional>
#include <span>
#include <type_traits>

#include "c/sample_queue.hpp"
#include "ident/base/effect_code.hpp"
#include "ident/monitor.hpp"
#include "wire/big_endian.hpp"
#include "wire/crc32.hpp"
#include "wire/monitor_bytes.hpp"

namespace {

using Report = ident::MonitorReport<float>;
using Event = ident::Event<float>;

// What depends on the size of the window; a program links those that it makes.
struct Calls {
  bool (*step)(stickband& loop, int budget);
  void (*push)(stickband& loop, const ident::Sample<float>& sample);
  void (*advance)(stickband& loop, std::int64_t now_us);
  std::optional<Event> (*poll)(stickband& loop);
  Report (*report)(const stickband& loop);
  ident::MonitorMemory (*memory)(const stickband& loop);
  void (*restore)(stickband& loop, const ident::MonitorMemory& memory, float windows);
  bool (*due)(const stickband& loop);
  std::size_t capacity;  // samples that a window holds
};

// Of which loop a memory is: span and period.
constexpr std::size_t kLoopBytes = 4 + 4 + 8;
constexpr std::array<unsigned char, 5> kMark = {'S', 'B', 'C', 'M', 1};
constexpr std::size_t kMemoryBytes =
    kMark.size() + kLoopBytes + wire::kMonitorBytes + sizeof(std::uint32_t);
static_assert(kMemoryBytes <= STICKBAND_MEMORY_BYTES);

}  // namespace

struct stickband {
  stickband(const Calls& with, const stickband_settings& from)
      : calls(&with), settings(from) {}
  const Calls* calls;
  stickband_settings settings;
  c::SampleQueue<stickband_sample, STICKBAND_QUEUE> queue;
};

namespace {

ident::MonitorSettings<float> settings_of(const stickband_settings& from) {
  ident::MonitorSettings<float> out;
  out.sample_period_us = from.sample_period_us;
  out.longest_hold = from.longest_hold;
  out.span_low = from.span_low;
  out.span_high = from.span_high;
  out.gain_sign = from.gain_sign;
  out.evaluate_every_pct = from.evaluate_every_pct;
  out.memory_pct = from.memory_pct;
  out.first_cycles = from.first_cycles;
  out.alarm.on_delay_windows = from.on_delay_windows;
  out.alarm.off_delay_windows = from.off_delay_windows;
  out.alarm.band_min_pct = from.band_min_pct;
  out.input.stale_after_us = from.stale_after_us;
  return out;
}

template <std::size_t Capacity>
struct Loop : stickband {
  using Monitor = ident::Monitor<float, Capacity>;

  explicit Loop(const stickband_settings& from)
      : stickband(kCalls, from), monitor(settings_of(from)) {}

  static Monitor& of(stickband& loop) { return static_cast<Loop&>(loop).monitor; }
  static const Monitor& of(const stickband& loop) {
    return static_cast<const Loop&>(loop).monitor;
  }

  static constexpr Calls kCalls = {
      [](stickband& l, int budget) { return of(l).step(budget); },
      [](stickband& l, const ident::Sample<float>& sample) { of(l).push(sample); },
      [](stickband& l, std::int64_t now_us) { of(l).advance(now_us); },
      [](stickband& l) { return of(l).poll(); },
      [](const stickband& l) { return of(l).report(); },
      [](const stickband& l) { return of(l).memory(); },
      [](stickband& l, const ident::MonitorMemory& memory, float windows) {
        of(l).restore(memory, windows);
      },
      [](const stickband& l) { return of(l).due(); },
      Capacity,
  };

  Monitor monitor;
};

// Room that the constants of the header leave beyond what is needed today, at most.
constexpr std::size_t kSpare = 1024;

template <std::size_t Capacity, class Storage>
stickband* init(Storage* storage, const stickband_settings* settings) {
  using Object = Loop<Capacity>;
  static_assert(
      sizeof(Object) <= sizeof(Storage) && sizeof(Storage) <= sizeof(Object) + kSpare,
      "STICKBAND_BYTES_… of stickband.h is what a loop needs");
  static_assert(alignof(Object) <= alignof(Storage));
  static_assert(std::is_trivially_destructible_v<Object>, "nothing is given back");
  return ::new (static_cast<void*>(storage)) Object(*settings);
}

stickband_estimate plain(const ident::Estimate<float>& from) {
  if (!from.known) return {};
  return {1, from.value, from.low, from.high};
}

stickband_valve plain(const ident::PerStroke<float>& band,
                      const ident::PerStroke<float>& jump) {
  return {plain(band.ascending), plain(band.descending), plain(jump.ascending),
          plain(jump.descending)};
}

// Behind "not evaluated", in the order of ident::Verdict.
std::int32_t verdict_of(ident::Verdict verdict) {
  return static_cast<std::int32_t>(verdict) + 1;
}
static_assert(STICKBAND_NOT_EVALUATED == 0 &&
              STICKBAND_STICTION == static_cast<int>(ident::Verdict::kStiction) + 1 &&
              STICKBAND_BACKLASH == static_cast<int>(ident::Verdict::kBacklash) + 1 &&
              STICKBAND_NO_STICTION ==
                  static_cast<int>(ident::Verdict::kNoStiction) + 1 &&
              STICKBAND_UNDECIDED == static_cast<int>(ident::Verdict::kUndecided) + 1 &&
              STICKBAND_BAD_DATA == static_cast<int>(ident::Verdict::kBadData) + 1);

std::uint32_t count_of(std::uint64_t count) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
  return static_cast<std::uint32_t>(std::min(count, kMost));
}

using LoopBytes = std::array<unsigned char, kLoopBytes>;

LoopBytes bytes_of_loop(const stickband_settings& settings) {
  LoopBytes bytes;
  const std::span<unsigned char> out(bytes);
  wire::put_big_endian(std::bit_cast<std::uint32_t>(settings.span_low), out.first(4));
  wire::put_big_endian(std::bit_cast<std::uint32_t>(settings.span_high),
                       out.subspan(4, 4));
  wire::put_big_endian(static_cast<std::uint64_t>(settings.sample_period_us),
                       out.last(8));
  return bytes;
}

}  // namespace

const char* stickband_version(void) {
  return STICKBAND_VERSION;
}

void stickband_default_settings(stickband_settings* settings) {
  const ident::MonitorSettings<float> from;
  *settings = {from.sample_period_us,
               from.input.stale_after_us,
               from.span_low,
               from.span_high,
               from.gain_sign,
               from.longest_hold,
               from.evaluate_every_pct,
               from.memory_pct,
               from.first_cycles,
               from.alarm.on_delay_windows,
               from.alarm.off_delay_windows,
               from.alarm.band_min_pct};
}

#ifdef STICKBAND_LEAST
stickband* stickband_init_384(stickband_storage_384* storage,
                              const stickband_settings* settings) {
  return init<ident::kSmallWindow>(storage, settings);
}
#else
stickband* stickband_init_512(stickband_storage_512* storage,
                              const stickband_settings* settings) {
  return init<ident::kSmallWindow>(storage, settings);
}
#endif

#ifndef STICKBAND_SMALL
stickband* stickband_init_2048(stickband_storage_2048* storage,
                               const stickband_settings* settings) {
  return init<ident::kStandardWindow>(storage, settings);
}

stickband* stickband_init_4096(stickband_storage_4096* storage,
                               const stickband_settings* settings) {
  return init<ident::kLargeWindow>(storage, settings);
}
#endif

int stickband_push(stickband* loop, const stickband_sample* sample) {
  return loop->queue.push(*sample) ? 1 : 0;
}

uint32_t stickband_pending(const stickband* loop) {
  return loop->queue.size();
}

namespace {

// A window that is due begins with the sample that made it so, however many wait.
void take_waiting(stickband& loop) {
  const Calls& calls = *loop.calls;
  for (stickband_sample sample; !calls.due(loop) && loop.queue.take(sample);) {
    calls.push(loop, {sample.t_us, sample.u, sample.y, sample.sp, sample.has_sp != 0});
  }
}

}  // namespace

int stickband_step(stickband* loop, int32_t budget) {
  take_waiting(*loop);
  const bool more = loop->calls->step(*loop, budget);
  return more || loop->queue.size() > 0 ? 1 : 0;
}

void stickband_advance(stickband* loop, int64_t now_us) {
  take_waiting(*loop);
  // What waits behind a window that is due is newer than what the monitor knows.
  if (loop->queue.size() == 0) loop->calls->advance(*loop, now_us);
}

int stickband_poll(stickband* loop, stickband_event* event) {
  const std::optional<Event> found = loop->calls->poll(*loop);
  if (!found) return 0;
  *event = {found->t_us,
            static_cast<std::int32_t>(found->kind),
            verdict_of(found->verdict),
            static_cast<std::int32_t>(found->reason),
            static_cast<std::int32_t>(found->fault),
            plain(found->stick_band, found->slip_jump)};
  return 1;
}

void stickband_get_report(const stickband* loop, stickband_report* report) {
  const Report from = loop->calls->report(*loop);
  *report = {};
  report->raised = from.stiction_raised;
  report->oscillating = from.oscillating;
  report->fault = static_cast<std::int32_t>(from.fault);
  report->evaluations = from.counters.evaluations;
  report->skipped_windows = from.counters.skipped_windows;
  const ident::WindowCounters& samples = from.samples;
  report->samples_accepted = count_of(samples.accepted);
  report->samples_refused =
      count_of(samples.repeats + samples.non_finite + samples.time_back);
  report->queue_refused = loop->queue.refused();
  report->gaps = count_of(samples.gaps);
  report->overruns = count_of(samples.overruns);
  report->restarts = count_of(samples.restarts);
  report->samples_filled = count_of(samples.filled);
  report->events_lost = from.counters.events_lost;
  report->input_faults = from.counters.input_faults;
  if (!from.evaluated) return;
  report->verdict = verdict_of(from.verdict);
  report->reason = static_cast<std::int32_t>(from.reason);
  report->suspect = static_cast<std::int32_t>(from.gap.suspect);
  report->valve = plain(from.stick_band, from.slip_jump);
  report->window_end_us = from.window_end_us;
  report->window_samples = static_cast<std::uint32_t>(from.window_samples);
  report->cycles = from.cycles;
  report->period_s = from.oscillation.period_samples *
                     static_cast<float>(loop->settings.sample_period_us) * 1e-6F;
  report->detectable_band = from.detectable_band;
  report->evidence_nats = from.evidence_nats;
  report->fit_percent = from.fit_valve_percent;
  report->suspect_share = from.gap.share_of_error;
}

size_t stickband_save(const stickband* loop, unsigned char* out, size_t room) {
  if (room < kMemoryBytes) return 0;
  const std::span<unsigned char> all(out, kMemoryBytes);
  const LoopBytes of_loop = bytes_of_loop(loop->settings);
  const auto monitor = wire::encode_monitor(loop->calls->memory(*loop));
  auto end = std::copy(kMark.begin(), kMark.end(), all.begin());
  end = std::copy(of_loop.begin(), of_loop.end(), end);
  std::copy(monitor.begin(), monitor.end(), end);
  const auto checked = all.first(kMemoryBytes - sizeof(std::uint32_t));
  wire::put_big_endian(wire::crc32(checked), all.last(sizeof(std::uint32_t)));
  return kMemoryBytes;
}

int stickband_restore(stickband* loop, const unsigned char* bytes, size_t count,
                      float missed_s) {
  if (loop->queue.size() > 0 || loop->calls->report(*loop).samples.accepted > 0) {
    return STICKBAND_TOO_LATE;
  }
  if (count < kMemoryBytes || !std::equal(kMark.begin(), kMark.end(), bytes)) {
    return STICKBAND_NO_MEMORY;
  }
  const std::span<const unsigned char, kMemoryBytes> all(bytes, kMemoryBytes);
  constexpr std::size_t kChecked = kMemoryBytes - sizeof(std::uint32_t);
  if (wire::crc32(all.first<kChecked>()) !=
      wire::get_big_endian(all.last<sizeof(std::uint32_t)>())) {
    return STICKBAND_DAMAGED;
  }
  const LoopBytes of_loop = bytes_of_loop(loop->settings);
  if (!std::equal(of_loop.begin(), of_loop.end(), bytes + kMark.size())) {
    return STICKBAND_OTHER_SETTINGS;
  }
  ident::MonitorMemory memory;
  const auto monitor = all.subspan<kMark.size() + kLoopBytes, wire::kMonitorBytes>();
  if (!wire::decode_monitor(monitor, memory)) return STICKBAND_DAMAGED;
  const float window_s = static_cast<float>(loop->calls->capacity) *
                         static_cast<float>(loop->settings.sample_period_us) * 1e-6F;
  // So many windows leave nothing of what is forgotten, and a memory that keeps all as
  // it is.
  constexpr float kMostMissed = 1e6F;
  const float windows =
      missed_s > 0.0F ? std::min(missed_s / window_s, kMostMissed) : 0.0F;
  loop->calls->restore(*loop, memory, windows);
  return STICKBAND_RESTORED;
}

// The texts are literals, so they end with a zero.
const char* stickband_verdict_name(int32_t verdict) {
  if (verdict == STICKBAND_NOT_EVALUATED) return "not_evaluated";
  if (verdict < 0 || verdict > STICKBAND_BAD_DATA) return "";
  return ident::name(static_cast<ident::Verdict>(verdict - 1)).data();
}

const char* stickband_event_name(int32_t kind) {
  if (kind < 0 || kind >= ident::kEventKinds) return "";
  return ident::name(static_cast<ident::EventKind>(kind)).data();
}

const char* stickband_fault_name(int32_t fault) {
  if (fault < 0 || fault > STICKBAND_FAULT_FROZEN_Y) return "";
  return ident::name(static_cast<ident::InputFault>(fault)).data();
}

const char* stickband_effect_name(int32_t suspect) {
  if (suspect < 0 || suspect >= ident::kEffectCodes) return "";
  return ident::name(static_cast<ident::EffectCode>(suspect)).data();
}

const char* stickband_reason_text(int32_t reason) {
  if (reason < 0 || reason >= ident::kReasons) return "";
  return ident::sentence(static_cast<ident::Reason>(reason)).data();
}

static_assert(STICKBAND_OSCILLATION_STARTED ==
                  static_cast<int>(ident::EventKind::kOscillationStarted) &&
              STICKBAND_INPUT_RESTORED ==
                  static_cast<int>(ident::EventKind::kInputRestored) &&
              STICKBAND_INPUT_RESTORED + 1 == ident::kEventKinds);
static_assert(STICKBAND_FAULT_STALE == static_cast<int>(ident::InputFault::kStale) &&
              STICKBAND_FAULT_FROZEN_Y == static_cast<int>(ident::InputFault::kFrozenY));
