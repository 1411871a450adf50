// The component that ships: samples of one loop in, events and a verdict on its valve
// out.
//
// Life: new → push, step, push, step … → poll and report, at any time.
//
//   static ident::Monitor<float, ident::kStandardWindow> monitor({.sample_period_us =
//   500'000}); monitor.push(sample);                      // whenever a sample comes
//   while (monitor.step(kPieces) && time_is_left) {}   // in between
//   while (auto event = monitor.poll()) { … }
//
// What happens. `push` puts the sample into the window, watches the health of the input
// and whether u or y oscillates. When an evaluation is due, the next `step` holds the
// window and the steps after it identify it where it is, a slice at a time; samples that
// come in wait. The last slice takes them in, puts the verdict into the report and shows
// it to the alarm. More than C/16 samples during one evaluation, and the window starts
// anew from the newest of them: `samples.overruns` counts these.
//
// When an evaluation is due. With a full window: every `evaluate_every_pct` of its
// capacity in new samples. Before it is full for the first time: once u oscillates and
// the window holds `first_cycles` of it, then each time that the window has grown by
// half. A fault of the input, and a gap that restarts the window, begin this anew: only
// samples since then are used. If the evaluation before is still going on, the window is
// skipped and counted. Evaluations that are asked for come on top: they show what the
// samples say now, leave the windows that are due as they are, and never count for the
// alarm. A window that comes due during one follows it.
//
// Events and the time they carry:
//   oscillation_started   u or y began to oscillate; newest sample
//   oscillation_ended     neither does any more; newest sample
//   stiction_raised       see alarm.hpp; newest sample of the window that decided
//   stiction_cleared      the same
//   undecided             a window says so, for a reason that has not been told yet or
//                         after two decided windows in a row; newest sample of that one
//   input_fault           see input_health.hpp; since when
//   input_restored        the sample that ended the fault
// So the event of a window may come after one with a later time. The queue holds kEvents;
// a further one pushes out the oldest and is counted.
//
// Same answer. The verdict on a window does not depend on the budgets. Which windows are
// evaluated does not either, as long as `step` is called once after each `push` and an
// evaluation ends before the next is due.
//
// What it costs where nothing is wrong. A due window without closed-loop evidence for a
// sticking valve ends before a valve is searched, and says so without a model; one that
// is asked for is always identified whole.
//
// Memory of earlier windows. What each window says of each stick band is added up
// (evidence_pool.hpp), every sample once, once a tenth of the window is new. What was
// added before fades with every such window, also where that one says nothing. Where the
// sum is beyond doubt and the newest window is not sure, the verdict is the sum's; a
// fault of which the sum knows nothing is undecided.
//
// One thread: none of the calls may interrupt another. No heap, exceptions, RTTI, OS or
// clock.
//
// Cost. `push`, `poll`, `advance`: constant. `step(budget)`: a unit of budget is 100,000
// instructions of a Cortex-M4F. The work is cut into pieces of about one unit at most: a
// slice is longer than its budget by less than one of them, so step(1) takes two units at
// most. (Where an evaluation begins and in its survey a piece is a pass over the window:
// one unit for 2,048 samples, two for 4,096.) An evaluation takes some 3·10⁴ units;
// `evaluate_now` does all of them. docs/memory.md has what was counted.
//
// Memory, bytes, R = sizeof(Real), C = Capacity:
//   window of samples      3·C·R, and 3·C/16·R for those that come during an evaluation
//   evaluation             C·R + C, and the larger of
//     the paper's search   23.3 KiB (float), 46.0 KiB (double)
//     the valve's search   7.1 KiB and the larger of C·R and 8.6 KiB (float),
//                          13.6 KiB and the larger of C·R and 15.6 KiB (double)
//   all else               under 3 700
// In all, KiB: float 512: 36.0, float 2048: 62.6, double 2048: 121, double 4096: 190.
// Where a pointer has four bytes, float: with the small sizes of limits.hpp 512: 20.0,
// with the least ones 384: 15.9.
// ram_bytes() tells; nothing lies outside the object but the stack.
//
// Failures, all counted in `report()`, none fatal: samples refused by the window
// (repeat, not finite, time going back), gaps, faults of the input, windows skipped,
// events lost.
//
// What is named here stands in signal/sample_window.hpp (Sample, PushResult),
// verdict/verdict.hpp (Verdict, Estimate, PerStroke), verdict/identification.hpp (Reason
// and its sentence(), Identification), signal/input_health.hpp (InputFault).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "ident/base/configurations.hpp"
#include "ident/in_place_identifier.hpp"
#include "ident/monitor_memory.hpp"
#include "ident/signal/input_health.hpp"
#include "ident/signal/oscillation_detector.hpp"
#include "ident/signal/sample_window.hpp"
#include "ident/verdict/alarm.hpp"

