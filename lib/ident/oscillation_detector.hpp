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
// strangers. The mean of e over the record, drawn towards ½ by one imaginary
// pair so that three lucky cycles are no proof, is the band's irregularity.
//
// Regularity is 0.4 / irregularity: above 1 the signal oscillates, the custom of the
// regularity index of Thornhill, Huang & Zhang, J. Process Control 13 (2003) 91,
// which looks at crossings of the autocovariance of a whole record instead.
// The limit of 0.4 was set on simulated signals (host-tests/score).
//
// Equation (1) knows neither offset nor scale. Slow drift, steps and noise fall
// outside the band; what they leave inside it spoils single cycles, each of
// which counts at most 1.
//
// One thread; no heap, clock or exceptions. Holds for years: every counter
// saturates and every mean forgets.
#pragma once

#include <array>
#include <cstdint>

namespace ident {

/// What the detector has seen up to now.
template <class Real>
struct OscillationReport {
  /// The signal oscillates over the record: most of its cycles are alike. The
  /// record is everything pushed, at most the latest 255 cycles of each band.
  bool detected = false;
  /// It oscillates now: judged on the latest 16 cycles, with hysteresis. Goes
  /// up when an oscillation starts, down when it ends.
  bool oscillating = false;
  /// Samples per cycle, 4 … 1000, mean of the latest 32 cycles; 0 if no band
  /// has seen two cycles that could be compared.
  Real period_samples = 0;
  /// 0.4 / irregularity over the record, 0 … 200; above 1 means `detected`.
  Real regularity = 0;
  /// Amplitude of the fundamental wave, in the unit of the signal: half the
  /// peak-to-peak swing of a sinusoid, 8/π² of that of a triangle, 4/π of that
  /// of a square wave. Mean of the latest 32 cycles.
  Real amplitude = 0;
  /// Cycles of the present oscillation, or of the last one if it has ended;
  /// saturates at 65535.
  std::uint16_t cycles = 0;
};

/// Real is the precision in which the signal's offset (its first sample) is
/// taken off; the state is kept in float for either. Distances from the first
/// sample above 1e15 are cut, swings below 1e-15 are not seen.
template <class Real>
class OscillationDetector {
 public:
  /// Octave bands: 4 … 8, 8 … 16, … 256 … 512 samples per cycle.
  static constexpr int kBands = 7;
  /// Irregularity below which a band oscillates, see (1).
  static constexpr float kIrregularityLimit = 0.4f;

  /// One sample, at a fixed rate. Takes 2 bands on average, at most 7; each
  /// some 20 floating-point operations, and two logarithms and a square root
  /// when a cycle ends. A sample that is not finite is skipped.
  void push(Real value);

  /// Constant time, 7 bands.
  [[nodiscard]] OscillationReport<Real> report() const;

  /// Forgets everything.
  void reset() { *this = OscillationDetector(); }

 private:
  // Means kept short: logarithms in 1/768 (±42, that is 1e±18), lengths in
  // 1/2048 sample of the band's own rate, irregularities in 1/65535.
  struct Cycles {
    std::int16_t last_log = 0;           // ln of the latest cycle's root mean square
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

  void watch(int band, float x);
  static void end_cycle(Cycles& c, float length, float mean_square);
  static void judge(Cycles& c, float irregularity);

  std::array<float, kBands> state1_{};  // band-pass, first integrator: its output
  std::array<float, kBands> state2_{};  // band-pass, second integrator
  std::array<float, kBands> halved_{};  // unfinished sample of the next band's rate
  std::array<float, kBands> energy_{};  // sum of squares over this cycle
  std::array<Cycles, kBands> cycles_{};
  Real first_ = 0;                // first sample
  std::uint8_t phase_ = 0;        // samples pushed, modulo 256
  std::int8_t orientation_ = 0;   // ±1: a signal and its mirror image look the same
  bool started_ = false;
};

// 7 bands · (4 · 4 + 18) = 238, the first sample 4 (8), three bytes, padding:
// 248 (256).
static_assert(sizeof(OscillationDetector<float>) <= 256,
              "the detector's share of the monitor's memory is 256 bytes");
static_assert(sizeof(OscillationDetector<double>) <= 256,
              "the detector's share of the monitor's memory is 256 bytes");

extern template class OscillationDetector<float>;
extern template class OscillationDetector<double>;

}  // namespace ident
