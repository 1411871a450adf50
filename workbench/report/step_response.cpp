#include "workbench/report/step_response.hpp"

#include <algorithm>
#include <cmath>

#include "ident/signal/movement.hpp"
#include "ident/signal/reversals.hpp"
#include "ident/two_path/path_simulation.hpp"
#include "workbench/analysis/wording.hpp"
#include "workbench/recording/statistics.hpp"

namespace workbench {
namespace {

// Retreat of u that confirms a turning point, as a share of its range.

double standard_deviation(const std::vector<double>& values) {
  const double mean = mean_of(values);
  double sum = 0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

// Drops what follows 1.4 settling times, where the response settles at all.
void cut_when_settled(StepResponse& response) {
  const std::size_t size = response.y.size();
  const double end = response.y.back();
  std::size_t settled = size;
  while (settled > 1 && std::abs(response.y[settled - 1] - end) <= 0.02 * std::abs(end)) {
    --settled;
  }
  const std::size_t kept = std::min(size, std::max<std::size_t>(settled * 7 / 5, 8));
  response.t.resize(kept);
  response.y.resize(kept);
}

}  // namespace

StemScale stem_scale(const ident::TwoPathModel<double>& model,
                     const Simulation& simulation) {
  const std::vector<double>& u = simulation.u;
  const std::vector<double>& stem = simulation.stem.empty() ? u : simulation.stem;
  std::vector<unsigned char> ascending(u.size());
  ident::mark_directions<double>(u, ident::kReversalShare * span_of(u), ascending, {});
  std::vector<double> x(u.size());
  for (std::size_t t = 0; t < u.size(); ++t) {
    x[t] = ascending[t] != 0 ? model.ascending.at(u[t]) : model.descending.at(u[t]);
  }
  const double n = static_cast<double>(x.size());
  double mean_x = 0;
  double mean_stem = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += x[i] / n;
    mean_stem += stem[i] / n;
  }
  double both = 0;
  double stem_square = 0;
  double square = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    both += (x[i] - mean_x) * (stem[i] - mean_stem);
    square += (x[i] - mean_x) * (x[i] - mean_x);
    stem_square += (stem[i] - mean_stem) * (stem[i] - mean_stem);
  }
  StemScale out;
  out.scale = square > 0 ? both / square : 0;
  out.shift = mean_stem - out.scale * mean_x;
  out.r_squared = stem_square > 0 ? out.scale * both / stem_square : 0;
  return out;
}

StepResponse two_path_step(const Identification& result, const StemScale& scale,
                           const Simulation& simulation) {
  if (!has_model(result) || !(scale.scale > 0)) return {};
  const double period = result.oscillation.period_samples;
  const std::size_t size = simulation.u.size();
  const std::size_t longest =
      result.oscillation.detected && period > 0
          ? std::min(size, static_cast<std::size_t>(4 * period) + 8)
          : size;
  ident::TwoPathModel<double> model = result.model;
  model.process.d = 0;
  // Before the first sample x equals x[0]: the step comes after it.
  std::vector<double> x(longest + 1, 1 / scale.scale);
  x[0] = 0;
  std::vector<double> y(longest + 1);
  ident::simulate_paths<double>({.u = {}, .y = y, .ascending = {}}, x, model, {}, y);
  StepResponse out;
  for (std::size_t i = 1; i < y.size(); ++i) {
    if (!std::isfinite(y[i])) break;
    out.t.push_back(static_cast<double>(i - 1) * simulation.period_s);
    out.y.push_back(y[i]);
  }
  if (!out.y.empty()) cut_when_settled(out);
  return out;
}

StepResponse valve_step(const Identification& result, const Simulation& simulation,
                        double duration_s) {
  const ident::ValveModel<double>& valve = result.valve;
  const double span = span_of(simulation.u);
  if (!valve.known || !(valve.poles.slow < 1) || !(span > 0)) return {};
  const double unit = result.gain_sign * standard_deviation(simulation.y) / span;
  const double period = simulation.period_s * result.decimation;
  const auto size = static_cast<std::size_t>(duration_s / period) + 1;
  std::vector<double> z(size);
  double slow = 0;
  double fast = 0;
  for (double& value : z) {
    slow = valve.poles.slow * slow + (1 - valve.poles.slow);
    fast = valve.poles.fast * fast + (1 - valve.poles.fast) * slow;
    value = fast;
  }
  const auto delayed = [&](std::size_t i, int delay) {
    const auto d = static_cast<std::size_t>(delay);
    return i >= d ? z[i - d] : 0;
  };
  StepResponse out;
  for (std::size_t i = 0; i < size; ++i) {
    out.t.push_back(static_cast<double>(i) * period);
    out.y.push_back(unit * (valve.fit.gain_a * delayed(i, valve.fit.delay) +
                            valve.fit.gain_b * delayed(i, valve.fit.delay + 1)));
  }
  return out;
}

StepResponse true_step(const ProcessModel& process, double period_s, double duration_s) {
  Process simulated(process, period_s);
  StepResponse out;
  for (double t = 0; t <= duration_s; t += period_s) {
    out.t.push_back(t);
    out.y.push_back(simulated.output());
    simulated.advance(1);
  }
  return out;
}

}  // namespace workbench
