#include "ident/signal/oscillation_detector.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numbers>

#include "ident/base/elementary.hpp"

namespace ident {
namespace {

// Band-pass: state-variable filter, trapezoidal integrators, quality 0.7,
// centre tan(pi/P) = 0.62, that is P = 5.66 samples, the middle of 4 … 8.
// V. Zavalishin, The Art of VA Filter Design (2012), section 4.
constexpr float kCentre = 0.62f;
constexpr float kQuality = 0.7f;
constexpr float kGain1 = 1.0f / (1.0f + kCentre * (kCentre + 1.0f / kQuality));
constexpr float kGain2 = kCentre * kGain1;
constexpr float kGain3 = kCentre * kGain2;

constexpr float kLargest = 1e15f;
constexpr float kSmallest = 1e-15f;
constexpr int kLogUnit = 512;
constexpr float kLn2 = 0.69314718f;
constexpr float kNepersPerUnit = kLn2 / static_cast<float>(kLogUnit);
constexpr float kLengthUnit = 2048.0f;
constexpr float kShareUnit = 65535.0f;
constexpr float kFractionUnit = 256.0f;

// A band that has not crossed zero for this many of its samples is silent.
constexpr int kSilence = 24;
constexpr int kSilentCycles = 4;
// Swings this small beside the distance from the first sample are rounding.
constexpr float kRounding = 4e-6f;
constexpr float kSizeWeight = 0.5f;

constexpr int kRecord = 255;
constexpr int kRecent = 12;
constexpr int kSmooth = 32;
// Hysteresis of the present state, and how much of it must have been seen.
constexpr float kStart = 0.35f;
constexpr float kEnd = 0.5f;
constexpr int kStartAfter = 4;

// The first band that shares its turn with the slower ones.
constexpr int kFirstSlow = 3;

/// std::lround, |value| < 2³⁰, without the call that it is on a Cortex-M4F.
int nearest(float value) {
  return static_cast<int>(value + std::copysign(0.5f, value));
}

/// A binary logarithm, taken apart so that a signal scaled by a power of two shifts it by
/// whole numbers.
struct BinaryLog {
  int whole;
  float rest;  ///< −½ … ½
};

/// Of a normal number > 0, to 2·10⁻⁶: the exponent, and for a mantissa of √½ … √2 the
/// series of the inverse hyperbolic tangent. Far fewer instructions than std::log2 takes
/// on a Cortex-M4F.
BinaryLog log2_of(float value) {
  constexpr std::uint32_t kRootHalf = 0x3f3504f3;
  constexpr float kTwoOverLn2 = 2.8853901f;
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(value);
  const int exponent = static_cast<int>(bits - kRootHalf) >> 23;
  const float mantissa =
      std::bit_cast<float>(bits - (static_cast<std::uint32_t>(exponent) << 23));
  const float s = (mantissa - 1.0f) / (mantissa + 1.0f);
  const float square = s * s;
  const float series = 1.0f + square * (1.0f / 3.0f + square * (1.0f / 5.0f));
  return {exponent, kTwoOverLn2 * s * series};
}

/// Moves `mean` towards `value` by weight/n of the way, at least one unit: a mean kept in
/// whole units would otherwise stop short. In whole numbers: a third of the instructions.
template <class Int>
void approach(Int& mean, int value, int weight, int n) {
  const int distance = value - mean;
  const int half = distance < 0 ? -n : n;
  int step = (2 * weight * distance + half) / (2 * n);
  if (step == 0) step = distance > 0 ? 1 : distance < 0 ? -1 : 0;
  mean = static_cast<Int>(mean + step);
}

/// Half the binary logarithm, that of the root of a mean square, in units of 1/512.
std::int16_t root_log(float mean_square) {
  constexpr int kHalfUnit = kLogUnit / 2;
  const BinaryLog log = log2_of(mean_square);
  const int units =
      nearest(static_cast<float>(kHalfUnit) * log.rest) + kHalfUnit * log.whole;
  return static_cast<std::int16_t>(std::clamp(units, -32767, 32767));
}

/// Mean of (1) over n pairs and an imaginary one at 1/2: few cycles prove little.
float cautious(std::uint16_t mean, int pairs) {
  const float n = static_cast<float>(pairs);
  return (static_cast<float>(mean) / kShareUnit * n + 0.5f) / (n + 1.0f);
}

/// How much larger a sinusoid of `length` samples per cycle comes out of the
/// band-pass's first integrator, in a band reached by `band` halvings.
float gain(float length, int band) {
  const float angle =
      std::numbers::pi_v<float> / std::max(length, 2.5f);  // steep towards 2
  const float ratio = elementary::tan(angle) / kCentre;
  const float detune = kQuality * (ratio - 1.0f / ratio);
  float g = kQuality / std::sqrt(1.0f + detune * detune) / elementary::cos(angle);
  float slower = angle;
  for (int i = 0; i < band; ++i) {
    slower *= 0.5f;
    const float c = elementary::cos(slower);
    g *= c * c;
  }
  return g;
}

}  // namespace

template <class Real>
bool OscillationDetector<Real>::push(Real value) {
  if (!std::isfinite(value)) return false;
  if (!started_) {
    first_ = value;
    started_ = true;
  }
  constexpr Real kCut = static_cast<Real>(kLargest);
  float x = static_cast<float>(std::clamp<Real>(value - first_, -kCut, kCut));
  if (orientation_ == 0 && x != 0.0f) orientation_ = x > 0.0f ? 1 : -1;
  if (orientation_ < 0) x = -x;

  // Bands 0 and 1 take their samples at once. Of the next three samples the first finds
  // time for band 2 and the third for one of the slower ones, which comes every 2, 4, 8,
  // 16 blocks of four samples: band 3 in blocks 0 2 4 …, 4 in 1 5 9 …, 5 in 3 11 19 …, 6
  // in 7 23 39 …
  const unsigned phase = ++phase_;
  const unsigned turn = phase % 4U;
  bool changed = false;
  if (turn == 1) {
    changed = take_waiting(2, phase - 1);
  } else if (turn == 3) {
    const unsigned block = phase / 4U;
    const int after = std::countr_one(block);
    if (kFirstSlow + after < kBands) {
      changed = take_waiting(kFirstSlow + after, 4U * (block - (1U << after) + 1U));
    }
  }
  if (take(0, phase, x, changed) && take(1, phase, x, changed)) {
    leave(2, x);
  }
  return changed;
}

// Bands 2 and 3 never have a sample waiting at the same time, nor have 4 and 5.
constexpr int waiting_slot(int band) {
  return band / 2 - 1;
}

template <class Real>
float& OscillationDetector<Real>::waiting(int slot) {
  return slot < 2 ? waiting_[static_cast<std::size_t>(slot)] : halved_[kBands - 1];
}

template <class Real>
void OscillationDetector<Real>::leave(int band, float x) {
  const int slot = waiting_slot(band);
  waiting(slot) = x;
  waiting_slots_ = (waiting_slots_ | 1U << slot) & 7U;
}

// The sample that waits for a band, if any, `phase` samples after the first. True when a
// cycle ended.
template <class Real>
bool OscillationDetector<Real>::take_waiting(int band, unsigned phase) {
  const int slot = waiting_slot(band);
  if ((waiting_slots_ >> slot & 1U) == 0) return false;
  waiting_slots_ = waiting_slots_ & ~(1U << slot) & 7U;
  float x = waiting(slot);
  bool changed = false;
  if (take(band, phase, x, changed)) leave(band + 1, x);
  return changed;
}

// A sample for a band, `phase` samples after the first: each second one is halved for the
// next band. True when there is one for that, then x.
template <class Real>
bool OscillationDetector<Real>::take(int band, unsigned phase, float& x, bool& changed) {
  changed |= watch(band, x);
  if (band + 1 == kBands) return false;
  // (1 2 1)/4 and every second sample: one sum is enough.
  float& half = halved_[static_cast<std::size_t>(band)];
  if ((phase >> band) & 1) {
    half += 0.5f * x;
    return false;
  }
  const float slower = half + 0.25f * x;
  half = 0.25f * x;
  x = slower;
  return true;
}

template <class Real>
bool OscillationDetector<Real>::watch(int band, float x) {
  const auto b = static_cast<std::size_t>(band);
  Cycles& c = cycles_[b];
  float& s1 = state1_[b];
  float& s2 = state2_[b];
  const float before = s1;
  const float high = x - s2;
  const float v1 = kGain1 * s1 + kGain2 * high;
  const float v2 = s2 + kGain2 * s1 + kGain3 * high;
  s1 = 2.0f * v1 - s1;
  s2 = 2.0f * v2 - s2;

  ++c.samples;
  energy_[b] += s1 * s1;
  const bool crossing = before <= 0.0f && s1 > 0.0f;
  if (!crossing && c.samples < kSilence) return false;

  if (crossing) {
    const int part = static_cast<int>(s1 / (s1 - before) * kFractionUnit);
    const float since = static_cast<float>(std::min(part, 255));
    if (c.crossed) {
      const float mean_square = energy_[b] / static_cast<float>(c.samples);
      const float floor = std::max(kRounding * std::fabs(x), kSmallest);
      if (mean_square > floor * floor) {
        const float length = static_cast<float>(c.samples) +
                             (static_cast<float>(c.fraction) - since) / kFractionUnit;
        end_cycle(c, length, mean_square);
      } else {
        c.last_length = 0;
        judge(c, 1.0f, 1);
      }
    }
    c.crossed = true;
    c.fraction = static_cast<std::uint8_t>(since);
  } else {
    c.crossed = false;
    c.last_length = 0;
    if (c.judged > 0) judge(c, 1.0f, kSilentCycles);
  }
  c.samples = 0;
  energy_[b] = 0.0f;
  return true;
}

template <class Real>
void OscillationDetector<Real>::end_cycle(Cycles& c, float length, float mean_square) {
  const int scaled_length = static_cast<int>(length * kLengthUnit);
  const std::int16_t log = root_log(mean_square);
  if (!c.ended && c.count < 65535) ++c.count;
  // The first cycle still rings from the start: the second one replaces it.
  const int n = std::clamp<int>(c.count - 1, 1, c.active ? kSmooth : kRecent);
  if (c.mean_length == 0) {
    c.mean_length = static_cast<std::uint16_t>(scaled_length);
    c.mean_log = log;
  } else {
    approach(c.mean_length, scaled_length, 1, n);
    approach(c.mean_log, log, 1, n);
  }
  if (c.last_length != 0) {
    const float last = static_cast<float>(c.last_length);
    const float size = kNepersPerUnit * static_cast<float>(std::abs(log - c.last_log));
    const BinaryLog ratio = log2_of(static_cast<float>(scaled_length) / last);
    const float longer = kLn2 * (static_cast<float>(ratio.whole) + ratio.rest);
    judge(c, std::fabs(longer) + kSizeWeight * size, 1);
  }
  c.last_length = static_cast<std::uint16_t>(scaled_length);
  c.last_log = log;
}

template <class Real>
void OscillationDetector<Real>::judge(Cycles& c, float irregularity, int weight) {
  const int e = nearest(std::min(irregularity, 1.0f) * kShareUnit);
  const int n = std::min(c.judged + weight, kRecord);
  c.judged = static_cast<std::uint8_t>(n);
  approach(c.irregularity, e, weight, n);
  approach(c.irregularity_now, e, weight, std::min(n, kRecent));
  const float now = static_cast<float>(c.irregularity_now) / kShareUnit;
  if (c.active && now > kEnd) {
    c.active = false;
    c.ended = true;
  } else if (!c.active && now < kStart && n >= kStartAfter) {
    c.active = true;
    c.ended = false;
    c.count = std::min<std::uint16_t>(c.count, kStartAfter);
  }
}

template <class Real>
OscillationReport<Real> OscillationDetector<Real>::report() const {
  return describe(false);
}

template <class Real>
OscillationReport<Real> OscillationDetector<Real>::present() const {
  return describe(true);
}

template <class Real>
OscillationRhythm<Real> OscillationDetector<Real>::rhythm() const {
  int band = -1;
  std::int16_t loudest = 0;
  for (int b = 0; b < kBands; ++b) {
    const Cycles& c = cycles_[static_cast<std::size_t>(b)];
    if (c.active && (band < 0 || c.mean_log > loudest)) {
      band = b;
      loudest = c.mean_log;
    }
  }
  return {band >= 0, period_of(band)};
}

template <class Real>
bool OscillationDetector<Real>::active() const {
  return std::any_of(cycles_.begin(), cycles_.end(),
                     [](const Cycles& c) { return c.active; });
}

template <class Real>
Real OscillationDetector<Real>::period_of(int band) const {
  if (band < 0) return 0;
  const Cycles& c = cycles_[static_cast<std::size_t>(band)];
  const float length = static_cast<float>(c.mean_length) / kLengthUnit;
  return static_cast<Real>(length * static_cast<float>(1 << band));
}

// The band with the largest swing among those that oscillate; the most regular one if
// none does.
template <class Real>
typename OscillationDetector<Real>::Choice OscillationDetector<Real>::choose(
    bool present) const {
  Choice out;
  float best_rank = 0.0f;
  for (int band = 0; band < kBands; ++band) {
    const Cycles& c = cycles_[static_cast<std::size_t>(band)];
    if (c.judged == 0 || c.mean_length == 0) continue;
    const float r =
        kIrregularityLimit /
        (present ? cautious(c.irregularity_now, std::min<int>(c.judged, kRecent))
                 : cautious(c.irregularity, c.judged));
    const bool passes = present ? c.active : r > 1.0f;
    const float rank = passes ? static_cast<float>(c.mean_log) : r;
    if (out.band < 0 || (passes && !out.passes) ||
        (passes == out.passes && rank > best_rank)) {
      out.band = band;
      out.passes = passes;
      best_rank = rank;
    }
    out.regularity = std::max(out.regularity, r);
  }
  return out;
}

template <class Real>
OscillationReport<Real> OscillationDetector<Real>::describe(bool present) const {
  OscillationReport<Real> out;
  out.oscillating = active();
  const Choice best = choose(present);
  if (best.band < 0) return out;
  const Cycles& c = cycles_[static_cast<std::size_t>(best.band)];
  const float length = static_cast<float>(c.mean_length) / kLengthUnit;
  const float rms = elementary::exp(kNepersPerUnit * static_cast<float>(c.mean_log));
  out.detected = best.passes;
  out.regularity = static_cast<Real>(best.regularity);
  out.period_samples = period_of(best.band);
  out.amplitude = static_cast<Real>(std::sqrt(2.0f) * rms / gain(length, best.band));
  out.cycles = c.count;
  return out;
}

template class OscillationDetector<float>;
template class OscillationDetector<double>;

}  // namespace ident
