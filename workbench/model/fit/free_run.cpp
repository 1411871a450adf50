#include "workbench/model/fit/free_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "workbench/effects/ringing.hpp"

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
                       .high = situation.duration_s(),
                       .logarithmic = true}});
  }
  process_slots_ = slots_.size();
  valve_slots_end_ = slots_.size();
  for (const Effect* effect : effects_) {
    first_.push_back(slots_.size());
    for (const SearchedParameter& parameter : effect->searched(situation)) {
      slots_.push_back({parameter, effect});
    }
    count_.push_back(slots_.size() - first_.back());
    if (effect->description().place < Place::kProcess) valve_slots_end_ = slots_.size();
  }
  pieces_.assign(situation.pieces.begin(), situation.pieces.end());
  if (pieces_.empty()) pieces_.push_back({0, situation.samples(), {}, 0, false});
  const std::size_t of_all = slots_.size();
  for (std::size_t piece = 1; piece < pieces_.size(); ++piece) {
    for (std::size_t i = 0; i < of_all; ++i) {
      if (!slots_[i].parameter.initial) continue;
      starts_.push_back({slots_.size(), i, piece});
      slots_.push_back(
          {slots_[i].parameter, slots_[i].effect, piece, pieces_[piece].judges});
    }
  }
  take_loads();
  at_rest_.resize(pieces_.size());
  valve_.resize(situation.samples());
  z_.resize(situation.samples());
  residual_.resize(situation.samples());
}

bool stays_behind(const Effect& effect) {
  const bool elsewhere = effect.description().is_load() || !effect.solved().empty();
  return elsewhere && !effect.description().recorded;
}

// The loads of each piece, from the first value of all.
void FreeRun::take_loads() {
  const bool any = std::any_of(effects_.begin(), effects_.end(),
                               [](const Effect* e) { return e->description().recorded; });
  loads_.resize(pieces_.size());
  for (std::size_t i = 0; any && i < pieces_.size(); ++i) {
    for (const Load& load : situation_->loads) {
      const auto begin = load.values.begin();
      loads_[i].push_back({load.name,
                           load.unit,
                           {begin + static_cast<std::ptrdiff_t>(pieces_[i].first),
                            begin + static_cast<std::ptrdiff_t>(pieces_[i].last)}});
      for (double& value : loads_[i].back().values) value -= load.values.front();
    }
  }
}

bool FreeRun::is_searched(std::span<const Slot> slots, std::span<const double> p,
                          std::size_t i) {
  const SearchedParameter& parameter = slots[i].parameter;
  if (parameter.constant || slots[i].judges) return false;
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

std::span<const double> FreeRun::of(const Effect& effect, std::span<const double> p,
                                    std::size_t piece) {
  std::size_t i = 0;
  while (effects_[i] != &effect) ++i;
  const std::span<const double> all = p.subspan(first_[i], count_[i]);
  if (piece == 0 || starts_.empty()) return all;
  own_.assign(all.begin(), all.end());
  for (const Start& start : starts_) {
    const bool its = start.of_all >= first_[i] && start.of_all < first_[i] + count_[i];
    if (start.piece == piece && its) {
      own_[start.of_all - first_[i]] = p[start.slot];
    }
  }
  return own_;
}

void FreeRun::simulate_valve(std::span<const double> p) {
  const auto same = [&](std::size_t from, std::size_t to) {
    return std::equal(p.begin() + static_cast<std::ptrdiff_t>(from),
                      p.begin() + static_cast<std::ptrdiff_t>(to),
                      last_p_.begin() + static_cast<std::ptrdiff_t>(from));
  };
  const bool same_lag = integrating_ || last_p_.empty() || last_p_[1] == p[1];
  if (!last_p_.empty() && same_lag && same(process_slots_, valve_slots_end_) &&
      same(slots_.size() - starts_.size(), slots_.size())) {
    return;
  }
  std::copy(situation_->u.begin(), situation_->u.end(), valve_.begin());
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const auto v =
        std::span(valve_).subspan(pieces_[i].first, pieces_[i].last - pieces_[i].first);
    ValveSignal signal{situation_->period_s, v, 0, integrating_ ? 0 : p[1], 0};
    for (const Effect* effect : effects_) {
      if (effect->description().place < Place::kProcess) {
        effect->move(of(*effect, p, i), signal);
      }
    }
    at_rest_[i] = signal.at_rest;
    settling_s_ = signal.settling_s;
  }
}

