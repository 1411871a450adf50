#include "hidden/case_list.hpp"

#include <cstdlib>
#include <sstream>

namespace hidden {
namespace {

constexpr std::array<Excitation, 2> kMoving{Excitation::kSetpointSteps,
                                            Excitation::kLimitCycle};

using Pair = std::array<Effect, 2>;
constexpr Pair kPairs[] = {
    {Effect::kStiction, Effect::kDeadTime},  {Effect::kStiction, Effect::kSinusoid},
    {Effect::kStiction, Effect::kRamp},      {Effect::kBacklash, Effect::kDeadTime},
    {Effect::kBacklash, Effect::kStep},      {Effect::kSaturation, Effect::kDeadTime},
    {Effect::kSaturation, Effect::kRamp},    {Effect::kCharacteristic, Effect::kDeadTime},
    {Effect::kRateLimit, Effect::kDeadTime}, {Effect::kRateLimit, Effect::kStep},
    {Effect::kDeadTime, Effect::kSecondLag}, {Effect::kDeadTime, Effect::kIntegrating},
    {Effect::kDeadTime, Effect::kGainDrift}, {Effect::kNonlinearGain, Effect::kStep},
    {Effect::kSecondLag, Effect::kSinusoid}, {Effect::kDeadTime, Effect::kOverflow},
    {Effect::kSinusoid, Effect::kStep},      {Effect::kRamp, Effect::kQuantisation},
    {Effect::kSensorLag, Effect::kStep},
};

std::uint64_t seed_of(const Seeds& seeds, int i) {
  return seeds.first + static_cast<std::uint64_t>(i);
}

}  // namespace

std::vector<CaseKey> one_effect(const Seeds& seeds) {
  std::vector<CaseKey> keys;
  for (const Effect effect : all_effects()) {
    for (const Excitation excitation : kMoving) {
      for (const double ratio : kRatios) {
        for (int i = 0; i < seeds.count; ++i) {
          keys.push_back({{effect}, excitation, ratio, seed_of(seeds, i)});
        }
      }
    }
  }
  return keys;
}

std::vector<CaseKey> two_effects(const Seeds& seeds) {
  std::vector<CaseKey> keys;
  std::size_t turn = 0;
  for (const Pair& pair : kPairs) {
    for (int i = 0; i < seeds.count; ++i) {
      const Excitation excitation = kMoving[turn++ % kMoving.size()];
      for (const double ratio : kRatios) {
        keys.push_back({{pair[0], pair[1]}, excitation, ratio, seed_of(seeds, i)});
      }
    }
  }
  return keys;
}

std::vector<CaseKey> clean(const Seeds& seeds, int count) {
  constexpr std::array<Excitation, 5> kTurns{
      Excitation::kSetpointSteps, Excitation::kLimitCycle, Excitation::kSetpointSteps,
      Excitation::kLimitCycle, Excitation::kQuiet};
  std::vector<CaseKey> keys;
  for (int i = 0; i < count; ++i) {
    const auto turn = static_cast<std::size_t>(i);
    keys.push_back({{},
                    kTurns[turn % kTurns.size()],
                    kRatios[turn / kTurns.size() % kRatios.size()],
                    seed_of(seeds, i)});
  }
  return keys;
}

std::vector<CaseKey> not_excited(const Seeds& seeds) {
  std::vector<CaseKey> keys;
  for (const Effect effect : all_effects()) {
    const bool shows_itself = effect == Effect::kSinusoid || effect == Effect::kStep ||
                              effect == Effect::kRamp || is_recorded(effect);
    for (const double ratio : kRatios) {
      for (int i = 0; i < seeds.count; ++i) {
        if (!shows_itself) {
          keys.push_back({{effect}, Excitation::kQuiet, ratio, seed_of(seeds, i)});
        }
        if (is_limit(effect) && !is_recorded(effect)) {
          keys.push_back(
              {{effect}, Excitation::kSetpointSteps, ratio, seed_of(seeds, i), true});
        }
      }
    }
  }
  return keys;
}

std::optional<CaseKey> parse_key(const std::string& effects,
                                 const std::string& excitation, const std::string& ratio,
                                 const std::string& seed) {
  CaseKey key;
  std::istringstream codes(effects == "clean" ? "" : effects);
  for (std::string code; std::getline(codes, code, '+');) {
    const std::size_t before = key.effects.size();
    for (const Effect effect : all_effects()) {
      if (code_of(effect) == code) {
        key.effects.push_back(effect);
      }
    }
    if (key.effects.size() == before) {
      return std::nullopt;
    }
  }
  bool known = false;
  for (const Excitation one :
       {Excitation::kSetpointSteps, Excitation::kLimitCycle, Excitation::kQuiet}) {
    if (name_of(one) == excitation) {
      key.excitation = one;
      known = true;
    }
  }
  key.beyond_reach = excitation == "beyond";  // of setpoint steps
  key.signal_to_noise = std::strtod(ratio.c_str(), nullptr);
  key.seed = std::strtoull(seed.c_str(), nullptr, 10);
  if ((!known && !key.beyond_reach) || key.signal_to_noise <= 0) {
    return std::nullopt;
  }
  return key;
}

}  // namespace hidden
