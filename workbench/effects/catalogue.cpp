#include "workbench/effects/catalogue.hpp"

#include <algorithm>
#include <stdexcept>

#include "workbench/effects/effects.hpp"
#include "workbench/recording/column_name.hpp"

namespace workbench {

namespace {

// The column of a measured load; "" for every other code.
std::string_view column_of(std::string_view code) {
  return code.starts_with(effects::kMeasuredLoad)
             ? code.substr(effects::kMeasuredLoad.size())
             : std::string_view();
}

// Without case and unit; some of the pieces of a name are enough.
bool fits(const ColumnName& asked, const ColumnName& name) {
  return asked.key == name.key ||
         (!asked.pieces.empty() &&
          std::ranges::all_of(asked.pieces, [&name](const std::string& piece) {
            return std::ranges::find(name.pieces, piece) != name.pieces.end();
          }));
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
  const ColumnName asked = column_name(column);
  const Effect* fitting = nullptr;
  for (const Effect* effect : effects_) {
    const std::string_view known = column_of(effect->code());
    if (known.empty() || !fits(asked, column_name(known))) continue;
    if (fitting != nullptr) return exact;
    fitting = effect;
  }
  return fitting != nullptr ? fitting : exact;
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
  return text + ", " + std::string(effects::kMeasuredLoad) + "COLUMN";
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
  });
  return catalogue;
}

}  // namespace workbench