// A new column, of its piece alone where `own`; that of the first piece otherwise.
std::span<double> FreeRun::place(const Column& column, bool own) {
  const Piece& piece = pieces_[column.piece];
  const std::size_t count = piece.last - piece.first;
  std::size_t i = columns_.size();
  if (!own && column.piece > 0) {
    i = 0;
    while (columns_[i].effect != column.effect || columns_[i].name != column.name) ++i;
    return std::span(raw_[i]).subspan(piece.first, count);
  }
  if (raw_.size() <= i) {
    raw_.emplace_back(situation_->samples());
    used_.emplace_back(situation_->samples());
  }
  columns_.push_back(column);
  extents_.push_back(own ? SampleRange{piece.first, piece.last}
                         : SampleRange{0, situation_->samples()});
  if (own && pieces_.size() > 1) std::fill(raw_[i].begin(), raw_[i].end(), 0.0);
  return std::span(raw_[i]).subspan(piece.first, count);
}

void FreeRun::build_columns(std::span<const double> p) {
  columns_.clear();
  extents_.clear();
  for (std::size_t piece = 0; piece < pieces_.size(); ++piece) build_piece(piece, p);
}

void FreeRun::build_piece(std::size_t number, std::span<const double> p) {
  form_shape(number, p);
  add_response(number, p);
  add_initial_states(number);
  add_effects(number, p);
  add_decay(number, "sensor_state", shape_.sensor_lag_s);
}

void FreeRun::form_shape(std::size_t number, std::span<const double> p) {
  shape_ = {};
  if (!integrating_) shape_.first_lag_s = p[1];
  ceiling_.reset();
  for (const Effect* effect : effects_) {
    const std::span<const double> own = of(*effect, p, number);
    effect->form(own, shape_);
    if (const auto level = effect->ceiling(own)) {
      ceiling_ = *level;
    }
  }
  if (ceiling_ && ceiling_->before_second && shape_.sensor_lag_s == 0 && !integrating_) {
    std::swap(shape_.second_lag_s, shape_.sensor_lag_s);
  }
}

std::span<double> FreeRun::shared_column(std::size_t number, std::string_view name,
                                         std::string_view unit) {
  return place({std::string(name), std::string(unit), nullptr, false, false, number,
                pieces_[number].judges},
               false);
}

std::span<double> FreeRun::initial_column(std::size_t number, std::string_view name) {
  return place(
      {std::string(name), "y", nullptr, true, false, number, pieces_[number].judges},
      true);
}

void FreeRun::add_decay(std::size_t number, std::string_view name, double lag_s) {
  const double h = situation_->period_s;
  if (lag_s > kShortestDecay * h) decay(h, lag_s, initial_column(number, name));
}

// What the process makes of the valve, and what it stands on.
void FreeRun::add_response(std::size_t number, std::span<const double> p) {
  const double h = situation_->period_s;
  const double reference = p[0];
  const Piece& piece = pieces_[number];
  const std::size_t count = piece.last - piece.first;
  const auto valve = std::span<const double>(valve_).subspan(piece.first, count);
  const auto z = std::span(z_).subspan(piece.first, count);
  std::span<double> column =
      shared_column(number, "gain", integrating_ ? "y/u/s" : "y/u");
  if (integrating_) {
    for (std::size_t k = 0; k < count; ++k) z[k] = valve[k] - reference;
    respond(shape_, h, z, scratch_, column);
    std::copy(column.begin(), column.end(), z.begin());
    column = shared_column(number, "drift", "y/s");
    for (std::size_t k = 0; k < count; ++k) column[k] = h * static_cast<double>(k);
    column = initial_column(number, "offset");
  } else {
    respond(shape_, h, valve, scratch_, z);
    for (const Effect* effect : effects_) effect->bend(of(*effect, p, number), z);
    for (std::size_t k = 0; k < count; ++k) column[k] = z[k] - reference;
    column = shared_column(number, "offset", "y");
  }
  std::fill(column.begin(), column.end(), 1.0);
}

