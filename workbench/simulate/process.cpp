#include "workbench/simulate/process.hpp"

#include <algorithm>
#include <cmath>

namespace workbench {

Process::Matrix Process::exponential(const Matrix& rate, double duration) {
  double norm = 0;
  for (const auto& row : rate) {
    double sum = 0;
    for (const double value : row) sum += std::abs(value * duration);
    norm = std::max(norm, sum);
  }
  int halvings = 0;
  while (std::ldexp(norm, -halvings) > 0.5) ++halvings;

  const auto multiply = [](const Matrix& a, const Matrix& b) {
    Matrix c{};
    for (int i = 0; i < kSize; ++i)
      for (int k = 0; k < kSize; ++k)
        for (int j = 0; j < kSize; ++j) c[i][j] += a[i][k] * b[k][j];
    return c;
  };

  const double step = std::ldexp(duration, -halvings);
  Matrix result{};
  Matrix term{};
  for (int i = 0; i < kSize; ++i) result[i][i] = term[i][i] = 1;
  // 0.5^16 / 16! is far below the rounding of 1.
  for (int n = 1; n <= 16; ++n) {
    term = multiply(term, rate);
    for (auto& row : term)
      for (double& value : row) value *= step / n;
    for (int i = 0; i < kSize; ++i)
      for (int j = 0; j < kSize; ++j) result[i][j] += term[i][j];
  }
  for (; halvings > 0; --halvings) result = multiply(result, result);
  return result;
}

Process::Process(const ProcessModel& model, double period_s) : gain_(model.gain) {
  // A chain of first-order stages, each fed by the one before; the last column
  // is the held input.
  Matrix rate{};
  const auto append = [&](double decay, double drive) {
    const int source = order_ == 0 ? kStates : order_ - 1;
    rate[order_][order_] = -decay;
    rate[order_][source] = drive;
    ++order_;
  };
  if (model.lag_s > 0) append(1 / model.lag_s, 1 / model.lag_s);
  if (model.second_lag_s > 0) append(1 / model.second_lag_s, 1 / model.second_lag_s);
  if (model.integrating) append(0, 1);

  const double delay = model.dead_time_s / period_s;
  // A dead time meant as whole samples must not become a sliver of one.
  const double whole = std::floor(delay + 1e-9);
  const double fraction = std::max(0.0, delay - whole);
  first_part_ = exponential(rate, fraction * period_s);
  second_part_ = exponential(rate, (1 - fraction) * period_s);
  held_.assign(static_cast<std::size_t>(whole) + 2, 0.0);
}

void Process::move(const Matrix& transition, double input) {
  std::array<double, kStates> next{};
  for (int i = 0; i < order_; ++i) {
    next[i] = transition[i][kStates] * input;
    for (int j = 0; j < order_; ++j) next[i] += transition[i][j] * state_[j];
  }
  state_ = next;
}

void Process::advance(double input) {
  const std::size_t size = held_.size();
  held_[next_] = input;
  const double newer = held_[(next_ + 2) % size];
  const double older = held_[(next_ + 1) % size];
  next_ = (next_ + 1) % size;
  move(first_part_, older);
  move(second_part_, newer);
  output_ = gain_ * (order_ == 0 ? newer : state_[order_ - 1]);
}

}  // namespace workbench
