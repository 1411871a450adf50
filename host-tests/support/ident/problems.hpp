// Random problems and slow references for the identification tests.
#pragma once

#include <Eigen/Dense>
#include <random>
#include <vector>

#include "ident/base/nnls.hpp"

namespace test {

using Random = std::mt19937_64;

/// Uniform in [low, high].
double uniform(Random& random, double low, double high);
/// Standard normal.
double normal(Random& random);

/// Minimum of ½·zᵀQz − cᵀz, z_i ≥ 0 on `constrained`, by solving every subset of active
/// bounds: 2^k factorisations. Q is made definite by rank-revealing solves, so that it
/// may be singular. Returns the value of the minimum.
double exhaustive_minimum(const Eigen::MatrixXd& q, const Eigen::VectorXd& c,
                          ident::UnknownSet constrained);

/// ½·zᵀQz − cᵀz.
double objective(const Eigen::MatrixXd& q, const Eigen::VectorXd& c,
                 const Eigen::VectorXd& z);

/// The same vector in another precision.
template <class To, class From>
std::vector<To> as(const std::vector<From>& values) {
  return {values.begin(), values.end()};
}

}  // namespace test
