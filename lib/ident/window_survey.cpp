#include "ident/window_survey.hpp"

#include <algorithm>

namespace ident {
namespace {

// Not in the least sizes, whose flash has no room for it: y within this share of the
// range of u (root of the mean square) is u itself.
constexpr double kCopied = 0.005;

template <class Real>
bool is_copy(std::span<const Real> y, const SignalScale<Real>& of_y,
             std::span<const Real> u, const SignalScale<Real>& of_u) {
  Real apart = 0;
  for (std::size_t t = 0; t < u.size(); ++t) {
    const Real between = (of_y.back(y[t]) - of_u.back(u[t])) / of_u.factor;
    apart += between * between;
  }
  return apart <= Real(kCopied * kCopied) * static_cast<Real>(u.size());
}

}  // namespace

template <class Real>
void WindowSurvey<Real>::start(const SurveyWindow<Real>& window) {
  window_ = window;
  detector_.reset();
  of_u_ = of_y_ = {};
  next_ = 0;
  refusal_ = Reason::kNone;
  stage_ = Stage::kRhythm;
}

template <class Real>
void WindowSurvey<Real>::refuse(Reason reason) {
  refusal_ = reason;
  stage_ = Stage::kDone;
}

template <class Real>
void WindowSurvey<Real>::watch_rhythm(Identification<Real>& result) {
  constexpr std::size_t kAtOnce = 512;
  const std::size_t end = std::min(next_ + kAtOnce, window_.u.size());
  for (; next_ < end; ++next_) {
    detector_.push(window_.u[next_]);
  }
  if (next_ == window_.u.size()) {
    result.oscillation = detector_.report();
    stage_ = Stage::kScale;
    check(result);
  }
}

// With a seam in it, or exchanged, u and y say nothing else either.
template <class Real>
void WindowSurvey<Real>::check(Identification<Real>& result) {
  if constexpr (kChecksRecord<Real>) {
    const std::span<const Real> sp = window_.sp;
    const std::size_t size = window_.u.size();
    result.health =
        check_record(window_.u, window_.y,
                     sp.size() >= size ? sp.first(size) : std::span<const Real>());
    if (result.health.seam_at > 0) {
      refuse(Reason::kSeam);
    } else if (result.health.swapped) {
      refuse(Reason::kSignalsSwapped);
    } else if (result.health.sensor_sticks) {
      result.cause = Cause::kSensor;
      refuse(Reason::kSensorSticks);
    }
  }
}

template <class Real>
void WindowSurvey<Real>::scale() {
  const SignalScale<Real> of_u = scale_of_range<Real>(window_.u);
  const SignalScale<Real> of_y = scale_of_variance<Real>(window_.y);
  if (!of_u.moves || !of_y.moves) {
    refuse(Reason::kConstant);
    return;
  }
  of_u_ = of_u;
  of_y_ = of_y;
  of_u_.apply(window_.u);
  of_y_.apply(window_.y);
  stage_ = Stage::kMovement;
}

template <class Real>
void WindowSurvey<Real>::measure(Identification<Real>& result) {
  if constexpr (kStemSearch) {
    OscillationReport<Real>& seen = result.oscillation;
    seen.detected = seen.detected &&
                    turns_in_cycles<Real>(window_.u, seen, seen.amplitude / of_u_.factor);
  }
  movement_ = measure_movement<Real>(window_.u, result.oscillation, of_u_.factor,
                                     window_.ascending);
  result.evidence.reversals = movement_.reversals;
  if constexpr (kStemSearch) {
    result.evidence.drifts =
        !result.oscillation.detected && movement_.swing < Real(kReversalShare);
  }
  result.cycles = movement_.cycles;
  stage_ = Stage::kController;
}

template <class Real>
void WindowSurvey<Real>::begin_law() {
  // In scaled units, which float32 needs; the law's gains are put back into the user's.
  const std::span<Real> error = window_.scratch.first(window_.y.size());
  for (std::size_t t = 0; t < error.size(); ++t) {
    const Real moved = window_.sp.empty() ? Real(0) : window_.sp[t] - window_.sp[0];
    error[t] = window_.y[t] - moved / of_y_.factor;
  }
  law_.start(window_.u, error, {});
  stage_ = Stage::kLaw;
}

template <class Real>
void WindowSurvey<Real>::recognise_controller(Identification<Real>& result) {
  ControllerAction<Real>& law = result.controller;
  law = law_.action();
  law.proportional *= of_u_.factor / of_y_.factor;
  law.integral *= of_u_.factor / of_y_.factor;
  sign_ = window_.gain_sign != 0 ? window_.gain_sign : law.sign;
  if (sign_ == 0) {
    likelier_.start(window_.u, window_.y, movement_.period, window_.scratch);
    stage_ = Stage::kSign;
  } else {
    stage_ = Stage::kTurn;
  }
}

// The sign of the process gain: as told, or as negative feedback needs it, or else the
// one with which a linear valve explains more.
template <class Real>
void WindowSurvey<Real>::turn(Identification<Real>& result) {
  result.gain_sign = sign_;
  if (sign_ < 0) {
    of_y_.factor = -of_y_.factor;
    for (Real& value : window_.y) {
      value = -value;
    }
  }
  stage_ = Stage::kShapeOfU;
}

template <class Real>
void WindowSurvey<Real>::look_at_u(Identification<Real>& result) {
  const std::span<const Real> u = window_.u;
  LoopEvidence<Real>& loop = result.loop;
  loop.oscillates = result.oscillation.detected;
  loop.regularity = result.oscillation.regularity;
  loop.cycles = result.cycles;
  loop.kurtosis = kurtosis<Real>(u);
  loop.limit_share = share_at_limits<Real>(u);
  loop.law_known = result.controller.sign != 0;
  std::copy(u.begin(), u.end(), window_.scratch.begin());
  levels_.start(window_.scratch.first(u.size()));
  stage_ = Stage::kStepOfU;
}

template <class Real>
void WindowSurvey<Real>::take_u_step(Identification<Real>& result) {
  result.loop.u_step = levels_.value() / movement_.swing;
  result.evidence.by_hand = moves_rarely<Real>(window_.u);
  if constexpr (kStemSearch) {
    if (!(levels_.value() > Real(0))) {
      result.loop.limit_share =
          std::max(result.loop.limit_share,
                   share_of_touches<Real>(window_.u, static_cast<Real>(result.cycles)));
    }
  }
  std::copy(window_.y.begin(), window_.y.end(), window_.scratch.begin());
  levels_.start(window_.scratch.first(window_.y.size()));
  stage_ = Stage::kStepOfY;
}

template <class Real>
void WindowSurvey<Real>::take_y_step(Identification<Real>& result) {
  result.loop.y_step = levels_.value() / kSwingOfUnit<Real>;
  if (movement_.reversals < 1) {
    refuse(Reason::kOneStroke);
  } else if (!kLeastSizes && is_copy<Real>(window_.y, of_y_, window_.u, of_u_)) {
    refuse(Reason::kSignalsSwapped);
  }
  stage_ = Stage::kDone;
}

template <class Real>
bool WindowSurvey<Real>::step(Identification<Real>& result) {
  switch (stage_) {
    case Stage::kRhythm:
      watch_rhythm(result);
      break;
    case Stage::kScale:
      scale();
      break;
    case Stage::kMovement:
      measure(result);
      break;
    case Stage::kController:
      begin_law();
      break;
    case Stage::kLaw:
      if (law_.step()) {
        recognise_controller(result);
      }
      break;
    case Stage::kSign:
      if (likelier_.step()) {
        sign_ = likelier_.sign();
        stage_ = Stage::kTurn;
      }
      break;
    case Stage::kTurn:
      turn(result);
      break;
    case Stage::kShapeOfU:
      look_at_u(result);
      break;
    case Stage::kStepOfU:
      if (levels_.step()) {
        take_u_step(result);
      }
      break;
    case Stage::kStepOfY:
      if (levels_.step()) {
        take_y_step(result);
      }
      break;
    case Stage::kDone:
      break;
  }
  return stage_ == Stage::kDone;
}

template class WindowSurvey<float>;
template class WindowSurvey<double>;

}  // namespace ident
