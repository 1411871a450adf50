#include "ident/evidence/one_step_sums.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ident {
namespace {

constexpr std::size_t kRowsInBlock = 32;
// Each column keeps this share of its square to itself: a thousandth of what it moves by
// is not believed, whatever the precision.
constexpr double kDisbelief = 1e-6;
// A column that those before it explain up to this share of its square is left out.
constexpr double kDependent = 2e-6;

}  // namespace

template <class Real>
void OneStepSums<Real>::start(std::span<const LagBin> bins) {
  bins_ = bins;
  sums_ = {};
  if constexpr (kStemSearch) {
    more_.second = {};
    more_.bins_beside = 0;
    more_.setpoint_bins = {};
    more_.bent = false;
  }
}

template <class Real>
void OneStepSums<Real>::stand_beside(const ThinnedSignal<Real>& setpoint) {
  if constexpr (kStemSearch) {
    const auto within_reach = [this](const LagBin& bin) {
      return bin.last <= bins_.back().last;
    };
    more_.setpoint = setpoint;
    more_.setpoint_bins = kSetpointLagBins;
    more_.setpoint_bins = more_.setpoint_bins.first(static_cast<std::size_t>(
        std::count_if(kSetpointLagBins.begin(), kSetpointLagBins.end(), within_reach)));
  }
}

// Bins of the values of v at some successive samples, from row[column] on. The sum of a
// bin of several lags follows from the one before it.
template <class Real>
template <class Value>
void OneStepSums<Real>::lay(std::span<const LagBin> bins, const ThinnedSignal<Real>& v,
                            std::size_t t, std::size_t count, Rows& rows,
                            std::size_t column, Value value) {
  const std::size_t thinning = v.thinning;
  const Real each = Real(1) / static_cast<Real>(thinning);
  Real means[kTogether] = {};
  for (std::size_t b = 0; b < bins.size(); ++b) {
    const LagBin bin = bins[b];
    const Real* oldest = &v.values[(t - static_cast<std::size_t>(bin.last)) * thinning];
    const Real* newest = &v.values[(t - static_cast<std::size_t>(bin.first)) * thinning];
    const bool single = bin.first == bin.last;
    const Real share = each / static_cast<Real>(bin.last - bin.first + 1);
    Real sum = 0;
    for (const Real* at = oldest; at < newest; ++at) {
      sum += value(*at);
    }
    for (std::size_t k = 0; k < count; ++k) {
      sum = single ? Real(0) : sum;
      for (std::size_t s = 0; s < thinning; ++s) {
        sum += value(*newest++);
      }
      const Real mean = sum * share;
      rows[k][column + b] = b == 0 ? mean : means[k] - mean;
      means[k] = mean;
      for (std::size_t s = 0; s < thinning; ++s) {
        sum -= value(*oldest++);
      }
    }
  }
}

// From where it began: of a level far from 0 little that it moves by would be believed.
template <class Real>
void OneStepSums<Real>::lay_setpoint(std::size_t t, std::size_t count, Rows& rows,
                                     std::size_t column) const {
  if constexpr (kStemSearch) {
    if (more_.setpoint_bins.empty()) {
      return;
    }
    lay(more_.setpoint_bins, more_.setpoint, t, count, rows, column,
        [](Real value) { return value; });
    for (std::size_t k = 0; k < count; ++k) {
      rows[k][column] -= more_.setpoint.values[0];
    }
  }
}

// What stands beside z.
template <class Real>
void OneStepSums<Real>::lay_second(std::span<const Real> z, std::size_t t,
                                   std::size_t count, Rows& rows) const {
  if constexpr (kStemSearch) {
    const std::size_t column = outputs() + bins_.size();
    const auto bent = [centre = more_.centre](Real v) {
      return (v - centre) * (v - centre);
    };
    if (more_.bent) {
      lay(bins_, {z}, t, count, rows, column, bent);
    } else if (more_.bins_beside > 0) {
      lay(bins_.first(more_.bins_beside), more_.second, t, count, rows, column,
          [](Real value) { return value; });
    }
  }
}

