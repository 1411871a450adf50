// What the process does when the stem moves by one unit of u.
#pragma once

#include <vector>

#include "workbench/analysis/analysis.hpp"
#include "workbench/report/truth_file.hpp"

namespace workbench {

/// Units of y per unit of u, from the instant of the step on.
struct StepResponse {
  std::vector<double> t;  ///< s
  std::vector<double> y;
};

/// How the two-path model's own measure of x relates to stem travel in units of u:
/// stem = scale · x + shift. Least squares against `stem`, or against u where it is
/// empty.
struct StemScale {
  double scale = 1;
  double shift = 0;
  double r_squared = 1;  ///< of the stem's motion that of the model explains
  /// Enough to tell how far the stem moves for one of x.
  [[nodiscard]] bool is_told() const { return r_squared > 0.5; }
};
[[nodiscard]] StemScale stem_scale(const ident::TwoPathModel<double>& model,
                                   const Simulation& simulation);

/// Of the two-path model's process. Long enough to settle, at most 4 oscillations or the
/// recording. Empty where the scale is not positive.
[[nodiscard]] StepResponse two_path_step(const Identification& result,
                                         const StemScale& scale,
                                         const Simulation& simulation);

/// Of the process behind the physical valve, over `duration_s`. Empty for an integrating
/// process, whose gain the model keeps in another measure.
[[nodiscard]] StepResponse valve_step(const Identification& result,
                                      const Simulation& simulation, double duration_s);

/// Of a known process.
[[nodiscard]] StepResponse true_step(const ProcessModel& process, double period_s,
                                     double duration_s);

}  // namespace workbench
