#include "workbench/simulate/scenarios.hpp"

#include <array>
#include <iterator>

#include "workbench/simulate/families.hpp"
#include "workbench/simulate/paper_example.hpp"

namespace workbench {
namespace {

struct Scenario {
  ScenarioInfo info;
  SimulatedLoop (*make)(std::string_view name, std::uint64_t seed);
};

template <const Friction& kValve, const double& kSetpoint>
SimulatedLoop paper(std::string_view name, std::uint64_t seed) {
  return paper_example(name, seed, kValve, kSetpoint);
}

template <Strokes kStrokes, bool kLevel = false, bool kMovingSetpoint = false>
SimulatedLoop sticking(std::string_view name, std::uint64_t seed) {
  return stiction_family(name, seed, kStrokes, kLevel, kMovingSetpoint);
}

template <bool kSticks>
SimulatedLoop few_steps(std::string_view name, std::uint64_t seed) {
  return few_steps_family(name, seed, kSticks);
}

constexpr Scenario kScenarios[] = {
    {{"paper-example-1", "the paper's Example 5.1: He's valve with fs = 5, fd = 0"},
     paper<kPaperValve, kPaperSetpoint>},
    {{"paper-example-1-midway",
      "the same with the setpoint midway between two standstills"},
     paper<kPaperValve, kMidwaySetpoint>},
    {{"paper-example-1-ascending", "Example 5.1 with only the ascending stroke sticking"},
     paper<kPaperValveAscending, kMidwaySetpoint>},
    {{"paper-example-1-descending",
      "Example 5.1 with only the descending stroke sticking"},
     paper<kPaperValveDescending, kMidwaySetpoint>},
    {{"paper-example-1-mixed", "Example 5.1 with both strokes sticking, unequally"},
     paper<kPaperValveMixed, kMidwaySetpoint>},
    {{"stiction", "sticking valve, equal strokes"}, sticking<Strokes::kEqual>},
    {{"stiction-one-sided", "only one stroke sticks"}, sticking<Strokes::kOneSided>},
    {{"stiction-mixed", "both strokes stick, unequally"}, sticking<Strokes::kMixed>},
    {{"stiction-integrating", "sticking valve on an integrating process, a level loop"},
     sticking<Strokes::kEqual, true>},
    {{"stiction-setpoint", "sticking valve while the setpoint moves"},
     sticking<Strokes::kEqual, false, true>},
    {{"backlash", "play without slip jump: limit cycle, or moved by load or setpoint"},
     backlash_family},
    {{"external-sinusoid", "healthy loop under a periodic load"}, external_sinusoid},
    {{"tight-tuning", "controller near or beyond its stability limit, valve fine"},
     tight_tuning},
    {{"random-load", "healthy loop under a wandering load"}, random_load},
    {{"setpoint", "healthy loop whose setpoint moves, cascades included"},
     setpoint_moves},
    {{"healthy", "healthy loop, measurement noise alone"}, noise_only},
    {{"quantised", "healthy loop, coarse y, u or both"}, quantised},
    {{"healthy-positioner", "hysteresis of 0.2 to 0.5 % of the swing of u and a lag"},
     healthy_positioner},
    {{"load-and-noise", "healthy loop, load steps, drift and strong noise"},
     load_and_noise},
    {{"few-steps", "healthy loop, one to four setpoint steps and a wandering load"},
     few_steps<false>},
    {{"stiction-few-steps", "the same behind a valve that sticks"}, few_steps<true>},
};

constexpr auto kInfos = [] {
  std::array<ScenarioInfo, std::size(kScenarios)> infos{};
  for (std::size_t i = 0; i < infos.size(); ++i) infos[i] = kScenarios[i].info;
  return infos;
}();

}  // namespace

std::span<const ScenarioInfo> scenarios() {
  return kInfos;
}

std::optional<SimulatedLoop> simulate(std::string_view scenario, std::uint64_t seed) {
  for (const Scenario& entry : kScenarios) {
    if (entry.info.name == scenario) return entry.make(entry.info.name, seed);
  }
  return std::nullopt;
}

}  // namespace workbench
