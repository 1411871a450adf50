// long_run SAMPLES [SECONDS]: one monitor through a long stream of mixed recordings.
//
// The recordings follow each other without end, every other one after a gap, while the
// monitor takes a slice of work after each sample, as on a device. Whenever it has judged
// a window, a new monitor judges the same samples, told nothing of the past but the valve
// that its search starts from; the two answers must be the same to the bit. Verdicts that
// rest on several windows together are counted only: a new monitor has seen one. Ends
// after SAMPLES, or at the next recording after SECONDS, and says how far it came; status
// 1 when an answer differed.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "ident/monitor.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace {

using Monitor = ident::Monitor<float, ident::kStandardWindow>;
using Report = ident::MonitorReport<float>;
using Sample = ident::Sample<float>;

constexpr std::int64_t kPeriod_us = 1'000'000;
constexpr std::int64_t kGap_us = 60 * kPeriod_us;
constexpr int kSlice = 1000;  // 0.6 s of a Cortex-M4F at 168 MHz in each second
constexpr int kUsage = 2;
constexpr float kApart = 0.01F;  // a band that differs by more is counted

struct Scenario {
  const char* name;
  std::uint64_t seed;
};
constexpr Scenario kMixed[] = {{"paper-example-1", 1}, {"healthy", 1},
                               {"stiction", 2},        {"external-sinusoid", 1},
                               {"stiction-mixed", 1},  {"tight-tuning", 1},
                               {"backlash", 1},        {"stiction-setpoint", 2},
                               {"random-load", 1},     {"paper-example-1-ascending", 3},
                               {"quantised", 1},       {"stiction-integrating", 1}};

std::vector<std::vector<Sample>> mixed_recordings() {
  std::vector<std::vector<Sample>> out;
  for (const Scenario& scenario : kMixed) {
    const auto loop = workbench::simulate(scenario.name, scenario.seed);
    if (!loop) {
      std::fprintf(stderr, "long_run: no scenario %s\n", scenario.name);
      std::exit(kUsage);
    }
    std::vector<Sample>& samples = out.emplace_back();
    for (std::size_t t = 0; t < loop->u.size(); ++t) {
      samples.push_back(
          {0, static_cast<float>(loop->u[t]), static_cast<float>(loop->y[t])});
    }
  }
  return out;
}

ident::MonitorSettings<float> settings() {
  ident::MonitorSettings<float> out;
  out.sample_period_us = kPeriod_us;
  out.evaluate_every_pct = 100;
  return out;
}

// What a judged window is compared by.
struct Answer {
  explicit Answer(const Report& report)
      : verdict(report.verdict), reason(report.reason), samples(report.window_samples) {
    for (const auto* e : {&report.stick_band.ascending, &report.stick_band.descending}) {
      bands[count++] = e->known ? e->value : 0;
    }
  }
  bool operator==(const Answer& other) const {
    return verdict == other.verdict && reason == other.reason && samples == other.samples;
  }
  /// Largest difference of a stick band, as a share of the other's larger one.
  [[nodiscard]] float apart(const Answer& other) const {
    const float band = std::max(other.bands[0], other.bands[1]);
    const float most = std::max(std::abs(bands[0] - other.bands[0]),
                                std::abs(bands[1] - other.bands[1]));
    return band > 0 ? most / band : most;
  }

  ident::Verdict verdict;
  ident::Reason reason;
  std::size_t samples;
  std::size_t count = 0;
  std::array<float, 2> bands{};
};

