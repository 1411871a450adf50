// The gateway without its hardware: frames and readings in; frames, flag levels and
// events out. No system calls, no heap after construction, no clock of its own.
//
//   Daemon daemon(configuration, random);
//   const Outputs& out = daemon.step(now, inputs);   // at least every 10 ms
//   while (time_is_left && daemon.work(kSlice)) {}
//
// step() takes what came since the call before, in order of time, samples the loops,
// answers queries, sends status frames. Its cost is linear in the frames, plus a constant
// for each loop; identification happens in work() only, one loop at a time.
//
// One thread. Memory: about 105 KiB for each loop, 50 KiB for the rest.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "config/gateway.hpp"
#include "firmware/monitored_loop.hpp"
#include "firmware/request_budget.hpp"
#include "firmware/window_copy.hpp"
#include "hal/can_bus.hpp"
#include "wire/can_frame.hpp"
#include "wire/diagnostics.hpp"
#include "wire/dtc_store.hpp"
#include "wire/state_image.hpp"
#include "wire/uds_connection.hpp"

namespace firmware {

/// Unpredictable bytes.
class Random {
 public:
  virtual ~Random() = default;
  [[nodiscard]] virtual bool fill(std::span<std::uint8_t> out) = 0;
};

struct BusFrame {
  std::size_t bus = 0;    ///< index into Gateway::buses
  std::int64_t t_us = 0;  ///< on the clock of Now::us
  wire::CanFrame frame;
};

/// Where a converter is read, and what for.
struct AnalogPoint {
  std::size_t loop = 0;  ///< index into Gateway::loops
  Role role = Role::kU;
};

struct AnalogReading {
  std::size_t point = 0;  ///< index into Daemon::analog_points()
  std::int64_t t_us = 0;
  bool ok = false;   ///< the device answered
  double value = 0;  ///< mV or mA
};

struct BusState {
  bool up = false;          ///< frames can come and go
  bool room = true;         ///< everything handed out so far has been sent
  std::uint64_t drops = 0;  ///< frames lost, since start
};

/// Times that a file could not be written, since start.
struct FileFailures {
  std::uint32_t textfile = 0;
  std::uint32_t state = 0;
  std::uint32_t history = 0;
};

struct Inputs {
  std::span<const BusFrame> frames;         ///< in order of time
  std::span<const AnalogReading> readings;  ///< in order of time
  std::span<const BusState> buses;          ///< all of Gateway::buses
  FileFailures failures = {};
};

struct OutFrame {
  std::size_t bus = 0;
  wire::CanFrame frame;
};

/// A row for the history of a loop.
struct LoopRow {
  int loop = 0;  ///< id
  wire::HistoryRow row;
};

/// Where the history of the loops is kept.
class HistorySource {
 public:
  virtual ~HistorySource() = default;
  /// Bytes of a loop's upload (wire/history_row.hpp); 0: there is none.
  [[nodiscard]] virtual std::uint32_t begin(int loop) = 0;
  /// Bytes `offset` … of the upload begun last; fills `out`.
  virtual void read(std::uint32_t offset, std::span<std::uint8_t> out) = 0;
};

enum class NoticeKind : std::uint8_t {
  kMonitor,     ///< `event` of the loop's monitor
  kInputFault,  ///< `input` tells
  kInputRestored,
  kFlagRaised,
  kFlagKept,  ///< raised by a window of before a restart or an outage, `age_s` ago
  kFlagLowered,
  kBandChanged,     ///< the stick band, by more than its intervals allow
  kTrend,           ///< the stick band goes somewhere: `trend`
  kSpanDoubted,     ///< u does not run where the span says (span_watch.hpp): `u_range`
  kSignalsSwapped,  ///< u and y are exchanged (swap_watch.hpp)
  kSlowSignal,      ///< u or y comes more seldom than samples are taken: `slow`
  kTwoSenders,      ///< of one signal: `senders`
  kSuspended,       ///< the mode is not automatic: `mode`
  kResumed,         ///< it is again: `mode`
  kBusUp,
  kBusDown,
  kBusOff,  ///< the controller left the bus: too many errors
  kAccess,  ///< a tester used its key, or a wrong one: `act`
  kGap,     ///< of the log that is replayed: `gap_s`
};

/// Something worth a line in the log.
struct Notice {
  NoticeKind kind = NoticeKind::kMonitor;
  std::int64_t t_us = 0;
  std::size_t index = 0;  ///< of the loop; kBus…: of the bus; kAccess, kGap: no meaning
  ident::Event<float> event = {};
  wire::InputStatus input = wire::InputStatus::kGood;
  wire::UdsAct act = wire::UdsAct::kUnlocked;
  std::uint8_t tester = 0;             ///< kAccess: source address
  int loop = 0;                        ///< kAccess: id; 0: all, or none
  double gap_s = 0;                    ///< kGap; negative: the clock went back
  double age_s = wire::kNotAvailable;  ///< kFlagKept: of the window; NaN: not known
  /// kBandChanged: the stick band's interval, % of span.
  wire::StrokeValues band_low_pct = {};
  wire::StrokeValues band_high_pct = {};
  Trend trend = {};
  std::array<double, 2> u_range = {};  ///< kSpanDoubted: units of u
  SlowSignal slow = {};                ///< kSlowSignal
  TwoSenders senders = {};             ///< kTwoSenders
  std::optional<FarSignal> far = {};   ///< kInputFault, out of range: for its span
  double mode = wire::kNotAvailable;   ///< kSuspended, kResumed: what the mode reads
};

struct Outputs {
  std::span<const OutFrame> frames;  ///< to send, oldest first
  std::span<const bool> flags;       ///< level of each loop's line
  std::span<const Notice> notices;
  std::span<const LoopRow> rows;  ///< for the history
  std::int64_t next_us = 0;       ///< call step() again by then
};

class Daemon final : private wire::UdsActions {
 public:
  static constexpr std::size_t kMostFrames = 64;   ///< sent in one step
  static constexpr std::size_t kMostNotices = 64;  ///< in one step; further ones are lost

