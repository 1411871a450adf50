#include "workbench/model/base/work.hpp"

#include <algorithm>
#include <exception>
#include <numeric>

namespace workbench {
namespace {

thread_local std::uint64_t spent_samples = 0;

// Thirty years: what the clock counts in 64 bits holds nine times that.
constexpr double kLongest_s = 1e9;

}  // namespace

// A for_each() that goes on. All but what is constant is guarded by the mutex.
struct Work::Loop {
  const std::function<void(std::size_t)>& part;
  const std::uint64_t spent_before;
  std::vector<std::uint64_t> spent;  // by each part
  std::vector<std::exception_ptr> failures;
  std::uint64_t number = 0;
  std::size_t next = 0;
  std::size_t running = 0;
  bool failed = false;

  Loop(std::size_t count, const std::function<void(std::size_t)>& what)
      : part(what), spent_before(spent_samples), spent(count), failures(count) {}

  [[nodiscard]] bool has_part() const { return next < spent.size() && !failed; }
};

Work::Work(const Limits& limits)
    : threads_(std::max(limits.threads, 1U)), stop_(limits.stop) {
  if (limits.seconds) {
    const std::chrono::duration<double> time(std::min(*limits.seconds, kLongest_s));
    end_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(time);
  }
}

Work::~Work() {
  {
    const Lock lock(mutex_);
    ends_ = true;
  }
  changed_.notify_all();
  helpers_.clear();  // while what they wait for is still there
}

const Work& Work::unlimited() {
  static const Work work;
  return work;
}

unsigned Work::cores() {
  return std::max(1U, std::thread::hardware_concurrency());
}

bool Work::out_of_time() const {
  return end_ && Clock::now() >= *end_;
}

void Work::check() const {
  check_stop(stop_);
  if (writing_ == 0 && out_of_time()) throw OutOfTime{};
}

void Work::spend(std::size_t samples) {
  spent_samples += samples;
}

std::uint64_t Work::spent() {
  return spent_samples;
}

void Work::do_part(Loop& loop, Lock& lock) const {
  const std::size_t i = loop.next++;
  ++loop.running;
  lock.unlock();
  spent_samples = loop.spent_before;
  std::exception_ptr failure;
  try {
    loop.part(i);
  } catch (...) {
    failure = std::current_exception();
  }
  loop.spent[i] = spent_samples - loop.spent_before;
  loop.failures[i] = failure;
  lock.lock();
  loop.failed = loop.failed || failure;
  if (--loop.running == 0 && !loop.has_part()) changed_.notify_all();
}

// The newest first: they are parts of what others wait for.
bool Work::help(Lock& lock, std::uint64_t after) const {
  for (std::size_t i = open_.size(); i-- > 0 && open_[i]->number > after;) {
    if (!open_[i]->has_part()) continue;
    do_part(*open_[i], lock);
    return true;
  }
  return false;
}

void Work::start_helpers() const {
  while (helpers_.size() + 1 < threads_) {
    helpers_.emplace_back([this] {
      Lock lock(mutex_);
      while (!ends_) {
        if (!help(lock, 0)) changed_.wait(lock);
      }
    });
  }
}

void Work::for_each(std::size_t count,
                    const std::function<void(std::size_t)>& part) const {
  Loop loop(count, part);
  Lock lock(mutex_);
  if (threads_ > 1 && count > 1) {
    start_helpers();
    loop.number = ++opened_;
    open_.push_back(&loop);
    changed_.notify_all();
  }
  while (loop.has_part()) do_part(loop, lock);
  while (loop.running > 0) {
    // What others do of this loop may be waiting for parts of its own. Not older ones:
    // they may take long.
    if (!help(lock, loop.number)) changed_.wait(lock);
  }
  std::erase(open_, &loop);
  lock.unlock();
  spent_samples =
      std::accumulate(loop.spent.begin(), loop.spent.end(), loop.spent_before);
  for (const std::exception_ptr& failure : loop.failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

}  // namespace workbench
