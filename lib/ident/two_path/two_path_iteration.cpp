#include "ident/two_path/two_path_iteration.hpp"

#include <algorithm>
#include <cmath>

#include "ident/two_path/step_layout.hpp"

namespace ident {
namespace {

// Of the parts of an iteration, thousands of instructions of a Cortex-M4F, most.
constexpr int kCostOfSums = 85;
constexpr int kCostOfInput = 50;
constexpr int kCostOfProcess = 15;

/// Turns sums over hats into sums over step functions, within each path.
template <class Derived>
void accumulate_steps(Eigen::MatrixBase<Derived>& sums, Eigen::Index ascending_hats) {
  for (Eigen::Index i = sums.size() - 2; i >= 0; --i) {
    if (i + 1 != ascending_hats) {
      sums(i) += sums(i + 1);
    }
  }
}

// The normal equations of the increments, from the sums over step functions.
template <class Real>
void add_increments(const Layout<Real>& layout, const HatSquare<Real>& hats,
                    const HatColumn<Real>& hat_sum, const HatColumn<Real>& hat_rhs,
                    HatSquare<Real>& normal, HatColumn<Real>& rhs) {
  for (int k = 0; k < layout.count; ++k) {
    const StepRange row = layout.ranges[k];
    const Real row_weight = Real(1) / static_cast<Real>(row.last - row.first);
    Real with_offset = 0;
    Real with_one = 0;
    Real with_target = 0;
    for (Eigen::Index i = row.first; i < row.last; ++i) {
      with_offset += hats(i, 0);
      with_one += hat_sum(i);
      with_target += hat_rhs(i);
    }
    normal(2 + k, 0) = normal(0, 2 + k) = with_offset * row_weight;
    normal(2 + k, 1) = normal(1, 2 + k) = with_one * row_weight;
    rhs(2 + k) = with_target * row_weight;
    for (int l = 0; l <= k; ++l) {
      const StepRange column = layout.ranges[l];
      Real sum = 0;
      for (Eigen::Index i = row.first; i < row.last; ++i) {
        for (Eigen::Index j = column.first; j < column.last; ++j) {
          sum += hats(i, j);
        }
      }
      const Real weight = row_weight / static_cast<Real>(column.last - column.first);
      normal(2 + k, 2 + l) = normal(2 + l, 2 + k) = sum * weight;
    }
  }
}

}  // namespace

template <class Real>
void TwoPathIteration<Real>::begin_paths(const LaggedGram<Real>& gram, const Structure& s,
                                         const Process<Real>& process) {
  const KnotGrid<Real>& grid = gram.grid();
  const Eigen::Index hats = grid.hats();
  const Eigen::Index ascending_hats = grid.ascending.segments + 1;

  hats_.resize(hats, hats);
  gram.filtered(process.nk, process.nb, process.b, hats_);
  hat_rhs_.setZero(hats);
  hat_sum_.setZero(hats);
  Real target_sum = gram.y_sum(0);
  for (int i = 1; i <= process.na; ++i) {
    target_sum += process.a[i - 1] * gram.y_sum(i);
  }
  for (int j = 1; j <= process.nb; ++j) {
    const Real b = process.b[j - 1];
    gram.add_hat_sum(process.nk + j, b, hat_sum_);
    gram.add_y_hats(0, process.nk + j, b, hat_rhs_);
    for (int i = 1; i <= process.na; ++i) {
      gram.add_y_hats(i, process.nk + j, b * process.a[i - 1], hat_rhs_);
    }
  }

  for (Eigen::Index c = 0; c < hats; ++c) {
    auto column = hats_.col(c);
    accumulate_steps(column, ascending_hats);
  }
  for (Eigen::Index c = hats - 2; c >= 0; --c) {
    if (c + 1 != ascending_hats) {
      hats_.col(c) += hats_.col(c + 1);
    }
  }
  accumulate_steps(hat_rhs_, ascending_hats);
  accumulate_steps(hat_sum_, ascending_hats);

  // Unknowns: κ (offset of the ascending path), d, then the increments.
  const Layout<Real> layout(grid, s);
  const Eigen::Index n = 2 + layout.count;
  normal_.setZero(n, n);
  rhs_.setZero(n);
  normal_(0, 0) = hats_(0, 0);
  normal_(0, 1) = normal_(1, 0) = hat_sum_(0);
  normal_(1, 1) = static_cast<Real>(gram.rows());
  rhs_(0) = hat_rhs_(0);
  rhs_(1) = target_sum;
  add_increments(layout, hats_, hat_sum_, hat_rhs_, normal_, rhs_);
  nnls_.start(normal_, rhs_, ((UnknownSet{1} << n) - 1) & ~UnknownSet{3}, slopes_);
}

// The values at the knots that the slopes make.
template <class Real>
void TwoPathIteration<Real>::lay_paths(const KnotGrid<Real>& grid, const Structure& s) {
  const Eigen::Index hats = grid.hats();
  const Eigen::Index ascending_hats = grid.ascending.segments + 1;
  const Layout<Real> layout(grid, s);
  x_.setZero(hats);
  x_.head(ascending_hats).setConstant(slopes_(0));
  for (int k = 0; k < layout.count; ++k) {
    const StepRange range = layout.ranges[k];
    const Real share = slopes_(2 + k) / static_cast<Real>(range.last - range.first);
    const Eigen::Index end = range.first <= ascending_hats ? ascending_hats : hats;
    for (Eigen::Index step = range.first; step < range.last; ++step) {
      x_.segment(step, end - step).array() += share;
    }
  }
}

template <class Real>
void TwoPathIteration<Real>::begin_process(const LaggedGram<Real>& gram,
                                           const Process<Real>& process) {
  const int na = process.na;
  const int nb = process.nb;
  const Eigen::Index n = na + nb + 1;
  normal_.setZero(n, n);
  rhs_.setZero(n);
  for (int i = 0; i < na; ++i) {
    rhs_(i) = -gram.yy(0, i + 1);
    for (int j = 0; j < na; ++j) {
      normal_(i, j) = gram.yy(i + 1, j + 1);
    }
    normal_(i, na + nb) = normal_(na + nb, i) = -gram.y_sum(i + 1);
  }
  normal_(na + nb, na + nb) = static_cast<Real>(gram.rows());
  rhs_(na + nb) = gram.y_sum(0);
  input_ = 0;
}

// The sums of one lag of x.
template <class Real>
void TwoPathIteration<Real>::add_input(const LaggedGram<Real>& gram,
                                       const Process<Real>& process, int j) {
  const int na = process.na;
  const int nb = process.nb;
  const int p = process.nk + j + 1;
  for (int i = 0; i <= na; ++i) {
    hat_rhs_.setZero(x_.size());
    gram.add_y_hats(i, p, Real(1), hat_rhs_);
    const Real sum = hat_rhs_.dot(x_);
    if (i == 0) {
      rhs_(na + j) = sum;
    } else {
      normal_(i - 1, na + j) = normal_(na + j, i - 1) = -sum;
    }
  }
  for (int k = 0; k <= j; ++k) {
    normal_(na + j, na + k) = normal_(na + k, na + j) =
        gram.xx(p, process.nk + k + 1, x_);
  }
  hat_rhs_.setZero(x_.size());
  gram.add_hat_sum(p, Real(1), hat_rhs_);
  normal_(na + j, na + nb) = normal_(na + nb, na + j) = hat_rhs_.dot(x_);
}

template <class Real>
bool TwoPathIteration<Real>::solve_process(Process<Real>& process) {
  const int na = process.na;
  const int nb = process.nb;
  nnls_.solve(normal_, rhs_, 0, solution_);
  std::copy_n(solution_.data(), na, process.a.begin());
  std::copy_n(solution_.data() + na, nb, process.b.begin());
  process.d = solution_(na + nb);
  return solution_.allFinite();
}

template <class Real>
void TwoPathIteration<Real>::begin(const LaggedGram<Real>& gram,
                                   const Structure& structure,
                                   TwoPathModel<Real>& model) {
  gram_ = &gram;
  model_ = &model;
  structure_ = structure;
  model.process = {};
  model.process.na = structure.na;
  model.process.nb = structure.nb;
  model.process.nk = structure.nk;
  model.ascending = gram.grid().ascending;
  model.descending = gram.grid().descending;
  solved_ = false;
}

template <class Real>
void TwoPathIteration<Real>::start(const LaggedGram<Real>& gram,
                                   const Structure& structure,
                                   TwoPathModel<Real>& model) {
  begin(gram, structure, model);
  model.process.b[0] = 1;  // Step 1
  slopes_.setZero(2 + structure.segments_ascending + structure.segments_descending);
  iteration_ = 0;
  linear_ = false;
  part_ = Part::kSums;
}

// Equation (6); x takes the scale, so that the model stays the same. False if b is 0.
template <class Real>
bool TwoPathIteration<Real>::normalise(Process<Real>& process) {
  Real norm = 0;
  Real sum = 0;
  for (int j = 0; j < process.nb; ++j) {
    norm += process.b[j] * process.b[j];
    sum += process.b[j];
  }
  norm = std::sqrt(norm);
  if (!(norm > Real(0))) {
    return false;
  }
  const Real scale = sum < Real(0) ? -norm : norm;
  for (int j = 0; j < process.nb; ++j) {
    process.b[j] /= scale;
  }
  x_ *= scale;
  return true;
}

// Equation (7).
template <class Real>
bool TwoPathIteration<Real>::settled(const Process<Real>& process) const {
  Real change = 0;
  Real size = 0;
  const auto compare = [&](Real now, Real then) {
    change += (now - then) * (now - then);
    size += now * now;
  };
  for (int i = 0; i < process.na; ++i) {
    compare(process.a[i], previous_.a[i]);
  }
  for (int j = 0; j < process.nb; ++j) {
    compare(process.b[j], previous_.b[j]);
  }
  compare(process.d, previous_.d);
  for (Eigen::Index i = 0; i < x_.size(); ++i) {
    compare(x_(i), previous_x_(i));
  }
  return change < kTolerance * kTolerance * size;
}

template <class Real>
void TwoPathIteration<Real>::end_iteration() {
  Process<Real>& process = model_->process;
  part_ = Part::kDone;
  const bool finite = solve_process(process);
  if (linear_) {
    solved_ = finite;
  } else if (finite && normalise(process)) {
    if (++iteration_ == kMaxIterations || (iteration_ > 1 && settled(process))) {
      finish();
    } else {
      part_ = Part::kSums;
    }
  }
}

template <class Real>
bool TwoPathIteration<Real>::step() {
  const Process<Real>& process = model_->process;
  switch (part_) {
    case Part::kSums:
      previous_ = process;
      previous_x_ = x_;
      begin_paths(*gram_, structure_, process);
      part_ = Part::kPaths;
      break;
    case Part::kPaths:
      if (nnls_.step()) {
        lay_paths(gram_->grid(), structure_);
        begin_process(*gram_, process);
        part_ = Part::kInputs;
      }
      break;
    case Part::kInputs:
      add_input(*gram_, process, input_);
      if (++input_ == process.nb) {
        part_ = Part::kProcess;
      }
      break;
    case Part::kProcess:
      end_iteration();
      break;
    case Part::kDone:
      break;
  }
  return done();
}

template <class Real>
int TwoPathIteration<Real>::cost_of_step() const {
  switch (part_) {
    case Part::kSums:
      return kCostOfSums;
    case Part::kPaths:
      return nnls_.cost_of_step();
    case Part::kInputs:
      return kCostOfInput;
    case Part::kProcess:
    case Part::kDone:
      break;
  }
  return kCostOfProcess;
}

template <class Real>
void TwoPathIteration<Real>::finish() {
  TwoPathModel<Real>& model = *model_;
  const int ascending = model.ascending.segments + 1;
  std::copy_n(x_.data(), ascending, model.ascending.x.begin());
  std::copy_n(x_.data() + ascending, model.descending.segments + 1,
              model.descending.x.begin());
  solved_ = x_.allFinite();
}

template <class Real>
void TwoPathIteration<Real>::start_linear(const LaggedGram<Real>& gram,
                                          const Structure& structure,
                                          TwoPathModel<Real>& model) {
  begin(gram, structure, model);
  model.ascending.x = model.ascending.knots;
  model.descending.x = model.descending.knots;
  x_.resize(gram.grid().hats());
  const int ascending = model.ascending.segments + 1;
  std::copy_n(model.ascending.x.begin(), ascending, x_.data());
  std::copy_n(model.descending.x.begin(), model.descending.segments + 1,
              x_.data() + ascending);
  begin_process(gram, model.process);
  linear_ = true;
  part_ = Part::kInputs;
}

template class TwoPathIteration<float>;
template class TwoPathIteration<double>;

}  // namespace ident
