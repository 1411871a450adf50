// What a long search may use, and when it has to end: cores, a time limit, a stop.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <vector>

#include "workbench/recording/stopped.hpp"

namespace workbench {

/// Thrown by Work::check() where the time is up. What was found so far still counts.
struct OutOfTime {};

/// Shared by all threads of one search; every member may be called from any of them. Its
/// answers depend on the clock, those of a search without time limit do not: for_each()
/// gives the same result for any number of threads.
class Work {
 public:
  struct Limits {
    unsigned threads = 1;             ///< at least 1
    std::optional<double> seconds{};  ///< from now on; none: no limit
    std::stop_token stop{};           ///< asks for an end from outside
  };

  Work() = default;
  explicit Work(const Limits& limits);
  ~Work();
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  /// One thread, no end: for whoever asks for nothing else.
  [[nodiscard]] static const Work& unlimited();
  /// Cores of this machine, at least 1.
  [[nodiscard]] static unsigned cores();

  /// Throws Stopped or OutOfTime. Some 30 ns; called before every simulation.
  void check() const;
  [[nodiscard]] bool out_of_time() const;
  /// Adds to what this thread has spent, in samples simulated.
  static void spend(std::size_t samples);
  /// Spent so far by this thread and by the parts of its for_each(). Within a part: by
  /// that part and by what came before for_each(), whatever the number of threads.
  [[nodiscard]] static std::uint64_t spent();

  /// Calls `part` for 0 … count - 1, on every thread that has nothing else to do; parts
  /// may call it, too. Throws what the first part in order that threw has thrown. Worth
  /// it for parts of 0.1 ms and more.
  void for_each(std::size_t count, const std::function<void(std::size_t)>& part) const;

  /// While one lives, the time limit no longer ends anything: what was found is written
  /// down, with its intervals. A stop still does.
  class WritingDown {
   public:
    explicit WritingDown(const Work& work) : work_(work) { ++work_.writing_; }
    ~WritingDown() { --work_.writing_; }
    WritingDown(const WritingDown&) = delete;
    WritingDown& operator=(const WritingDown&) = delete;

   private:
    const Work& work_;
  };

 private:
  using Clock = std::chrono::steady_clock;
  using Lock = std::unique_lock<std::mutex>;
  struct Loop;

  void start_helpers() const;
  // One part of a loop that was opened after number `after`; false where none has any.
  bool help(Lock& lock, std::uint64_t after) const;
  void do_part(Loop& loop, Lock& lock) const;

  unsigned threads_ = 1;
  std::optional<Clock::time_point> end_;
  std::stop_token stop_;
  mutable std::atomic<int> writing_ = 0;

  mutable std::mutex mutex_;                 // of all that follows
  mutable std::condition_variable changed_;  // a loop was opened or ended
  mutable std::vector<Loop*> open_;          // in the order of their numbers
  mutable std::uint64_t opened_ = 0;         // loops so far
  mutable bool ends_ = false;
  mutable std::vector<std::jthread> helpers_;  // the threads but that of the caller
};

}  // namespace workbench
