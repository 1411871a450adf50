// The effects that the hidden-effect benchmark hides: how large they are, how to take one
// out again, and what their true parameters are called.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "support/hidden/loop.hpp"
#include "support/hidden/random.hpp"

namespace hidden {

/// In the order of the contract's table.
enum class Effect {
  kStiction,
  kBacklash,
  kSaturation,
  kCharacteristic,
  kPositionerLag,
  kRateLimit,
  kDeadTime,
  kSecondLag,
  kIntegrating,
  kNonlinearGain,
  kGainDrift,
  kOverflow,
  kSinusoid,
  kStep,
  kRamp,
  kSensorLag,
  kQuantisation,
  kInverseResponse,
  kOscillatory,
  kSticking,
  kSpikes,
  kCompression,
  kDirectionalLag,
  kSlowTail,
  kReadingEnd,
};
inline constexpr int kEffects = 25;

/// Code of the contract: "valve.stiction".
[[nodiscard]] std::string_view code_of(Effect effect);
[[nodiscard]] std::array<Effect, kEffects> all_effects();

/// Sizes that the effects are drawn relative to.
struct Scale {
  double swing_u = 0;   ///< half the width that the loop's u is meant to move over
  double swing_y = 0;   ///< |gain|·swing_u
  double lag_s = 0;     ///< first lag of the process
  bool narrow = false;  ///< loads stay within the reach of a relay of this swing
};

/// Effects that are a limit on a signal are drawn after the rest of the loop is known,
/// from the range that the signal would have without them.
[[nodiscard]] bool is_limit(Effect effect);

/// Effects of what is recorded: seen in the recorded y, not in what the sensor would say.
[[nodiscard]] bool is_recorded(Effect effect);

/// Draws one effect into the loop. Limits: `trace` is the noise-free loop without the
/// effect; `reached` false puts the limit where the loop never gets.
void draw_effect(Effect effect, const Scale& scale, Random& random, LoopSetup& setup);
void draw_limit(Effect effect, const Trace& trace, bool reached, Random& random,
                LoopSetup& setup);

/// The loop without the effect.
[[nodiscard]] LoopSetup without(const LoopSetup& setup, Effect effect);

/// Stick-slip, backlash, limits and overflow must act at least this often.
inline constexpr int kFewestEvents = 6;

/// How often the recorded samples exercise an effect that needs events; the number of
/// samples for the others.
[[nodiscard]] int events_of(Effect effect, const LoopSetup& setup, const Trace& trace);

struct TrueParameter {
  std::string name;
  double value = 0;  ///< u, y, s as the name says
};

/// Only those whose meaning does not depend on how the effect is modelled.
[[nodiscard]] std::vector<TrueParameter> true_parameters(Effect effect,
                                                         const LoopSetup& setup);

}  // namespace hidden
