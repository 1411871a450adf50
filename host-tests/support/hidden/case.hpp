// One case of the hidden-effect benchmark: a recording, and the truth that its judge must
// not see.
//
// The loop is a textbook one (first-order self-regulating process, linear valve, no dead
// time, PI controller, relay or floating controller) with the effects of the key added.
// A draw is kept only if every effect of the key matters, and drawn again otherwise:
//
//   size(A) = misfit(u, y₀ + (y − y_A)) / std(y),
//
// y the noise-free output, y_A the output of the same plant without A under the same u,
// y₀ that of the plant without any effect, and misfit the root mean square error of the
// textbook model refitted to the sum (textbook.hpp). For a single effect this is
// the misfit of the textbook model itself. A matters when size ≥ √3/40: with noise of
// std(y)/40 the textbook model's error is then at least twice the noise. Stick-slip,
// backlash, limits and overflow also need six events in the recording.
//
// Signal-to-noise ratio: standard deviation of y before noise and quantisation, in the
// recorded samples, over that of the white noise added to it. Quiet recordings: half of
// |gain|·swing instead, the deviation that the same loop would have when excited.
//
// Cost: 10 to 100 ms for a case, most of it for draws that are thrown away.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/hidden/effects.hpp"
#include "workbench/recording/recording.hpp"

namespace hidden {

enum class Excitation {
  kSetpointSteps,  ///< PI, at least ten setpoints of random height
  kLimitCycle,     ///< at least eight cycles: PI for a sticking valve, a floating
                   ///< controller where u must take many values, a relay elsewhere.
                   ///< Constant setpoint, but for three effects that one cycle alone
                   ///< hardly shows: integrating, nonlinear gain, backlash
  kQuiet,          ///< PI, constant setpoint, at rest
};
[[nodiscard]] std::string_view name_of(Excitation excitation);

inline constexpr std::size_t kSamples = 1500;

/// Every key gives one case, the same each time.
struct CaseKey {
  std::vector<Effect> effects;  ///< none to two
  Excitation excitation = Excitation::kSetpointSteps;
  double signal_to_noise = 40;
  std::uint64_t seed = 1;
  bool beyond_reach = false;  ///< the effect, a limit, lies where the loop never gets
  std::size_t samples = kSamples;
};
/// "valve.stiction steps 40 seed 7".
[[nodiscard]] std::string describe(const CaseKey& key);

struct EffectTruth {
  Effect effect = Effect::kStiction;
  double size = 0;  ///< see above
  int events = 0;
  std::vector<TrueParameter> parameters;
};

struct Truth {
  std::vector<EffectTruth> effects;
  bool excited = true;  ///< every effect matters; false for quiet and out of reach
  double noise_std = 0;
  double signal_std = 0;  ///< of y before noise and quantisation, recorded samples
  LoopSetup setup;
  Trace trace;
};

struct HiddenCase {
  workbench::Recording recording;  ///< t, u, y, sp and nothing else
  Truth truth;
};

inline constexpr double kSmallestSize = 0.0433;  ///< √3/40

/// Throws std::runtime_error when no draw of the key matters.
[[nodiscard]] HiddenCase make_case(const CaseKey& key);

}  // namespace hidden