template <class Real>
void OneStepSums<Real>::add(std::span<const Real> y, std::span<const Real> z,
                            std::size_t first, std::size_t last) {
  const std::size_t from = z.empty() ? 0 : outputs();
  const std::size_t to = z.empty() ? outputs() : columns();
  Triangle& block = factor_;
  for (std::size_t begin = first; begin < last; begin += kRowsInBlock) {
    std::fill(block.data() + place(from, 0), block.data() + place(to, 0), Real(0));
    const std::size_t end = std::min(begin + kRowsInBlock, last);
    for (std::size_t t = begin; t < end; t += kTogether) {
      const std::size_t count = std::min(kTogether, end - t);
      Rows rows{};
      lay_bins({y}, t, count, rows, 0);
      for (std::size_t k = 0; k < count; ++k) {
        rows[k][bins_.size()] = Real(1);
        rows[k][bins_.size() + 1] = y[t + k] - y[t + k - 1];
      }
      lay_setpoint(t, count, rows, bins_.size() + 2);
      if (!z.empty()) {
        lay_bins({z}, t, count, rows, outputs());
        lay_second(z, t, count, rows);
      }
      multiply(rows, from, to, block);
    }
    for (std::size_t k = place(from, 0); k < place(to, 0); ++k) {
      sums_[k] += block[k];
    }
  }
}

template <class Real>
void OneStepSums<Real>::multiply(const Rows& rows, std::size_t from, std::size_t to,
                                 Triangle& block) {
  const auto& [r0, r1, r2, r3] = rows;
  for (std::size_t i = from; i < to; ++i) {
    const Real v0 = r0[i];
    const Real v1 = r1[i];
    const Real v2 = r2[i];
    const Real v3 = r3[i];
    Real* const sums = &block[place(i, 0)];
    for (std::size_t j = 0; j <= i; ++j) {
      sums[j] = sums[j] + r0[j] * v0 + r1[j] * v1 + r2[j] * v2 + r3[j] * v3;
    }
  }
}

template <class Real>
void OneStepSums<Real>::begin_input(const ThinnedSignal<Real>& second,
                                    std::size_t newest) {
  if constexpr (kStemSearch) {
    more_.second = second;
    more_.bins_beside = second.values.empty() ? 0 : std::min(newest, bins_.size());
    more_.bent = false;
  }
  clear_inputs();
}

template <class Real>
void OneStepSums<Real>::begin_bent_input(Real centre) {
  if constexpr (kStemSearch) {
    more_.second = {};
    more_.bins_beside = bins_.size();
    more_.centre = centre;
    more_.bent = true;
  }
  clear_inputs();
}

template <class Real>
void OneStepSums<Real>::clear_inputs() {
  std::fill(sums_.begin() + static_cast<std::ptrdiff_t>(place(outputs(), 0)), sums_.end(),
            Real(0));
}

template <class Real>
Real OneStepSums<Real>::error() {
  // Cholesky, what is predicted last: its own pivot is what the others leave of it.
  const std::size_t target = bins_.size() + 1;
  const std::size_t count = columns();
  const auto original = [&](std::size_t k) {
    return k < target ? k : (k + 1 < count ? k + 1 : target);
  };
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t from = original(i);
    Real* const row = &factor_[place(i, 0)];
    for (std::size_t j = 0; j <= i; ++j) {
      const std::size_t to = original(j);
      row[j] = sums_[from >= to ? place(from, to) : place(to, from)];
    }
    const Real square = row[i];
    const bool last = i + 1 == count;
    row[i] = last ? square : square * (Real(1) + Real(kDisbelief));
    for (std::size_t j = 0; j < i; ++j) {
      const Real* const other = &factor_[place(j, 0)];
      Real sum = row[j];
      for (std::size_t k = 0; k < j; ++k) {
        sum -= row[k] * other[k];
      }
      // The diagonal holds inverse pivots; 0: left out.
      row[j] = sum * other[j];
      row[i] -= row[j] * row[j];
    }
    if (last) {
      return std::max(row[i], square * Real(kDependent)) +
             std::numeric_limits<Real>::min();
    }
    row[i] = row[i] > Real(kDependent) * square ? Real(1) / std::sqrt(row[i]) : Real(0);
  }
  return Real(0);
}

