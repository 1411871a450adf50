#include "workbench/model/free_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "workbench/model/least_squares.hpp"

namespace workbench {
namespace {

constexpr double kShortestDecay = 0.3;  // sample periods; faster ones leave no trace

bool finite(std::span<const double> values) {
  return std::isfinite(dot(values, values));
}

}  // namespace

FreeRun::FreeRun(const Situation& situation, const Blocks& blocks,
                 std::vector<const Effect*> effects, const Work& work)
    : situation_(&situation),
      blocks_(&blocks),
      work_(&work),
      effects_(std::move(effects)) {
  // The order of the parameters does not depend on that in which effects were added.
  std::sort(effects_.begin(), effects_.end(), [](const Effect* a, const Effect* b) {
    const Place here = a->description().place;
    const Place there = b->description().place;
    return here != there ? here < there : a->code() < b->code();
  });
  ProcessShape shape;
  for (const Effect* effect : effects_) {
    if (effect->searched(situation).empty()) effect->form({}, shape);
  }
  integrating_ = shape.integrating;
  slots_.push_back({{.name = "reference",
                     .unit = "u",
                     .low = situation.u_low,
                     .high = situation.u_high,
                     .constant = true}});
  if (!integrating_) {
    slots_.push_back({{.name = "first_lag",
                       .unit = "s",
                       .low = situation.period_s / 10,
                       .high = situation.duration_s() / 5,
                       .logarithmic = true}});
  }
  process_slots_ = slots_.size();
  valve_slots_end_ = slots_.size();
  for (const Effect* effect : effects_) {
    first_.push_back(slots_.size());
    for (const SearchedParameter& parameter : effect->searched(situation)) {
      slots_.push_back({parameter, effect});
    }
    if (effect->description().place < Place::kProcess) valve_slots_end_ = slots_.size();
  }
  valve_.resize(situation.samples());
  z_.resize(situation.samples());
  residual_.resize(situation.samples());
}

bool FreeRun::is_searched(std::span<const Slot> slots, std::span<const double> p,
                          std::size_t i) {
  const SearchedParameter& parameter = slots[i].parameter;
  if (parameter.constant) return false;
  if (parameter.only_with.empty()) return true;
  for (std::size_t j = 0; j < slots.size(); ++j) {
    if (slots[j].effect == slots[i].effect &&
        slots[j].parameter.name == parameter.only_with) {
      return p[j] > 0.5;
    }
  }
  return true;
}

std::size_t FreeRun::first_slot(const Effect& effect) const {
  for (std::size_t i = 0; i < effects_.size(); ++i) {
    if (effects_[i] == &effect) return first_[i];
  }
  return slots_.size();
}

std::span<const double> FreeRun::of(const Effect& effect,
                                    std::span<const double> p) const {
  const std::size_t first = first_slot(effect);
  std::size_t last = first;
  while (last < slots_.size() && slots_[last].effect == &effect) ++last;
  return p.subspan(first, last - first);
}

void FreeRun::simulate_valve(std::span<const double> p) {
  const auto from = static_cast<std::ptrdiff_t>(process_slots_);
  const auto to = static_cast<std::ptrdiff_t>(valve_slots_end_);
  const bool same_lag = integrating_ || last_p_.empty() || last_p_[1] == p[1];
  if (!last_p_.empty() && same_lag &&
      std::equal(p.begin() + from, p.begin() + to, last_p_.begin() + from)) {
    return;
  }
  std::copy(situation_->u.begin(), situation_->u.end(), valve_.begin());
  ValveSignal signal{situation_->period_s, valve_, 0, integrating_ ? 0 : p[1], 0};
  for (const Effect* effect : effects_) {
    if (effect->description().place < Place::kProcess)
      effect->move(of(*effect, p), signal);
  }
  at_rest_ = signal.at_rest;
  settling_s_ = signal.settling_s;
}

std::span<double> FreeRun::next_column(std::string_view name, std::string_view unit,
                                       const Effect* effect, bool initial,
                                       bool strength) {
  const std::size_t i = columns_.size();
  if (raw_.size() <= i) {
    raw_.emplace_back(situation_->samples());
    used_.emplace_back(situation_->samples());
  }
  columns_.push_back({std::string(name), std::string(unit), effect, initial, strength});
  return raw_[i];
}

void FreeRun::build_columns(std::span<const double> p) {
  const double h = situation_->period_s;
  const double reference = p[0];
  shape_ = {};
  if (!integrating_) shape_.first_lag_s = p[1];
  ceiling_.reset();
  for (const Effect* effect : effects_) {
    const std::span<const double> own = of(*effect, p);
    effect->form(own, shape_);
    if (const auto level = effect->ceiling(own)) {
      ceiling_ = *level;
    }
  }
  if (ceiling_ && ceiling_->before_second && shape_.sensor_lag_s == 0 && !integrating_) {
    std::swap(shape_.second_lag_s, shape_.sensor_lag_s);
  }
  columns_.clear();
  std::span<double> column =
      next_column("gain", integrating_ ? "y/u/s" : "y/u", nullptr, false, false);
  if (integrating_) {
    for (std::size_t k = 0; k < valve_.size(); ++k) z_[k] = valve_[k] - reference;
    respond(shape_, h, z_, scratch_, column);
    std::copy(column.begin(), column.end(), z_.begin());
    column = next_column("drift", "y/s", nullptr, false, false);
    for (std::size_t k = 0; k < column.size(); ++k)
      column[k] = h * static_cast<double>(k);
  } else {
    respond(shape_, h, valve_, scratch_, z_);
    for (const Effect* effect : effects_) effect->bend(of(*effect, p), z_);
    for (std::size_t k = 0; k < z_.size(); ++k) column[k] = z_[k] - reference;
  }
  column = next_column("offset", "y", nullptr, integrating_, false);
  std::fill(column.begin(), column.end(), 1.0);
  const auto add_decay = [&](std::string_view name, double lag_s) {
    if (lag_s > kShortestDecay * h) {
      decay(h, lag_s, next_column(name, "y", nullptr, true, false));
    }
  };
  if (!integrating_) add_decay("first_lag_state", shape_.first_lag_s);
  add_decay("second_lag_state", shape_.second_lag_s);
  ProcessShape linear = shape_;
  linear.storage = {};
  linear.start = 0;
  if (at_rest_ > 0 && at_rest_ < valve_.size()) {
    column = next_column("initial_stem", "y", nullptr, true, false);
    std::vector<double> rest(valve_.size(), 0.0);
    std::fill_n(rest.begin(), at_rest_, 1.0);
    respond(linear, h, rest, scratch_, column);
  }
  if (shape_.dead_time_s > h) {
    // What was underway at the first sample is not what u was there.
    ProcessShape arrived = linear;
    arrived.dead_time_s = 0;
    std::vector<double> underway(valve_.size());
    for (const auto& [name, share] :
         {std::pair("initial_pipe", 1.0), std::pair("initial_pipe_first_half", 0.5)}) {
      column = next_column(name, "y", nullptr, true, false);
      for (std::size_t k = 0; k < underway.size(); ++k) {
        underway[k] =
            std::clamp(share * shape_.dead_time_s / h - static_cast<double>(k), 0.0, 1.0);
      }
      respond(arrived, h, underway, scratch_, column);
    }
  }
  if (settling_s_ > kShortestDecay * h) {
    column = next_column("positioner_state", "y", nullptr, true, false);
    std::vector<double> settling(valve_.size());
    decay(h, settling_s_, settling);
    respond(linear, h, settling, scratch_, column);
  }
  for (const Effect* effect : effects_) {
    const auto solved = effect->solved();
    if (solved.empty()) continue;
    std::vector<std::span<double>> own;
    for (const SolvedParameter& parameter : solved) {
      own.push_back(
          next_column(parameter.name, parameter.unit, effect, false, parameter.strength));
    }
    effect->load(of(*effect, p), {h, z_, shape_, situation_->loads}, own);
  }
  add_decay("sensor_state", shape_.sensor_lag_s);
}

// What is left after one period of a deviation from the linear process: a storage that
// spilled starts from its brim.
double FreeRun::memory() const {
  if (!ceiling_->spills) return 0;
  const double lag_s = integrating_ ? 0 : shape_.first_lag_s;
  return integrating_ ? 1 : std::exp(-situation_->period_s / lag_s);
}

// The linear output in residual_ becomes the one below the ceiling, behind the sensor.
void FreeRun::cut_off() {
  free_.resize(residual_.size());
  const double keep = memory();
  double lost = 0;
  for (std::size_t k = 0; k < residual_.size(); ++k) {
    const double reached = residual_[k] + keep * lost;
    free_[k] = reached < ceiling_->level;
    const double left = std::min(reached, ceiling_->level);
    lost = left - residual_[k];
    residual_[k] = left;
  }
  if (shape_.sensor_lag_s > 0) {
    lag_of_lines(residual_, situation_->period_s, shape_.sensor_lag_s, residual_);
  }
}

// The same for the derivatives with respect to the coefficients.
void FreeRun::cut_columns() {
  const double keep = memory();
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (columns_[i].name == "sensor_state") {
      used_[i] = raw_[i];
      continue;
    }
    double lost = 0;
    for (std::size_t k = 0; k < free_.size(); ++k) {
      used_[i][k] = free_[k] ? raw_[i][k] + keep * lost : 0;
      lost = used_[i][k] - raw_[i][k];
    }
    if (shape_.sensor_lag_s > 0) {
      lag_of_lines(used_[i], situation_->period_s, shape_.sensor_lag_s, used_[i]);
    }
  }
}

