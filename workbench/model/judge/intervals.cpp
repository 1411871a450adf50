#include "workbench/model/judge/intervals.hpp"

#include <algorithm>
#include <cmath>

#include "workbench/model/base/least_squares.hpp"
#include "workbench/model/base/noise.hpp"
#include "workbench/model/fit/parameter_search.hpp"
#include "workbench/model/fit/random_walk.hpp"
#include "workbench/model/fit/sudden_instant.hpp"
#include "workbench/model/judge/without_beginning.hpp"

namespace workbench {
namespace {

constexpr double kUnbounded = 1e9;  // search coordinates that no sample tells

// A derivative over a step that the error notices, and the play below which it does not.
struct Slope {
  std::vector<double> residual;      // d residual / d coordinate
  std::vector<double> coefficients;  // d coefficient / d coordinate
  double play = 0;                   // coordinate
};

struct Side {
  double coordinate = 0;
  double error = 0;
  std::vector<double> residual;
  std::vector<double> coefficients;
};

Side probe(FreeRun& run, const Fit& fit, std::size_t slot, double step) {
  const SearchedParameter& parameter = fit.slots[slot].parameter;
  std::vector<double> p = fit.p;
  const double here = to_search(parameter, p[slot]);
  p[slot] =
      std::clamp(from_search(parameter, here + step), parameter.low, parameter.high);
  Side side;
  side.coordinate = to_search(parameter, p[slot]) - here;
  side.error = run.run(p);
  side.residual.assign(run.judged().begin(), run.judged().end());
  side.coefficients.assign(run.coefficients().begin(), run.coefficients().end());
  return side;
}

Slope slope_of(FreeRun& run, const Fit& fit, std::size_t slot, double noticeable) {
  Slope slope;
  Side up;
  Side down;
  for (double step = 2e-4; step < 0.6; step *= 2.5) {
    up = probe(run, fit, slot, step);
    down = probe(run, fit, slot, -step);
    const double rise = std::max(up.error, down.error) - fit.error;
    const bool smooth = !fit.slots[slot].parameter.jumpy;
    if (rise > noticeable || (smooth && step > 0.05)) break;
    if (rise < 1e-3 * noticeable) slope.play = step;
  }
  const double width = up.coordinate - down.coordinate;
  slope.residual.assign(fit.residual.size(), 0.0);
  slope.coefficients.assign(fit.coefficients.size(), 0.0);
  if (!(width > 0)) return slope;
  for (std::size_t k = 0; k < slope.residual.size(); ++k) {
    slope.residual[k] = (up.residual[k] - down.residual[k]) / width;
  }
  if (up.coefficients.size() == fit.coefficients.size() &&
      down.coefficients.size() == fit.coefficients.size()) {
    for (std::size_t i = 0; i < fit.coefficients.size(); ++i) {
      slope.coefficients[i] = (up.coefficients[i] - down.coefficients[i]) / width;
    }
  }
  return slope;
}

// The resolution of a parameter in search coordinates; a lag or a rate has none.
double finest(const SearchedParameter& parameter) {
  return parameter.logarithmic ? 0 : to_search(parameter, parameter.resolution);
}

void keep_estimation(const Blocks& blocks, std::vector<double>& signal) {
  for (std::size_t k = 0; k < signal.size(); ++k) {
    if (!blocks.estimation()[k]) signal[k] = 0;
  }
}

// Rows of (AᵀA)⁻¹Aᵀ, zero on the validation samples.
std::vector<std::vector<double>> pseudo_inverse(
    const std::vector<std::vector<double>>& columns) {
  const std::size_t n = columns.size();
  std::vector<double> gram(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) gram[i * n + j] = dot(columns[i], columns[j]);
  }
  const std::vector<double> inverse = inverse_spd(gram, n);
  const std::size_t length = n > 0 ? columns[0].size() : 0;
  std::vector<std::vector<double>> rows(n, std::vector<double>(length, 0.0));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const double w = inverse[i * n + j];
      if (w == 0) continue;
      for (std::size_t k = 0; k < length; ++k) rows[i][k] += w * columns[j][k];
    }
  }
  return rows;
}

