// Prints what 31 loops at 10 Hz on a fully loaded bus cost: score_bus_load [SECONDS]
//
// Every one of 8,000 frames a second is handed to the daemon, in turns of 2 ms, shorter
// than those of its event loop. System calls are not in the figures (score_daemon_load
// has them). A tester asks all the time.
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "firmware/daemon_load.hpp"
#include "firmware/event_loop.hpp"

namespace {

constexpr int kFramesPerTurn = 16;
constexpr std::int64_t kTurn_us = 2'000;
constexpr std::int64_t kSample_us = 100'000;
constexpr std::uint64_t kTurnsPerSample = kSample_us / kTurn_us;
constexpr int kSlice = 8;

double cpu_s() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 300;
  const std::vector<workbench::SimulatedLoop> loops = load_loops();
  const config::Gateway gateway = config::parse_gateway(
      load_configuration("backend = \"socketcan\"\ninterface = \"can0\"\n",
                         1e-6 * kSample_us),
      "load.toml");
  const auto random = firmware::system_random();
  firmware::Daemon daemon(gateway, *random, "load");
  const std::vector<firmware::BusState> buses = {{.up = true}};
  const wire::CanFrame request{.id = 0x7E0, .dlc = 8, .data = {3, 0x22, 0xF1, 0x86}};

  std::vector<firmware::BusFrame> frames;
  double step_s = 0;
  double work_s = 0;
  double worst_step_s = 0;
  double worst_slice_s = 0;
  std::uint64_t asked = 0;
  std::uint64_t answered = 0;
  std::uint64_t given = 0;
  std::uint64_t turn = 0;
  bool waiting = false;
  for (std::int64_t now = kTurn_us; now < static_cast<std::int64_t>(seconds * 1e6);
       now += kTurn_us, ++turn) {
    frames.clear();
    const auto sample = static_cast<std::size_t>(now / kSample_us);
    for (int k = 0; k < kFramesPerTurn; ++k) {
      const int index = static_cast<int>(turn % kTurnsPerSample) * kFramesPerTurn + k;
      frames.push_back({0, now - 1000 + 50 * k, load_frame(loops, sample, index)});
    }
    if (turn % kTurnsPerSample == 7 && !waiting) {
      frames.push_back({0, now, request});
      ++asked;
      waiting = true;
    }
    given += frames.size();
    const double before = cpu_s();
    const auto& out = daemon.step({now, now}, {frames, {}, buses});
    const double middle = cpu_s();
    for (const auto& frame : out.frames) {
      if (frame.frame.id == 0x7E8) {
        ++answered;
        waiting = false;
      }
    }
    step_s += middle - before;
    worst_step_s = std::max(worst_step_s, middle - before);
    // The rest of the turn is for identification.
    double slice_from = middle;
    while (slice_from - before < 1e-6 * kTurn_us && daemon.work(kSlice)) {
      const double slice_to = cpu_s();
      worst_slice_s = std::max(worst_slice_s, slice_to - slice_from);
      work_s += slice_to - slice_from;
      slice_from = slice_to;
    }
  }
  std::uint32_t windows = 0;
  std::uint64_t skipped = 0;
  std::uint64_t gaps = 0;
  std::uint64_t taken = 0;
  for (std::size_t k = 0; k < kLoadLoops; ++k) {
    const auto report = daemon.loop(k).monitor().report();
    windows += report.counters.evaluations;
    skipped += report.counters.skipped_windows;
    gaps += daemon.loops()[k].counters.gaps;
    taken += daemon.loops()[k].counters.frames;
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("| figure | value |\n|---|---|\n");
  std::printf("| simulated time, s | %.0f |\n", seconds);
  std::printf("| frames, of them with a signal | %llu, %llu |\n",
              static_cast<unsigned long long>(given),
              static_cast<unsigned long long>(taken));
  std::printf("| sample periods without a value | %llu |\n",
              static_cast<unsigned long long>(gaps));
  std::printf("| windows identified, skipped | %u, %llu |\n", windows,
              static_cast<unsigned long long>(skipped));
  std::printf("| one core, frames and diagnostics, %% | %.2f |\n",
              100 * step_s / seconds);
  std::printf("| one core, identification, %% | %.2f |\n", 100 * work_s / seconds);
  std::printf("| longest step, ms | %.2f |\n", 1e3 * worst_step_s);
  std::printf("| longest slice of identification, ms | %.2f |\n", 1e3 * worst_slice_s);
  std::printf("| queries, answered in the same turn | %llu, %llu |\n",
              static_cast<unsigned long long>(asked),
              static_cast<unsigned long long>(answered));
  return 0;
}
