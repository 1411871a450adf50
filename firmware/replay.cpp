#include "firmware/replay.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "firmware/event_loop.hpp"
#include "hal/candump_file.hpp"

namespace firmware {
namespace {

constexpr int kSlice = 1000;
constexpr std::int64_t kBack_us = 1'000'000;
constexpr std::int64_t kOn_us = 3'600'000'000;

bool is_beside_can(const config::Source* source) {
  return source && source->kind != config::SourceKind::kCan;
}

}  // namespace

Replay::Replay(const config::Gateway& configuration)
    : configuration_(configuration),
      random_(system_random()),
      daemon_(configuration, *random_, STICKBAND_VERSION),
      lines_(configuration.loops.size()),
      states_(configuration.buses.size(), BusState{.up = true}) {
  for (std::size_t k = 0; k < lines_.size(); ++k) {
    const auto& flag = configuration.loops[k].flag;
    if (flag) (void)lines_[k].open(flag->fail_safe);
    const auto stale_us = std::llround(configuration.loops[k].stale_after_s * 1e6);
    quiet_us_ = std::max<std::int64_t>(quiet_us_, stale_us + kBack_us);
  }
}

void Replay::run_to(std::int64_t log_us, const Listener& listener) {
  const std::int64_t gap_us = log_us + offset_us_ - now_us_;
  const bool back = gap_us < -kBack_us;
  const bool jump = back || gap_us > std::max(kOn_us, 2 * quiet_us_);
  const std::int64_t until_us = jump ? now_us_ + quiet_us_ : log_us + offset_us_;
  while (next_us_ < until_us) step(next_us_, {}, listener);
  if (!jump) return;
  const double gap_s = static_cast<double>(gap_us) / 1e6;
  listener({.kind = NoticeKind::kGap, .t_us = now_us_, .gap_s = gap_s},
           static_cast<double>(now_us_ - start_us_) / 1e6);
  if (back) offset_us_ = now_us_ - log_us;
}

void Replay::step(std::int64_t t_us, std::span<const BusFrame> frames,
                  const Listener& listener) {
  now_us_ = t_us;
  const Outputs& outputs = daemon_.step({t_us, t_us}, {frames, {}, states_});
  next_us_ = outputs.next_us;
  for (const Notice& notice : outputs.notices) {
    listener(notice, static_cast<double>(notice.t_us - start_us_) / 1e6);
  }
  for (std::size_t k = 0; k < lines_.size(); ++k) {
    if (lines_[k].is_open) (void)lines_[k].set(outputs.flags[k]);
  }
  sent_.clear();
  for (const OutFrame& out : outputs.frames) {
    if (configuration_.uds && out.bus == configuration_.uds->bus)
      sent_.push_back(out.frame);
  }
  while (daemon_.work(kSlice)) {
  }
}

bool Replay::open_logs(const std::string& log) {
  static const hal::FakeClock clock;
  const auto of = [&log](const std::string& interface) {
    return std::make_unique<hal::CandumpFile>(log, interface, hal::ReplayPace::kFast,
                                              clock);
  };
  files_.clear();
  if (configuration_.buses.size() == 1) {
    files_.push_back(of(""));
    if (!files_[0]->open()) return true;
    const std::vector<std::string> found = files_[0]->interfaces();
    if (found.size() < 2) return true;
    const std::string wanted = name_in_log(configuration_.buses[0]);
    std::string all;
    for (const std::string& name : found) all += (all.empty() ? "" : ", ") + name;
    if (std::ranges::find(found, wanted) == found.end()) {
      error_ = log + ": expected frames of " + wanted + " or of one interface, found " +
               all + "; name the one in `interface` of [bus." +
               configuration_.buses[0].name + "]";
      return false;
    }
    files_[0] = of(wanted);
  } else {
    for (const config::Bus& bus : configuration_.buses) {
      files_.push_back(of(name_in_log(bus)));
    }
  }
  return true;
}

bool Replay::play(const std::string& log, const Listener& listener) {
  const auto has_input = [](const config::Loop& loop) {
    return !is_beside_can(&loop.u) && !is_beside_can(&loop.y);
  };
  if (std::ranges::none_of(configuration_.loops, has_input)) {
    error_ = sources_beside_can(configuration_).front();
    return false;
  }
  if (!open_logs(log)) return false;
  // The log of each bus with its next frame; a bus the log does not name stays silent.
  std::vector<BusFrame> next(files_.size());
  std::vector<bool> pending(files_.size());
  const auto fetch = [&](std::size_t k) {
    std::array<hal::ReceivedFrame, 1> one;
    std::size_t count = 0;
    (void)files_[k]->read(one, count);
    pending[k] = count == 1;
    next[k] = {k, one[0].time_us, one[0].frame};
  };
  for (std::size_t k = 0; k < files_.size(); ++k) {
    if (files_[k]->open()) {
      fetch(k);
    } else {
      error_ = files_[k]->error();
    }
  }
  for (;;) {
    std::size_t first = files_.size();
    for (std::size_t k = 0; k < files_.size(); ++k) {
      if (pending[k] && (first == files_.size() || next[k].t_us < next[first].t_us))
        first = k;
    }
    if (first == files_.size()) break;
    BusFrame frame = next[first];
    if (frames_++ == 0) start_us_ = now_us_ = next_us_ = frame.t_us;
    run_to(frame.t_us, listener);
    frame.t_us = std::max(now_us_, frame.t_us + offset_us_);
    step(frame.t_us, std::span(&frame, 1), listener);
    fetch(first);
    if (!pending[first] && files_[first]->failed()) {
      error_ = files_[first]->error();
      return false;
    }
  }
  if (frames_ == 0) return false;
  for (const auto& file : files_) cut_line_ = std::max(cut_line_, file->cut_line());
  daemon_.evaluate_all();
  step(now_us_ + 10'000, {}, listener);
  return true;
}

std::vector<std::uint8_t> Replay::ask(std::span<const std::uint8_t> request) {
  if (!configuration_.uds) return {};
  const config::Uds& uds = *configuration_.uds;
  std::array<std::uint8_t, 4095> receive;
  std::array<std::uint8_t, 4095> transmit;
  wire::IsoTpLink tester({.request_id = uds.response_id,
                          .response_id = uds.request_id,
                          .functional_id = uds.functional_id,
                          .extended_ids = uds.extended_ids,
                          .answer_busy = false},
                         receive, transmit);
  if (!tester.send(request)) return {};
  constexpr int kMostSteps = 2000;
  for (int k = 0; k < kMostSteps; ++k) {
    std::vector<BusFrame> frames;
    while (const auto frame = tester.poll(now_us_)) {
      frames.push_back({uds.bus, now_us_, *frame});
    }
    step(now_us_ + 1000, frames, [](const Notice&, double) {});
    for (const wire::CanFrame& frame : sent_) tester.on_frame(frame, now_us_);
    if (const auto answer = tester.request())
      return {answer->data.begin(), answer->data.end()};
  }
  return {};
}

std::vector<std::string> sources_beside_can(const config::Gateway& configuration) {
  std::vector<std::string> lines;
  for (const config::Loop& loop : configuration.loops) {
    const auto sources = sources_of(loop);
    const auto* const found = std::ranges::find_if(sources, is_beside_can);
    if (found == sources.end()) continue;
    const bool is_register = (*found)->kind == config::SourceKind::kModbus;
    lines.push_back(config::at_place(
        configuration, (*found)->place,
        std::string("expected a signal on CAN, found ") +
            (is_register ? "a Modbus register" : "a converter") +
            ": a CAN log has no value of it; replay loops whose u and y are on CAN"));
  }
  return lines;
}

}  // namespace firmware
