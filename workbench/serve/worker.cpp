#include "workbench/serve/worker.hpp"

#include <sys/resource.h>

#include <utility>

#include "workbench/model/base/work.hpp"

namespace workbench {
namespace {

// So that answers to the page, and the browser that draws them, go before. On Linux this
// is of the calling thread, and of those that it starts.
void step_back() {
  constexpr int kNiceness = 5;
  static_cast<void>(setpriority(PRIO_PROCESS, 0, kNiceness));
}

}  // namespace

Worker::~Worker() {
  cancel();
}

bool Worker::start(std::string task, Task work) {
  const std::lock_guard starting(starting_);
  {
    const std::lock_guard lock(mutex_);
    if (now_) return false;
    now_ = WorkProgress{std::move(task), {}, 0, 0, 0, false};
    began_ = Clock::now();
    failure_ = nullptr;
  }
  thread_ = std::jthread(
      [this, work = std::move(work)](const std::stop_token& stop) { run(stop, work); });
  return true;
}

void Worker::run(const std::stop_token& stop, const Task& work) {
  std::exception_ptr failure;
  step_back();
  try {
    work(
        [this, &stop](std::string_view detail, int number, int of) {
          if (stop.stop_requested()) throw Cancelled{};
          const std::lock_guard lock(mutex_);
          now_->detail = detail;
          now_->number = number;
          now_->of = of;
        },
        stop);
  } catch (const Cancelled&) {
  } catch (const Stopped&) {
  } catch (...) {
    failure = std::current_exception();
  }
  const std::lock_guard lock(mutex_);
  now_.reset();
  failure_ = failure;
}

void Worker::cancel() {
  const std::lock_guard starting(starting_);
  {
    const std::lock_guard lock(mutex_);
    if (now_) now_->stopping = true;
  }
  thread_ = std::jthread();  // asks the old one to stop and joins it
  const std::lock_guard lock(mutex_);
  failure_ = nullptr;
}

std::optional<WorkProgress> Worker::progress() const {
  const std::lock_guard lock(mutex_);
  std::optional<WorkProgress> out = now_;
  if (out) out->seconds = std::chrono::duration<double>(Clock::now() - began_).count();
  return out;
}

std::exception_ptr Worker::failure() const {
  const std::lock_guard lock(mutex_);
  return failure_;
}

}  // namespace workbench