// Standard deviation of Σ row·v for noise v of the given colour: the row filtered
// backwards through the noise model.
double deviation(const NoiseColour& colour, std::vector<double> row) {
  for (std::size_t k = row.size(); k-- > 0;) {
    for (std::size_t j = 1; j < colour.a.size() && k + j < row.size(); ++j) {
      row[k] -= colour.a[j] * row[k + j];
    }
  }
  return std::sqrt(std::max(0.0, colour.variance * dot(row, row)));
}

// What the error must rise by to be more than noise: four times the variance of a slow
// average, for one sample.
double noticeable_error(const NoiseColour& colour) {
  double sum = 0;
  for (const double a : colour.a) sum += a;
  const double slow = colour.variance / std::max(sum * sum, 0.05);
  return 4 * std::max(slow, colour.variance);
}

// The columns of a fit, 0 but on the estimation blocks. `run` is left at the fit.
std::vector<std::vector<double>> columns_of(const Fitter& fitter, const Fit& fit,
                                            FreeRun& run) {
  run.run(fit.p);
  std::vector<std::vector<double>> columns;
  for (std::size_t i = 0; i < fit.columns.size(); ++i) {
    columns.push_back(run.judged_column(i));
    keep_estimation(fitter.blocks(), columns.back());
  }
  return columns;
}

// What the searched parameters do to the residual near the fit.
struct Linearised {
  std::vector<std::size_t> slots;
  std::vector<Slope> slopes;
  std::vector<std::vector<double>> jacobian;  // one for each slot, on estimation samples
  std::vector<std::vector<double>> rows;      // its pseudo-inverse

  [[nodiscard]] bool is_flat(std::size_t j) const {
    return dot(jacobian[j], jacobian[j]) == 0;
  }
};

std::vector<DerivedValue> derived_intervals(const Fit& fit, const NoiseColour& colour,
                                            const Linearised& line) {
  std::vector<DerivedValue> out = derived_of(fit);
  for (DerivedValue& derived : out) {
    std::vector<double> row(fit.residual.size(), 0.0);
    double play = 0;
    for (std::size_t j = 0; j < line.slots.size(); ++j) {
      if (std::count(derived.slots.begin(), derived.slots.end(), line.slots[j]) == 0) {
        continue;
      }
      const SearchedParameter& part = fit.slots[line.slots[j]].parameter;
      const double unit = from_search(part, 1) - from_search(part, 0);
      play += line.is_flat(j) ? kUnbounded : unit * line.slopes[j].play;
      for (std::size_t k = 0; k < row.size(); ++k) row[k] += unit * line.rows[j][k];
    }
    const double width = kNormal95 * deviation(colour, std::move(row)) + play;
    derived.interval = within_bounds(fit, derived, width, width);
  }
  return out;
}

// What the rest of each piece would make of all parameters, searched ones first.
WithoutBeginning left_of(const Fit& fit, const Situation& situation, const Blocks& blocks,
                         const Linearised& line,
                         const std::vector<std::vector<double>>& columns) {
  std::vector<std::vector<double>> jacobian = line.jacobian;
  for (std::vector<double> column : columns) {
    for (double& value : column) value = -value;
    jacobian.push_back(std::move(column));
  }
  WithoutBeginning out(jacobian, fit.judged(), blocks,
                       beginnings(situation.pieces, blocks));
  for (std::size_t i = 0; i < columns.size(); ++i) {
    for (std::size_t j = 0; j < line.slots.size(); ++j) {
      out.moved[line.slots.size() + i] += line.slopes[j].coefficients[i] * out.moved[j];
    }
  }
  return out;
}

// Variance of the noise on the estimation samples, as large as slow averages show it.
double noise_variance(const Fitter& fitter, const Fit& fit) {
  constexpr double kMostColour = 30;
  const NoiseColour colour = colour_of(fit.judged());
  double sum = 0;
  for (const double a : colour.a) sum += a;
  const double count = static_cast<double>(fitter.blocks().estimation_samples());
  const double freedom = std::max(count - static_cast<double>(fit.parameters()), 1.0);
  const double mean = fit.error / freedom;
  const double slow = colour.variance / std::max(sum * sum, 1e-6);
  return mean * std::clamp(slow / std::max(mean, 1e-300), 1.0, kMostColour);
}

// The same fit with the instants held that the fitted samples do not tell.
Fit with_held_instants(const Fitter& fitter, Fit fit) {
  for (const SuddenInstant& instant :
       sudden_instants(fit.slots, fit.p, fitter.situation(fit))) {
    fit.slots[instant.slot].parameter.constant = true;
  }
  return fit;
}

