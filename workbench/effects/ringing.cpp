#include "workbench/effects/ringing.hpp"

#include <Eigen/Dense>
#include <numbers>
#include <unsupported/Eigen/MatrixFunctions>

namespace workbench {
namespace {

// First storage, second lag, the ringing pair (its output and the slope of that, in units
// of the natural frequency), and the input, which stays.
constexpr int kStates = 5;
using Matrix = Eigen::Matrix<double, kStates, kStates>;
using Vector = Eigen::Matrix<double, kStates, 1>;
constexpr int kFirst = 0;
constexpr int kSecond = 1;
constexpr int kPair = 2;
constexpr int kSlope = 3;
constexpr int kInput = 4;

double frequency(const ProcessShape& shape) {
  return 2 * std::numbers::pi / shape.ring_period_s;
}

// The pair, driven by state `from`.
void drive_pair(const ProcessShape& shape, int from, Matrix& a) {
  const double w = frequency(shape);
  a(kPair, kSlope) = w;
  a(kSlope, from) += w;
  a(kSlope, kPair) = -w;
  a(kSlope, kSlope) = -2 * shape.ring_damping * w;
}

}  // namespace

void ring_behind_lags(const ProcessShape& shape, double period_s,
                      std::span<const double> in, std::span<double> out) {
  if (in.empty()) return;
  Matrix a = Matrix::Zero();
  int last = kInput;
  if (shape.integrating) {
    a(kFirst, kInput) = 1;
    last = kFirst;
  } else if (shape.first_lag_s > 0) {
    a(kFirst, kInput) = 1 / shape.first_lag_s;
    a(kFirst, kFirst) = -1 / shape.first_lag_s;
    last = kFirst;
  }
  if (shape.second_lag_s > 0) {
    a(kSecond, last) = 1 / shape.second_lag_s;
    a(kSecond, kSecond) = -1 / shape.second_lag_s;
    last = kSecond;
  }
  drive_pair(shape, last, a);
  const Matrix step = (a * period_s).exp();
  Vector x = Vector::Zero();
  if (!shape.integrating) {
    x[kFirst] = x[kSecond] = x[kPair] = in[0] + shape.start;
  }
  for (std::size_t k = 0; k < in.size(); ++k) {
    x[kInput] = in[k];
    out[k] = x[kPair];
    x = (step * x).eval();
  }
}

void ring(const ProcessShape& shape, double period_s, std::span<double> signal) {
  if (signal.empty()) return;
  Matrix a = Matrix::Zero();
  drive_pair(shape, kInput, a);
  const Matrix step = (a * period_s).exp();
  Vector x = Vector::Zero();
  x[kPair] = signal[0];
  for (std::size_t k = 0; k < signal.size(); ++k) {
    const double next = k + 1 < signal.size() ? signal[k + 1] : signal[k];
    x[kInput] = (signal[k] + next) / 2;
    signal[k] = x[kPair];
    x = (step * x).eval();
  }
}

void ring_off(const ProcessShape& shape, double period_s, std::span<double> even,
              std::span<double> odd) {
  Matrix a = Matrix::Zero();
  drive_pair(shape, kInput, a);
  const Matrix step = (a * period_s).exp();
  Vector x = Vector::Zero();
  Vector z = Vector::Zero();
  x[kPair] = 1;
  z[kSlope] = 1;
  for (std::size_t k = 0; k < even.size(); ++k) {
    even[k] = x[kPair];
    odd[k] = z[kPair];
    x = (step * x).eval();
    z = (step * z).eval();
  }
}

}  // namespace workbench
