// How often each detector of records that cannot be judged, or that mislead, fires: on
// the recordings by label, on simulated loops, and on cases made for it. Prints Markdown
// tables.
//
//   score_records [SEEDS]
//
// SEEDS of each scenario, from 1001 on, default 20.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ident/signal/seam.hpp"
#include "ident/signal/sensor_hold.hpp"
#include "ident/signal/storage.hpp"
#include "ident/signal/swap.hpp"
#include "workbench/analysis/alignment.hpp"
#include "workbench/recording/csv.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/simulate/draft.hpp"
#include "workbench/simulate/he_valve.hpp"
#include "workbench/simulate/linear_valve.hpp"
#include "workbench/simulate/scenarios.hpp"
#include "workbench/simulate/sliding_valve.hpp"

namespace {

using ident::Storage;
using Signal = std::vector<double>;

constexpr std::uint64_t kFirstSeed = 1001;

struct Loop {
  std::string label;
  Signal u, y, sp;
};

/// What fired, how often.
struct Fired {
  int loops = 0, seams = 0, swaps = 0, compressed = 0, interpolated_u = 0,
      interpolated_y = 0, held_u = 0, held_y = 0, sensor = 0;
};

void count(const Loop& loop, Fired& fired) {
  const auto of_u = ident::find_storage(loop.u);
  const auto of_y = ident::find_storage(loop.y);
  ++fired.loops;
  fired.seams += ident::find_seams(loop.u, loop.y, loop.sp).count > 0;
  fired.swaps += ident::are_swapped(loop.u, loop.y, loop.sp);
  fired.interpolated_u += of_u.storage == Storage::kInterpolated;
  fired.interpolated_y += of_y.storage == Storage::kInterpolated;
  fired.held_u += of_u.storage == Storage::kHeld;
  fired.held_y += of_y.storage == Storage::kHeld;
  fired.sensor += ident::find_sensor_hold(loop.u, loop.y).sticks;
  fired.compressed += ident::was_compressed(of_u, of_y);
}

void print_header(const char* title) {
  std::printf(
      "\n%s\n\n| loops | n | seam | swapped | compressed | u lines | y lines | u held | "
      "y held | "
      "sensor sticks |\n|---|---|---|---|---|---|---|---|---|---|\n",
      title);
}

void print_row(const std::string& name, const Fired& f) {
  std::printf("| %s | %d | %d | %d | %d | %d | %d | %d | %d | %d |\n", name.c_str(),
              f.loops, f.seams, f.swaps, f.compressed, f.interpolated_u, f.interpolated_y,
              f.held_u, f.held_y, f.sensor);
}

void print_rows(const std::vector<Loop>& loops) {
  std::vector<std::string> order;
  std::map<std::string, Fired> rows;
  for (const Loop& loop : loops) {
    if (rows.find(loop.label) == rows.end()) {
      order.push_back(loop.label);
    }
    count(loop, rows[loop.label]);
  }
  for (const std::string& name : order) {
    print_row(name, rows[name]);
  }
}

std::string label_of(const nlohmann::json& labels, const std::string& name) {
  if (!labels.contains(name)) {
    return "unlabelled";
  }
  const nlohmann::json& label = labels.at(name);
  if (label.contains("cause")) {
    return label.at("cause").get<std::string>();
  }
  if (label.contains("stiction") && label.at("stiction").is_boolean()) {
    return label.at("stiction").get<bool>() ? "stiction" : "no stiction";
  }
  return "unlabelled";
}

/// The recordings of a folder, by name; empty where it is absent.
std::vector<Loop> read_folder(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(STICKBAND_RECORDINGS) / name;
  std::vector<std::filesystem::path> files;
  if (std::filesystem::exists(folder)) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() == ".csv") {
        files.push_back(entry.path());
      }
    }
  }
  std::sort(files.begin(), files.end());
  nlohmann::json labels = nlohmann::json::object();
  if (std::ifstream file(folder / "labels.json"); file) {
    labels = nlohmann::json::parse(file);
  }
  std::vector<Loop> loops;
  for (const auto& file : files) {
    try {
      const workbench::Recording r = workbench::read_csv(file.string());
      loops.push_back(
          {name + ", " + label_of(labels, file.stem().string()), r.u, r.y, r.sp});
    } catch (const workbench::InputError&) {
      std::printf("SKIPPED: %s is no plain recording\n", file.filename().c_str());
    }
  }
  std::stable_sort(loops.begin(), loops.end(),
                   [](const Loop& a, const Loop& b) { return a.label < b.label; });
  return loops;
}

