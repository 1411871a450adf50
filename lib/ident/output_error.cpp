#include "ident/output_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace ident {
namespace {

// Order of the unknowns: a, b, d, initial state, κ, increments of both paths.
template <class Real>
struct Unknowns {
  Unknowns(const TwoPathModel<Real>& model, bool with_paths)
      : na(model.process.na),
        nb(model.process.nb),
        ascending(with_paths ? model.ascending.segments : 0),
        descending(with_paths ? model.descending.segments : 0),
        paths(with_paths) {}
  [[nodiscard]] int b() const { return na; }
  [[nodiscard]] int d() const { return na + nb; }
  [[nodiscard]] int initial() const { return na + nb + 1; }
  [[nodiscard]] int offset() const { return initial() + na; }
  [[nodiscard]] int increments() const { return offset() + 1; }
  [[nodiscard]] int count() const {
    return paths ? increments() + ascending + descending : offset();
  }
  int na;
  int nb;
  int ascending;
  int descending;
  bool paths;
};

// The last kMaxNk + kMaxNb samples of a signal.
template <class Value>
class Past {
 public:
  explicit Past(const Value& before) { values_.fill(before); }
  void push(const Value& value) {
    newest_ = (newest_ + 1) % kLength;
    values_[newest_] = value;
  }
  /// 0: the last one pushed; lag < kMaxNk + kMaxNb.
  [[nodiscard]] const Value& operator[](int lag) const {
    return values_[(newest_ + kLength - static_cast<unsigned>(lag)) % kLength];
  }

 private:
  static constexpr unsigned kLength = 16;
  static_assert(kLength >= kMaxNk + kMaxNb, "the oldest lag must be there");
  std::array<Value, kLength> values_;
  unsigned newest_ = 0;
};

/// x of a path at one u after another: the search starts where the last one ended.
template <class Real>
class PathCursor {
 public:
  explicit PathCursor(const Path<Real>& path) : path_(path) {}
  /// Path::at.
  Real at(Real u) {
    const auto& knots = path_.knots;
    while (segment_ > 0 && u < knots[segment_]) {
      --segment_;
    }
    while (segment_ < path_.segments && !(u < knots[segment_ + 1])) {
      ++segment_;
    }
    if (u <= knots[0]) {
      return path_.x[0];
    }
    if (segment_ == path_.segments) {
      return path_.x[segment_];
    }
    const Real low = path_.x[segment_];
    return low + (path_.x[segment_ + 1] - low) * (u - knots[segment_]) /
                     (knots[segment_ + 1] - knots[segment_]);
  }

 private:
  const Path<Real>& path_;
  int segment_ = 0;
};

}  // namespace

template <class Real>
void OutputErrorFit<Real>::read(const TwoPathModel<Real>& model,
                                const InitialState<Real>& initial, Valve valve) {
  const Unknowns<Real> at(model, valve == Valve::kPaths);
  now_.setZero(at.count());
  for (int i = 0; i < at.na; ++i) {
    now_(i) = model.process.a[i];
    now_(at.initial() + i) = initial[i];
  }
  for (int j = 0; j < at.nb; ++j) {
    now_(at.b() + j) = model.process.b[j];
  }
  now_(at.d()) = model.process.d;
  if (at.paths) {
    now_(at.offset()) = model.ascending.x[0];
    for (int k = 0; k < at.ascending; ++k) {
      now_(at.increments() + k) = model.ascending.x[k + 1] - model.ascending.x[k];
    }
    for (int k = 0; k < at.descending; ++k) {
      now_(at.increments() + at.ascending + k) =
          model.descending.x[k + 1] - model.descending.x[k];
    }
  }
}

template <class Real>
void OutputErrorFit<Real>::write(TwoPathModel<Real>& model, InitialState<Real>& initial,
                                 Valve valve) const {
  const Unknowns<Real> at(model, valve == Valve::kPaths);
  for (int i = 0; i < at.na; ++i) {
    model.process.a[i] = next_(i);
    initial[i] = next_(at.initial() + i);
  }
  for (int j = 0; j < at.nb; ++j) {
    model.process.b[j] = next_(at.b() + j);
  }
  model.process.d = next_(at.d());
  if (at.paths) {
    model.ascending.x[0] = next_(at.offset());
    for (int k = 0; k < at.ascending; ++k) {
      model.ascending.x[k + 1] = model.ascending.x[k] + next_(at.increments() + k);
    }
    model.descending.x[0] = 0;
    for (int k = 0; k < at.descending; ++k) {
      model.descending.x[k + 1] =
          model.descending.x[k] + next_(at.increments() + at.ascending + k);
    }
  }
}

