#include "python/core/long_work.hpp"

#include <pybind11/pybind11.h>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

namespace stickband_python {
namespace {

constexpr std::chrono::milliseconds kListen{50};  // between two looks for Ctrl-C

// The work and how far it is.
class Job {
 public:
  explicit Job(const std::function<void(const std::stop_token&)>& work)
      : thread_([this, &work](const std::stop_token& stop) {
          try {
            work(stop);
          } catch (...) {
            failure_ = std::current_exception();
          }
          const std::lock_guard lock(mutex_);
          done_ = true;
          ended_.notify_all();
        }) {}

  [[nodiscard]] bool ended_within(std::chrono::milliseconds time) {
    std::unique_lock lock(mutex_);
    return ended_.wait_for(lock, time, [this] { return done_; });
  }
  void stop() { thread_.request_stop(); }
  /// Waits for the end.
  [[nodiscard]] std::exception_ptr failure() {
    thread_.join();
    return failure_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable ended_;
  bool done_ = false;
  std::exception_ptr failure_;
  std::jthread thread_;  // last: it uses the others
};

}  // namespace

void run_long(const std::function<void(const std::stop_token&)>& work) {
  bool interrupted = false;
  std::exception_ptr failure;
  {
    const pybind11::gil_scoped_release released;
    Job job(work);
    while (!interrupted && !job.ended_within(kListen)) {
      const pybind11::gil_scoped_acquire held;
      interrupted = PyErr_CheckSignals() != 0;  // what was raised stays with this thread
    }
    if (interrupted) job.stop();
    failure = job.failure();
  }
  if (interrupted) throw pybind11::error_already_set();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace stickband_python