std::vector<FreeRun::Held> held_in(const Fit& fit) {
  std::vector<FreeRun::Held> held;
  for (std::size_t i = 0; i < fit.p.size(); ++i) {
    const FreeRun::Slot& slot = fit.slots[i];
    if (!slot.parameter.sudden || !slot.parameter.constant) continue;
    held.push_back({slot.effect, std::string(slot.parameter.name), fit.p[i]});
  }
  return held;
}

// Their intervals, from the samples around them.
void place_instants(const Fitter& fitter, const Fit& fit, FitIntervals& out) {
  const Situation here = fitter.situation(fit);
  for (const SuddenInstant& instant : sudden_instants(fit.slots, fit.p, here)) {
    const double rise = least_rise(fitter, fit);
    const SuddenPlace place =
        place_of(instant, here, fitter.blocks(), fit.effects, fit.p, fitter.work(), rise);
    out.searched[instant.slot] = {std::min(place.low, fit.p[instant.slot]),
                                  std::max(place.high, fit.p[instant.slot])};
  }
}

// A gain stays on the side of zero that its controller asks for, (W11).
Interval around(const FreeRun& run, std::size_t i, double value, double width) {
  Interval out{value - width, value + width};
  const int sign = FreeRun::is_gain(run.columns()[i]) ? run.situation().gain_sign : 0;
  if (sign > 0) out.low = std::max(out.low, 0.0);
  if (sign < 0) out.high = std::min(out.high, 0.0);
  return out;
}

// What the walk adds to the uncertainty of the coefficients.
void widen_solved(const Fitter& fitter, const Fit& fit, const Walk& walk, FreeRun& run,
                  double variance, FitIntervals& out) {
  const std::vector<std::vector<double>> rows =
      pseudo_inverse(columns_of(fitter, fit, run));
  for (std::size_t i = 0; i < fit.columns.size(); ++i) {
    double sum = 0;
    double square = 0;
    double count = 0;
    for (const std::vector<double>& coefficients : walk.coefficients) {
      if (coefficients.size() != fit.columns.size()) continue;
      const double away = coefficients[i] - fit.coefficients[i];
      sum += away;
      square += away * away;
      ++count;
    }
    if (count == 0) continue;
    const double mean = sum / count;
    const double spread = std::max(0.0, square / count - mean * mean);
    const double width =
        kNormal95 * std::sqrt(spread + variance * dot(rows[i], rows[i])) + std::abs(mean);
    out.solved[i] = around(run, i, fit.coefficients[i], width);
  }
}

}  // namespace

double least_rise(const Fitter& fitter, const Fit& fit) {
  return kNormal95 * kNormal95 * noise_variance(fitter, fit);
}

