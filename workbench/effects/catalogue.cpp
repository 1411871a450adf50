#include "workbench/effects/catalogue.hpp"

#include <algorithm>
#include <stdexcept>

#include "workbench/effects/effects.hpp"
#include "workbench/recording/listed.hpp"
#include "workbench/recording/named_signal.hpp"

namespace workbench {

namespace {

// The column of a measured load; "" for every other code.
std::string_view column_of(std::string_view code) {
  return code.starts_with(effects::kMeasuredLoad)
             ? code.substr(effects::kMeasuredLoad.size())
             : std::string_view();
}

}  // namespace

void Catalogue::add(const Effect& effect) {
  if (find(effect.code()) != nullptr) {
    throw std::invalid_argument("the catalogue already has " +
                                std::string(effect.code()));
  }
  effects_.push_back(&effect);
}

const Effect* Catalogue::find(std::string_view code) const {
  for (const Effect* effect : effects_) {
    if (effect->code() == code) return effect;
  }
  const std::string_view column = column_of(code);
  return column.empty() ? nullptr : &effects::disturbance_measured(column);
}

const Effect* Catalogue::find_asked(std::string_view code) const {
  const Effect* const exact = find(code);
  const std::string_view column = column_of(code);
  if (column.empty() || std::ranges::find(effects_, exact) != effects_.end()) {
    return exact;
  }
  std::vector<NamedSignal> loads;
  std::vector<const Effect*> of_load;
  for (const Effect* effect : effects_) {
    const std::string_view known = column_of(effect->code());
    if (known.empty()) continue;
    loads.push_back({.name = column_name(known)});
    of_load.push_back(effect);
  }
  const std::vector<std::size_t> found = best_fitting(column_name(column), loads);
  return found.size() == 1 ? of_load[found.front()] : exact;
}

Catalogue Catalogue::with(const std::vector<Load>& loads) const {
  Catalogue more = *this;
  for (const Load& load : loads) {
    const Effect& effect = effects::disturbance_measured(load.name);
    const bool known = std::ranges::find(more.effects_, &effect) != more.effects_.end();
    if (!known) more.effects_.push_back(&effect);
  }
  return more;
}

Catalogue Catalogue::without(const Effect& effect) const {
  Catalogue rest = *this;
  std::erase(rest.effects_, &effect);
  return rest;
}

std::string Catalogue::codes() const {
  return listed(effects_, ", ", &Effect::code) + ", " +
         std::string(effects::kMeasuredLoad) + "COLUMN";
}

std::string Catalogue::no_effect(std::string_view code) const {
  return "no effect '" + std::string(code) + "'; known effects: " + codes();
}

const Catalogue& standard_catalogue() {
  using namespace effects;
  static const Catalogue catalogue({
      &valve_stiction(),          &valve_backlash(),
      &valve_saturation(),        &valve_characteristic(),
      &valve_positioner_lag(),    &valve_rate_limit(),
      &process_dead_time(),       &process_second_lag(),
      &process_integrating(),     &process_nonlinear_gain(),
      &process_gain_drift(),      &process_overflow(),
      &disturbance_sinusoid(),    &disturbance_step(),
      &disturbance_ramp(),        &sensor_lag(),
      &sensor_quantisation(),     &process_inverse_response(),
      &process_oscillatory(),     &sensor_sticking(),
      &sensor_spikes(),           &record_compression(),
      &process_directional_lag(), &process_slow_tail(),
      &sensor_saturation(),
  });
  return catalogue;
}

}  // namespace workbench
