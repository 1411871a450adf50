// How often a load that comes back at its own time, or at any time, is taken for a
// sticking valve.
//
//   score_clocked [LOOPS=600] [SWITCHED=300]
//
// Draws loops whose valve follows, under loads that repeat: steps, ramps, saw teeth and
// other shapes, before or behind the process, with an exact clock or one whose periods
// vary by 2 or 5 %, as pumps between two level switches, batches and neighbours that hunt
// have. Half of them are recorded whenever the controller acts, a quarter each at every
// second and every third of its samples: what u and y did in between is lost, which makes
// fewer of them look like a valve. SWITCHED more loops have loads that are on or off for
// times of any length, as a feed or a consumer. Identifies each and prints Markdown
// tables of the verdicts. Nothing was chosen on these loops.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "workbench/analysis/analysis.hpp"

namespace {

using ident::Verdict;
using workbench::Recording;

constexpr std::array kShapes = {"steps", "unequal steps", "four levels", "ramps",
                                "saw",   "trapezes",      "lags",        "waves"};
constexpr std::size_t kUnequalSteps = 1;
constexpr std::array kJitters = {0.0, 0.02, 0.05};

enum class Times { kItsOwn, kAny };

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }
  double log_uniform(double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
  }
  double normal() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += uniform(0, 1);
    return sum;
  }
  template <class Values>
  auto one_of(const Values& values) {
    return values[static_cast<std::size_t>(random_() % std::size(values))];
  }

 private:
  std::mt19937_64 random_;
};

// A load of that shape at a phase from 0 to 1; `duty`: of unequal steps. −1 … 1.
double load_at(std::size_t shape, double phase, double duty) {
  const double ramps = phase < 0.5 ? 4 * phase - 1 : 3 - 4 * phase;
  const double lags =
      phase < 0.5 ? 1 - 2 * std::exp(-8 * phase) : 2 * std::exp(-8 * (phase - 0.5)) - 1;
  constexpr double kTurn = 6.283185307179586;
  switch (shape) {
    case 0:
      return phase < 0.5 ? 1 : -1;
    case 1:
      return phase < duty ? 1 : -1;
    case 2:
      return std::floor(4 * phase) / 1.5 - 1;
    case 3:
      return ramps;
    case 4:
      return 2 * phase - 1;
    case 5:
      return std::clamp(2 * ramps, -1.0, 1.0);
    case 6:
      return lags;
    default:
      return std::sin(kTurn * phase) + 0.3 * std::sin(2 * kTurn * phase);
  }
}

struct Loop {
  Recording recording;
  std::size_t shape = 0;
  double jitter = 0;
  std::size_t every = 1;  // of how many samples of the controller one is recorded
};

Loop loop_of(std::uint64_t seed, Times times) {
  Draw draw(seed);
  Loop out;
  out.shape = times == Times::kAny ? kUnequalSteps : seed % kShapes.size();
  out.jitter = kJitters[seed / kShapes.size() % kJitters.size()];
  const auto samples = static_cast<std::size_t>(draw.uniform(700, 2200));
  const double lag = draw.log_uniform(3, 60);
  const double second = lag * draw.one_of(std::array{0.0, 0.2, 0.5});
  const auto dead = draw.one_of(std::array<std::size_t, 5>{0, 1, 2, 5, 10});
  const bool integrating = draw.uniform(0, 1) < 0.25;
  const double gain = draw.one_of(std::array{0.5, 1.0, 2.0});
  const double period = draw.log_uniform(40, 220);
  const double closed =
      std::max(lag, static_cast<double>(dead)) * draw.log_uniform(0.4, 2);
  const double answer = closed + static_cast<double>(dead);
  const double proportional = lag / (gain * answer);
  const double reset = integrating ? 4 * answer : std::min(lag, 4 * answer);
  const double size = draw.one_of(std::array{2.0, 5.0, 10.0});
  const double noise = size * draw.one_of(std::array{0.0, 0.01, 0.03, 0.1});
  const bool before = draw.uniform(0, 1) < 0.5;
  double duty = draw.uniform(0.25, 0.75);
  const auto every = draw.one_of(std::array<std::size_t, 4>{1, 1, 2, 3});
  out.every = every;
  out.recording.name = "loop.csv";
  out.recording.period_s = static_cast<double>(every);
  std::vector<double> pipe(dead + 1, 0.0);
  double phase = 0;
  double length = period;
  double first = 0;
  double y = 0;
  double behind = 0;
  double sum = 0;
  for (std::size_t k = 0; k < samples; ++k) {
    phase += 1 / length;
    if (phase >= 1) {
      phase -= 1;
      length = period * std::max(0.2, 1 + out.jitter * draw.normal());
      if (times == Times::kAny) {
        length = period * draw.uniform(0.5, 3);
        duty = draw.uniform(0.2, 0.8);
      }
    }
    const double load = size * load_at(out.shape, phase, duty);
    const double valve = pipe[k % pipe.size()] + (before ? load / gain : 0);
    const double share = 1 - std::exp(-1 / lag);
    first += integrating ? gain * valve / lag : (gain * valve - first) * share;
    y += second > 0 ? (first - y) * (1 - std::exp(-1 / second)) : first - y;
    behind += (load - behind) * (1 - std::exp(-1 / std::max(0.3 * lag, 1.0)));
    const double measured = y + (before ? 0 : behind) + noise * draw.normal();
    sum -= proportional / reset * measured;
    const double u = std::clamp(sum - proportional * measured, -1e4, 1e4);
    pipe[k % pipe.size()] = u;
    if (k % every != 0) continue;
    out.recording.t.push_back(static_cast<double>(k));
    out.recording.u.push_back(50 + u);
    out.recording.y.push_back(100 + measured);
    out.recording.sp.push_back(100);
  }
  return out;
}