// From the columns and their coefficients to the residual, before anything is recorded.
void FreeRun::output() {
  const std::size_t n = residual_.size();
  std::fill(residual_.begin(), residual_.end(), 0.0);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const double c = coefficients_[i];
    if (c == 0) continue;
    const std::vector<double>& column = ceiling_ ? raw_[i] : used_[i];
    if (ceiling_ && columns_[i].name == "sensor_state") continue;
    for (std::size_t k = 0; k < n; ++k) residual_[k] += c * column[k];
  }
  if (ceiling_) {
    cut_off();
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (columns_[i].name != "sensor_state") continue;
      for (std::size_t k = 0; k < n; ++k) residual_[k] += coefficients_[i] * raw_[i][k];
    }
  }
  for (std::size_t k = 0; k < n; ++k) residual_[k] = situation_->y[k] - residual_[k];
}

void FreeRun::solve(bool initial_only, Rows where) {
  std::vector<std::size_t> active;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (!initial_only || columns_[i].initial) active.push_back(i);
  }
  std::vector<std::span<const double>> columns;
  for (const std::size_t i : active) columns.emplace_back(used_[i]);
  const Block everything{0, residual_.size(), true};
  const std::span<const Block> rows = where == Rows::kAll
                                          ? std::span<const Block>(&everything, 1)
                                          : std::span<const Block>(blocks_->blocks());
  const auto improve = [&] {
    const std::vector<double> step = least_squares(columns, residual_, rows);
    for (std::size_t i = 0; i < active.size(); ++i) coefficients_[active[i]] += step[i];
    output();
    return sum_of_squares(residual_, rows);
  };
  if (!ceiling_) {
    output();
    improve();
    return;
  }
  // The cut makes the output piecewise linear in the coefficients: Gauss-Newton steps,
  // the first over what lies clearly below the level.
  const Ceiling ceiling = *ceiling_;
  ceiling_.reset();
  std::vector<Block> below;
  for (const Block& block : rows) {
    if (!block.estimation) continue;
    for (std::size_t k = block.first; k < block.last; ++k) {
      if (situation_->y[k] > ceiling.level - 0.02 * situation_->y_span()) continue;
      if (below.empty() || below.back().last != k) below.push_back({k, k, true});
      below.back().last = k + 1;
    }
  }
  output();
  const std::vector<double> step = least_squares(columns, residual_, below);
  for (std::size_t i = 0; i < active.size(); ++i) coefficients_[active[i]] += step[i];
  ceiling_ = ceiling;
  output();
  double best = sum_of_squares(residual_, rows);
  constexpr int kMostSteps = 4;
  for (int i = 0; i < kMostSteps; ++i) {
    cut_columns();
    const std::vector<double> kept = coefficients_;
    const std::vector<unsigned char> before = free_;
    const double error = improve();
    if (!(error < best)) {
      coefficients_ = kept;
      output();
      return;
    }
    if (free_ == before || error > best * (1 - 1e-4)) return;
    best = error;
  }
}