// Backward substitution in the factor of `error`.
template <class Real>
void OneStepSums<Real>::solve_weights() {
  const std::size_t last = columns() - 1;
  const Real* const shares = &factor_[place(last, 0)];
  for (std::size_t i = last; i-- > 0;) {
    Real sum = shares[i];
    for (std::size_t k = i + 1; k < last; ++k) {
      sum -= factor_[place(k, i)] * weights_[k];
    }
    weights_[i] = sum * factor_[place(i, i)];
  }
}

template <class Real>
Real OneStepSums<Real>::error_of(std::span<const Real> y, std::span<const Real> z,
                                 std::size_t first, std::size_t last) const {
  const std::size_t of_setpoint = bins_.size() + 1;
  const std::size_t of_z = outputs() - 1;
  Real sum = 0;
  for (std::size_t t = first; t < last; t += kTogether) {
    const std::size_t count = std::min(kTogether, last - t);
    Rows rows;
    lay_bins({y}, t, count, rows, 0);
    lay_setpoint(t, count, rows, of_setpoint);
    lay_bins({z}, t, count, rows, of_z);
    for (std::size_t k = 0; k < count; ++k) {
      rows[k][bins_.size()] = Real(1);
      Real error = y[t + k] - y[t + k - 1];
      for (std::size_t j = 0; j < of_z + bins_.size(); ++j) {
        error -= weights_[j] * rows[k][j];
      }
      sum += error * error;
    }
  }
  return sum;
}

template <class Real>
void OneStepSums<Real>::add_planted(std::span<const Real> y, const ThinnedSignal<Real>& z,
                                    std::span<const Real> w, std::size_t first,
                                    std::size_t last) {
  for (std::size_t begin = first; begin < last; begin += kRowsInBlock) {
    Row block{};
    const std::size_t end = std::min(begin + kRowsInBlock, last);
    for (std::size_t t = begin; t < end; t += kTogether) {
      const std::size_t count = std::min(kTogether, end - t);
      Rows rows;
      Rows of_w;
      lay_bins({w}, t, count, of_w, 0);
      Real parts[kTogether] = {};
      for (std::size_t k = 0; k < count; ++k) {
        for (std::size_t b = 0; b < bins_.size(); ++b) {
          parts[k] += weights_[outputs() - 1 + b] * of_w[k][b];
        }
      }
      lay_bins({y}, t, count, rows, 0);
      lay_setpoint(t, count, rows, bins_.size() + 1);
      lay_bins(z, t, count, rows, outputs() - 1);
      for (std::size_t k = 0; k < count; ++k) {
        rows[k][bins_.size()] = Real(1);
        rows[k][columns() - 1] = parts[k];
        for (std::size_t j = 0; j < columns(); ++j) {
          block[j] += parts[k] * rows[k][j];
        }
      }
    }
    for (std::size_t j = 0; j < columns(); ++j) {
      planted_[j] += block[j];
    }
  }
}

// Forward substitution in the factor of `error`: the shares of the columns in what was
// planted, and what they leave of its square.
template <class Real>
Real OneStepSums<Real>::planted() const {
  Row shares;
  Real square = planted_[columns() - 1];
  for (std::size_t i = 0; i + 1 < columns(); ++i) {
    Real sum = planted_[i];
    for (std::size_t k = 0; k < i; ++k) {
      sum -= factor_[place(i, k)] * shares[k];
    }
    shares[i] = sum * factor_[place(i, i)];
    square -= shares[i] * shares[i];
  }
  return std::max(square, Real(0));
}

template class OneStepSums<float>;
template class OneStepSums<double>;

}  // namespace ident
