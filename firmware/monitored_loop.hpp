// One loop of the gateway: its inputs, its monitor and the state that the views show.
//
// Life: new → take_* through input() and advance(), in order of time → evaluate, in idle
// time → refresh → status, events. One thread; no heap after construction, no clock.
// Memory: a monitor (ident/monitor.hpp) and less than 4 KiB. Cost of each call but
// evaluate: constant.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "config/gateway.hpp"
#include "firmware/band_trend.hpp"
#include "firmware/band_watch.hpp"
#include "firmware/evaluation_pace.hpp"
#include "firmware/loop_input.hpp"
#include "firmware/span_watch.hpp"
#include "firmware/swap_watch.hpp"
#include "ident/monitor.hpp"
#include "wire/diagnostics.hpp"
#include "wire/history_row.hpp"
#include "wire/loop_memory.hpp"
#include "wire/window_image.hpp"

namespace firmware {

using Monitor = ident::Monitor<float, ident::kStandardWindow>;

/// The time on the clock of the samples and of the calendar, µs.
struct Now {
  std::int64_t us = 0;
  std::int64_t epoch_us = 0;  ///< since the Unix epoch
};

class MonitoredLoop {
 public:
  /// All three outlive this object, which keeps `status` up to date.
  MonitoredLoop(const config::Loop& loop, wire::LoopStatus& status, SwapWatch& swaps);
  MonitoredLoop(const MonitoredLoop&) = delete;
  MonitoredLoop& operator=(const MonitoredLoop&) = delete;

  [[nodiscard]] LoopInput& input() { return input_; }
  /// Newest usable value of an input; NaN before the first.
  [[nodiscard]] double live(Role role) const { return input_.live(role); }
  /// Hands the samples due until then to the monitor.
  void advance(std::int64_t until_us);
  /// There is a window to be judged now, or one is; it may wait (evaluation_pace.hpp).
  [[nodiscard]] bool has_work();
  /// One slice of that; true while there is work.
  bool evaluate(int budget);
  /// Asks for an evaluation, which answer() does. It is shown; pace, on-delay and alarm
  /// are as without it.
  void request_evaluation() { asked_ = true; }
  [[nodiscard]] bool asked() const { return asked_ && !evaluating_; }
  [[nodiscard]] bool answering() const { return answering_; }
  /// One slice of what is asked for; true while there is more.
  bool answer(int budget);
  /// The recording ends here: the last window, as of ident::Monitor::end_recording.
  void end_recording();
  /// Brings the status up to date; true when the verdict, the flag or the input changed.
  bool refresh(const Now& now);
  /// The oldest event of the monitor that has not been read.
  [[nodiscard]] std::optional<ident::Event<float>> poll() { return monitor_->poll(); }
  /// True, once, after a stick band has changed (band_watch.hpp).
  [[nodiscard]] bool band_changed() { return std::exchange(band_changed_, false); }

  /// The range of u, once, after a window of it that does not fit the span.
  [[nodiscard]] std::optional<std::array<double, 2>> span_doubted() {
    return std::exchange(doubted_by_, std::nullopt);
  }

  /// True, once, after a window in which u and y are exchanged (swap_watch.hpp): it is
  /// undecided, whatever the monitor makes of it.
  [[nodiscard]] bool signals_swapped() {
    const bool told = std::exchange(swap_told_, swap_told_ || swapped_);
    return swapped_ && !told;
  }

  /// u or y that comes more seldom than samples are taken, once.
  [[nodiscard]] std::optional<SlowSignal> new_slow_signal() {
    const auto slow = slow_told_ ? std::nullopt : input_.slow_signal();
    slow_told_ = slow_told_ || slow;
    return slow;
  }
  /// A signal that two devices send, once.
  [[nodiscard]] std::optional<TwoSenders> new_two_senders() {
    const auto two = senders_told_ ? std::nullopt : input_.two_senders();
    senders_told_ = senders_told_ || two;
    return two;
  }
  [[nodiscard]] std::optional<FarSignal> far_signal() const {
    return input_.far_signal();
  }
  /// No window that was due has been judged since the input was unusable: what is shown
  /// rests on one of before.
  [[nodiscard]] bool rests_on_before() const { return !judged_since_; }

  /// The newest window that was due, or a mark after a reset, once; for the history.
  [[nodiscard]] std::optional<wire::HistoryRow> take_row() {
    return std::exchange(row_, std::nullopt);
  }
  /// The rows of the history, oldest first, before the first sample.
  void recall(std::span<const wire::HistoryRow> rows);
  /// The trend of the stick band, once, when it begins to stand.
  [[nodiscard]] std::optional<Trend> new_trend() {
    return std::exchange(new_trend_, std::nullopt);
  }

