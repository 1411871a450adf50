#include "workbench/effects/catalogue.hpp"

#include <algorithm>
#include <stdexcept>

#include "workbench/effects/effects.hpp"

namespace workbench {

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
  if (code.size() > effects::kMeasuredLoad.size() &&
      code.starts_with(effects::kMeasuredLoad)) {
    return &effects::disturbance_measured(code.substr(effects::kMeasuredLoad.size()));
  }
  return nullptr;
}

Catalogue Catalogue::with(const std::vector<Load>& loads) const {
  Catalogue more = *this;
  for (const Load& load : loads) {
    const Effect& effect = effects::disturbance_measured(load.name);
    const bool known = std::find(more.effects_.begin(), more.effects_.end(), &effect) !=
                       more.effects_.end();
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
  std::string text;
  for (const Effect* effect : effects_) {
    text += (text.empty() ? "" : ", ") + std::string(effect->code());
  }
  return text;
}

const Catalogue& standard_catalogue() {
  using namespace effects;
  static const Catalogue catalogue({
      &valve_stiction(),       &valve_backlash(),
      &valve_saturation(),     &valve_characteristic(),
      &valve_positioner_lag(), &valve_rate_limit(),
      &process_dead_time(),    &process_second_lag(),
      &process_integrating(),  &process_nonlinear_gain(),
      &process_gain_drift(),   &process_overflow(),
      &disturbance_sinusoid(), &disturbance_step(),
      &disturbance_ramp(),     &sensor_lag(),
      &sensor_quantisation(),  &process_inverse_response(),
      &process_oscillatory(),  &sensor_sticking(),
      &sensor_spikes(),        &record_compression(),
  });
  return catalogue;
}

}  // namespace workbench
