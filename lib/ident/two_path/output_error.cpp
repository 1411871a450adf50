#include "ident/two_path/output_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "ident/two_path/output_error_unknowns.hpp"

namespace ident {
namespace {

constexpr double kFirstDamping = 1e-3;
constexpr double kLeastDamping = 1e-7;
constexpr double kWorstDamping = 1e6;
constexpr double kLeastGain = 1e-4;  // of the error, or the step was the last
// Slow, being denormal, long before it is nothing; never seen in a sum.
constexpr double kNothing = 1e-30;
// Instructions of a Cortex-M4F: for one product of two sensitivities, times 5, for all
// else at one sample, and what a piece of the equations may take.
constexpr int kPerFiveProducts = 13;
constexpr int kPerSample = 450;
constexpr int kMostOfPiece = 85'000;

}  // namespace

template <class Real>
void OutputErrorFit<Real>::read() {
  const TwoPathModel<Real>& model = *model_;
  const InitialState<Real>& initial = *initial_;
  const Unknowns<Real> at(model, with_paths());
  now_.setZero(at.count());
  std::copy_n(model.process.a.begin(), at.na, now_.data());
  std::copy_n(initial.begin(), at.na, now_.data() + at.initial());
  std::copy_n(model.process.b.begin(), at.nb, now_.data() + at.b());
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
void OutputErrorFit<Real>::write_trial() {
  TwoPathModel<Real>& model = trial_;
  InitialState<Real>& initial = trial_initial_;
  model = *model_;
  initial = *initial_;
  const Unknowns<Real> at(model, with_paths());
  std::copy_n(next_.data(), at.na, model.process.a.begin());
  std::copy_n(next_.data() + at.initial(), at.na, initial.begin());
  std::copy_n(next_.data() + at.b(), at.nb, model.process.b.begin());
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
Real OutputErrorFit<Real>::position(std::ptrdiff_t t) {
  return pass_.valve.at(window_, x_, *model_, t);
}

template <class Real>
HatPair<Real> OutputErrorFit<Real>::pair_at(std::ptrdiff_t t) const {
  if (!with_paths()) {
    return {};
  }
  const bool ascending = window_.ascending[t] != 0;
  const int hats_before = ascending ? 0 : model_->ascending.segments + 1;
  const Path<Real>& path = ascending ? model_->ascending : model_->descending;
  return hats_at(path, hats_before, window_.u[t]);
}

template <class Real>
void OutputErrorFit<Real>::begin_pass() {
  const Unknowns<Real> at(*model_, with_paths());
  hessian_.setZero(at.count(), at.count());
  gradient_.setZero(at.count());
  of_hat_ = {};
  pass_ = {};
  // The inputs before the first sample are held.
  pass_.x.fill(position(0));
  pass_.pair.fill(pair_at(0));
}

// The sensitivities to both paths.
template <class Real>
void OutputErrorFit<Real>::add_paths(std::array<Real, kMaxUnknowns>& row) {
  const Process<Real>& process = model_->process;
  const Unknowns<Real> at(*model_, true);
  const int ascending_hats = model_->ascending.segments + 1;
  const int hats = ascending_hats + model_->descending.segments + 1;
  std::array<Real, kMaxHats>& of_hat = of_hat_[pass_.now];
  of_hat.fill(Real(0));
  for (int j = 0; j < at.nb; ++j) {
    const HatPair<Real>& pair = pass_.pair[process.nk + j];
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

// The equations of the samples up to `end`. Lags share one filter.
template <class Real>
void OutputErrorFit<Real>::add_samples(std::ptrdiff_t end) {
  const Process<Real>& process = model_->process;
  const Unknowns<Real> at(*model_, with_paths());
  const auto advance = [&](Memory& memory, Real input) {
    Real sum = input;
    for (int i = 0; i < process.na; ++i) {
      sum -= process.a[i] * memory[back(i + 1)];
    }
    memory[pass_.now] = sum;
  };
  for (; pass_.next < end; ++pass_.next, pass_.now = (pass_.now + 1) % kRing) {
    const std::ptrdiff_t t = pass_.next;
    if (t > 0) {
      pass_.x.push(position(t - 1));
      pass_.pair.push(pair_at(t - 1));
    }
    std::array<Real, kMaxUnknowns>& row = rows_[pass_.filled];
    advance(pass_.of_y, t > 0 ? -scratch_[t - 1] : Real(0));
    advance(pass_.of_one, Real(1));
    if (pass_.remembers) {
      advance(pass_.impulse, t == 0 ? Real(1) : Real(0));
      Real most = 0;
      for (int i = 0; i < at.na; ++i) {
        most = std::max(most, std::abs(pass_.impulse[back(i)]));
      }
      if (most < Real(kNothing)) {
        pass_.remembers = false;
        pass_.impulse = {};
      }
    }
    for (int i = 0; i < at.na; ++i) {
      row[i] = pass_.of_y[back(i)];
      row[at.initial() + i] = pass_.impulse[back(i)];
    }
    for (int j = 0; j < at.nb; ++j) {
      advance(pass_.of_x[j], pass_.x[process.nk + j]);
      row[at.b() + j] = pass_.of_x[j][pass_.now];
    }
    row[at.d()] = pass_.of_one[pass_.now];
    if (at.paths) {
      add_paths(row);
    }
    errors_[pass_.filled] = window_.y[t] - scratch_[t];
    if (++pass_.filled == kRows) {
      add_rows();
      pass_.filled = 0;
    }
  }
}

template <class Real>
void OutputErrorFit<Real>::finish_pass() {
  if (pass_.filled > 0) {
    for (; pass_.filled < kRows; ++pass_.filled) {
      rows_[pass_.filled].fill(Real(0));
      errors_[pass_.filled] = 0;
    }
    add_rows();
  }
  for (Eigen::Index c = 0; c < hessian_.cols(); ++c) {
    for (Eigen::Index r = 0; r < c; ++r) {
      hessian_(c, r) = hessian_(r, c);
    }
  }
  diagonal_ = hessian_.diagonal();
  read();
}

template <class Real>
void OutputErrorFit<Real>::begin_step() {
  if (steps_left_ == 0) {
    stage_ = Stage::kDone;
    return;
  }
  --steps_left_;
  begin_pass();
  stage_ = Stage::kEquations;
}

// The step at the present damping: begins it.
template <class Real>
void OutputErrorFit<Real>::begin_solution() {
  for (Eigen::Index i = 0; i < hessian_.rows(); ++i) {
    hessian_(i, i) = diagonal_(i) + damping_ * diagonal_(i);
  }
  rhs_ = gradient_;
  for (Eigen::Index j = 0; j < hessian_.cols(); ++j) {
    rhs_ += hessian_.col(j) * now_(j);
  }
  next_ = now_;
  nnls_.start(hessian_, rhs_, constrained_, next_);
  stage_ = Stage::kSolve;
}

// False when its process is not stable.
template <class Real>
bool OutputErrorFit<Real>::take_solution() {
  write_trial();
  return next_.allFinite() && is_stable(trial_.process);
}

template <class Real>
void OutputErrorFit<Real>::take_trial(Real error) {
  const Real before = error_;
  error_ = error;
  *model_ = trial_;
  *initial_ = trial_initial_;
  damping_ = std::max(damping_ * Real(0.1), Real(kLeastDamping));
  if (error_ > before * Real(1 - kLeastGain)) {
    stage_ = Stage::kDone;
    return;
  }
  begin_step();
}

template <class Real>
void OutputErrorFit<Real>::start(const WindowView<Real>& window, std::span<const Real> x,
                                 int max_steps, TwoPathModel<Real>& model,
                                 InitialState<Real>& initial, std::span<Real> scratch) {
  window_ = window;
  x_ = x;
  model_ = &model;
  initial_ = &initial;
  scratch_ = scratch;
  steps_left_ = max_steps;
  damping_ = Real(kFirstDamping);
  const Unknowns<Real> at(model, with_paths());
  constrained_ = 0;
  for (int k = 0; k < at.ascending + at.descending; ++k) {
    constrained_ |= UnknownSet{1} << (at.increments() + k);
  }
  begin_simulation(Stage::kSimulate, model, initial);
}

template <class Real>
void OutputErrorFit<Real>::begin_simulation(Stage stage, const TwoPathModel<Real>& model,
                                            const InitialState<Real>& initial) {
  stage_ = stage;
  simulation_.start(window_, x_, model, initial, scratch_);
}

// The trial was no good: a shorter step, if there is one.
template <class Real>
void OutputErrorFit<Real>::damp() {
  damping_ *= Real(10);
  if (damping_ < Real(kWorstDamping)) {
    begin_solution();
  } else {
    begin_simulation(Stage::kRestore, *model_, *initial_);
  }
}

// So many samples that the piece costs about the same for any number of unknowns.
template <class Real>
int OutputErrorFit<Real>::add_piece() {
  const int n = static_cast<int>(hessian_.cols());
  const int per_sample = kPerSample + n * (n + 12) * kPerFiveProducts / 5;
  const std::ptrdiff_t samples = std::max(kMostOfPiece / per_sample / kRows, 1) * kRows;
  const std::ptrdiff_t from = pass_.next;
  const std::ptrdiff_t end = static_cast<std::ptrdiff_t>(window_.y.size());
  add_samples(std::min(from + samples, end));
  const int cost = static_cast<int>(pass_.next - from) * per_sample / 1000 + 1;
  if (pass_.next == end) {
    finish_pass();
    begin_solution();
  }
  return cost;
}

template <class Real>
int OutputErrorFit<Real>::step() {
  switch (stage_) {
    case Stage::kEquations:
      return add_piece();
    case Stage::kSolve: {
      const int cost = nnls_.cost_of_step();
      if (nnls_.step()) {
        if (take_solution()) {
          begin_simulation(Stage::kTry, trial_, trial_initial_);
        } else {
          damp();
        }
      }
      return cost;
    }
    case Stage::kDone:
      return 0;
    case Stage::kSimulate:
    case Stage::kTry:
    case Stage::kRestore:
      break;
  }
  if (!simulation_.step(kSimulatedAtOnce)) {
    return kCostOfSimulated;
  }
  const Real error = simulation_.error();
  if (stage_ == Stage::kSimulate) {
    error_ = error;
    begin_step();
  } else if (stage_ == Stage::kRestore) {
    error_ = error;
    stage_ = Stage::kDone;
  } else if (error < error_) {
    take_trial(error);
  } else {
    damp();
  }
  return kCostOfSimulated;
}

template class OutputErrorFit<float>;
template class OutputErrorFit<double>;

}  // namespace ident
