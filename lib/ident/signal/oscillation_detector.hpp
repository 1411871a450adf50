// Tells from one signal, sample by sample, whether it oscillates.
//
// new -> push, push, push … -> report, at any time and as often as liked.
//
// Method. Seven band-passes, one per octave, watch periods of 4 … 512 samples.
// Each next one runs on every second sample of a halved, low-passed rate. In
// each band one cycle lasts from one crossing of zero to the next in the same
// direction. Two cycles that follow each other are compared:
//
//   e = min(1, |ln(T/T')| + ½·|ln(A/A')|)                                  (1)
//
// T, T' their lengths and A, A' their root mean squares: 0 for twins, 1 for
// strangers. The mean of e, drawn towards ½ by one imaginary pair so that two
// lucky cycles count less, is the band's irregularity. Noise gives about 0.6, a
// good limit cycle 0.1. Regularity is 0.42 / irregularity: above 1
// the signal oscillates, as in the index of Thornhill, Huang & Zhang, J. Process
// Control 13 (2003) 91, which looks at the autocovariance of a whole record
// instead. At the limit of 0.42 false alarms and misses are equally frequent, the
// mean taken of simulated signals and labelled recordings, see
// host-tests/score/score_oscillation.cpp.
//
// The measure (1) knows neither offset nor scale. Slow drift, steps and noise fall
// outside the band; what they leave inside it spoils single cycles, each of
// which counts at most 1.
//
// What it cannot tell: a resonance kept alive by noise from a limit cycle, if
// it is damped with less than 0.15; luck from cycle when a record holds only
// two or three cycles (some 6 % of simulated short records without oscillation
// are called oscillating).
//
// One thread; no heap, clock or exceptions. Holds for years: every counter
// saturates and every mean forgets.
#pragma once

#include <array>
#include <cstdint>

namespace ident {

/// What the detector has seen.
template <class Real>
struct OscillationReport {
  /// report(): it oscillates over the record, that is, `regularity` > 1.
  /// present(): the same as `oscillating`.
  bool detected = false;
  /// It oscillates now: a memory of 12 cycles, with hysteresis. Goes
  /// up some 4 cycles after the first sample, or 10 after an oscillation
  /// begins in the middle of noise, and down 10 to 30 cycles after it ends.
  bool oscillating = false;
  /// Samples per cycle, mean of the latest 32 cycles; 4 … 512 is watched, 2 …
  /// 1600 can come out. 0 if no two cycles could be compared.
  Real period_samples = 0;
  /// 0.42 / irregularity, 0 … 215; the highest of all bands.
  Real regularity = 0;
  /// Amplitude of the fundamental wave, in the unit of the signal: half the
  /// peak-to-peak swing of a sinusoid, 8/π² of that of a triangle, 4/π of that
  /// of a square wave. Mean of the latest 32 cycles, the geometric one.
  Real amplitude = 0;
  /// Cycles of the present oscillation, or of the last one if it has ended;
  /// one that sets in late is counted from 4 when it is recognised. Saturates
  /// at 65535.
  std::uint16_t cycles = 0;
};

/// The part of `present` that costs little: no division, no exponential, no angle.
template <class Real>
struct OscillationRhythm {
  bool oscillating = false;  ///< now, as in OscillationReport
  Real period_samples = 0;   ///< as in OscillationReport; 0 unless oscillating
};

/// Real is the precision in which the signal's offset (its first sample) is
/// taken off; the state is kept in float for either. A distance from the first
/// sample above 1e15 is cut to that, and a swing is seen if it is above 1e-15
/// and above 1e-5 of that distance.
///
/// Where several bands oscillate, period, amplitude and cycles are those of the
/// one that swings most; where none does, of the most regular one.
template <class Real>
class OscillationDetector {
 public:
  /// Octave bands: 4 … 8, 8 … 16, … 256 … 512 samples per cycle.
  static constexpr int kBands = 7;
  /// Irregularity below which a band oscillates, see (1).
  static constexpr float kIrregularityLimit = 0.42f;

