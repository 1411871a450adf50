// FreeRun: the columns, one for each thing that the output is linear in.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "workbench/effects/ringing.hpp"
#include "workbench/model/fit/free_run.hpp"

namespace workbench {
namespace {

constexpr double kShortestDecay = 0.3;  // sample periods; faster ones leave no trace
constexpr double kForEver = std::numeric_limits<double>::infinity();

// By which a ringing pair falls, s.
double lag_of_ringing(const ProcessShape& shape) {
  return shape.ring_period_s / (2 * std::numbers::pi * shape.ring_damping);
}

}  // namespace

// A new column, of its piece alone where `own`; that of the first piece otherwise.
std::span<double> FreeRun::place(const Column& column, bool own) {
  const Piece& piece = pieces_[column.piece];
  return place(column, own, piece.last - piece.first);
}

// One of its own is `count` samples long, and 0 elsewhere.
std::span<double> FreeRun::place(const Column& column, bool own, std::size_t count) {
  const Piece& piece = pieces_[column.piece];
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
  const SampleRange extent = own ? SampleRange{piece.first, piece.first + count}
                                 : SampleRange{0, situation_->samples()};
  extents_.push_back(extent);
  const auto at = [&](std::size_t k) {
    return raw_[i].begin() + static_cast<std::ptrdiff_t>(k);
  };
  std::fill(raw_[i].begin(), at(extent.first), 0.0);
  std::fill(at(extent.last), raw_[i].end(), 0.0);
  return std::span(raw_[i]).subspan(piece.first, count);
}

void FreeRun::build_columns(std::span<const double> p) {
  columns_.clear();
  extents_.clear();
  for (std::size_t piece = 0; piece < pieces_.size(); ++piece) build_piece(piece, p);
}

void FreeRun::build_piece(std::size_t number, std::span<const double> p) {
  const bool at_rest = pieces_[number].at_rest;
  form_shape(number, p);
  add_response(number, p);
  if (!at_rest) add_initial_states(number);
  add_effects(number, p);
  if (!at_rest) add_decay(number, "sensor_state", shape_.sensor_lag_s);
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

// Of a state that is forgotten after some `memory_s`, no longer than that.
std::span<double> FreeRun::initial_column(std::size_t number, std::string_view name,
                                          double memory_s) {
  const Piece& piece = pieces_[number];
  std::size_t count = piece.last - piece.first;
  if (memory_s < situation_->period_s * static_cast<double>(count)) {
    const double samples = std::ceil(memory_s / situation_->period_s);
    count = static_cast<std::size_t>(std::max(samples, 0.0));
  }
  return place({std::string(name), "y", nullptr, true, false, number, piece.judges}, true,
               count);
}

// How long the lags that follow on `lag_s` remember its state. What comes behind them, a
// ceiling, a sensor's lag or the record, may carry it anywhere.
double FreeRun::memory_of_state(double lag_s) const {
  constexpr double kLags = 36;  // to the rounding of it
  const bool record = std::any_of(
      effects_.begin(), effects_.end(),
      [](const Effect* effect) { return effect->description().place == Place::kRecord; });
  if (ceiling_ || shape_.sensor_lag_s > 0 || record) {
    return kForEver;
  }
  return kLags * lag_s;
}

void FreeRun::add_decay(std::size_t number, std::string_view name, double lag_s) {
  const double h = situation_->period_s;
  if (lag_s > kShortestDecay * h) {
    decay(h, lag_s, initial_column(number, name, memory_of_state(lag_s)));
  }
}

// The same behind the process, whose lags, all in a row, forget no later than this.
double FreeRun::memory_of_process() const {
  if (integrating_) return kForEver;
  double lags_s = shape_.first_lag_s * std::max(1.0, shape_.falling_over_rising) +
                  shape_.second_lag_s;
  if (shape_.opposite_s > 0) lags_s += fast_lag_of(shape_);
  if (shape_.ring_period_s > 0) lags_s += lag_of_ringing(shape_);
  if (shape_.tail_share > 0) lags_s += shape_.tail_lag_s;
  return shape_.dead_time_s + memory_of_state(lags_s);
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
    column = initial_column(number, "offset", kForEver);
  } else {
    respond(shape_, h, valve, scratch_, z);
    for (const Effect* effect : effects_) effect->bend(of(*effect, p, number), z);
    for (std::size_t k = 0; k < count; ++k) column[k] = z[k] - reference;
    column = shared_column(number, "offset", "y");
  }
  std::fill(column.begin(), column.end(), 1.0);
  if (!integrating_ && begins_other_load(number)) add_level(number);
}

// (W9) Another recording was made under another load.
bool FreeRun::begins_other_load(std::size_t number) const {
  return number > 0 && !pieces_[number].judges &&
         pieces_[number].recording != pieces_[number - 1].recording;
}

// How much higher y stands in all of the recording that begins with this piece.
void FreeRun::add_level(std::size_t number) {
  std::size_t last = number;
  while (last + 1 < pieces_.size() &&
         pieces_[last + 1].recording == pieces_[number].recording) {
    ++last;
  }
  const std::size_t count = pieces_[last].last - pieces_[number].first;
  const std::span<double> column =
      place({"level", "y", nullptr, true, false, number, false}, true, count);
  std::fill(column.begin(), column.end(), 1.0);
}

void FreeRun::add_initial_states(std::size_t number) {
  const double h = situation_->period_s;
  if (!integrating_) add_decay(number, "first_lag_state", shape_.first_lag_s);
  add_decay(number, "second_lag_state", shape_.second_lag_s);
  if (shape_.opposite_s > 0) add_decay(number, "fast_part_state", fast_lag_of(shape_));
  if (shape_.tail_share > 0) add_decay(number, "tail_state", shape_.tail_lag_s);
  if (shape_.ring_period_s > 0) {
    const double memory_s = memory_of_state(lag_of_ringing(shape_));
    const std::span<double> even = initial_column(number, "ringing_state", memory_s);
    ring_off(shape_, h, even, initial_column(number, "ringing_slope", memory_s));
  }
  ProcessShape linear = shape_;
  linear.storage = {};
  linear.falling_over_rising = 1;
  linear.start = 0;
  const double memory_s = memory_of_process();
  std::vector<double> in;
  const auto answer = [&](const ProcessShape& shape, std::span<double> column) {
    respond(shape, h, in, scratch_, column);
  };
  const std::size_t at_rest = at_rest_[number];
  if (at_rest > 0 && at_rest < pieces_[number].last - pieces_[number].first) {
    const std::span<double> column = initial_column(
        number, "initial_stem", h * static_cast<double>(at_rest) + memory_s);
    in.assign(column.size(), 0.0);
    std::fill_n(in.begin(), at_rest, 1.0);
    answer(linear, column);
  }
  if (shape_.dead_time_s > h) {
    // What was underway at the first sample is not what u was there.
    ProcessShape arrived = linear;
    arrived.dead_time_s = 0;
    for (const auto& [name, share] :
         {std::pair(kPipe, 1.0), std::pair(kFirstHalfOfPipe, 0.5)}) {
      const std::span<double> column =
          initial_column(number, name, shape_.dead_time_s + memory_s);
      in.resize(column.size());
      for (std::size_t k = 0; k < in.size(); ++k) {
        in[k] =
            std::clamp(share * shape_.dead_time_s / h - static_cast<double>(k), 0.0, 1.0);
      }
      answer(arrived, column);
    }
  }
  if (settling_s_ > kShortestDecay * h) {
    const std::span<double> column = initial_column(
        number, "positioner_state", memory_of_state(settling_s_) + memory_s);
    in.resize(column.size());
    decay(h, settling_s_, in);
    answer(linear, column);
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
      const bool summed = integrating_ && !parameter.integrated_unit.empty();
      const std::string_view unit = summed ? parameter.integrated_unit : parameter.unit;
      // That of a later piece is not a parameter of the model.
      own.push_back(
          place({std::string(parameter.name), std::string(unit), effect,
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

}  // namespace workbench
