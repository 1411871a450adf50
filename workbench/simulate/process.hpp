// The controlled process, discretised exactly behind a zero-order hold.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace workbench {

/// G(s) = gain · L(s) · e^{-dead_time s} / ((lag s + 1)(second_lag s + 1)), with
/// L(s) = 1, or 1/s where `integrating`. A lag of 0 is absent.
struct ProcessModel {
  double gain = 1;          ///< units of y per unit of x; per second where integrating
  double lag_s = 0;         ///< first time constant, >= 0
  double second_lag_s = 0;  ///< second time constant, >= 0
  double dead_time_s = 0;   ///< any value >= 0, not only whole samples
  bool integrating = false;
};

/// Simulates a ProcessModel one sample at a time. The input is held over the
/// sample period; the state advances by the matrix exponential of the model, so
/// that the output at the sampling instants is exact up to rounding. A dead time
/// of (n + f) periods splits each period: the older held value acts for f of it.
class Process {
 public:
  /// `period_s` > 0.
  Process(const ProcessModel& model, double period_s);
  /// Output y at the present instant. It never depends on the input that is
  /// about to be applied, except where the model has neither lag nor integrator
  /// (a static gain), which answers one sample later here.
  [[nodiscard]] double output() const { return output_; }
  /// Holds `input` for one period and moves on to the next instant.
  void advance(double input);

 private:
  static constexpr int kStates = 3;
  static constexpr int kSize = kStates + 1;  // states and the held input
  using Matrix = std::array<std::array<double, kSize>, kSize>;
  static Matrix exponential(const Matrix& rate, double duration);
  void move(const Matrix& transition, double input);

  Matrix first_part_;   // over the fraction f of a period
  Matrix second_part_;  // over the rest of it
  std::array<double, kStates> state_{};
  std::vector<double> held_;  // ring of the inputs still under way
  std::size_t next_ = 0;
  int order_ = 0;
  double gain_ = 1;
  double output_ = 0;
};

}  // namespace workbench
