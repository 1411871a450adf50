// A session on a loop with a dead time of six samples.
#pragma once

#include <chrono>
#include <cmath>
#include <string>
#include <thread>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/serve/session.hpp"

namespace workbench::test {

inline Recording late_recording(std::uint64_t seed = 1000) {
  SetpointLoop loop;
  loop.delay = 6;
  loop.seed = seed;
  Recording recording = simulated(loop);
  recording.name = "late.csv";
  return recording;
}

// Coarse readings cost nothing while a ramp is missing, and most of the error beside it.
inline Recording drifting_and_coarse() {
  SetpointLoop loop;
  loop.load = [](std::size_t k) { return 0.02 * static_cast<double>(k); };
  loop.sensor = [](double y) { return 3 * std::round(y / 3); };
  return simulated(loop);
}

inline std::string csv_of(const Recording& r) {
  std::string text = "t,u,y,x\n";
  for (std::size_t k = 0; k < r.size(); ++k) {
    text += std::to_string(r.t[k]) + ',' + std::to_string(r.u[k]) + ',' +
            std::to_string(r.y[k]) + ',' + std::to_string(r.x[k]) + '\n';
  }
  return text;
}

inline void wait(const Session& session) {
  while (session.progress()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

inline void wait_for_verdict(const Session& session) {
  while (session.verdict_progress()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

}  // namespace workbench::test
