#include "workbench/model/base/model.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace workbench {

bool Model::has(std::string_view effect) const {
  return std::ranges::any_of(
      effects, [effect](const EffectTerm& term) { return term.effect == effect; });
}

std::vector<std::string> Model::effect_codes() const {
  std::vector<std::string> codes;
  for (const EffectTerm& term : effects) codes.push_back(term.effect);
  return codes;
}

std::string fingerprint_of(std::initializer_list<std::span<const double>> signals) {
  std::uint64_t hash = 14695981039346656037U;  // FNV-1a
  for (const std::span<const double> signal : signals) {
    for (const double value : signal) {
      const float rounded = static_cast<float>(value) + 0.0F;  // no zero with a sign
      const auto bits = std::bit_cast<std::uint32_t>(rounded);
      for (unsigned shift = 0; shift < 32; shift += 8) {
        hash = (hash ^ ((bits >> shift) & 0xFFU)) * 1099511628211U;
      }
    }
  }
  std::string text(16, '0');
  for (auto digit = text.rbegin(); digit != text.rend(); ++digit, hash >>= 4) {
    *digit = "0123456789abcdef"[hash & 0xFU];
  }
  return text;
}

std::string state_name(std::string_view name, std::size_t piece) {
  std::string out(name);
  if (piece > 0) out += '_' + std::to_string(piece + 1);
  return out;
}

const Parameter* find(const std::vector<Parameter>& parameters, std::string_view name) {
  const auto found = std::ranges::find(parameters, name, &Parameter::name);
  return found == parameters.end() ? nullptr : &*found;
}

}  // namespace workbench
