// Laws of the oscillation detector: what a change of the signal may change in
// the report, on the simulated signals of the scorer.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "ident/signal/oscillation_detector.hpp"
#include "score/oscillation_signals.hpp"

namespace {

using oscillation_signals::Random;
using oscillation_signals::Signal;

/// A signal of any kind, on a grid of 1/1024 so that whole shifts are exact.
std::vector<double> arbitrary_signal(std::uint64_t seed) {
  std::vector<double> values =
      oscillation_signals::simulated_set(8, seed)[seed % 8].values;
  for (double& v : values) v = std::round(v * 1024.0) / 1024.0;
  return values;
}

template <class Real>
ident::OscillationReport<Real> seen(const std::vector<double>& values, double scale = 1.0,
                                    double shift = 0.0) {
  ident::OscillationDetector<Real> detector;
  for (double v : values) detector.push(static_cast<Real>(scale * v + shift));
  return detector.report();
}

/// Equal but for the amplitude, exactly.
template <class Real>
void same(const ident::OscillationReport<Real>& a,
          const ident::OscillationReport<Real>& b) {
  RC_ASSERT(a.detected == b.detected);
  RC_ASSERT(a.oscillating == b.oscillating);
  RC_ASSERT(a.regularity == b.regularity);
  RC_ASSERT(a.period_samples == b.period_samples);
  RC_ASSERT(a.cycles == b.cycles);
}

/// Equal within a rounding, amplitudes in units of their own signal. Swings as small as
/// rounding come and go with it, and within a rounding of the limit either answer is
/// right.
template <class RealA, class RealB>
bool same_within_rounding(const ident::OscillationReport<RealA>& a, double unit_a,
                          const ident::OscillationReport<RealB>& b, double unit_b) {
  const auto within = [](double share, double x, double y) {
    return std::fabs(x - y) <= share * std::fabs(x);
  };
  const double r = static_cast<double>(a.regularity);
  if (r > 0.7 && !within(0.03, r, static_cast<double>(b.regularity))) return false;
  if (std::fabs(r - 1.0) > 0.05 && a.detected != b.detected) return false;
  return !a.detected || !b.detected ||
         (within(0.01, static_cast<double>(a.period_samples),
                 static_cast<double>(b.period_samples)) &&
          within(0.05, static_cast<double>(a.amplitude) / unit_a,
                 static_cast<double>(b.amplitude) / unit_b));
}

/// Where two bands swing alike to a rounding, either may speak for the signal, and each
/// has measured its own period: then the report is that of a signal a hair larger or
/// smaller.
template <class Real>
bool same_as_a_near_scale(const ident::OscillationReport<Real>& a, double unit,
                          const std::vector<double>& values) {
  for (double near : {1.0, 0.9995, 1.0005, 0.999, 1.001, 0.998, 1.002}) {
    if (same_within_rounding(a, unit, seen<double>(values, near), near)) return true;
  }
  return false;
}

RC_GTEST_PROP(OscillationLaw, AMirrorImageIsTheSame, ()) {
  const auto values = arbitrary_signal(*rc::gen::inRange<std::uint64_t>(0, 100000));
  const auto plain = seen<float>(values);
  const auto mirrored = seen<float>(values, -1.0);
  same(plain, mirrored);
  RC_ASSERT(plain.amplitude == mirrored.amplitude);
}

RC_GTEST_PROP(OscillationLaw, AWholeShiftChangesNothing, ()) {
  const auto values = arbitrary_signal(*rc::gen::inRange<std::uint64_t>(0, 100000));
  const auto plain = seen<double>(values);
  const auto shifted = seen<double>(values, 1.0, *rc::gen::inRange(-100000, 100000));
  same(plain, shifted);
  RC_ASSERT(plain.amplitude == shifted.amplitude);
}

RC_GTEST_PROP(OscillationLaw, AScaleChangesOnlyTheAmplitude, ()) {
  const auto values = arbitrary_signal(*rc::gen::inRange<std::uint64_t>(0, 100000));
  const double scale = 0.001 * *rc::gen::inRange(1, 10000000);
  RC_ASSERT(same_as_a_near_scale(seen<double>(values, scale, 12.34), scale, values));
}

RC_GTEST_PROP(OscillationLaw, FloatAndDoubleAgree, ()) {
  const auto values = arbitrary_signal(*rc::gen::inRange<std::uint64_t>(0, 100000));
  RC_ASSERT(same_as_a_near_scale(seen<float>(values), 1.0, values));
}

RC_GTEST_PROP(OscillationLaw, TheReportIsAlwaysInRange, ()) {
  const auto values =
      *rc::gen::container<std::vector<double>>(rc::gen::arbitrary<double>());
  const auto r = seen<float>(values);
  RC_ASSERT(std::isfinite(r.period_samples) && r.period_samples >= 0.0f);
  RC_ASSERT(std::isfinite(r.amplitude) && r.amplitude >= 0.0f);
  RC_ASSERT(r.regularity >= 0.0f && r.regularity <= 216.0f);
  RC_ASSERT(r.detected == (r.regularity > 1.0f));
}

}  // namespace
