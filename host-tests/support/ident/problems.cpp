#include "support/ident/problems.hpp"

#include <algorithm>
#include <limits>

namespace test {

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

double normal(Random& random) {
  return std::normal_distribution<double>()(random);
}

double objective(const Eigen::MatrixXd& q, const Eigen::VectorXd& c,
                 const Eigen::VectorXd& z) {
  return 0.5 * z.dot(q * z) - c.dot(z);
}

double exhaustive_minimum(const Eigen::MatrixXd& q, const Eigen::VectorXd& c,
                          ident::UnknownSet constrained) {
  const Eigen::Index n = q.rows();
  double best = std::numeric_limits<double>::infinity();
  for (ident::UnknownSet passive = 0; passive < ident::UnknownSet{1} << n; ++passive) {
    std::vector<Eigen::Index> index;
    bool skip = false;
    for (Eigen::Index i = 0; i < n; ++i) {
      const bool in = passive >> i & 1U;
      const bool free = !(constrained >> i & 1U);
      skip = skip || (free && !in);
      if (in) {
        index.push_back(i);
      }
    }
    if (skip) {
      continue;
    }
    Eigen::VectorXd z = Eigen::VectorXd::Zero(n);
    if (!index.empty()) {
      const Eigen::MatrixXd sub = q(index, index);
      const Eigen::VectorXd rhs = c(index);
      const Eigen::VectorXd part = sub.completeOrthogonalDecomposition().solve(rhs);
      z(index) = part;
    }
    bool feasible = true;
    const double slack = 1e-9 * std::max(1.0, z.cwiseAbs().maxCoeff());
    for (const Eigen::Index i : index) {
      if (constrained >> i & 1U) {
        feasible = feasible && z(i) >= -slack;
        z(i) = std::max(z(i), 0.0);
      }
    }
    if (feasible) {
      best = std::min(best, objective(q, c, z));
    }
  }
  return best;
}

}  // namespace test
