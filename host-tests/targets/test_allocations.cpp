// On Linux too the monitor takes nothing from the heap: every call of the allocator is
// counted while a whole recording goes through it.
#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <new>

#include "ident/monitor.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace {
std::size_t calls = 0;
}

// The C library's own, under the names by which it lets a program replace them.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* memory);

void* malloc(std::size_t size) {
  ++calls;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  ++calls;
  return __libc_calloc(count, size);
}
void* realloc(void* memory, std::size_t size) {
  ++calls;
  return __libc_realloc(memory, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  ++calls;
  return __libc_memalign(alignment, size);
}
void free(void* memory) {
  calls += memory != nullptr ? 1 : 0;
  __libc_free(memory);
}
}

namespace ident {
namespace {

using Device = Monitor<float, kStandardWindow>;

TEST(Allocations, AreSeenByTheCount) {
  const std::size_t before = calls;
  const auto number = std::make_unique<int>(3);
  static_cast<void>(*static_cast<volatile int*>(number.get()));
  EXPECT_GT(calls, before);
}

TEST(Allocations, AreNoneOverAWholeRecording) {
  const auto loop = *workbench::simulate("paper-example-1", 1);
  MonitorSettings<float> settings;
  settings.sample_period_us = 500'000;
  const auto monitor = std::make_unique<Device>(settings);
  Sample<float> sample;
  int events = 0;
  const std::size_t before = calls;
  for (std::size_t t = 0; t < loop.u.size(); ++t) {
    sample.t_us += settings.sample_period_us;
    sample.u = static_cast<float>(loop.u[t]);
    sample.y = static_cast<float>(loop.y[t]);
    static_cast<void>(monitor->push(sample));
    monitor->advance(sample.t_us);
    while (monitor->step(100)) {
    }
    while (monitor->poll()) {
      ++events;
    }
  }
  monitor->evaluate_now();
  const MonitorReport<float> report = monitor->report();
  const std::size_t after = calls;
  EXPECT_EQ(after - before, 0u);
  EXPECT_GE(report.counters.evaluations, 3u);
  EXPECT_EQ(report.verdict, Verdict::kStiction);
  EXPECT_GE(events, 1);
}

}  // namespace
}  // namespace ident