namespace ident {

/// Values outside the ranges are moved to the nearest bound.
template <class Real>
struct MonitorSettings {
  std::int64_t sample_period_us = 1'000'000;  ///< nominal, µs, 1 … 2⁴⁰, default 1 s
  int longest_hold = 3;         ///< missing samples that are filled, 0 … 16, default 3
  Real span_low = 0;            ///< lower end of the span of u, units of u, default 0
  Real span_high = 100;         ///< upper end; if not above span_low, the span is 100
  int gain_sign = 0;            ///< ±1: known sign of the process gain; 0, default: not
  int evaluate_every_pct = 25;  ///< new samples, % of the window, 1 … 100, default 25
  /// Share of what earlier windows said of each stick band that still counts when a whole
  /// window of new samples has come, %, 0 … 100, default 90.
  int memory_pct = 90;
  int first_cycles = 5;  ///< cycles, 2 … 100, default 5
  AlarmSettings alarm;
  InputHealthSettings input;
};

/// What an event tells.
enum class EventKind : std::uint8_t {
  kOscillationStarted,
  kOscillationEnded,
  kStictionRaised,
  kStictionCleared,
  kUndecided,
  kInputFault,
  kInputRestored,
};
inline constexpr int kEventKinds = 7;

/// The contract's name, e.g. "stiction_raised".
[[nodiscard]] std::string_view name(EventKind kind);

/// One event, with what was known then. Fields that do not belong to its kind keep their
/// defaults.
template <class Real>
struct Event {
  std::int64_t t_us = 0;  ///< on the clock of the samples, µs
  EventKind kind = EventKind::kUndecided;
  InputFault fault = InputFault::kNone;   ///< input_fault, input_restored: which
  Verdict verdict = Verdict::kUndecided;  ///< stiction_*, undecided: of that window
  Reason reason = Reason::kNone;          ///< stiction_*, undecided: of that window
  PerStroke<Real> stick_band = {};        ///< stiction_*: of that window, units of u
  PerStroke<Real> slip_jump = {};         ///< stiction_*: of that window, units of u
  Real period_samples = 0;                ///< oscillation_*: samples per cycle

  [[nodiscard]] double t_s() const { return static_cast<double>(t_us) * 1e-6; }
};

/// How often each thing happened since construction; never reset.
struct MonitorCounters {
  std::uint32_t evaluations = 0;      ///< finished
  std::uint32_t skipped_windows = 0;  ///< due while the evaluation before was going on
  std::uint32_t input_faults = 0;
  std::uint32_t events_lost = 0;  ///< pushed out of the queue before they were read
};

/// The state of the monitor: the latest verdict and what it rests on. `fit_percent` is 0
/// unless the window was asked for, or u turned too seldom for a verdict without it.
template <class Real>
struct MonitorReport : Findings<Real> {
  bool evaluated = false;          ///< false: no number of a window means anything
  bool asked = false;              ///< the window was asked for, not due
  std::int64_t window_end_us = 0;  ///< newest sample of the window
  std::size_t window_samples = 0;  ///< samples in the window
  Real evidence_nats = 0;          ///< closed-loop evidence of the window; 0 unknown
  LadderFinding<Real>
      pooled;  ///< of all windows since the memory began; bands in units of u

  /// Windows in a row, of those that were due, that said what the newest of them does.
  int alike_windows = 0;
  bool confirmed = false;        ///< these are the on-delay of the alarm, or more
  bool stiction_raised = false;  ///< the alarm
  bool oscillating = false;      ///< u or y does, now
  InputFault fault = InputFault::kNone;
  MonitorCounters counters;
  WindowCounters samples;
};

template <class Real, std::size_t Capacity>
class Monitor {
 public:
  static constexpr std::size_t kCapacity = Capacity;
  static constexpr std::size_t kEvents = kSmallSizes ? 4 : 8;

  explicit Monitor(const MonitorSettings<Real>& settings);
  Monitor(const Monitor&) = delete;
  Monitor& operator=(const Monitor&) = delete;

  /// Takes a sample; says what the window did with it. Constant time.
  PushResult push(const Sample<Real>& sample);
  /// Where a clock is at hand: finds out that samples have stopped coming. `now_us` is on
  /// the clock of the samples. Constant time.
  void advance(std::int64_t now_us);
  /// Goes on with the evaluation by about `budget` units (≥ 1; less is 1). True while
  /// there is work.
  bool step(int budget);
  /// As `step`, but a window that is due and has not begun waits.
  bool step_asked(int budget);
  /// Asks for an evaluation of the samples there are; `step` does it, after the window
  /// that is due. It never counts for the alarm. Without a sample since the latest
  /// evaluation, or with one going on, nothing happens.
  void request_evaluation();
  /// A recording ends here: if half of the samples that make a window due are new, the
  /// last window is due and counts; else it is asked for.
  void end_recording();
  /// Ends the evaluation that is going on, then that of `end_recording`. The time is not
  /// bounded by a budget.
  void evaluate_now();

