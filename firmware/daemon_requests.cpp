// What the diagnostic server asks of the daemon.
#include "firmware/daemon.hpp"

namespace firmware {

template <class Act>
bool Daemon::for_loops(int id, Act act) {
  bool any = false;
  for (const auto& loop : loops_) {
    if (id != 0 && loop->configuration().id != id) continue;
    act(*loop);
    any = true;
  }
  return any;
}

bool Daemon::write_parameters(int loop, const wire::LoopParameters& parameters) {
  return for_loops(loop, [&](MonitoredLoop& l) { l.set_parameters(parameters); });
}

bool Daemon::reset(int loop) {
  return for_loops(loop, [](MonitoredLoop& l) { l.reset(); });
}

bool Daemon::evaluate(int loop) {
  return for_loops(loop, [](MonitoredLoop& l) { l.request_evaluation(); });
}

bool Daemon::simulate(int loop, wire::LoopVerdict verdict) {
  return for_loops(loop, [verdict](MonitoredLoop& l) { l.simulate(verdict); });
}

void Daemon::end_simulation(int loop) {
  for_loops(loop, [](MonitoredLoop& l) { l.simulate(std::nullopt); });
}

void Daemon::tell(wire::UdsAct act, std::uint8_t tester, int loop) {
  wire::AccessCounters& counters = gateway_.access;
  switch (act) {
    case wire::UdsAct::kUnlocked:
      ++counters.unlocks;
      break;
    case wire::UdsAct::kRefusedKey:
      ++counters.refused_keys;
      break;
    case wire::UdsAct::kWritten:
      ++counters.writes;
      break;
    case wire::UdsAct::kCleared:
      ++counters.clears;
      break;
    case wire::UdsAct::kReset:
      ++counters.resets;
      break;
    case wire::UdsAct::kSimulated:
      ++counters.simulations;
      break;
  }
  Notice& notice = notify(NoticeKind::kAccess);
  notice.act = act;
  notice.tester = tester;
  notice.loop = loop;
}

std::uint32_t Daemon::begin_recording(int loop) {
  std::uint32_t bytes = 0;
  for_loops(loop,
            [&](MonitoredLoop& l) { bytes = recording_.take(loop, l.monitor(), now_); });
  return bytes;
}

std::uint32_t Daemon::begin_history(int loop) {
  const std::uint32_t bytes = history_ != nullptr ? history_->begin(loop) : 0;
  history_goes_out_ = bytes > 0;
  return bytes;
}

void Daemon::read_recording(std::uint32_t offset, std::span<std::uint8_t> out) {
  if (!history_goes_out_) {
    recording_.read(offset, out);
  } else if (history_ != nullptr) {
    history_->read(offset, out);
  }
}

void Daemon::end_recording() {
  recording_.clear();
  history_goes_out_ = false;
}

}  // namespace firmware