FitIntervals intervals_of(const Fitter& fitter, const Fit& told) {
  const Fit fit = with_held_instants(fitter, told);
  const Situation here = fitter.situation(fit);
  FreeRun run(here, fitter.blocks(), fit.effects, fitter.work(), fit.weight);
  const NoiseColour colour = colour_of(fit.judged());
  const double noticeable = noticeable_error(colour);
  Linearised line;
  for (std::size_t i = 0; i < fit.p.size(); ++i) {
    if (!FreeRun::is_searched(fit.slots, fit.p, i)) continue;
    Slope slope = slope_of(run, fit, i, noticeable);
    std::vector<double> direction = slope.residual;
    keep_estimation(fitter.blocks(), direction);
    // A start that no sample shows says nothing about the rest.
    if (fit.slots[i].parameter.initial && dot(direction, direction) < noticeable)
      continue;
    line.slots.push_back(i);
    line.slopes.push_back(std::move(slope));
    line.jacobian.push_back(std::move(direction));
  }
  const std::vector<std::vector<double>> columns = columns_of(fitter, fit, run);
  // residual = y - ŷ, so the estimate moves by minus the pseudo-inverse.
  line.rows = pseudo_inverse(line.jacobian);
  const WithoutBeginning rest = left_of(fit, here, fitter.blocks(), line, columns);
  FitIntervals out;
  for (std::size_t i = 0; i < fit.p.size(); ++i) {
    const double factor = fit.slots[i].parameter.within_factor;
    out.searched.push_back({fit.p[i] / factor, fit.p[i] * factor});
  }
  for (std::size_t j = 0; j < line.slots.size(); ++j) {
    const SearchedParameter& parameter = fit.slots[line.slots[j]].parameter;
    const double width = line.is_flat(j) ? kUnbounded
                                         : kNormal95 * deviation(colour, line.rows[j]) +
                                               line.slopes[j].play;
    const double at = to_search(parameter, fit.p[line.slots[j]]);
    const double minded = parameter.initial ? width : rest.minding(width, j);
    const double reach = std::clamp(minded, finest(parameter), 1e3);
    out.searched[line.slots[j]] = {
        std::max(parameter.low, from_search(parameter, at - reach)),
        std::min(parameter.high, from_search(parameter, at + reach))};
  }
  out.derived = derived_intervals(fit, colour, line);
  const std::vector<std::vector<double>> linear = pseudo_inverse(columns);
  for (std::size_t i = 0; i < fit.columns.size(); ++i) {
    std::vector<double> row = linear[i];
    for (std::size_t j = 0; j < line.slots.size(); ++j) {
      const double g = line.slopes[j].coefficients[i];
      if (g == 0) continue;
      for (std::size_t k = 0; k < row.size(); ++k) row[k] -= g * line.rows[j][k];
    }
    const double width = kNormal95 * deviation(colour, row);
    const double minded =
        fit.columns[i].initial ? width : rest.minding(width, line.slots.size() + i);
    out.solved.push_back(around(run, i, fit.coefficients[i], minded));
  }
  place_instants(fitter, told, out);
  return out;
}

FitIntervals thorough_intervals_of(const Fitter& fitter, const Fit& told) {
  constexpr int kStepsPerParameter = 250;
  constexpr double kWidestScale = 0.03;
  constexpr double kTail = 0.025;
  // A walk of finite length sees too little, and a stem simulated sample by sample is not
  // quite the real one.
  constexpr double kStretch = 1.5;
  FitIntervals out = intervals_of(fitter, told);
  const Fit fit = with_held_instants(fitter, told);
  const Situation here = fitter.situation(fit);
  FreeRun run(here, fitter.blocks(), fit.effects, fitter.work(), fit.weight);
  run.hold(held_in(fit));
  if (!has_jumpy(run)) return out;
  std::vector<double> scale;
  int searched = 0;
  for (std::size_t i = 0; i < fit.p.size(); ++i) {
    const SearchedParameter& parameter = fit.slots[i].parameter;
    const double width = to_search(parameter, out.searched[i].high) -
                         to_search(parameter, out.searched[i].low);
    scale.push_back(std::clamp(width / (2 * kNormal95), 1e-5, kWidestScale));
    searched += FreeRun::is_searched(fit.slots, fit.p, i);
  }
  const double variance = noise_variance(fitter, fit);
  const Walk walk =
      walk_around(run, fit.p, scale, variance, kStepsPerParameter * (searched + 2));
  if (walk.p.empty()) return out;
  std::vector<double> values(walk.p.size());
  for (std::size_t i = 0; i < fit.p.size(); ++i) {
    const SearchedParameter& parameter = fit.slots[i].parameter;
    if (!FreeRun::is_searched(fit.slots, fit.p, i)) continue;
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = walk.p[k][i];
    const double at = to_search(parameter, fit.p[i]);
    const double least = finest(parameter);
    const double down = std::max(least, kStretch * (at - quantile(values, kTail)));
    const double up = std::max(least, kStretch * (quantile(values, 1 - kTail) - at));
    out.searched[i] = {std::max(parameter.low, from_search(parameter, at - down)),
                       std::min(parameter.high, from_search(parameter, at + up))};
  }
  for (DerivedValue& derived : out.derived) {
    for (std::size_t k = 0; k < values.size(); ++k) {
      values[k] = 0;
      for (const std::size_t slot : derived.slots) {
        values[k] += from_search(fit.slots[slot].parameter, walk.p[k][slot]);
      }
    }
    derived.interval =
        within_bounds(fit, derived, kStretch * (derived.value - quantile(values, kTail)),
                      kStretch * (quantile(values, 1 - kTail) - derived.value));
  }
  widen_solved(fitter, fit, walk, run, variance, out);
  return out;
}

}  // namespace workbench