double deviation(const Signal& x) {
  double mean = 0;
  double square = 0;
  for (const double v : x) mean += v / static_cast<double>(x.size());
  for (const double v : x) square += (v - mean) * (v - mean);
  return std::sqrt(square / static_cast<double>(x.size()));
}

/// A swinging door: stored points as far apart as lines between them stay within `width`.
Signal swinging_door(const Signal& x, double width) {
  Signal out(x);
  std::size_t first = 0;
  while (first + 1 < x.size()) {
    double low = -1e300;
    double high = 1e300;
    std::size_t last = first + 1;
    for (std::size_t t = first + 1; t < x.size() && low <= high; ++t) {
      const double away = static_cast<double>(t - first);
      low = std::max(low, (x[t] - width - x[first]) / away);
      high = std::min(high, (x[t] + width - x[first]) / away);
      last = low <= high ? t : last;
    }
    const double slope = (x[last] - x[first]) / static_cast<double>(last - first);
    for (std::size_t t = first + 1; t < last; ++t) {
      out[t] = x[first] + slope * static_cast<double>(t - first);
    }
    first = last;
  }
  return out;
}

/// Stored when further than `width` from what was stored before, held in between.
Signal exception_report(const Signal& x, double width) {
  Signal out(x);
  double stored = x[0];
  for (double& v : out) {
    if (std::fabs(v - stored) > width) stored = v;
    v = stored;
  }
  return out;
}

/// The same with the middle cut out, from `gone` of the samples to as many before the
/// end.
Loop without_middle(const Loop& loop) {
  const auto cut = [](const Signal& x) {
    Signal out(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(x.size() * 2 / 5));
    out.insert(out.end(), x.begin() + static_cast<std::ptrdiff_t>(x.size() * 3 / 5),
               x.end());
    return out;
  };
  return {loop.label, cut(loop.u), cut(loop.y), cut(loop.sp)};
}

Loop joined(const Loop& a, const Loop& b) {
  const auto join = [](const Signal& x, const Signal& y) {
    Signal out(x);
    out.insert(out.end(), y.begin(), y.end());
    return out;
  };
  const bool sp = a.sp.size() == a.u.size() && b.sp.size() == b.u.size();
  return {a.label, join(a.u, b.u), join(a.y, b.y), sp ? join(a.sp, b.sp) : Signal{}};
}

/// Of joined recordings: found there, found there among other places, found elsewhere.
void print_joined(const std::string& name, const std::vector<Loop>& loops,
                  const std::vector<std::size_t>& at) {
  int there = 0;
  int also = 0;
  int elsewhere = 0;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const auto s = ident::find_seams(loops[k].u, loops[k].y, loops[k].sp);
    const auto end = s.at.begin() + static_cast<std::ptrdiff_t>(s.count);
    const bool hit = std::find(s.at.begin(), end, at[k]) != end;
    there += hit && s.count == 1;
    also += hit && s.count > 1;
    elsewhere += !hit && s.count > 0;
  }
  std::printf("| %s | %zu | %d | %d | %d |\n", name.c_str(), loops.size(), there, also,
              elsewhere);
}

void score_joined(const std::string& name, const std::vector<Loop>& loops) {
  std::vector<Loop> cut;
  std::vector<Loop> pairs;
  std::vector<std::size_t> cut_at;
  std::vector<std::size_t> pairs_at;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    cut.push_back(without_middle(loops[k]));
    cut_at.push_back(loops[k].u.size() * 2 / 5);
    pairs.push_back(joined(loops[k], loops[(k + 7) % loops.size()]));
    pairs_at.push_back(loops[k].u.size());
  }
  print_joined(name + ", the middle cut out", cut, cut_at);
  print_joined(name + ", another loop behind it", pairs, pairs_at);
}

void score_swapped(const std::string& name, const std::vector<Loop>& loops) {
  int with = 0;
  int without = 0;
  for (const Loop& loop : loops) {
    with += ident::are_swapped(loop.y, loop.u, loop.sp);
    without += ident::are_swapped(loop.y, loop.u, {});
  }
  std::printf("| %s | %zu | %d | %d |\n", name.c_str(), loops.size(), with, without);
}

// As recorded with y so many samples behind u, or u behind y where below 0.
workbench::Recording recorded_late(const Loop& loop, int late) {
  const std::size_t of_y = static_cast<std::size_t>(std::max(late, 0));
  const std::size_t of_u = static_cast<std::size_t>(std::max(-late, 0));
  workbench::Recording out;
  out.period_s = 1;
  for (std::size_t t = of_y + of_u; t < loop.u.size(); ++t) {
    out.t.push_back(static_cast<double>(out.t.size()));
    out.u.push_back(loop.u[t - of_u]);
    out.y.push_back(loop.y[t - of_y]);
    if (!loop.sp.empty()) out.sp.push_back(loop.sp[t]);
  }
  return out;
}