  /// CRC-32 of what memory and history hold for: span, sampling, signals.
  [[nodiscard]] std::uint32_t configuration_crc() const { return configuration_crc_; }
  /// What is to survive a restart, beside the numbers in the status.
  [[nodiscard]] wire::LoopMemory memory() const;
  /// Takes it back, before the first sample; the status has its numbers. What is raised
  /// or confirmed is so at once, until windows say otherwise; the evidence fades by the
  /// time that has passed, if the calendar knows it.
  void restore(const wire::LoopMemory& memory, const Now& now);

  /// What the samples in the window have been made of, for windows that are kept.
  [[nodiscard]] wire::WindowMark window_mark() const;
  /// Takes a kept window back, after restore() and before the first sample; its first
  /// sample is of `first_us` on the clock of today's. False: it is another
  /// configuration's, or of samples to come.
  bool resume(const wire::WindowReader& kept, std::int64_t first_us, const Now& now);

  /// Forgets the window, the verdict, the alarm and the trend; counters stay.
  void reset();
  /// Takes the parameters and begins anew.
  void set_parameters(const wire::LoopParameters& parameters);
  /// Shows `verdict` instead of the own one until it is called with nullopt.
  void simulate(std::optional<wire::LoopVerdict> verdict) { simulated_ = verdict; }

  [[nodiscard]] const Monitor& monitor() const { return *monitor_; }
  [[nodiscard]] const config::Loop& configuration() const { return loop_; }
  [[nodiscard]] const wire::LoopStatus& status() const { return status_; }

 private:
  [[nodiscard]] ident::MonitorSettings<float> settings() const;
  void begin_anew();
  void forget_windows();
  void show_finished();
  void write_row();
  void show_trend(std::int64_t epoch_s);
  [[nodiscard]] double age_of(const ident::MonitorReport<float>& report,
                              const Now& now) const;
  void show_window(const ident::MonitorReport<float>& report);
  void show_paths();
  void show_live(const ident::MonitorReport<float>& report, const Now& now);
  [[nodiscard]] wire::InputStatus input_status(const ident::MonitorReport<float>& report,
                                               std::int64_t now_us);
  void show_verdict(const ident::MonitorReport<float>& report);
  void follow_input(std::int64_t now_us);
  [[nodiscard]] double percent_of_span(double value) const;
  [[nodiscard]] EvaluationPace::Standing standing() const;
  [[nodiscard]] double received_share(const ident::MonitorReport<float>& report) const;

  const config::Loop& loop_;
  wire::LoopStatus& status_;
  SwapWatch& swaps_;
  LoopInput input_;
  std::optional<Monitor> monitor_;
  EvaluationPace pace_;
  bool evaluating_ = false;  // the window that was due is being judged
  bool asked_ = false;
  bool answering_ = false;  // what was asked for is being judged
  wire::LoopVerdict standing_ = wire::LoopVerdict::kNotEvaluated;  // newest due window's
  std::size_t judged_ = 0;                                         // its samples
  std::uint32_t configuration_crc_ = 0;  // of what the memory holds for
  bool remembered_ = false;              // there is a window to remember
  bool dated_ = true;                    // ended_ms_ is that of the newest window
  std::int64_t ended_ms_ = 0;            // its end, since the epoch
  std::int64_t evidence_ms_ = 0;         // the evidence has faded up to then
  bool counted_ = false;  // a window that was due is not in the history yet
  std::optional<wire::HistoryRow> row_;
  BandTrend trend_;
  std::optional<Trend> new_trend_;
  SpanWatch span_;
  bool span_told_ = false;
  bool swapped_ = false;  // u and y, in the newest window
  bool swap_told_ = false;
  bool slow_told_ = false;
  bool senders_told_ = false;
  std::optional<std::array<double, 2>> doubted_by_;
  BandWatch bands_;
  bool band_changed_ = false;
  std::optional<wire::LoopVerdict> simulated_;
  bool returning_ = false;           // the input is usable again, but not for long
  std::int64_t returned_us_ = 0;     // since when
  bool judged_since_ = true;         // a window that was due has been
  std::uint32_t evaluations_ = 0;    // that the status shows
  std::uint64_t filled_before_ = 0;  // samples made up, gaps held or lost, as of the
  std::uint64_t held_before_ = 0;    // window before
};

}  // namespace firmware
