#include "workbench/simulate/plant.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "workbench/simulate/cycles.hpp"
#include "workbench/simulate/draft.hpp"
#include "workbench/simulate/noise.hpp"
#include "workbench/simulate/setpoint_moves.hpp"

namespace workbench {
namespace {

constexpr std::size_t kWarmUp = 1500;
constexpr double kHeaderLag = 4;   // samples
constexpr double kOwnDraw = 0.04;  // of a neighbour's flow on the header

// A loop of the area while it runs.
struct Running {
  Draft draft;
  PlantLoop loop;
  double on_header = 0;  // input load per unit of header pressure, units of u
  double heat_lag = 0;   // samples; 0: the header acts at once
  std::vector<double> setpoint, load, noise;
  std::unique_ptr<Process> process;
  std::unique_ptr<PiController> controller;
  std::unique_ptr<Valve> valve;
  double heat = 0;
};

// Times in the samples of one period for all.
void rescale(Draft& draft, double period_s) {
  LoopSetup& setup = draft.setup;
  const double factor = period_s / setup.period_s;
  setup.process.lag_s *= factor;
  setup.process.second_lag_s *= factor;
  setup.process.dead_time_s *= factor;
  if (setup.process.integrating) setup.process.gain /= factor;
  setup.controller.reset_time_s *= factor;
  setup.period_s = period_s;
}

Draft draw_settling(Random& random, LoopType type, double period_s) {
  for (int redraw = 0; redraw < kMostRedraws; ++redraw) {
    Draft draft;
    draw_loop(random, type, draft);
    rescale(draft, period_s);
    if (settles(draft)) return draft;
  }
  throw std::runtime_error("simulate plant: no loop settles; try another seed");
}

// A loop that cycles because its valve sticks, for this long at least.
Draft draw_sticking(Random& random, double period_s, std::size_t samples) {
  for (int redraw = 0; redraw < kMostRedraws; ++redraw) {
    const LoopType type = random.chance(0.7) ? LoopType::kFlow : LoopType::kSlow;
    Draft draft = draw_settling(random, type, period_s);
    const double band = random.log_uniform(2, 9);
    draft.valve_model = random.chance(0.5) ? "he" : "sliding";
    draft.friction = friction_from_s_j(band, band * random.uniform(0.35, 1));
    LoopSetup& setup = draft.setup;
    const double offset =
        random.sign() * random.uniform(0.15, 0.85) * draft.friction.slip_jump_ascending();
    setup.setpoint = {setup.process.gain * offset};
    setup.warm_up = kWarmUp;
    setup.samples = std::min<std::size_t>(samples, 3000);
    const Trajectory quiet = run_draft(draft);
    const Cycles cycle = measure_cycles(quiet.y_clean);
    const double enough = static_cast<double>(samples) / 14;
    if (cycle.count < 4 || cycle.period < 18 || cycle.period > std::min(enough, 220.0) ||
        cycle.spread > 0.15) {
      continue;
    }
    if (swing_of(run_with_linear_valve(draft).y) > 0.02 * swing_of(quiet.y_clean)) {
      continue;
    }
    return draft;
  }
  throw std::runtime_error("simulate plant: no valve cycles; try another seed");
}

std::string tag_of(LoopType type, int number) {
  const char letter = type == LoopType::kFlow ? 'F' : type == LoopType::kSlow ? 'T' : 'L';
  char out[24];
  std::snprintf(out, sizeof out, "%cIC-%04d", letter, number);
  return out;
}

LoopType type_of(const Draft& draft) {
  if (draft.setup.process.integrating) return LoopType::kLevel;
  return draft.setup.process.lag_s > 4 * draft.setup.period_s ? LoopType::kSlow
                                                              : LoopType::kFlow;
}

class Area {
 public:
  Area(const PlantOptions& options, int number)
      : options_(options),
        random_("plant", options.seed * 100'003 + static_cast<std::uint64_t>(number)),
        total_(kWarmUp + options.samples) {
    area_.number = number;
    area_.period_s = static_cast<double>(random_.integer(1, 10));
    const int count =
        std::min(kLoopsPerArea, options.loops - (number - 1) * kLoopsPerArea);
    const int wanted = options.sticking < 0 ? areas_of(options) : options.sticking;
    const bool sticks = number <= wanted;
    leader_ = sticks ? random_.integer(0, count - 1) : -1;
    for (int i = 0; i < count; ++i) draw(i);
    if (sticks) choose_shaken(count);
  }

  PlantArea run() {
    run_all();
    for (Running& one : running_) {
      store(one);
      area_.loops.push_back(std::move(one.loop));
    }
    return std::move(area_);
  }

 private:
  void draw(int index) {
    Running one;
    if (index == leader_) {
      one.draft = draw_sticking(random_, area_.period_s, options_.samples);
      one.loop.cause = "stiction";
      one.loop.stick_band = one.draft.friction.stick_band_ascending();
      one.loop.slip_jump = one.draft.friction.slip_jump_ascending();
    } else {
      one.draft = draw_settling(random_, draw_loop_type(random_), area_.period_s);
      one.loop.cause = "noise";
      if (random_.chance(0.05)) tighten(one);
    }
    LoopSetup& setup = one.draft.setup;
    const double gain = std::abs(setup.process.gain) *
                        (setup.process.integrating ? 20 * area_.period_s : 1);
    // In percent of travel, as y shows them at rest.
    one.draft.noise_std = gain * random_.log_uniform(0.03, 0.25);
    one.noise = coloured_noise(random_, total_, random_.chance(0.5) ? 0.0 : 0.5,
                               one.draft.noise_std);
    const double size = index == leader_ ? 0.1 : random_.log_uniform(0.05, 0.8);
    one.load = coloured_noise(random_, total_, random_.uniform(0.9, 0.995), size);
    if (one.loop.cause == "noise" && size > 0.3) one.loop.cause = "load";
    one.setpoint = setup.setpoint.empty()
                       ? std::vector<double>(total_, 0.0)
                       : std::vector<double>(total_, setup.setpoint[0]);
    if (one.loop.cause == "noise" && random_.chance(0.3)) {
      const std::vector<double> moves =
          step_moves(random_, total_, random_.log_uniform(200, 900));
      for (std::size_t t = 0; t < total_; ++t) {
        one.setpoint[t] += gain * 3 * moves[t];
      }
      one.loop.cause = "setpoint";
    }
    one.loop.tag = tag_of(type_of(one.draft), 1000 * area_.number + index + 1);
    one.on_header = random_.sign() * random_.uniform(0.02, 0.08);
    running_.push_back(std::move(one));
  }

  // Close to its limit of stability, so that noise keeps it ringing.
  void tighten(Running& one) {
    double low = 1;
    double high = 1;
    while (high < 1000 && ringing_growth(one.draft, high) < 1) high *= 1.5;
    for (int k = 0; k < 20; ++k) {
      const double middle = std::sqrt(low * high);
      (ringing_growth(one.draft, middle) < 1 ? low : high) = middle;
    }
    one.draft.setup.controller.gain *= random_.uniform(0.85, 0.95) * low;
    one.loop.cause = "tight_tuning";
  }

  void choose_shaken(int count) {
    std::vector<int> others;
    for (int i = 0; i < count; ++i) {
      if (i != leader_ &&
          running_[static_cast<std::size_t>(i)].loop.cause != "tight_tuning") {
        others.push_back(i);
      }
    }
    for (std::size_t i = 0; i + 1 < others.size(); ++i) {
      const int other =
          random_.integer(static_cast<int>(i), static_cast<int>(others.size()) - 1);
      std::swap(others[i], others[static_cast<std::size_t>(other)]);
    }
    others.resize(std::min<std::size_t>(others.size(), kShaken));
    const std::string leader = running_[static_cast<std::size_t>(leader_)].loop.tag;
    for (const int i : others) {
      Running& one = running_[static_cast<std::size_t>(i)];
      one.on_header = random_.sign() * random_.uniform(0.8, 2.2);
      if (type_of(one.draft) == LoopType::kSlow) one.heat_lag = random_.uniform(1, 8);
      one.loop.cause = "neighbour";
      one.loop.leader = leader;
      // A quiet loop otherwise: the header is what moves it.
      for (double& value : one.load) value *= 0.3;
    }
  }

  void run_all() {
    for (Running& one : running_) {
      const LoopSetup& setup = one.draft.setup;
      one.process = std::make_unique<Process>(setup.process, setup.period_s);
      one.controller =
          std::make_unique<PiController>(setup.controller, setup.period_s, setup.rest_u);
      one.valve = make_valve(one.draft);
      one.valve->rest(setup.rest_u);
    }
    const std::vector<double> common = coloured_noise(random_, total_, 0.97, 0.4);
    std::vector<double> pressure_seen;
    double pressure = 0;
    for (std::size_t t = 0; t < total_; ++t) {
      double drawn = 0;
      for (std::size_t i = 0; i < running_.size(); ++i) {
        drawn +=
            step(running_[i], static_cast<int>(i) == leader_, pressure + common[t], t);
      }
      pressure += (-drawn - pressure) / kHeaderLag;
      if (t >= kWarmUp) pressure_seen.push_back(50 + pressure + common[t]);
    }
    char tag[24];
    std::snprintf(tag, sizeof tag, "PI-%04d", 1000 * area_.number);
    area_.indicators.emplace_back(tag, std::move(pressure_seen));
  }

  // One sample; returns what the loop draws from the header, units of u.
  double step(Running& one, bool leads, double pressure, std::size_t t) {
    const double y = one.process->output() + one.noise[t];
    const double u = one.controller->step(one.setpoint[t], y);
    const double x = one.valve->step(u);
    double load = one.on_header * pressure;
    if (one.heat_lag > 0) {
      one.heat += (load - one.heat) / one.heat_lag;
      load = one.heat;
    }
    one.process->advance(x - one.draft.setup.rest_u + load + one.load[t]);
    if (t >= kWarmUp) {
      one.loop.u.push_back(u);
      one.loop.y.push_back(y);
      one.loop.sp.push_back(one.setpoint[t]);
    }
    return (leads ? 1 : kOwnDraw) * (x - one.draft.setup.rest_u);
  }

  // In units of its own, through the historian.
  void store(Running& one) {
    PlantLoop& loop = one.loop;
    const double swing = std::max(swing_of(loop.y), 1e-9);
    const double scale = random_.log_uniform(0.5, 50) / swing;
    const double offset = random_.uniform(2, 10) * scale * swing;
    for (auto* signal : {&loop.y, &loop.sp}) {
      for (double& value : *signal) value = scale * value + offset;
    }
    if (random_.chance(1.0 / 3)) {
      loop.compressed = random_.log_uniform(0.02, 0.2);
      by_exception(loop.u, loop.compressed);                       // of 0 … 100 %
      by_exception(loop.y, loop.compressed * scale * swing / 30);  // of a wider range
    }
    loop.bad = loop.cause == "noise" && random_.chance(1.0 / 15);
  }

  static void by_exception(std::vector<double>& values, double deviation) {
    double stored = values.front();
    for (double& value : values) {
      if (std::abs(value - stored) > deviation) stored = value;
      value = stored;
    }
  }

  const PlantOptions& options_;
  Random random_;
  std::size_t total_;
  int leader_ = -1;
  PlantArea area_;
  std::vector<Running> running_;
};

void append_number(std::string& out, double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  out += text;
}

// 1 March 2026 and so many seconds.
void append_time(std::string& out, double seconds) {
  const auto whole = static_cast<long>(seconds);
  const long day = whole / 86400;
  constexpr long kDays[] = {31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  long month = 0;
  long left = day;
  while (month < 9 && left >= kDays[month]) left -= kDays[month++];
  char text[40];
  std::snprintf(text, sizeof text, "2026-%02ld-%02ld %02ld:%02ld:%02ld", month + 3,
                left + 1, whole % 86400 / 3600, whole % 3600 / 60, whole % 60);
  out += text;
}

void append_loop(std::string& out, const PlantLoop& loop, std::size_t t) {
  out += ',';
  append_number(out, loop.u[t]);
  out += ',';
  if (loop.bad && t % 3 != 0) {
    out += "Bad";
  } else {
    append_number(out, loop.y[t]);
  }
  out += ',';
  append_number(out, loop.sp[t]);
}

}  // namespace

int areas_of(const PlantOptions& options) {
  return (options.loops + kLoopsPerArea - 1) / kLoopsPerArea;
}

PlantArea simulate_area(const PlantOptions& options, int number) {
  return Area(options, number).run();
}

std::string area_csv(const PlantArea& area) {
  std::string out = "Timestamp";
  for (const PlantLoop& loop : area.loops) {
    out += ',' + loop.tag + ".OP," + loop.tag + ".PV," + loop.tag + ".SP";
  }
  for (const auto& [tag, values] : area.indicators) out += ',' + tag;
  out += '\n';
  for (std::size_t t = 0; t < area.loops.front().u.size(); ++t) {
    append_time(out, static_cast<double>(t) * area.period_s);
    for (const PlantLoop& loop : area.loops) append_loop(out, loop, t);
    for (const auto& [tag, values] : area.indicators) {
      out += ',';
      append_number(out, values[t]);
    }
    out += '\n';
  }
  return out;
}

std::string loop_csv(const PlantArea& area, const PlantLoop& loop) {
  std::string out = "Timestamp,OP,PV,SP\n";
  for (std::size_t t = 0; t < loop.u.size(); ++t) {
    append_time(out, static_cast<double>(t) * area.period_s);
    append_loop(out, loop, t);
    out += '\n';
  }
  return out;
}

nlohmann::ordered_json truth_json(const PlantArea& area) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const PlantLoop& loop : area.loops) {
    const bool sticks = loop.stick_band > 0;
    out.push_back({{"loop", loop.tag},
                   {"area", area.number},
                   {"kind", sticks ? "stiction" : "no_stiction"},
                   {"cause", loop.cause},
                   {"leader", loop.leader.empty() ? nlohmann::ordered_json(nullptr)
                                                  : nlohmann::ordered_json(loop.leader)},
                   {"stick_band", loop.stick_band},
                   {"slip_jump", loop.slip_jump},
                   {"compressed_percent", loop.compressed},
                   {"bad_tag", loop.bad}});
  }
  return out;
}

}  // namespace workbench
