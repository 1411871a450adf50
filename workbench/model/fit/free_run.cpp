#include "workbench/model/fit/free_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace workbench {
namespace {

bool finite(std::span<const double> values) {
  return std::isfinite(dot(values, values));
}

}  // namespace

FreeRun::FreeRun(const Situation& situation, const Blocks& blocks,
                 std::vector<const Effect*> effects, const Work& work,
                 std::vector<double> colour)
    : situation_(&situation),
      blocks_(&blocks),
      work_(&work),
      effects_(std::move(effects)),
      weight_(std::move(colour)) {
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
  Situation here = situation;
  here.integrating = integrating_;
  process_slots_ = slots_.size();
  valve_slots_end_ = slots_.size();
  for (const Effect* effect : effects_) {
    first_.push_back(slots_.size());
    for (const SearchedParameter& parameter : effect->searched(here)) {
      slots_.push_back({parameter, effect});
    }
    count_.push_back(slots_.size() - first_.back());
    if (effect->description().place <= Place::kProcess) valve_slots_end_ = slots_.size();
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

// The loads of each piece.
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

// A slow stem that has come to its stop leaves it as soon as its signal turns back: it
// follows the signal cut off at the stop. A stuck one reaches its stop later.
void FreeRun::stop_at_limit(std::size_t number, std::span<const double> p,
                            ValveSignal& signal) {
  const auto is_at = [](Place place) {
    return [place](const Effect* effect) { return effect->description().place == place; };
  };
  if (std::ranges::any_of(effects_, is_at(Place::kFriction))) return;
  const auto limit = std::ranges::find_if(effects_, is_at(Place::kLimit));
  if (limit != effects_.end()) (*limit)->move(of(**limit, p, number), signal);
}

void FreeRun::simulate_valve(std::span<const double> p) {
  const auto same = [&](std::size_t from, std::size_t to) {
    return std::equal(p.begin() + static_cast<std::ptrdiff_t>(from),
                      p.begin() + static_cast<std::ptrdiff_t>(to),
                      last_p_.begin() + static_cast<std::ptrdiff_t>(from));
  };
  const bool same_lag =
      integrating_ || !weighed_ || last_p_.empty() || last_p_[1] == p[1];
  if (!last_p_.empty() && same_lag && same(process_slots_, valve_slots_end_) &&
      same(slots_.size() - starts_.size(), slots_.size())) {
    return;
  }
  std::copy(situation_->u.begin(), situation_->u.end(), valve_.begin());
  weighed_ = false;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const auto v =
        std::span(valve_).subspan(pieces_[i].first, pieces_[i].last - pieces_[i].first);
    ValveSignal signal{situation_->period_s, v, 0, integrating_ ? 0 : p[1]};
    for (const Effect* effect : effects_) {
      const Place place = effect->description().place;
      if (place == Place::kRate) stop_at_limit(i, p, signal);
      if (place <= Place::kProcess) effect->move(of(*effect, p, i), signal);
    }
    at_rest_[i] = signal.at_rest;
    weighed_ = weighed_ || signal.weighed;
    settling_s_ = signal.settling_s;
  }
}

// The columns as the record shows them; no coefficient is known yet.
void FreeRun::lay_columns(std::span<const double> p) {
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
}

double FreeRun::run(std::span<const double> p) {
  work_->check();
  if (solved_ && std::equal(p.begin(), p.end(), last_p_.begin(), last_p_.end())) {
    return *solved_;
  }
  Work::spend(residual_.size());
  lay_columns(p);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (const Held* one = held(columns_[i])) coefficients_[i] = one->value;
  }
  solve(false, Rows::kEstimation);
  finish(p);
  solve_behind_rounding(p);
  last_p_.assign(p.begin(), p.end());
  set_aside();
  weigh(residual_, judged_);
  solved_ = finite(residual_) ? sum_of_squares(judged(), blocks_->blocks())
                              : std::numeric_limits<double>::infinity();
  return *solved_;
}

double FreeRun::run_with(std::span<const double> p, std::span<const double> plant,
                         Rows rows) {
  work_->check();
  solved_.reset();
  lay_columns(p);
  for (std::size_t i = 0; i < columns_.size() && i < plant.size(); ++i) {
    if (!columns_[i].initial) coefficients_[i] = plant[i];
  }
  solve(true, rows);
  finish(p);
  last_p_.assign(p.begin(), p.end());
  set_aside();
  weigh(residual_, judged_);
  return sum_of_squares(judged(), blocks_->blocks());
}

}  // namespace workbench