void FreeRun::finish(std::span<const double> p) {
  for (const Effect* effect : effects_) {
    if (effect->description().place != Place::kRecord) continue;
    for (std::size_t k = 0; k < residual_.size(); ++k) {
      residual_[k] = situation_->y[k] - residual_[k];
    }
    effect->record(of(*effect, p), residual_);
    for (std::size_t k = 0; k < residual_.size(); ++k) {
      residual_[k] = situation_->y[k] - residual_[k];
    }
  }
}

// What a rounding makes of the output differs from it in step with it, so the
// coefficients that fit best before the rounding are not those that fit best behind it.
void FreeRun::solve_behind_rounding(std::span<const double> p) {
  const bool rounded = std::any_of(effects_.begin(), effects_.end(), [](const Effect* e) {
    return e->description().place == Place::kRecord;
  });
  if (!rounded || ceiling_) return;
  const std::vector<std::span<const double>> columns(
      used_.begin(), used_.begin() + static_cast<std::ptrdiff_t>(columns_.size()));
  double best = sum_of_squares(residual_, blocks_->blocks());
  constexpr int kMostSteps = 6;
  double share = 1;
  for (int i = 0; i < kMostSteps; ++i) {
    const std::vector<double> kept = coefficients_;
    const std::vector<double> step = least_squares(columns, residual_, blocks_->blocks());
    for (std::size_t j = 0; j < step.size(); ++j) coefficients_[j] += share * step[j];
    output();
    finish(p);
    const double error = sum_of_squares(residual_, blocks_->blocks());
    if (error < best) {
      if (error > best * (1 - 1e-4)) return;
      best = error;
      continue;
    }
    share /= 3;
    coefficients_ = kept;
    output();
    finish(p);
  }
}

