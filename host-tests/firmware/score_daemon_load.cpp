// Prints what the daemon as a whole costs under a full bus (daemon_load.hpp), system
// calls included:
//   score_daemon_load seconds N   8,000 frames a second for that long, loops at 10 Hz
//   score_daemon_load frames N    that many as fast as it reads them, loops at 100 Hz,
//                                 once every window is full: what its memory does; exit
//                                 code 1 where it grows or is more than kMostKib
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string_view>

#include "firmware/daemon_load.hpp"

namespace {

constexpr double kFullBus = 8'000;    // frames a second at 1 Mbit/s
constexpr double kFilling_s = 204.8;  // a window of 2,048 samples at 10 Hz
constexpr long kMostKib = 16 * 1024L;

double now_s() {
  return std::chrono::duration<double>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

void print(const char* figure, const char* format, double value) {
  std::printf("| %s | ", figure);
  std::printf(format, value);
  std::printf(" |\n");
}

// In all; of which is its own, not the code of programs and libraries as it is read in.
struct Memory {
  long all_kib;
  long own_kib;
};

Memory print_memory(const char* when, const Process& process) {
  const Memory memory{process.memory_kib("VmRSS"), process.memory_kib("RssAnon")};
  std::printf("| resident memory %s, KiB; of which its own | %ld; %ld |\n", when,
              memory.all_kib, memory.own_kib);
  return memory;
}

void play(DaemonLoad& load, double seconds, const char* when) {
  const std::uint64_t sent_before = load.sent();
  const double cpu_before_s = load.process().cpu_s();
  const double start_s = now_s();
  load.play(static_cast<std::uint64_t>(seconds * kFullBus), kFullBus);
  const double spent_s = now_s() - start_s;
  const double cpu_s = load.process().cpu_s() - cpu_before_s;
  std::printf("| while %s, s | %.0f |\n", when, spent_s);
  print("frames a second", "%.0f",
        static_cast<double>(load.sent() - sent_before) / spent_s);
  print("one core, system calls included, %", "%.2f", 100 * cpu_s / spent_s);
}

void score_time(double seconds) {
  DaemonLoad load(STICKBAND_DAEMON, 0.1);
  const double first_s = std::min(seconds, kFilling_s);
  play(load, first_s, "the windows fill up");
  if (seconds > first_s) play(load, seconds - first_s, "they are full");
  print("frames lost by us", "%.0f", load.metric("dropped"));
  print("queries", "%.0f", static_cast<double>(load.asked()));
  print("answered", "%.0f", static_cast<double>(load.answered()));
  print("slowest answer, ms", "%.1f", 1e3 * load.slowest_answer_s());
  print_memory("at the end", load.process());
}

bool score_memory(double frames) {
  constexpr double kWindow = 2048;  // samples
  constexpr double kPeriod_s = 0.01;
  DaemonLoad load(STICKBAND_DAEMON, kPeriod_s);
  const Memory first = print_memory("after the start", load.process());
  // All code has been read in once: each loop is identified.
  const double start_s = now_s();
  while (now_s() - start_s < 1.5 * kWindow * kPeriod_s) load.play(100'000, 0);
  print("frames until then", "%.0f", static_cast<double>(load.sent()));
  const Memory full = print_memory("with full windows", load.process());
  Memory last = full;
  for (int quarter = 1; quarter <= 4; ++quarter) {
    load.play(static_cast<std::uint64_t>(frames / 4), 0);
    print("frames until then", "%.0f", static_cast<double>(load.sent()));
    last = print_memory("then", load.process());
  }
  print("of them with a signal, at the last textfile", "%.0f", load.metric("frames"));
  const long most_kib = load.process().memory_kib("VmHWM");
  const long growth_kib = last.all_kib - full.all_kib;
  std::printf("| growth of its own since the start, KiB | %ld |\n",
              last.own_kib - first.own_kib);
  std::printf("| growth with full windows, KiB (goal 0) | %ld |\n", growth_kib);
  std::printf("| most resident memory, KiB (goal %ld) | %ld |\n", kMostKib, most_kib);
  return growth_kib <= 0 && most_kib <= kMostKib;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view what = argc == 3 ? argv[1] : "";
  const double count = argc == 3 ? std::atof(argv[2]) : 0;
  if ((what != "seconds" && what != "frames") || !(count >= 1)) {
    std::fputs("usage: score_daemon_load seconds N | frames N\n", stderr);
    return 2;
  }
  try {
    std::printf("| figure | value |\n|---|---|\n");
    if (what == "seconds") {
      score_time(count);
    } else {
      return score_memory(count) ? 0 : 1;
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
