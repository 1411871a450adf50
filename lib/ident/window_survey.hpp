// What u and y say of the loop before anything is fitted, and the scale in which
// everything is fitted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "ident/process/process_sign.hpp"
#include "ident/signal/controller_action.hpp"
#include "ident/signal/movement.hpp"
#include "ident/signal/oscillation_detector.hpp"
#include "ident/signal/record_check.hpp"
#include "ident/signal/signal_scale.hpp"
#include "ident/signal/signal_shape.hpp"
#include "ident/verdict/identification.hpp"

namespace ident {

/// The memory of one window; all spans have one length ≥ 1 and belong to the survey until
/// it is done, u and y for good.
template <class Real>
struct SurveyWindow {
  std::span<Real> u;                   ///< finite
  std::span<Real> y;                   ///< finite
  std::span<const Real> sp;            ///< empty: unknown; may be longer
  std::span<unsigned char> ascending;  ///< gets the direction of every sample of u
  std::span<Real> scratch;
  int gain_sign = 0;  ///< ±1 where the sign of the process gain is known
};

/// Watches the rhythm of u, asks whether u and y can be what the controller saw, scales u
/// to 0 … 1 and y to zero mean and unit variance where they are, recognises the
/// controller's law, turns y where the process gain is negative, and looks at the shape
/// of both.
///
/// Life: new → start → step until done. It writes the oscillation, cycles, reversals,
/// controller, gain sign, health and what is known of the loop's cause into the result.
/// Cost: some 31 passes, eight more where a seam is likely; twelve of
/// ProcessRegression::screen where the controller does not tell the sign.
template <class Real>
class WindowSurvey {
 public:
  void start(const SurveyWindow<Real>& window);
  /// Some passes at most; true when done.
  bool step(Identification<Real>& result);

  /// Why nothing can be fitted: kConstant, kOneStroke, kSignalsSwapped where y is u, or
  /// what the check found: kSeam, kSignalsSwapped, kSensorSticks; kNone: it can. When
  /// done.
  [[nodiscard]] Reason refusal() const { return refusal_; }
  /// From u and y as they stand to those that came: identity until they are scaled. The
  /// factor of y has the sign of the process gain.
  [[nodiscard]] const SignalScale<Real>& of_u() const { return of_u_; }
  [[nodiscard]] const SignalScale<Real>& of_y() const { return of_y_; }
  /// Of the scaled u. When done.
  [[nodiscard]] const Movement<Real>& movement() const { return movement_; }

 private:
  enum class Stage : std::uint8_t {
    kRhythm,
    kScale,
    kMovement,
    kController,
    kLaw,
    kSign,
    kTurn,
    kShapeOfU,
    kStepOfU,
    kStepOfY,
    kDone
  };

  void watch_rhythm(Identification<Real>& result);
  void check(Identification<Real>& result);
  void scale();
  void measure(Identification<Real>& result);
  void begin_law();
  void recognise_controller(Identification<Real>& result);
  void turn(Identification<Real>& result);
  void look_at_u(Identification<Real>& result);
  void take_u_step(Identification<Real>& result);
  void take_y_step(Identification<Real>& result);
  void refuse(Reason reason);

  SurveyWindow<Real> window_;
  OscillationDetector<Real> detector_;
  ControllerRecognition<Real> law_;
  LikelierSign<Real> likelier_;
  LevelStep<Real> levels_;
  Movement<Real> movement_;
  SignalScale<Real> of_u_;
  SignalScale<Real> of_y_;
  std::size_t next_ = 0;  // sample for the detector
  int sign_ = 0;          // of the process gain
  Reason refusal_ = Reason::kNone;
  Stage stage_ = Stage::kDone;
};

/// Of a sinusoid of unit variance, from peak to peak.
template <class Real>
inline constexpr Real kSwingOfUnit = Real(2.8);

}  // namespace ident