struct Row {
  int loops = 0;
  std::map<Verdict, int> verdicts;
  void add(Verdict verdict) {
    ++loops;
    ++verdicts[verdict];
  }
};

std::string recorded(const Loop& loop) {
  return "1 in " + std::to_string(loop.every);
}

void tell(const char* title, const std::map<std::string, Row>& rows) {
  std::printf(
      "| %s | n | stiction or backlash | %% | no stiction | undecided |\n"
      "|---|---|---|---|---|---|\n",
      title);
  for (const auto& [name, row] : rows) {
    const auto of = [&row](Verdict verdict) {
      const auto found = row.verdicts.find(verdict);
      return found == row.verdicts.end() ? 0 : found->second;
    };
    const int faults = of(Verdict::kStiction) + of(Verdict::kBacklash);
    std::printf("| %s | %d | %d | %.1f | %d | %d |\n", name.c_str(), row.loops, faults,
                100.0 * faults / row.loops, of(Verdict::kNoStiction),
                row.loops - faults - of(Verdict::kNoStiction));
  }
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  const int loops = argc > 1 ? std::atoi(argv[1]) : 600;
  const int switched = argc > 2 ? std::atoi(argv[2]) : 300;
  if (loops < 1 || switched < 1) {
    std::fprintf(stderr, "score_clocked: expected numbers of loops, 1 or more\n");
    return 2;
  }
  std::map<std::string, Row> by_shape;
  std::map<std::string, Row> by_jitter;
  std::map<std::string, Row> by_every;
  const auto verdict_on = [](const Loop& loop) {
    return workbench::Analysis(loop.recording).result().verdict;
  };
  for (int seed = 1; seed <= loops; ++seed) {
    const Loop loop = loop_of(static_cast<std::uint64_t>(seed), Times::kItsOwn);
    const Verdict verdict = verdict_on(loop);
    by_shape[kShapes[loop.shape]].add(verdict);
    char jitter[32];
    std::snprintf(jitter, sizeof jitter, "%.0f %%", 100 * loop.jitter);
    by_jitter[jitter].add(verdict);
    by_jitter["all"].add(verdict);
    by_every[recorded(loop)].add(verdict);
  }
  std::map<std::string, Row> by_any;
  for (int seed = 1; seed <= switched; ++seed) {
    const Loop loop = loop_of(static_cast<std::uint64_t>(seed), Times::kAny);
    const Verdict verdict = verdict_on(loop);
    by_any[recorded(loop)].add(verdict);
    by_any["all"].add(verdict);
  }
  std::printf(
      "Loops whose valve follows, under a load that comes back at its own time\n\n");
  tell("shape of the load", by_shape);
  tell("its periods vary by", by_jitter);
  tell("samples of the controller that are recorded", by_every);
  std::printf("Loops whose valve follows, under a load that is switched at any time\n\n");
  tell("samples of the controller that are recorded", by_any);
}
