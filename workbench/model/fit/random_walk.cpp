#include "workbench/model/fit/random_walk.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "workbench/model/base/noise.hpp"
#include "workbench/model/fit/parameter_search.hpp"

namespace workbench {
namespace {

class Random {
 public:
  double uniform() {
    return (static_cast<double>(next_random(state_) >> 11U) + 0.5) * 0x1p-53;
  }
  double normal() {
    const double radius = std::sqrt(-2 * std::log(uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
  }

 private:
  std::uint64_t state_ = 1;
};

// Mean and covariance of the points so far, with its Cholesky factor.
class Shape {
 public:
  explicit Shape(std::size_t n) : n_(n), mean_(n), cov_(n * n), factor_(n * n) {}

  void add(const std::vector<double>& x) {
    ++count_;
    const double share = 1 / static_cast<double>(count_);
    std::vector<double> before(n_);
    for (std::size_t i = 0; i < n_; ++i) before[i] = x[i] - mean_[i];
    for (std::size_t i = 0; i < n_; ++i) mean_[i] += share * before[i];
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        double& c = cov_[i * n_ + j];
        c += share * (before[i] * (x[j] - mean_[j]) - c);
      }
    }
  }
  void factor(const std::vector<double>& scale) {
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        double sum = cov_[i * n_ + j];
        if (i == j) sum += 1e-4 * scale[i] * scale[i];
        for (std::size_t k = 0; k < j; ++k)
          sum -= factor_[i * n_ + k] * factor_[j * n_ + k];
        factor_[i * n_ + j] = i == j
                                  ? std::sqrt(std::max(sum, 1e-8 * scale[i] * scale[i]))
                                  : sum / factor_[j * n_ + j];
      }
    }
  }
  [[nodiscard]] double row(std::size_t i, const std::vector<double>& z) const {
    double sum = 0;
    for (std::size_t k = 0; k <= i; ++k) sum += factor_[i * n_ + k] * z[k];
    return sum;
  }

 private:
  std::size_t n_;
  std::size_t count_ = 0;
  std::vector<double> mean_;
  std::vector<double> cov_;
  std::vector<double> factor_;
};

// Proposes the next point of a walk: first one parameter at a time, whose scales follow
// what is accepted, then along the shape of what was visited, too.
class Proposal {
 public:
  Proposal(std::vector<double> scale, std::vector<double> here)
      : own_(std::move(scale)), shape_(own_.size()), here_(std::move(here)) {}

  [[nodiscard]] const std::vector<double>& here() const { return here_; }

  [[nodiscard]] std::vector<double> next(int step, Random& random) {
    const std::size_t n = own_.size();
    std::vector<double> next = here_;
    if (step < learnt() || step % 3 == 0) {
      const std::size_t j =
          static_cast<std::size_t>(step) / (step < learnt() ? 1 : 3) % n;
      const double reach = random.uniform() < 0.2 ? 5 : 1;
      next[j] += 2.4 * reach * own_[j] * random.normal();
      return next;
    }
    if (step % 50 == 1 || step <= learnt() + 3) shape_.factor(own_);
    std::vector<double> z(n);
    for (double& value : z) value = random.normal();
    const double reach =
        2.38 / std::sqrt(static_cast<double>(n)) * (random.uniform() < 0.3 ? 0.2 : 1);
    for (std::size_t j = 0; j < n; ++j) next[j] += reach * shape_.row(j, z);
    return next;
  }

  // Whether the point was accepted.
  void take(int step, const std::vector<double>& next, bool accepted) {
    if (accepted) here_ = next;
    if (step < learnt()) {
      own_[static_cast<std::size_t>(step) % own_.size()] *= accepted ? 1.5 : 0.75;
    }
    shape_.add(here_);
  }

 private:
  // Points before the shape is used.
  [[nodiscard]] int learnt() const { return 20 * static_cast<int>(own_.size()); }

  std::vector<double> own_;
  Shape shape_;
  std::vector<double> here_;
};

}  // namespace

Walk walk_around(FreeRun& run, const std::vector<double>& start,
                 const std::vector<double>& scale, double variance, int steps) {
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < run.slots().size(); ++i) {
    if (FreeRun::is_searched(run.slots(), start, i)) free.push_back(i);
  }
  const std::size_t n = free.size();
  Walk walk;
  if (n == 0 || !(variance > 0)) return walk;
  Random random;
  std::vector<double> own(n);
  std::vector<double> here(n);
  std::vector<double> p = start;
  for (std::size_t j = 0; j < n; ++j) {
    own[j] = scale[free[j]];
    here[j] = to_search(run.slots()[free[j]].parameter, start[free[j]]);
  }
  Proposal proposal(std::move(own), std::move(here));
  double error = run.run(p);
  std::vector<double> coefficients(run.coefficients().begin(), run.coefficients().end());
  for (int step = 0; step < steps; ++step) {
    const std::vector<double> next = proposal.next(step, random);
    bool inside = true;
    for (std::size_t j = 0; j < n; ++j) {
      const SearchedParameter& parameter = run.slots()[free[j]].parameter;
      p[free[j]] = from_search(parameter, next[j]);
      inside = inside && p[free[j]] >= parameter.low && p[free[j]] <= parameter.high;
    }
    bool taken = false;
    if (inside) {
      const double there = run.run(p);
      taken = std::log(random.uniform()) < 0.5 * (error - there) / variance;
      if (taken) {
        error = there;
        coefficients.assign(run.coefficients().begin(), run.coefficients().end());
      }
    }
    proposal.take(step, next, taken);
    if (4 * step < steps) continue;
    std::vector<double> at(run.slots().size());
    for (std::size_t i = 0; i < at.size(); ++i) {
      at[i] = to_search(run.slots()[i].parameter, start[i]);
    }
    for (std::size_t j = 0; j < n; ++j) at[free[j]] = proposal.here()[j];
    walk.p.push_back(std::move(at));
    walk.coefficients.push_back(coefficients);
  }
  return walk;
}

}  // namespace workbench
