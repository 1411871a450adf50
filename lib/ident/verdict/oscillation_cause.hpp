// Why a loop moves whose valve is fine.
//
// In closed loop y and u are bound by u = −C·y. A load of a single period is therefore
// explained as well by a process with the response −1/C there as by the true one, and
// that process puts the loop at the edge of stability, or beyond it where u rests at its
// limits. So a margin alone proves nothing. Only where the model also holds beside that
// period, at the harmonics that the limits make, is the process known and the loop seen
// to be unstable. A resonance that noise keeps ringing, just inside the edge, is left
// open.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "ident/process/process_regression.hpp"
#include "ident/verdict/verdict.hpp"

namespace ident {

/// What makes u and y move.
enum class Cause : std::uint8_t {
  kUnknown,           ///< left open
  kValve,             ///< stiction or backlash
  kExternalPeriodic,  ///< a periodic load or another loop
  kTightTuning,       ///< the controller's gain is beyond what the process bears
  kSetpoint,          ///< the setpoint moves them
  kSensor,            ///< the sensor of y sticks
};
inline constexpr int kCauses = 6;

/// "valve", "external_periodic", "tight_tuning", "setpoint", "sensor"; empty
/// for kUnknown.
[[nodiscard]] std::string_view name(Cause cause);

/// The cause as one sentence for a technician; empty for kUnknown, kValve and kSensor,
/// of which the reason of the verdict tells.
[[nodiscard]] std::string_view sentence(Cause cause);

/// A PI law around a linear process, per sample, in any units.
template <class Real>
struct LinearLoop {
  Real proportional = 0;  ///< Δu for Δe; negative feedback has it positive
  Real integral = 0;      ///< Δu per sample for e
  ProcessPoles<Real> poles;
  ProcessFit<Real> fit;  ///< only gains and delay are used
  int delay = 0;         ///< samples, on top of the fit's own
  int samples = 0;       ///< of the window that the process was fitted to
};

/// Where the open loop turns by half a circle.
template <class Real>
struct Crossover {
  bool known = false;  ///< it does so within the periods that were looked at
  Real period = 0;     ///< samples
  Real gain = 0;       ///< of the open loop there; above 1: the closed loop is unstable
};

/// The crossover between half and twice `period`. Constant time, 100 frequencies.
template <class Real>
[[nodiscard]] Crossover<Real> crossover(const LinearLoop<Real>& loop, Real period);

/// How much of what the simulation does beside the oscillation y does as well: 1 if the
/// model holds there, 0 if not; the lower end of a 95 % interval. `period` in samples.
/// One pass.
template <class Real>
[[nodiscard]] Real gain_beside(std::span<const Real> y, std::span<const Real> simulated,
                               Real period);

/// Share of the movement of u, at most 1, that the loop makes of the setpoint alone,
/// simulated from rest; below 0 where it does worse than nothing. The first tenth of the
/// window is not counted. `scratch`: as long as u. One pass.
template <class Real>
[[nodiscard]] Real setpoint_share(const LinearLoop<Real>& loop, std::span<const Real> u,
                                  std::span<const Real> sp, std::span<Real> scratch);

/// What a cause is concluded from, all free of units.
template <class Real>
struct LoopEvidence {
  bool oscillates = false;
  Real regularity = 0;          ///< of u, see oscillation_detector.hpp
  Real cycles = 0;              ///< of u in the window
  Real kurtosis = 0;            ///< of u
  Real limit_share = 0;         ///< share of the time that u rests at a limit
  bool law_known = false;       ///< the controller's law was recognised
  Real crossover_gain = 0;      ///< of the open loop; 0 unknown
  Real crossover_period = 0;    ///< over the period of the oscillation
  Real gain_beside = 0;         ///< of the linear valve's simulation, see above
  Real setpoint_share = 0;      ///< of the movement of u; 0 where the setpoint rests
  Real fit_linear_percent = 0;  ///< of a linear valve
  Real u_step = 0;              ///< resolution of u over its usual swing; 0: not seen
  Real y_step = 0;              ///< resolution of y over its usual swing; 0: not seen
};

/// Whether the setpoint makes most of the movement of u.
template <class Real>
[[nodiscard]] bool setpoint_moves(const LoopEvidence<Real>& evidence);

/// Names the cause only where it is nearly certain. Thresholds are set on simulated loops
/// (host-tests/score/score_verdict.cpp prints the names against the truth).
template <class Real>
[[nodiscard]] Cause cause_of(const LoopEvidence<Real>& evidence, Verdict verdict);

}  // namespace ident