// The same samples before a monitor that has seen nothing else. Windows come back when
// the recordings do; each is judged once with each valve to start from.
class FreshAnswers {
 public:
  Answer of(const std::vector<Sample>& window, const ident::EarlierValve& earlier) {
    std::string key;
    const auto& f = earlier.friction;
    for (const float value : {f.deadband, f.slip_ascending, f.slip_descending,
                              static_cast<float>(f.motion), earlier.slow, earlier.fast,
                              earlier.unexplained, static_cast<float>(earlier.trusted)}) {
      key.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    for (const Sample& sample : window) {
      key.append(reinterpret_cast<const char*>(&sample.u), sizeof sample.u);
      key.append(reinterpret_cast<const char*>(&sample.y), sizeof sample.y);
    }
    const auto found = known_.find(key);
    if (found != known_.end()) {
      return found->second;
    }
    const auto monitor = std::make_unique<Monitor>(settings());
    ident::MonitorMemory memory;
    memory.earlier = earlier;
    monitor->restore(memory, 0);
    for (const Sample& sample : window) {
      static_cast<void>(monitor->push(sample));
    }
    monitor->evaluate_now();
    return known_.emplace(std::move(key), Answer(monitor->report())).first->second;
  }
  [[nodiscard]] std::size_t distinct() const { return known_.size(); }

 private:
  std::map<std::string, Answer> known_;
};

class LongRun {
 public:
  void push(const Sample& sample) {
    recent_.push_back(sample);
    if (recent_.size() > 2 * Monitor::kCapacity) {
      recent_.pop_front();
    }
    static_cast<void>(monitor_->push(sample));
    static_cast<void>(monitor_->step(kSlice));
    const Report report = monitor_->report();
    if (report.counters.evaluations != evaluations_) {
      evaluations_ = report.counters.evaluations;
      compare(report);
    }
    while (monitor_->poll()) {
      ++events_;
    }
  }
  [[nodiscard]] int differing() const { return differing_; }
  void tell(std::uint64_t samples, double seconds) const {
    const Report report = monitor_->report();
    std::printf(
        "samples %llu\nevaluations %u\ndistinct_windows %zu\ndiffering %d\n"
        "skipped_windows %u\noverruns %llu\nevents %u\nevents_lost %u\nrestarts %llu\n"
        "seconds %.0f\n",
        static_cast<unsigned long long>(samples), evaluations_, fresh_.distinct(),
        differing_, report.counters.skipped_windows,
        static_cast<unsigned long long>(report.samples.overruns), events_,
        report.counters.events_lost,
        static_cast<unsigned long long>(report.samples.restarts), seconds);
    std::printf("judged_together %d\n", together_);
    std::printf("bands_more_than_1_percent_apart %d\nmost_apart_percent %.3f\n",
                bands_apart_, 100.0 * static_cast<double>(most_apart_));
    for (const auto& [verdict, count] : verdicts_) {
      std::printf("verdict %s %d\n", verdict.c_str(), count);
    }
  }

 private:
  void compare(const Report& report) {
    const ident::EarlierValve earlier = earlier_;
    earlier_ = monitor_->memory().earlier;
    ++verdicts_[std::string(ident::name(report.verdict))];
    std::size_t end = recent_.size();
    while (end > 0 && recent_[end - 1].t_us != report.window_end_us) {
      --end;
    }
    if (end < report.window_samples) {
      std::fprintf(stderr, "long_run: the window is no longer kept\n");
      ++differing_;
      return;
    }
    const auto last = recent_.begin() + static_cast<std::ptrdiff_t>(end);
    const std::vector<Sample> window(
        last - static_cast<std::ptrdiff_t>(report.window_samples), last);
    if (report.reason == ident::Reason::kSticksTogether ||
        report.reason == ident::Reason::kWindowsDisagree) {
      ++together_;
      return;
    }
    const Answer fresh = fresh_.of(window, earlier);
    const float apart = Answer(report).apart(fresh);
    bands_apart_ += apart > kApart ? 1 : 0;
    most_apart_ = std::max(most_apart_, apart);
    if (!(fresh == Answer(report))) {
      ++differing_;
      std::fprintf(stderr, "long_run: at %lld us: %s, a new monitor says %s\n",
                   static_cast<long long>(report.window_end_us),
                   std::string(ident::name(report.verdict)).c_str(),
                   std::string(ident::name(fresh.verdict)).c_str());
    }
  }

  std::unique_ptr<Monitor> monitor_ = std::make_unique<Monitor>(settings());
  FreshAnswers fresh_;
  ident::EarlierValve earlier_;  // of the monitor, before the window that it judges
  std::deque<Sample> recent_;
  std::map<std::string, int> verdicts_;
  std::uint32_t evaluations_ = 0;
  std::uint32_t events_ = 0;
  int differing_ = 0;
  int together_ = 0;
  int bands_apart_ = 0;
  float most_apart_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  const std::uint64_t wanted = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 0;
  const double most_s = argc > 2 ? std::atof(argv[2]) : 1e9;
  if (wanted == 0 || argc > 3) {
    std::fputs("usage: long_run SAMPLES [SECONDS]\n", stderr);
    return kUsage;
  }
  const auto recordings = mixed_recordings();
  const auto begin = std::chrono::steady_clock::now();
  const auto seconds = [begin] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
        .count();
  };
  LongRun run;
  std::uint64_t samples = 0;
  std::int64_t t_us = 0;
  for (std::size_t turn = 0; samples < wanted && seconds() < most_s; ++turn) {
    const std::vector<Sample>& recording = recordings[turn % recordings.size()];
    t_us += turn % 2 == 0 ? 0 : kGap_us;
    for (std::size_t t = 0; t < recording.size() && samples < wanted; ++t, ++samples) {
      Sample sample = recording[t];
      sample.t_us = t_us += kPeriod_us;
      run.push(sample);
    }
  }
  run.tell(samples, seconds());
  return run.differing() == 0 ? 0 : 1;
}