template <class Real>
Real OutputErrorFit<Real>::simulate(const WindowView<Real>& window, Valve valve,
                                    std::span<const Real> x,
                                    const TwoPathModel<Real>& model,
                                    const InitialState<Real>& initial,
                                    std::span<Real> simulated) {
  const Process<Real>& process = model.process;
  const std::ptrdiff_t n = static_cast<std::ptrdiff_t>(window.y.size());
  PathCursor<Real> ascending(model.ascending);
  PathCursor<Real> descending(model.descending);
  const auto position = [&](std::ptrdiff_t t) {
    if (valve == Valve::kFixed) {
      return x[t];
    }
    return window.ascending[t] ? ascending.at(window.u[t]) : descending.at(window.u[t]);
  };
  Past<Real> x_past(position(0));
  Real error = 0;
  for (std::ptrdiff_t t = 0; t < n; ++t) {
    Real sum = process.d;
    for (int j = 0; j < process.nb; ++j) {
      sum += process.b[j] * x_past[process.nk + j];
    }
    for (int i = 0; i < process.na && i < t; ++i) {
      sum -= process.a[i] * simulated[t - 1 - i];
    }
    if (t < process.na) {
      sum += initial[t];
    }
    simulated[t] = sum;
    const Real e = window.y[t] - sum;
    error += e * e;
    x_past.push(position(t));
  }
  return error;
}

// Adds kRows rows to the upper triangle: each sum is read and written once for all.
template <class Real>
void OutputErrorFit<Real>::add_rows() {
  const auto& [r0, r1, r2, r3] = rows_;
  const auto& [e0, e1, e2, e3] = errors_;
  const Eigen::Index count = hessian_.cols();
  Real* sums = hessian_.data();
  for (Eigen::Index c = 0; c < count; ++c, sums += count) {
    const Real v0 = r0[c];
    const Real v1 = r1[c];
    const Real v2 = r2[c];
    const Real v3 = r3[c];
    gradient_(c) = gradient_(c) + v0 * e0 + v1 * e1 + v2 * e2 + v3 * e3;
    for (Eigen::Index r = 0; r <= c; ++r) {
      sums[r] = sums[r] + r0[r] * v0 + r1[r] * v1 + r2[r] * v2 + r3[r] * v3;
    }
  }
}

template <class Real>
void OutputErrorFit<Real>::normal_equations(const WindowView<Real>& window, Valve valve,
                                            std::span<const Real> x,
                                            const TwoPathModel<Real>& model,
                                            std::span<const Real> simulated) {
  const Process<Real>& process = model.process;
  const Unknowns<Real> at(model, valve == Valve::kPaths);
  const KnotGrid<Real> grid{model.ascending, model.descending};
  const int hats = at.paths ? grid.hats() : 0;
  const int ascending_hats = model.ascending.segments + 1;
  const std::ptrdiff_t n = static_cast<std::ptrdiff_t>(window.y.size());
  hessian_.setZero(at.count(), at.count());
  gradient_.setZero(at.count());

  // Every sensitivity is a signal through 1/A: of ŷ, of x, of 1, of an impulse, of each
  // hat. Lags share one filter; `now` is where the newest of its last outputs lies.
  using Memory = std::array<Real, kRing>;
  Memory of_y{};
  Memory of_one{};
  Memory impulse{};
  std::array<Memory, kMaxNb> of_x{};
  of_hat_ = {};
  unsigned now = 0;
  const auto back = [&](int lag) {
    return (now + kRing - static_cast<unsigned>(lag)) % kRing;
  };
  const auto advance = [&](Memory& memory, Real input) {
    Real sum = input;
    for (int i = 0; i < process.na; ++i) {
      sum -= process.a[i] * memory[back(i + 1)];
    }
    memory[now] = sum;
  };
  const auto pair_at = [&](std::ptrdiff_t t) {
    return at.paths ? grid.at(window.u[t], window.ascending[t] != 0) : HatPair<Real>{};
  };
  PathCursor<Real> ascending(model.ascending);
  PathCursor<Real> descending(model.descending);
  const auto position = [&](std::ptrdiff_t t) {
    if (valve == Valve::kFixed) {
      return x[t];
    }
    return window.ascending[t] ? ascending.at(window.u[t]) : descending.at(window.u[t]);
  };

  // The inputs before the first sample are held; fill the lags of x accordingly by
  // running the filter on the samples as they come, starting from zero sensitivity.
  Past<Real> x_past(position(0));
  Past<HatPair<Real>> pair_past(pair_at(0));
  int filled = 0;
  bool remembers = true;
  for (std::ptrdiff_t t = 0; t < n; ++t, now = (now + 1) % kRing) {
    if (t > 0) {
      x_past.push(position(t - 1));
      pair_past.push(pair_at(t - 1));
    }
    std::array<Real, kMaxUnknowns>& row = rows_[filled];
    advance(of_y, t > 0 ? -simulated[t - 1] : Real(0));
    advance(of_one, Real(1));
    if (remembers) {
      advance(impulse, t == 0 ? Real(1) : Real(0));
      Real most = 0;
      for (int i = 0; i < at.na; ++i) {
        most = std::max(most, std::abs(impulse[back(i)]));
      }
      // Slow, being denormal, long before it is nothing; never seen in a sum.
      if (most < Real(1e-30)) {
        remembers = false;
        impulse = {};
      }
    }
    for (int i = 0; i < at.na; ++i) {
      row[i] = of_y[back(i)];
      row[at.initial() + i] = impulse[back(i)];
    }
    for (int j = 0; j < at.nb; ++j) {
      advance(of_x[j], x_past[process.nk + j]);
      row[at.b() + j] = of_x[j][now];
    }
    row[at.d()] = of_one[now];
    if (at.paths) {
      std::array<Real, kMaxHats>& of_hat = of_hat_[now];
      of_hat.fill(Real(0));
      for (int j = 0; j < at.nb; ++j) {
        const HatPair<Real>& pair = pair_past[process.nk + j];
        of_hat[pair.first] += process.b[j] * (Real(1) - pair.upper);
        of_hat[pair.first + 1] += process.b[j] * pair.upper;
      }
      for (int i = 0; i < at.na; ++i) {
        const Real a = process.a[i];
        const std::array<Real, kMaxHats>& past = of_hat_[back(i + 1)];
        for (int h = 0; h < hats; ++h) {
          of_hat[h] -= a * past[h];
        }
      }
      // Increments are step functions over the hats.
      Real sum = 0;
      for (int h = ascending_hats - 1; h > 0; --h) {
        sum += of_hat[h];
        row[at.increments() + h - 1] = sum;
      }
      row[at.offset()] = sum + of_hat[0];
      sum = 0;
      for (int h = hats - 1; h > ascending_hats; --h) {
        sum += of_hat[h];
        row[at.increments() + h - 2] = sum;
      }
    }
    errors_[filled] = window.y[t] - simulated[t];
    if (++filled == kRows) {
      add_rows();
      filled = 0;
    }
  }
  if (filled > 0) {
    for (; filled < kRows; ++filled) {
      rows_[filled].fill(Real(0));
      errors_[filled] = 0;
    }
    add_rows();
  }
  for (Eigen::Index c = 0; c < hessian_.cols(); ++c) {
    for (Eigen::Index r = 0; r < c; ++r) {
      hessian_(c, r) = hessian_(r, c);
    }
  }
}

