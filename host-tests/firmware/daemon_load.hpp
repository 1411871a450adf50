// stickbandd under a full bus: 31 loops, frames over slcan on TCP, a tester that asks.
//
// 62 of 800 frames carry u or y of a loop, the rest is other traffic. On a SocketCAN bus
// the kernel keeps that from the daemon; here it reads every line, as text.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "firmware/process.hpp"
#include "hal/descriptor.hpp"
#include "support/base/temporary_folder.hpp"
#include "wire/can_frame.hpp"
#include "workbench/simulate/simulated_loop.hpp"

inline constexpr int kLoadLoops = 31;
inline constexpr int kLoadFrames = 800;  ///< until every signal has been sent once

/// Configuration of the loops, all on a bus that `bus_lines` describes.
[[nodiscard]] std::string load_configuration(const std::string& bus_lines,
                                             double sample_period_s);
/// What the loops do, stiction and other oscillations in turn.
[[nodiscard]] std::vector<workbench::SimulatedLoop> load_loops();
/// Frame number `index`, 0 … kLoadFrames − 1, with the values of sample `sample`.
[[nodiscard]] wire::CanFrame load_frame(
    const std::vector<workbench::SimulatedLoop>& loops, std::size_t sample, int index);

class DaemonLoad {
 public:
  /// Starts the program `daemon` in a folder of its own. Throws std::runtime_error.
  DaemonLoad(const std::string& daemon, double sample_period_s);
  DaemonLoad(const DaemonLoad&) = delete;
  DaemonLoad& operator=(const DaemonLoad&) = delete;

  /// `frames` at `per_s` (0: as fast as they are read). A query every 0.1 s.
  void play(std::uint64_t frames, double per_s);

  /// The tester goes; play() may not follow.
  void disconnect() { socket_.reset(); }
  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] const std::string& folder() const { return folder_.path(); }
  [[nodiscard]] Process& process() { return process_; }
  [[nodiscard]] std::uint64_t sent() const { return sent_; }
  [[nodiscard]] std::uint64_t asked() const { return asked_; }
  [[nodiscard]] std::uint64_t answered() const { return answered_; }
  [[nodiscard]] double slowest_answer_s() const { return slowest_s_; }
  /// A number of the textfile, summed over the loops.
  [[nodiscard]] double metric(const std::string& name) const;

 private:
  void connect_to(std::uint16_t port);
  void put(const wire::CanFrame& frame);
  void ask();
  /// Sends what is put together, and takes what has come; waits for that long at most.
  void exchange(int wait_ms);
  void take_line();

  double sample_period_s_;
  TemporaryFolder folder_;  // goes after the program that writes to it
  std::uint16_t port_;
  std::vector<workbench::SimulatedLoop> loops_;
  Process process_;
  hal::Descriptor socket_;
  std::string pending_;
  std::string line_;
  std::int64_t start_us_ = 0;
  std::int64_t asked_us_ = 0;
  bool waiting_ = false;
  std::uint64_t sent_ = 0;
  std::uint64_t asked_ = 0;
  std::uint64_t answered_ = 0;
  double slowest_s_ = 0;
};