void FreeRun::add_initial_states(std::size_t number) {
  const double h = situation_->period_s;
  const std::size_t count = pieces_[number].last - pieces_[number].first;
  if (!integrating_) add_decay(number, "first_lag_state", shape_.first_lag_s);
  add_decay(number, "second_lag_state", shape_.second_lag_s);
  if (shape_.opposite_s > 0) add_decay(number, "fast_part_state", fast_lag_of(shape_));
  if (shape_.ring_period_s > 0) {
    const std::span<double> even = initial_column(number, "ringing_state");
    ring_off(shape_, h, even, initial_column(number, "ringing_slope"));
  }
  ProcessShape linear = shape_;
  linear.storage = {};
  linear.start = 0;
  if (at_rest_[number] > 0 && at_rest_[number] < count) {
    std::vector<double> rest(count, 0.0);
    std::fill_n(rest.begin(), at_rest_[number], 1.0);
    respond(linear, h, rest, scratch_, initial_column(number, "initial_stem"));
  }
  if (shape_.dead_time_s > h) {
    // What was underway at the first sample is not what u was there.
    ProcessShape arrived = linear;
    arrived.dead_time_s = 0;
    std::vector<double> underway(count);
    for (const auto& [name, share] :
         {std::pair("initial_pipe", 1.0), std::pair("initial_pipe_first_half", 0.5)}) {
      for (std::size_t k = 0; k < count; ++k) {
        underway[k] =
            std::clamp(share * shape_.dead_time_s / h - static_cast<double>(k), 0.0, 1.0);
      }
      respond(arrived, h, underway, scratch_, initial_column(number, name));
    }
  }
  if (settling_s_ > kShortestDecay * h) {
    std::vector<double> settling(count);
    decay(h, settling_s_, settling);
    respond(linear, h, settling, scratch_, initial_column(number, "positioner_state"));
  }
}

// The solved parameters of the effects.
void FreeRun::add_effects(std::size_t number, std::span<const double> p) {
  const double h = situation_->period_s;
  const Piece& piece = pieces_[number];
  const auto z = std::span(z_).subspan(piece.first, piece.last - piece.first);
  const double start_s = h * static_cast<double>(piece.first);
  for (const Effect* effect : effects_) {
    const auto solved = effect->solved();
    if (solved.empty()) continue;
    const bool absent = piece.judges && stays_behind(*effect);
    std::vector<std::span<double>> own;
    for (const SolvedParameter& parameter : solved) {
      if (absent && parameter.each) continue;
      // That of a later piece is not a parameter of the model.
      own.push_back(
          place({std::string(parameter.name), std::string(parameter.unit), effect,
                 parameter.each && number > 0, parameter.strength, number, piece.judges},
                parameter.each));
    }
    if (absent) {
      for (const std::span<double> part : own) std::fill(part.begin(), part.end(), 0.0);
    } else {
      effect->load(of(*effect, p, number), {h, z, shape_, loads_[number], start_s}, own);
    }
  }
}

double FreeRun::run(std::span<const double> p) {
  work_->check();
  Work::spend(residual_.size());
  simulate_valve(p);
  build_columns(p);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (shape_.sensor_lag_s > 0 && columns_[i].name != "sensor_state") {
      behind_sensor(raw_[i], used_[i]);
    } else {
      std::swap(raw_[i], used_[i]);
      if (ceiling_) raw_[i] = used_[i];
    }
  }
  record_columns(p);
  coefficients_.assign(columns_.size(), 0.0);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (const Held* one = held(columns_[i])) coefficients_[i] = one->value;
  }
  solve(false, Rows::kEstimation);
  finish(p);
  solve_behind_rounding(p);
  last_p_.assign(p.begin(), p.end());
  set_aside();
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
      behind_sensor(raw_[i], used_[i]);
    } else {
      used_[i] = raw_[i];
    }
  }
  record_columns(p);
  coefficients_.assign(columns_.size(), 0.0);
  for (std::size_t i = 0; i < columns_.size() && i < plant.size(); ++i) {
    if (!columns_[i].initial) coefficients_[i] = plant[i];
  }
  solve(true, rows);
  finish(p);
  last_p_.assign(p.begin(), p.end());
  set_aside();
  return sum_of_squares(residual_, blocks_->blocks());
}

}  // namespace workbench