template <class Real>
Real OutputErrorFit<Real>::refine(const WindowView<Real>& window, Valve valve,
                                  std::span<const Real> x, int max_steps,
                                  TwoPathModel<Real>& model, InitialState<Real>& initial,
                                  Real& damping, std::span<Real> scratch) {
  const Unknowns<Real> at(model, valve == Valve::kPaths);
  UnknownSet constrained = 0;
  for (int k = 0; k < at.ascending + at.descending; ++k) {
    constrained |= UnknownSet{1} << (at.increments() + k);
  }
  Real best = simulate(window, valve, x, model, initial, scratch);
  bool simulated_best = true;  // what scratch holds
  for (int step = 0; step < max_steps; ++step) {
    normal_equations(window, valve, x, model, scratch);
    diagonal_ = hessian_.diagonal();
    read(model, initial, valve);
    bool improved = false;
    const Real before = best;
    while (damping < kWorstDamping) {
      for (Eigen::Index i = 0; i < hessian_.rows(); ++i) {
        hessian_(i, i) = diagonal_(i) + damping * diagonal_(i);
      }
      rhs_ = gradient_;
      for (Eigen::Index j = 0; j < hessian_.cols(); ++j) {
        rhs_ += hessian_.col(j) * now_(j);
      }
      nnls_.solve(hessian_, rhs_, constrained, next_);
      TwoPathModel<Real> trial = model;
      InitialState<Real> trial_initial = initial;
      write(trial, trial_initial, valve);
      if (next_.allFinite() && is_stable(trial.process)) {
        const Real error = simulate(window, valve, x, trial, trial_initial, scratch);
        simulated_best = error < best;
        if (simulated_best) {
          best = error;
          model = trial;
          initial = trial_initial;
          improved = true;
          damping = std::max(damping * Real(0.1), Real(1e-7));
          break;
        }
      }
      damping *= Real(10);
    }
    if (!improved || best > before * Real(0.9999)) {
      damping = Real(10) * kWorstDamping;
      break;
    }
  }
  return simulated_best ? best : simulate(window, valve, x, model, initial, scratch);
}

template class OutputErrorFit<float>;
template class OutputErrorFit<double>;

}  // namespace ident
