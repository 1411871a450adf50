#include "ident/valve/valve_grid.hpp"

#include <array>

#include "ident/base/elementary.hpp"

namespace ident {
namespace {

/// Shares of the stick band.
template <class Real>
struct Proportion {
  Real deadband;
  Real ascending;
  Real descending;
};

template <class Real>
ValveFriction<Real> in_proportion(const Proportion<Real>& share, Real stick,
                                  SlipMotion motion) {
  return {stick * share.deadband, stick * share.ascending, stick * share.descending,
          motion};
}

}  // namespace

template <class Real>
bool sliding_start(int index, Real swing, ValveForm& form,
                   ValveFriction<Real>& friction) {
  constexpr int kSteps = 22;
  constexpr int kKinds = 8;
  constexpr std::array<Proportion<Real>, kKinds> kProportions{
      {{1, 0, 0},
       {0, 1, 0},
       {0, 0, 1},
       {Real(0.7), Real(0.3), Real(0.3)},
       {Real(0.35), Real(0.65), Real(0.65)},
       {0, 1, 1},
       {Real(0.2), Real(0.8), Real(0.2)},
       {Real(0.2), Real(0.2), Real(0.8)}}};
  constexpr std::array<ValveForm, kKinds> kForms{
      ValveForm::kBacklash,  ValveForm::kAscending, ValveForm::kDescending,
      ValveForm::kSymmetric, ValveForm::kSymmetric, ValveForm::kSymmetric,
      ValveForm::kMixed,     ValveForm::kMixed};
  if (index == 0) {
    form = ValveForm::kLinear;
    friction = {};
    return true;
  }
  --index;
  if (index >= kSteps * kKinds) {
    return false;
  }
  const Real share = static_cast<Real>(index / kKinds + 1) / Real(kSteps);
  const Real stick = swing * Real(1.15) * share * (Real(0.4) + Real(0.6) * share);
  form = kForms[index % kKinds];
  friction = in_proportion(kProportions[index % kKinds], stick, SlipMotion::kSlides);
  return true;
}

template <class Real>
bool remembering_start(int index, SlipMotion motion, Real swing, Real first_u,
                       ValveFriction<Real>& friction, Real& position) {
  constexpr int kSteps = 27;
  constexpr int kKinds = 9;
  constexpr std::array<Proportion<Real>, kKinds> kProportions{
      {{0, 1, 1},
       {Real(0.3), Real(0.7), Real(0.7)},
       {Real(0.65), Real(0.35), Real(0.35)},
       {0, 1, 0},
       {0, 0, 1},
       {Real(0.2), Real(0.8), Real(0.2)},
       {Real(0.2), Real(0.2), Real(0.8)},
       {Real(0.1), Real(0.9), Real(0.5)},
       {Real(0.1), Real(0.5), Real(0.9)}}};
  constexpr std::array<int, kKinds> kRestickStarts{24, 16, 10, 12, 12, 12, 12, 14, 14};
  constexpr int kAllRestickStarts = 126;
  constexpr int kStopStarts = 2;
  const bool resticks = motion == SlipMotion::kResticks;
  const int each = resticks ? kAllRestickStarts : kKinds * kStopStarts;
  if (index >= kSteps * each) {
    return false;
  }
  const Real stick =
      swing * Real(0.1) * elementary::pow(Real(1.1), static_cast<Real>(index / each));
  int kind = 0;
  int start = index % each;
  const auto starts = [&](int k) { return resticks ? kRestickStarts[k] : kStopStarts; };
  while (start >= starts(kind)) {
    start -= starts(kind);
    ++kind;
  }
  friction = in_proportion(kProportions[kind], stick, motion);
  const Real share =
      (static_cast<Real>(start) + Real(0.5)) / static_cast<Real>(starts(kind));
  position = resting_range(friction, first_u).at(share);
  return true;
}

#define STICKBAND_INSTANTIATE(Real)                                               \
  template bool sliding_start<Real>(int, Real, ValveForm&, ValveFriction<Real>&); \
  template bool remembering_start<Real>(int, SlipMotion, Real, Real,              \
                                        ValveFriction<Real>&, Real&);
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)

}  // namespace ident