void score_late(const std::string& name, const std::vector<Loop>& loops) {
  std::printf("| %s | %zu |", name.c_str(), loops.size());
  for (const int late : {0, 1, 2, -1}) {
    int told = 0;
    int wrong = 0;
    for (const Loop& loop : loops) {
      const int found = workbench::samples_late(recorded_late(loop, late));
      told += found == late && late != 0;
      wrong += found != late && found != 0;
    }
    std::printf(" %d, %d |", told, wrong);
  }
  std::printf("\n");
}

void score_stored(const std::string& name, const std::vector<Loop>& loops) {
  for (const double width : {0.02, 0.05, 0.1, 0.2}) {
    std::vector<Loop> lines = loops;
    std::vector<Loop> holds = loops;
    Fired of_lines;
    Fired of_holds;
    double lines_apart = 0;
    double holds_apart = 0;
    for (std::size_t k = 0; k < loops.size(); ++k) {
      for (const auto signal : {&Loop::u, &Loop::y}) {
        const Signal& x = loops[k].*signal;
        lines[k].*signal = swinging_door(x, width * deviation(x));
        holds[k].*signal = exception_report(x, width * deviation(x));
      }
      count(lines[k], of_lines);
      count(holds[k], of_holds);
      lines_apart += static_cast<double>(ident::find_storage(lines[k].y).points_apart);
      holds_apart += static_cast<double>(ident::find_storage(holds[k].y).points_apart);
    }
    const double n = static_cast<double>(loops.size());
    char title[160];
    std::snprintf(title, sizeof title, "%s, door of %.2f (y %.1f apart)", name.c_str(),
                  width, lines_apart / n);
    print_row(title, of_lines);
    std::snprintf(title, sizeof title, "%s, exceptions of %.2f (y %.1f apart)",
                  name.c_str(), width, holds_apart / n);
    print_row(title, of_holds);
  }
}

/// What sticks in a simulated loop, and how its y is measured.
struct Sticking {
  const char* name;
  bool sensor;         // or the valve
  bool slides;         // or stands still after each jump
  bool fast;           // no lag in the process
  double load;         // its wandering in a sample, in stick bands
  double noise;        // of what the sensor feels, likewise
  double noise_after;  // of the recorded y
  double resolution;   // of the recorded y
};

constexpr Sticking kSticking[] = {
    {"sensor that jumps, no noise", true, false, false, 0.03, 0, 0, 0},
    {"sensor that jumps, little noise", true, false, false, 0.03, 0.02, 0, 0},
    {"sensor that jumps, noise", true, false, false, 0.03, 0.2, 0, 0},
    {"the same, y in steps of 0.02", true, false, false, 0.03, 0.2, 0, 0.02},
    {"the same, y in steps of 0.3", true, false, false, 0.03, 0.2, 0, 0.3},
    {"the same, noise behind it", true, false, false, 0.03, 0.2, 0.05, 0},
    {"sensor that slides, noise", true, true, false, 0.03, 0.2, 0, 0},
    {"valve, no noise", false, false, false, 0.03, 0, 0, 0},
    {"valve, noise", false, false, false, 0.03, 0.05, 0, 0},
    {"valve that slides, y in steps of 0.1", false, true, false, 0.03, 0.02, 0, 0.1},
    {"valve, fast process, noise", false, false, true, 0.03, 0.02, 0, 0},
    {"valve, fast, y in steps of 0.1", false, false, true, 0.03, 0.01, 0, 0.1},
    {"valve, fast, y in steps of 0.02", false, false, true, 0.03, 0.002, 0, 0.02},
    {"valve, fast, slow load, steps of 0.1", false, false, true, 0.002, 0.01, 0, 0.1},
    {"valve, fast, slow load, steps of 0.03", false, false, true, 0.002, 0.003, 0, 0.03},
    {"valve, fast, slow load, steps of 0.01", false, false, true, 0.002, 0.001, 0, 0.01},
    {"valve, fast, no load, no noise", false, false, true, 0, 0, 0, 0},
    {"valve, fast, no load, steps of 0.02", false, false, true, 0, 0.002, 0, 0.02},
};

