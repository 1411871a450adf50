// What the poles of a process remembered before the window, as columns over its samples.
#pragma once

#include <cmath>
#include <cstddef>

#include "ident/base/elementary.hpp"

namespace ident {

/// A column some samples later, written with what is there already:
/// c(t + delay) = share·c(t) + constant + slope·(2t / n).
template <class Real>
struct ColumnShift {
  Real share = 1;
  Real constant = 0;
  Real slope = 0;
};

/// p^delay and 1 − p^delay, the second exact near p = 1 too.
template <class Real>
struct PolePower {
  explicit PolePower(Real pole) : pole_(pole) {}
  void next() {
    left *= pole_;
    gone += (Real(1) - pole_) * (Real(1) - gone);
  }
  Real left = 1;
  Real gone = 0;

 private:
  Real pole_;
};

/// p^t without denormal numbers.
template <class Real>
Real next_power(Real value, Real pole) {
  value *= pole;
  return value > Real(1e-12) ? value : Real(0);
}

/// What a pole remembered before the window, as a column over its n samples: p^t, and for
/// a slow pole what p^t has that the offset (and the drift, if there is one) have not,
/// scaled to order one. The plain column of a slow pole is all but a sum of those two.
template <class Real>
class StartColumn {
 public:
  StartColumn() = default;
  StartColumn(Real pole, std::size_t n, bool drift)
      : pole_(pole), samples_(static_cast<Real>(n)) {
    constexpr Real kSlow = Real(0.3);  // left of the start at the end of the window
    const Real last = elementary::pow(pole, static_cast<Real>(n - 1));
    if (!(pole < Real(1))) {
      factor_ = 0;  // an integrator's start is an offset
    } else if (last > kSlow) {
      // 1 − p^t stays exact near p = 1 where p^t itself does not: u = 1 − p^t.
      value_ = 0;
      growth_ = Real(1) - pole;
      const Real end = Real(1) - last;
      const Real middle = Real(1) - std::sqrt(last);
      slope_ = drift ? end / static_cast<Real>(n - 1) : Real(0);
      constant_ = drift ? Real(0) : end / Real(2);
      const Real height = drift ? middle - end / Real(2) : end / Real(2);
      const Real least = sizeof(Real) < sizeof(double) ? Real(1e-2) : Real(1e-9);
      factor_ = height > least ? Real(1) / height : Real(0);
      slow_ = true;
    }
  }
  /// A PlainStart, and no column, in the same type: one code for all three.
  static StartColumn plain(Real pole, std::size_t n) {
    StartColumn column;
    column.pole_ = pole;
    if (!(pole < Real(1))) {
      column.samples_ = static_cast<Real>(n);
      column.slope_ = Real(-1) / column.samples_;
      column.value_ = 0;
      column.slow_ = true;
    }
    return column;
  }
  static StartColumn none() {
    StartColumn column;
    column.factor_ = 0;
    return column;
  }
  /// False when the column is zero, or from here on.
  [[nodiscard]] bool present() const {
    return factor_ != Real(0) && (slow_ || value_ != Real(0));
  }
  [[nodiscard]] Real pole() const { return pole_; }
  [[nodiscard]] ColumnShift<Real> shift(int delay, const PolePower<Real>& decayed) const {
    if (!slow_) {
      return {decayed.left, Real(0), Real(0)};
    }
    return {decayed.left,
            factor_ * (decayed.gone * (Real(1) - constant_) -
                       slope_ * static_cast<Real>(delay)),
            -factor_ * decayed.gone * slope_ * samples_ / Real(2)};
  }
  /// Back to the first sample.
  void restart() {
    value_ = slow_ ? Real(0) : Real(1);
    time_ = 0;
  }
  /// The column's value at the next sample, from the first on.
  Real next() {
    Real out;
    if (slow_) {
      out = factor_ * (value_ - slope_ * time_ - constant_);
      value_ += growth_ * (Real(1) - value_);
      time_ += Real(1);
    } else {
      out = factor_ * value_;
      value_ = next_power(value_, pole_);
    }
    return out;
  }

 private:
  Real pole_ = 1;
  Real samples_ = 0;
  Real value_ = 1;
  Real growth_ = 0;
  Real slope_ = 0;
  Real constant_ = 0;
  Real factor_ = 1;
  Real time_ = 0;
  bool slow_ = false;
};

/// The same for a screening: p^t, or for an integrator a ramp t / n.
template <class Real>
class PlainStart {
 public:
  PlainStart() = default;
  PlainStart(Real pole, std::size_t n)
      : pole_(pole),
        step_(pole < Real(1) ? Real(0) : Real(1) / static_cast<Real>(n)),
        value_(pole < Real(1) ? Real(1) : Real(0)) {}
  [[nodiscard]] bool present() const { return value_ != Real(0) || step_ != Real(0); }
  [[nodiscard]] Real pole() const { return pole_; }
  [[nodiscard]] ColumnShift<Real> shift(int delay, const PolePower<Real>& decayed) const {
    return {decayed.left, step_ * static_cast<Real>(delay), Real(0)};
  }
  void restart() { value_ = step_ > Real(0) ? Real(0) : Real(1); }
  Real next() {
    const Real out = value_;
    value_ = step_ > Real(0) ? value_ + step_ : next_power(value_, pole_);
    return out;
  }

 private:
  Real pole_ = 1;
  Real step_ = 0;
  Real value_ = 0;
};

/// No column.
template <class Real>
struct NoStart {
  [[nodiscard]] bool present() const { return false; }
  [[nodiscard]] Real pole() const { return Real(1); }
  [[nodiscard]] ColumnShift<Real> shift(int, const PolePower<Real>&) const { return {}; }
  void restart() {}
  Real next() { return Real(0); }
};

}  // namespace ident
