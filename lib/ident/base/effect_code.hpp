// The physical effects that a valve loop may show, and their codes: the one table.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace ident {

/// In the order in which diagnostic answers number them; kNone is 0.
enum class EffectCode : std::uint8_t {
  kNone,
  kValveStiction,
  kValveBacklash,
  kValveSaturation,
  kValveCharacteristic,
  kValvePositionerLag,
  kValveRateLimit,
  kProcessDeadTime,
  kProcessSecondLag,
  kProcessIntegrating,
  kProcessNonlinearGain,
  kProcessGainDrift,
  kProcessOverflow,
  kDisturbanceSinusoid,
  kDisturbanceStep,
  kDisturbanceRamp,
  kSensorLag,
  kSensorQuantisation,
  kProcessInverseResponse,
  kProcessOscillatory,
  kSensorSticking,
  kSensorSpikes,
  kRecordCompression,
  kProcessDirectionalLag,
  kProcessSlowTail,
  kSensorSaturation,
};
inline constexpr int kEffectCodes = 26;  ///< kNone among them

inline constexpr std::array<std::string_view, kEffectCodes> kEffectNames = {
    "",
    "valve.stiction",
    "valve.backlash",
    "valve.saturation",
    "valve.characteristic",
    "valve.positioner_lag",
    "valve.rate_limit",
    "process.dead_time",
    "process.second_lag",
    "process.integrating",
    "process.nonlinear_gain",
    "process.gain_drift",
    "process.overflow",
    "disturbance.sinusoid",
    "disturbance.step",
    "disturbance.ramp",
    "sensor.lag",
    "sensor.quantisation",
    "process.inverse_response",
    "process.oscillatory",
    "sensor.sticking",
    "sensor.spikes",
    "record.compression",
    "process.directional_lag",
    "process.slow_tail",
    "sensor.saturation",
};

/// E.g. "valve.stiction"; empty for kNone.
[[nodiscard]] constexpr std::string_view name(EffectCode effect) {
  return kEffectNames[static_cast<std::size_t>(effect)];
}

}  // namespace ident
