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
  const int depth = process.nk + process.nb;
  // x of the last `depth` samples, newest at x_past[0].
  std::array<Real, kMaxNk + kMaxNb + 1> x_past{};
  const auto position = [&](std::ptrdiff_t t) {
    if (valve == Valve::kFixed) {
      return x[t];
    }
    return window.ascending[t] ? model.ascending.at(window.u[t])
                               : model.descending.at(window.u[t]);
  };
  x_past.fill(position(0));
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
    for (int k = depth; k > 0; --k) {
      x_past[k] = x_past[k - 1];
    }
    x_past[0] = position(t);
  }
  return error;
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
  // hat. Lags share one filter; [0] is the newest of the last kMaxNa outputs.
  using Memory = std::array<Real, kMaxNa + 1>;
  Memory of_y{};
  Memory of_one{};
  Memory impulse{};
  std::array<Memory, kMaxNb> of_x{};
  std::array<Memory, kMaxHats> of_hat{};
  Column<Real> row(at.count());

  const auto advance = [&](auto& memory, Real input) {
    Real sum = input;
    for (int i = 0; i < process.na; ++i) {
      sum -= process.a[i] * memory[i];
    }
    for (std::size_t i = memory.size() - 1; i > 0; --i) {
      memory[i] = memory[i - 1];
    }
    memory[0] = sum;
  };
  const auto pair_at = [&](std::ptrdiff_t t) {
    const std::ptrdiff_t s = t > 0 ? t : 0;
    return grid.at(window.u[s], window.ascending[s] != 0);
  };
  const auto position = [&](std::ptrdiff_t t) {
    const std::ptrdiff_t s = t > 0 ? t : 0;
    if (valve == Valve::kFixed) {
      return x[s];
    }
    return window.ascending[s] ? model.ascending.at(window.u[s])
                               : model.descending.at(window.u[s]);
  };

  // The inputs before the first sample are held; fill the lags of x accordingly by
  // running the filter on the samples as they come, starting from zero sensitivity.
  std::array<Real, kMaxHats> hat_input{};
  for (std::ptrdiff_t t = 0; t < n; ++t) {
    advance(of_y, t > 0 ? -simulated[t - 1] : Real(0));
    advance(of_one, Real(1));
    advance(impulse, t == 0 ? Real(1) : Real(0));
    for (int i = 0; i < at.na; ++i) {
      row(i) = of_y[i];
      row(at.initial() + i) = impulse[i];
    }
    for (int j = 0; j < at.nb; ++j) {
      advance(of_x[j], position(t - process.nk - 1 - j));
      row(at.b() + j) = of_x[j][0];
    }
    row(at.d()) = of_one[0];
    if (at.paths) {
      hat_input.fill(Real(0));
      for (int j = 0; j < at.nb; ++j) {
        const HatPair<Real> pair = pair_at(t - process.nk - 1 - j);
        hat_input[pair.first] += process.b[j] * (Real(1) - pair.upper);
        hat_input[pair.first + 1] += process.b[j] * pair.upper;
      }
      for (int h = 0; h < hats; ++h) {
        advance(of_hat[h], hat_input[h]);
      }
      // Increments are step functions over the hats.
      Real sum = 0;
      for (int h = ascending_hats - 1; h > 0; --h) {
        sum += of_hat[h][0];
        row(at.increments() + h - 1) = sum;
      }
      row(at.offset()) = sum + of_hat[0][0];
      sum = 0;
      for (int h = hats - 1; h > ascending_hats; --h) {
        sum += of_hat[h][0];
        row(at.increments() + h - 2) = sum;
      }
    }
    const Real e = window.y[t] - simulated[t];
    for (Eigen::Index c = 0; c < row.size(); ++c) {
      const Real value = row(c);
      gradient_(c) += value * e;
      for (Eigen::Index r = 0; r <= c; ++r) {
        hessian_(r, c) += row(r) * value;
      }
    }
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
  for (int step = 0; step < max_steps; ++step) {
    normal_equations(window, valve, x, model, scratch);
    read(model, initial, valve);
    bool improved = false;
    const Real before = best;
    while (damping < kWorstDamping) {
      damped_ = hessian_;
      for (Eigen::Index i = 0; i < damped_.rows(); ++i) {
        damped_(i, i) += damping * hessian_(i, i);
      }
      rhs_ = gradient_;
      for (Eigen::Index j = 0; j < damped_.cols(); ++j) {
        rhs_ += damped_.col(j) * now_(j);
      }
      nnls_.solve(damped_, rhs_, constrained, next_);
      TwoPathModel<Real> trial = model;
      InitialState<Real> trial_initial = initial;
      write(trial, trial_initial, valve);
      if (next_.allFinite() && is_stable(trial.process)) {
        const Real error = simulate(window, valve, x, trial, trial_initial, scratch);
        if (error < best) {
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
  // A rejected trial may have been the last thing simulated.
  return simulate(window, valve, x, model, initial, scratch);
}

template class OutputErrorFit<float>;
template class OutputErrorFit<double>;

}  // namespace ident
