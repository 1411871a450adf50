// One piece of long work at a time, on a thread of its own, with progress.
#pragma once

#include <chrono>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

namespace workbench {

/// How far a piece of work has come.
struct WorkProgress {
  std::string task;    ///< "explain"
  std::string detail;  ///< "valve.stiction"; may be empty
  int number = 0;      ///< of the part under way, from 1 on; 0: not known
  int of = 0;
  double seconds = 0;     ///< since the start
  bool stopping = false;  ///< asked to stop, and about to
};

/// start → progress … → done, or failure, or cancelled. Every member may be called from
/// any thread but that of the work itself.
class Worker {
 public:
  /// Handed to the work, which calls it between its parts: throws where the work was
  /// cancelled, so that it unwinds. No InputError and no std::exception.
  using Report = std::function<void(std::string_view detail, int number, int of)>;
  /// What is done. It may also let a Work (model/work.hpp) ask the token, which throws
  /// Stopped.
  using Task = std::function<void(const Report& report, const std::stop_token& stop)>;

  Worker() = default;
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Starts `work` and forgets the last failure. False, and nothing started, while other
  /// work is under way.
  [[nodiscard]] bool start(std::string task, Task work);
  /// Asks the work to stop and waits for it: as long as one of its parts takes. Forgets
  /// the last failure.
  void cancel();

  /// Nothing while no work is under way.
  [[nodiscard]] std::optional<WorkProgress> progress() const;
  /// What the last work threw; null where it ended well or was cancelled.
  [[nodiscard]] std::exception_ptr failure() const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Cancelled {};

  void run(const std::stop_token& stop, const Task& work);

  mutable std::mutex mutex_;         // of the next four
  std::optional<WorkProgress> now_;  // set while work is under way
  Clock::time_point began_;
  std::exception_ptr failure_;
  std::jthread thread_;
  std::mutex starting_;  // held by start and cancel as a whole
};

}  // namespace workbench