  /// `configuration` and `random` outlive this object.
  Daemon(const config::Gateway& configuration, Random& random, const char* version);
  Daemon(const Daemon&) = delete;
  Daemon& operator=(const Daemon&) = delete;

  /// What it returns is valid until the next call.
  const Outputs& step(const Now& now, const Inputs& inputs);
  /// One slice of identification; true while there is work. Windows that are due come
  /// first; evaluations that testers ask for are rationed (request_budget.hpp).
  bool work(int budget);
  /// What the call of work() before took of a core.
  void charge(std::int64_t us);
  /// Evaluates what every window holds, due or not: for the end of a recording.
  void evaluate_all();

  /// What is to survive a restart (wire/state_image.hpp): bytes written into `out`, 0
  /// when it is too small.
  [[nodiscard]] std::size_t save(std::span<std::uint8_t> out) const;
  /// Takes it back, before the first step; flags() are as they were then. After an error
  /// nothing has changed.
  [[nodiscard]] wire::StateError restore(std::span<const std::uint8_t> image,
                                         const Now& now);

  /// The windows of samples of the loops that have a sample period of `least_period_s` or
  /// more: bytes written into `out` (wire/window_image.hpp), all but the CRC-32 at the
  /// end; 0 when it is too small, or there is none.
  [[nodiscard]] std::size_t save_windows(const Now& now, double least_period_s,
                                         std::span<std::uint8_t> out);
  struct Resumed {
    wire::StateError error = wire::StateError::kNone;
    int loops = 0;     ///< whose window is there again
    double age_s = 0;  ///< of the newest sample
  };
  /// Takes them back, after restore() and before the first step. `calendar`: the clock of
  /// the calendar went on while the machine was off; else windows of before that are of
  /// unknown age, and stay away.
  [[nodiscard]] Resumed restore_windows(std::span<const std::uint8_t> image,
                                        const Now& now, bool calendar);

  /// What the history knows of a loop, oldest first, before the first step.
  void recall(std::size_t index, std::span<const wire::HistoryRow> rows) {
    loops_[index]->recall(rows);
  }
  /// Who answers for the history from now on; nullptr: nobody.
  void set_history(HistorySource* history) { history_ = history; }

