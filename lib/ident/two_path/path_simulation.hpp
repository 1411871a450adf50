// Free simulation of a two-path model, in pieces.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "ident/two_path/lagged_gram.hpp"
#include "ident/two_path/two_path_model.hpp"

namespace ident {

/// What the process remembered before the first sample, as additions to the first
/// na outputs; zero: at rest.
template <class Real>
using InitialState = std::array<Real, kMaxNa>;

/// The last kMaxNk + kMaxNb values of a signal.
template <class Value>
class PastValues {
 public:
  void fill(const Value& before) { values_.fill(before); }
  void push(const Value& value) {
    newest_ = (newest_ + 1) % kLength;
    values_[newest_] = value;
  }
  /// 0: the last one pushed; lag < kMaxNk + kMaxNb.
  [[nodiscard]] const Value& operator[](int lag) const {
    return values_[(newest_ - static_cast<unsigned>(lag)) % kLength];
  }

 private:
  static constexpr unsigned kLength = 16;  // a power of two
  static_assert(kLength >= kMaxNk + kMaxNb, "the oldest lag must be there");
  std::array<Value, kLength> values_;
  unsigned newest_ = 0;
};

/// x(t) of a model at one sample after another: each search for the knot starts where the
/// last one ended.
template <class Real>
class PathFollower {
 public:
  /// x[t], or, where x is empty, as Path::at for the path of the sample's direction.
  [[nodiscard]] Real at(const WindowView<Real>& window, std::span<const Real> x,
                        const TwoPathModel<Real>& model, std::ptrdiff_t t);

 private:
  static Real along(const Path<Real>& path, Real u, int& segment);

  int ascending_ = 0;   // segment of the ascending path
  int descending_ = 0;  // and of the other
};

/// Samples simulated at once, and what they take on a Cortex-M4F, thousands of
/// instructions.
inline constexpr int kSimulatedAtOnce = 256;
inline constexpr int kCostOfSimulated = 62;

/// ŷ from u alone, equation (8), and its squared error: start → step until done.
/// Memory: about 30 numbers. Cost: N·(na + nb + 10) multiplications.
template <class Real>
class PathSimulation {
 public:
  /// `x`, the valve position, has the length of the window; empty: both paths of the
  /// model make it. `simulated` has that length too. Before the first sample x kept its
  /// first value.
  /// Everything must outlive the work.
  void start(const WindowView<Real>& window, std::span<const Real> x,
             const TwoPathModel<Real>& model, const InitialState<Real>& initial,
             std::span<Real> simulated);
  /// At most `samples` ≥ 1 samples more; true when done.
  bool step(int samples);
  /// Σ(y − ŷ)² so far.
  [[nodiscard]] Real error() const { return error_; }

 private:
  WindowView<Real> window_;
  std::span<const Real> x_;
  std::span<Real> simulated_;
  const TwoPathModel<Real>* model_ = nullptr;
  const InitialState<Real>* initial_ = nullptr;
  PathFollower<Real> follower_;
  PastValues<Real> past_;
  std::ptrdiff_t next_ = 0;
  Real error_ = 0;
};

/// All at once: Σ(y − ŷ)² of a free simulation, ŷ left in `simulated`.
template <class Real>
Real simulate_paths(const WindowView<Real>& window, std::span<const Real> x,
                    const TwoPathModel<Real>& model, const InitialState<Real>& initial,
                    std::span<Real> simulated);

}  // namespace ident