  /// The oldest event that has not been read.
  std::optional<Event<Real>> poll();
  [[nodiscard]] MonitorReport<Real> report() const;
  /// True while an evaluation is due, asked for or going on.
  [[nodiscard]] bool busy() const { return due_ || asked_ || running_; }
  /// A window is due and has not begun.
  [[nodiscard]] bool due() const { return due_; }
  /// Everything the latest evaluation found; meaningful when it has ended and `busy` is
  /// false.
  [[nodiscard]] const Identification<Real>& identification() const {
    return identifier_.result();
  }
  /// What is worth keeping over a restart.
  [[nodiscard]] MonitorMemory memory() const;
  /// Takes it back, before the first push, with the settings that it was made with (those
  /// of the alarm may differ). The evidence fades as if `missed_windows` (≥ 0) windows
  /// had come and said nothing; the alarm waits for windows that do.
  void restore(const MonitorMemory& memory, Real missed_windows);
  /// After restore() and the samples that the window held: goes on from there. Of those
  /// samples the newest `unjudged` are news, as unjudged() said; what they made happen is
  /// neither announced nor counted.
  void resume(std::size_t unjudged);
  /// Samples that the memory of earlier windows does not know yet.
  [[nodiscard]] std::size_t unjudged() const { return since_; }
  /// The newest samples of the window that are looked at: those since the latest fault.
  [[nodiscard]] std::size_t usable() const { return usable_; }
  [[nodiscard]] const SampleWindow<Real, Capacity>& window() const { return window_; }
  [[nodiscard]] static constexpr std::size_t ram_bytes() { return sizeof(Monitor); }

 private:
  using Search = InPlaceIdentifier<Real, Capacity>;
  static constexpr std::size_t kFewest = Search::kFewestSamples;

  void announce(const Event<Real>& event);
  void announce_health(HealthChange change, InputFault before);
  void show_to_detectors(const Sample<Real>& sample);
  void watch_oscillation();
  void restart_evidence();
  [[nodiscard]] std::size_t hop() const;
  [[nodiscard]] bool window_due() const;
  [[nodiscard]] bool has_news() const;
  bool advance_evaluation(bool may_begin, int budget);
  void make_due();
  void begin_evaluation();
  void finish_evaluation();
  void tell_undecided();
  void show_to_alarm();
  void count_alike();
  void judge_with_pool();
  [[nodiscard]] float kept_after(float windows) const;

  MonitorSettings<Real> settings_;
  SampleWindow<Real, Capacity> window_;
  InputHealth<Real> health_;
  OscillationDetector<Real> u_detector_;
  OscillationDetector<Real> y_detector_;
  Alarm alarm_;
  Search identifier_;
  EvidencePool pool_;
  EarlierValve earlier_;  // of the newest window that was due and showed one
  std::array<Event<Real>, kEvents> events_;
  Sample<Real> newest_;       // that was accepted
  std::size_t usable_ = 0;    // samples in the window since the latest fault or restart
  std::size_t fresh_ = 0;     // of them, since the latest window that was due
  std::size_t since_ = 0;     // of them, since the latest window that the pool knows
  std::size_t compared_ = 0;  // usable_ of that window; 0: none since fault or restart
  OscillationRhythm<Real> u_oscillation_;
  OscillationRhythm<Real> y_oscillation_;
  Real period_ = 0;             // of the loop's oscillation, or of the last one; samples
  MonitorReport<Real> report_;  // confirmed … fault and samples come in by report()
  std::int64_t running_end_us_ = 0;
  std::size_t running_samples_ = 0;
  int decided_windows_ = 0;                      // in a row
  Verdict alike_verdict_ = Verdict::kUndecided;  // of the newest window that was due
  bool alike_oscillation_ = false;               // its
  Reason told_ = Reason::kNone;  // newest undecided that was announced and still stands
  std::uint8_t first_event_ = 0;
  std::uint8_t event_count_ = 0;
  std::uint8_t waited_ = 0;  // samples in a row that ended a cycle
  bool u_cycle_ = false;     // ended in u's detector, not yet asked what it means
  bool y_cycle_ = false;
  bool oscillating_ = false;
  bool due_ = false;
  bool asked_ = false;
  bool counts_ = false;  // the evaluation that is running is for the alarm
  bool running_ = false;
};

/// KiB that a loop on a host takes beyond those of a device.
inline constexpr std::size_t kWidePointers = sizeof(void*) == 4 ? 0 : 1;
static_assert(!kSmallSizes || kLeastSizes ||
                  Monitor<float, kSmallWindow>::ram_bytes() <=
                      (20 + kWidePointers) * 1024,
              "one loop on a small device has 20 KiB of RAM");
static_assert(!kLeastSizes || kTwoPathSearch ||
                  Monitor<float, kSmallWindow>::ram_bytes() <=
                      (16 + kWidePointers) * 1024,
              "one loop on the least device has 16 KiB of RAM");
static_assert(Monitor<float, kSmallWindow>::ram_bytes() <= 37 * 1024,
              "23 KiB are the paper's search, which does not shrink with the window");
static_assert(Monitor<float, kStandardWindow>::ram_bytes() <= 64 * 1024,
              "one loop on the standard device has 64 KiB of RAM");
static_assert(Monitor<double, kStandardWindow>::ram_bytes() <= 128 * 1024,
              "twice the standard device's, for the host");
static_assert(Monitor<double, kLargeWindow>::ram_bytes() <= 192 * 1024,
              "gateways and the host: four thousand loops in a gigabyte");

}  // namespace ident