/// A loop drawn as the simulator draws them, with one thing in it that sticks.
Loop sticking_loop(const Sticking& kind, std::uint64_t seed) {
  workbench::Random random(kind.name, seed);
  workbench::Draft draft;
  workbench::draw_loop(
      random, kind.fast ? workbench::LoopType::kFlow : workbench::draw_loop_type(random),
      draft);
  const double period = draft.setup.period_s;
  const double gain = draft.setup.process.integrating
                          ? 1 / std::fabs(draft.setup.controller.gain)
                          : std::fabs(draft.setup.process.gain);
  if (kind.fast) {
    draft.setup.process.lag_s = 0;
    draft.setup.process.second_lag_s = 0;
    draft.setup.process.dead_time_s = 0;
  }
  constexpr std::size_t kWarmUp = 500;
  constexpr std::size_t kSamples = 2000;
  const double band = random.uniform(1, 5);  // % of u, or of y over the gain
  const double jump = random.uniform(0.3, 1);
  const workbench::Friction friction =
      workbench::friction_from_s_j(band / 2, band / 2 * jump);
  workbench::Friction felt = friction;
  for (double* force : {&felt.static_ascending, &felt.static_descending,
                        &felt.kinetic_ascending, &felt.kinetic_descending}) {
    *force *= gain;
  }
  workbench::LinearValve linear;
  workbench::HeValve jumps(kind.sensor ? felt : friction);
  workbench::SlidingValve slides(kind.sensor ? felt : friction);
  workbench::Valve& sticking =
      kind.slides ? static_cast<workbench::Valve&>(slides) : jumps;
  workbench::Valve& valve = kind.sensor ? linear : sticking;
  workbench::Valve& sensor = kind.sensor ? sticking : linear;
  workbench::Process process(draft.setup.process, period);
  workbench::PiController controller(draft.setup.controller, period, 50);
  valve.rest(50);
  sensor.rest(0);
  Loop loop{kind.name, {}, {}, {}};
  const double resolution = kind.resolution * band * gain;
  const double setpoint = 0.3 * band * gain;
  double load = 0;
  for (std::size_t t = 0; t < kWarmUp + kSamples; ++t) {
    load = 0.995 * load + kind.load * band * random.normal();
    double y = sensor.step(process.output() + kind.noise * band * gain * random.normal());
    y += kind.noise_after * band * gain * random.normal();
    if (resolution > 0) y = resolution * std::round(y / resolution);
    const double u = controller.step(setpoint, y);
    process.advance(valve.step(u) - 50 + load);
    if (t >= kWarmUp) {
      loop.u.push_back(u);
      loop.y.push_back(y);
    }
  }
  return loop;
}

}  // namespace

int main(int argc, char** argv) {
  const int seeds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 20;
  std::vector<Loop> recorded;
  print_header("Recordings, columns as labelled: seam, swapped and sensor are false");
  for (const char* folder :
       {"isdb", "plant", "sacac", "lab-valve", "valve-position", "cascaded-tanks",
        "heat-exchanger", "step-test", "friction-damper"}) {
    const std::vector<Loop> loops = read_folder(folder);
    print_rows(loops);
    const std::string name(folder);
    if (name == "isdb" || name == "plant" || name == "sacac") {
      recorded.insert(recorded.end(), loops.begin(), loops.end());
    }
  }
  if (recorded.empty()) {
    std::printf("SKIPPED: no recordings in %s\n", STICKBAND_RECORDINGS);
  }

  std::vector<Loop> simulated;
  for (const workbench::ScenarioInfo& scenario : workbench::scenarios()) {
    for (int k = 0; k < seeds; ++k) {
      auto loop =
          *workbench::simulate(scenario.name, kFirstSeed + static_cast<std::uint64_t>(k));
      simulated.push_back({std::string(scenario.name), std::move(loop.u),
                           std::move(loop.y), std::move(loop.sp)});
    }
  }
  print_header("Simulated loops: everything is false");
  print_rows(simulated);

  std::printf(
      "\nJoined recordings\n\n| loops | n | found | with others | only elsewhere |\n"
      "|---|---|---|---|---|\n");
  score_joined("recordings", recorded);
  score_joined("simulated", simulated);
  std::printf(
      "\nColumns exchanged\n\n| loops | n | found | found without sp "
      "|\n|---|---|---|---|\n");
  score_swapped("recordings", recorded);
  score_swapped("simulated", simulated);
  std::printf(
      "\nStored at different times: told rightly, told wrongly\n\n"
      "| loops | n | as they are | y 1 later | y 2 later | u 1 later |\n"
      "|---|---|---|---|---|---|\n");
  score_late("recordings", recorded);
  score_late("simulated", simulated);
  print_header("Compressed, u and y; width in standard deviations");
  score_stored("recordings", recorded);
  score_stored("simulated", simulated);
  print_header("Sticking sensors, and sticking valves");
  for (const Sticking& kind : kSticking) {
    Fired fired;
    for (int k = 0; k < 2 * seeds; ++k) {
      count(sticking_loop(kind, kFirstSeed + static_cast<std::uint64_t>(k)), fired);
    }
    print_row(kind.name, fired);
  }
  return 0;
}
