#include "workbench/simulate/scenarios.hpp"

#include <array>
#include <iterator>

#include "workbench/simulate/paper_example.hpp"

namespace workbench {
namespace {

struct Scenario {
  ScenarioInfo info;
  SimulatedLoop (*make)(std::string_view name, std::uint64_t seed);
};

constexpr Scenario kScenarios[] = {
    {{"paper-example-1", "the paper's Example 5.1: He's valve with fs = 5, fd = 0"},
     [](std::string_view name, std::uint64_t seed) {
       return paper_example(name, seed, kPaperValve, kPaperSetpoint);
     }},
    {{"paper-example-1-midway", "the same with the setpoint midway between two standstills"},
     [](std::string_view name, std::uint64_t seed) {
       return paper_example(name, seed, kPaperValve, kMidwaySetpoint);
     }},
    {{"paper-example-1-ascending", "Example 5.1 with only the ascending stroke sticking"},
     [](std::string_view name, std::uint64_t seed) {
       return paper_example(name, seed, kPaperValveAscending, kMidwaySetpoint);
     }},
    {{"paper-example-1-descending", "Example 5.1 with only the descending stroke sticking"},
     [](std::string_view name, std::uint64_t seed) {
       return paper_example(name, seed, kPaperValveDescending, kMidwaySetpoint);
     }},
    {{"paper-example-1-mixed", "Example 5.1 with both strokes sticking, unequally"},
     [](std::string_view name, std::uint64_t seed) {
       return paper_example(name, seed, kPaperValveMixed, kMidwaySetpoint);
     }},
};

constexpr auto kInfos = [] {
  std::array<ScenarioInfo, std::size(kScenarios)> infos{};
  for (std::size_t i = 0; i < infos.size(); ++i) infos[i] = kScenarios[i].info;
  return infos;
}();

}  // namespace

std::span<const ScenarioInfo> scenarios() { return kInfos; }

std::optional<SimulatedLoop> simulate(std::string_view scenario, std::uint64_t seed) {
  for (const Scenario& entry : kScenarios) {
    if (entry.info.name == scenario) return entry.make(entry.info.name, seed);
  }
  return std::nullopt;
}

}  // namespace workbench
