#include "workbench/model/base/work.hpp"

#include <algorithm>
#include <exception>
#include <numeric>
#include <thread>
#include <vector>

namespace workbench {
namespace {

thread_local bool busy = false;  // this thread is part of a for_each()
thread_local std::uint64_t spent_samples = 0;

class Busy {
 public:
  Busy() { busy = true; }
  ~Busy() { busy = false; }
  Busy(const Busy&) = delete;
  Busy& operator=(const Busy&) = delete;
};

}  // namespace

Work::Work(const Limits& limits)
    : threads_(std::max(limits.threads, 1U)), stop_(limits.stop) {
  if (limits.seconds) {
    end_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                              std::chrono::duration<double>(*limits.seconds));
  }
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
  if (stop_.stop_requested()) throw Stopped{};
  if (writing_ == 0 && out_of_time()) throw OutOfTime{};
}

void Work::spend(std::size_t samples) {
  spent_samples += samples;
}

std::uint64_t Work::spent() {
  return spent_samples;
}

void Work::for_each(std::size_t count,
                    const std::function<void(std::size_t)>& part) const {
  const std::size_t most = std::min<std::size_t>(threads_, count);
  const std::uint64_t before = spent_samples;
  std::vector<std::uint64_t> spent_by(count, 0);
  const auto do_part = [&](std::size_t i) {
    spent_samples = before;
    part(i);
    spent_by[i] = spent_samples - before;
  };
  const auto add_up = [&] {
    spent_samples = std::accumulate(spent_by.begin(), spent_by.end(), before);
  };
  if (most < 2 || busy) {
    for (std::size_t i = 0; i < count; ++i) do_part(i);
    add_up();
    return;
  }
  std::vector<std::exception_ptr> failures(count);
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> failed = false;
  const auto take_turns = [&] {
    const Busy mark;
    for (std::size_t i = next++; i < count && !failed; i = next++) {
      try {
        do_part(i);
      } catch (...) {
        failures[i] = std::current_exception();
        failed = true;
      }
    }
  };
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 1; i < most; ++i) threads.emplace_back(take_turns);
    take_turns();
  }
  add_up();
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

}  // namespace workbench