double FreeRun::run(std::span<const double> p) {
  work_->check();
  Work::spend(residual_.size());
  simulate_valve(p);
  build_columns(p);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (shape_.sensor_lag_s > 0 && columns_[i].name != "sensor_state") {
      lag_of_lines(raw_[i], situation_->period_s, shape_.sensor_lag_s, used_[i]);
    } else {
      std::swap(raw_[i], used_[i]);
      if (ceiling_) raw_[i] = used_[i];
    }
  }
  coefficients_.assign(columns_.size(), 0.0);
  solve(false, Rows::kEstimation);
  finish(p);
  solve_behind_rounding(p);
  last_p_.assign(p.begin(), p.end());
  if (!finite(residual_)) return std::numeric_limits<double>::infinity();
  return sum_of_squares(residual_, blocks_->blocks());
}

double FreeRun::run_with(std::span<const double> p, std::span<const double> plant,
                         Rows rows) {
  work_->check();
  simulate_valve(p);
  build_columns(p);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (shape_.sensor_lag_s > 0 && columns_[i].name != "sensor_state") {
      lag_of_lines(raw_[i], situation_->period_s, shape_.sensor_lag_s, used_[i]);
    } else {
      used_[i] = raw_[i];
    }
  }
  coefficients_.assign(columns_.size(), 0.0);
  for (std::size_t i = 0; i < columns_.size() && i < plant.size(); ++i) {
    if (!columns_[i].initial) coefficients_[i] = plant[i];
  }
  solve(true, rows);
  finish(p);
  last_p_.assign(p.begin(), p.end());
  return sum_of_squares(residual_, blocks_->blocks());
}

}  // namespace workbench
