// Evidence made by hand, and what the judge makes of it.
#pragma once

#include <gtest/gtest.h>

#include "ident/verdict/judge.hpp"

namespace test {

using ident::Evidence;
using ident::LoopEvidence;
using ident::Reason;
using ident::ValveForm;

using Change = void (*)(Evidence<double>&);

/// A plain case of stiction in a window too short to be predicted one sample ahead: good
/// fit, large gain, wide band, clear slip, every cycle better.
inline Evidence<double> sticking() {
  Evidence<double> e;
  e.form = ValveForm::kSymmetric;
  e.error_ratio = 2;
  e.jump_ratio = 1.5;
  e.observations = 100;
  e.score = 30;
  e.cycles = 10;
  e.cycles_better = 9;
  e.consistency = 4;
  e.band_over_swing = 0.5;
  e.slip_over_band = 0.5;
  e.fit_percent = 90;
  e.fit_linear_percent = 81;
  e.time_constant = 1;
  e.reversals = 20;
  return e;
}

/// Fine signals, away from limits, the setpoint at rest.
template <class Real>
[[nodiscard]] Reason judge(const Evidence<Real>& e, bool oscillates) {
  LoopEvidence<Real> loop;
  loop.oscillates = oscillates;
  return ident::judge(e, loop);
}

inline void expect(Reason found, Reason wanted) {
  EXPECT_EQ(sentence(found), sentence(wanted));
}

}  // namespace test