  /// Level of each loop's line, as of the newest step.
  [[nodiscard]] std::span<const bool> flags() const {
    return std::span(flags_).first(loops_.size());
  }
  [[nodiscard]] std::span<const AnalogPoint> analog_points() const { return points_; }
  /// Identifiers to receive on a bus.
  [[nodiscard]] std::vector<hal::CanFilter> filters(std::size_t bus) const;
  [[nodiscard]] const wire::GatewayStatus& gateway() const { return gateway_; }
  [[nodiscard]] std::span<const wire::LoopStatus> loops() const { return status_; }
  [[nodiscard]] const MonitoredLoop& loop(std::size_t index) const {
    return *loops_[index];
  }
  [[nodiscard]] const config::Gateway& configuration() const { return configuration_; }

 private:
  /// A frame that carries a signal of a loop.
  struct Route {
    std::size_t bus;
    std::uint32_t ignored;  // bits of the identifier
    std::uint32_t key;      // identifier without these, bit 31: extended
    std::size_t loop;
    Role role;
  };

  bool fill_random(std::span<std::uint8_t> out) override { return random_.fill(out); }
  bool write_parameters(int loop, const wire::LoopParameters& parameters) override;
  bool reset(int loop) override;
  bool evaluate(int loop) override;
  bool simulate(int loop, wire::LoopVerdict verdict) override;
  void end_simulation(int loop) override;
  std::uint32_t begin_recording(int loop) override;
  std::uint32_t begin_history(int loop) override;
  void read_recording(std::uint32_t offset, std::span<std::uint8_t> out) override;
  void end_recording() override;
  void tell(wire::UdsAct act, std::uint8_t tester, int loop) override;

  void build_routes();
  /// The next loop whose evaluation is asked for and may begin.
  [[nodiscard]] bool next_request();
  void take_bus(std::size_t bus, const BusState& state);
  void take_frame(const BusFrame& frame);
  void take_signals(const BusFrame& in, std::uint32_t ignored, std::uint32_t key);
  void take_reading(const AnalogReading& reading);
  void refresh(std::size_t index);
  void tell_findings(std::size_t index);
  void tell_mode(std::size_t index, wire::LoopMode before);
  void set_flag(std::size_t index);
  [[nodiscard]] bool may_send(std::size_t bus) const {
    return buses_[bus].up && buses_[bus].room;
  }
  void serve();
  void broadcast();
  void broadcast_loop(std::size_t index);
  void send(std::size_t bus, const wire::CanFrame& frame);
  // The next notice, to be filled in.
  Notice& notify(NoticeKind kind, std::size_t index = 0);
  template <class Act>
  bool for_loops(int id, Act act);

  const config::Gateway& configuration_;
  Random& random_;
  wire::GatewayStatus gateway_;
  std::vector<wire::LoopStatus> status_;
  std::vector<wire::LoopParameters> configured_;
  mutable std::vector<wire::LoopMemory> memories_;  // room for save()
  SwapWatch swaps_;
  std::vector<std::unique_ptr<MonitoredLoop>> loops_;
  std::vector<Route> routes_;           // sorted
  std::vector<std::uint32_t> ignored_;  // of them, each once
  std::vector<AnalogPoint> points_;
  std::vector<BusState> buses_;
  std::vector<bool> bus_off_;
  wire::DtcStore dtcs_;
  std::unique_ptr<wire::UdsConnection> uds_;
  WindowCopy recording_;
  WindowCopy kept_;  // while save_windows() works
  HistorySource* history_ = nullptr;
  bool history_goes_out_ = false;  // by an upload

  Now now_;
  std::int64_t start_us_ = 0;
  std::int64_t refreshed_us_ = 0;
  std::vector<std::int64_t> sent_us_;  // when the status frame of each loop was
  std::vector<bool> changed_;          // since then
  std::size_t turn_ = 0;               // the loop that is evaluated
  RequestBudget requests_;
  std::size_t asked_turn_ = 0;  // the loop that is evaluated on request
  bool charged_ = false;        // the call of work() before was for a request
  bool started_ = false;

  std::array<OutFrame, kMostFrames> frames_;
  std::size_t frame_count_ = 0;
  std::array<Notice, kMostNotices + 1> notices_;  // and one that is lost
  std::size_t notice_count_ = 0;
  std::array<LoopRow, wire::kMostLoops> rows_;
  std::size_t row_count_ = 0;
  std::array<bool, wire::kMostLoops> flags_{};
  Outputs outputs_;
};

}  // namespace firmware
