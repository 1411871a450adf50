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
void OneStepSums<Real>::start(std::size_t bins) {
  bins_ = std::clamp<std::size_t>(bins, 1, kLagBins);
  sums_ = {};
}

template <class Real>
void OneStepSums<Real>::lay_bins(const ThinnedSignal<Real>& v, std::size_t t,
                                 Real* out) const {
  Real before = 0;
  for (std::size_t b = 0; b < bins_; ++b) {
    const LagBin bin = kAllLagBins[b];
    const std::size_t from = (t - static_cast<std::size_t>(bin.last)) * v.thinning;
    const std::size_t end = (t - static_cast<std::size_t>(bin.first) + 1) * v.thinning;
    Real sum = 0;
    for (std::size_t s = from; s < end; ++s) {
      sum += v.values[s];
    }
    const Real mean = sum / static_cast<Real>(end - from);
    out[b] = b == 0 ? mean : before - mean;
    before = mean;
  }
}

template <class Real>
void OneStepSums<Real>::lay_output(std::span<const Real> y, std::size_t t,
                                   Row& row) const {
  lay_bins({y}, t, row.data());
  row[bins_] = Real(1);
  row[bins_ + 1] = y[t] - y[t - 1];
}

template <class Real>
void OneStepSums<Real>::multiply(const Row& row, std::size_t from, std::size_t to,
                                 Triangle& block) {
  for (std::size_t i = from; i < to; ++i) {
    Real* const sums = &block[place(i, 0)];
    for (std::size_t j = 0; j <= i; ++j) {
      sums[j] += row[i] * row[j];
    }
  }
}

template <class Real>
void OneStepSums<Real>::add_block(const Triangle& block, std::size_t from,
                                  std::size_t to) {
  for (std::size_t k = place(from, 0); k < place(to, 0); ++k) {
    sums_[k] += block[k];
  }
}

template <class Real>
void OneStepSums<Real>::add_output(std::span<const Real> y, std::size_t first,
                                   std::size_t last) {
  Row row;
  for (std::size_t begin = first; begin < last; begin += kRowsInBlock) {
    Triangle block{};
    const std::size_t end = std::min(begin + kRowsInBlock, last);
    for (std::size_t t = begin; t < end; ++t) {
      lay_output(y, t, row);
      multiply(row, 0, outputs(), block);
    }
    add_block(block, 0, outputs());
  }
}

template <class Real>
void OneStepSums<Real>::begin_input() {
  std::fill(sums_.begin() + static_cast<std::ptrdiff_t>(place(outputs(), 0)), sums_.end(),
            Real(0));
}

template <class Real>
void OneStepSums<Real>::add_input(std::span<const Real> y, std::span<const Real> z,
                                  std::size_t first, std::size_t last) {
  Row row;
  for (std::size_t begin = first; begin < last; begin += kRowsInBlock) {
    Triangle block{};
    const std::size_t end = std::min(begin + kRowsInBlock, last);
    for (std::size_t t = begin; t < end; ++t) {
      lay_output(y, t, row);
      lay_bins({z}, t, row.data() + outputs());
      multiply(row, outputs(), columns(), block);
    }
    add_block(block, outputs(), columns());
  }
}

template <class Real>
Real OneStepSums<Real>::error() {
  // Cholesky, what is predicted last: its own pivot is what the others leave of it.
  const std::size_t target = bins_ + 1;
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

// Backward substitution in the factor of `error`; the columns of z are the last of it.
template <class Real>
void OneStepSums<Real>::solve_weights() {
  const std::size_t last = columns() - 1;
  const Real* const shares = &factor_[place(last, 0)];
  for (std::size_t i = last; i-- > last - bins_;) {
    Real sum = shares[i];
    for (std::size_t k = i + 1; k < last; ++k) {
      sum -= factor_[place(k, i)] * weights_[k + bins_ - last];
    }
    weights_[i + bins_ - last] = sum * factor_[place(i, i)];
  }
}

template <class Real>
void OneStepSums<Real>::begin_planted() {
  planted_ = {};
}

template <class Real>
void OneStepSums<Real>::add_planted(std::span<const Real> y, const ThinnedSignal<Real>& z,
                                    std::span<const Real> w, std::size_t first,
                                    std::size_t last) {
  Row row;
  Row bins;
  for (std::size_t begin = first; begin < last; begin += kRowsInBlock) {
    Row block{};
    const std::size_t end = std::min(begin + kRowsInBlock, last);
    for (std::size_t t = begin; t < end; ++t) {
      lay_bins({y}, t, row.data());
      row[bins_] = Real(1);
      lay_bins(z, t, row.data() + bins_ + 1);
      lay_bins({w}, t, bins.data());
      Real part = 0;
      for (std::size_t b = 0; b < bins_; ++b) {
        part += weights_[b] * bins[b];
      }
      row[columns() - 1] = part;
      for (std::size_t j = 0; j < columns(); ++j) {
        block[j] += part * row[j];
      }
    }
    for (std::size_t j = 0; j < columns(); ++j) {
      planted_[j] += block[j];
    }
  }
}

template <class Real>
Real OneStepSums<Real>::planted() const {
  const std::size_t last = columns() - 1;
  Row shares;
  Real left = planted_[last];
  for (std::size_t i = 0; i < last; ++i) {
    Real sum = planted_[i];
    for (std::size_t k = 0; k < i; ++k) {
      sum -= factor_[place(i, k)] * shares[k];
    }
    shares[i] = sum * factor_[place(i, i)];
    left -= shares[i] * shares[i];
  }
  return std::max(left, Real(0));
}

template class OneStepSums<float>;
template class OneStepSums<double>;

}  // namespace ident