  /// One sample, at a fixed rate. True when a cycle ended in some band, or failed to:
  /// only then can `report`, `present` and `rhythm` say something new. Takes 2 bands at
  /// most, the slow ones up to 31 samples later; each some 20 floating-point operations,
  /// and 60 more when a cycle ends. A sample that is not finite is skipped.
  bool push(Real value);

  /// The record as a whole: everything pushed, fading with a memory of 255
  /// cycles in each band. Constant time, 7 bands.
  [[nodiscard]] OscillationReport<Real> report() const;

  /// The oscillation that goes on now, with a memory of 12 cycles.
  [[nodiscard]] OscillationReport<Real> present() const;

  /// Of `present`, what is wanted after every sample. Constant time, 7 bands.
  [[nodiscard]] OscillationRhythm<Real> rhythm() const;

  /// Forgets everything.
  void reset() { *this = OscillationDetector(); }

 private:
  // Means kept short: binary logarithms in 1/512 (2^±64), lengths in 1/2048
  // sample of the band's own rate, irregularities in 1/65535.
  struct Cycles {
    std::int16_t last_log = 0;           // log2 of the latest cycle's root mean square
    std::int16_t mean_log = 0;           // its mean
    std::uint16_t last_length = 0;       // of the latest cycle; 0: nothing to compare
    std::uint16_t mean_length = 0;       // its mean; 0: no cycle yet
    std::uint16_t irregularity = 0;      // mean of (1) over the record
    std::uint16_t irregularity_now = 0;  // mean of (1) over the latest cycles
    std::uint16_t count = 0;             // cycles of the present or last oscillation
    std::uint8_t judged = 0;             // values of (1) in the means
    std::uint8_t samples = 0;            // since the crossing that began this cycle
    std::uint8_t fraction = 0;           // from that crossing to its sample, 1/256
    bool crossed : 1 = false;            // a cycle has begun
    bool active : 1 = false;             // oscillates now
    bool ended : 1 = false;              // did, but no longer
  };

  // The band that speaks for all.
  struct Choice {
    int band = -1;  // none
    bool passes = false;
    float regularity = 0;  // the highest of all bands
  };

  [[nodiscard]] Choice choose(bool present) const;
  [[nodiscard]] bool active() const;
  [[nodiscard]] Real period_of(int band) const;
  OscillationReport<Real> describe(bool present) const;
  bool take(int band, unsigned phase, float& x, bool& changed);
  float& waiting(int slot);
  void leave(int band, float x);
  bool take_waiting(int band, unsigned phase);
  bool watch(int band, float x);
  static void end_cycle(Cycles& c, float length, float mean_square);
  static void judge(Cycles& c, float irregularity, int weight);

  std::array<float, kBands> state1_{};  // band-pass, first integrator: its output
  std::array<float, kBands> state2_{};  // band-pass, second integrator
  std::array<float, kBands> halved_{};  // unfinished sample of the next band's rate; of
                                        // the last, the sample that waits for it
  std::array<float, kBands> energy_{};  // sum of squares over this cycle
  std::array<Cycles, kBands> cycles_{};
  std::uint8_t phase_ = 0;           // samples pushed, modulo 256
  std::int8_t orientation_ : 2 = 0;  // ±1: a signal and its mirror image look the same
  bool started_ : 1 = false;
  std::uint8_t waiting_slots_ : 3 = 0;  // those of waiting_slot that hold a sample
  Real first_ = 0;                      // first sample
  std::array<float, 2> waiting_{};      // samples for bands 2 or 3, 4 or 5
};

// 7 bands · (4 · 4 + 18) = 238, two bytes, the first sample 4 (8), two that wait 8: 252
// (256).
static_assert(sizeof(OscillationDetector<float>) <= 256,
              "the detector's share of the monitor's memory is 256 bytes");
static_assert(sizeof(OscillationDetector<double>) <= 256,
              "the detector's share of the monitor's memory is 256 bytes");

extern template class OscillationDetector<float>;
extern template class OscillationDetector<double>;

}  // namespace ident
