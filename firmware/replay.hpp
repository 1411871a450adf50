// The daemon on a recorded CAN log: the same object, the log's clock, a line in memory
// instead of GPIO, as fast as the machine allows.
//
// Every frame of the log is taken to come from the bus it names, if that is a bus of the
// configuration; a log of one interface and a configuration of one bus always match, but
// of a log of several interfaces the configuration has to name one. An
// evaluation that is due ends before the next frame, and at the end each loop's window is
// evaluated once more.
//
// A CAN log has no value of a converter or a register: a loop that needs one stays
// without its input. Where no loop is left with u and y, there is nothing to play.
//
// A step of the log's clock, back by more than a second or on by more than an hour (and
// than the inputs need to be missed), is told as a gap: the inputs go missing, and the
// replay goes on from there.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "config/gateway.hpp"
#include "firmware/daemon.hpp"
#include "hal/candump_file.hpp"
#include "hal/fake_io.hpp"

namespace firmware {

class Replay {
 public:
  using Listener = std::function<void(const Notice&, double t_s)>;

  explicit Replay(const config::Gateway& configuration);

  /// Plays the whole log; `listener` hears each notice with the seconds since the first
  /// frame. False: error() says what is wrong with the log, or that it has no loop.
  [[nodiscard]] bool play(const std::string& log, const Listener& listener);
  [[nodiscard]] const std::string& error() const { return error_; }
  /// Number of the log's last line where it was cut and left out; 0: it was not.
  [[nodiscard]] std::size_t cut_line() const { return cut_line_; }

  /// Asks the diagnostic server over its own frames, as a tester on the bus; empty: no
  /// answer. Needs [uds] in the configuration.
  [[nodiscard]] std::vector<std::uint8_t> ask(std::span<const std::uint8_t> request);

  [[nodiscard]] const Daemon& daemon() const { return daemon_; }
  /// The line of a loop; closed if it has no flag.
  [[nodiscard]] const hal::FakeOutput& line(std::size_t loop) const {
    return lines_[loop];
  }
  [[nodiscard]] std::uint64_t frames() const { return frames_; }

 private:
  /// A log for each bus; false: there is no telling which lines are of the only one.
  [[nodiscard]] bool open_logs(const std::string& log);
  /// Lets the clock run to that time of the log.
  void run_to(std::int64_t log_us, const Listener& listener);
  void step(std::int64_t t_us, std::span<const BusFrame> frames,
            const Listener& listener);

  const config::Gateway& configuration_;
  std::unique_ptr<Random> random_;
  Daemon daemon_;
  std::vector<hal::FakeOutput> lines_;
  std::vector<BusState> states_;
  std::vector<std::unique_ptr<hal::CandumpFile>> files_;  // of the buses
  std::vector<wire::CanFrame> sent_;  // on the diagnostic bus, in the step before
  std::int64_t quiet_us_ = 0;         // until every input is missed
  std::int64_t offset_us_ = 0;        // from the clock of the log to ours
  std::int64_t start_us_ = 0;
  std::int64_t now_us_ = 0;
  std::int64_t next_us_ = 0;
  std::uint64_t frames_ = 0;
  std::size_t cut_line_ = 0;
  std::string error_;
};

/// The loops with a source that no CAN log has a value of, one line each: the first such
/// source, with its place in the file.
[[nodiscard]] std::vector<std::string> sources_beside_can(
    const config::Gateway& configuration);

}  // namespace firmware
