// Where a model fails: its residual in physical coordinates, largest share first.
#pragma once

#include <string>
#include <vector>

#include "workbench/effects/catalogue.hpp"
#include "workbench/model/base/model.hpp"
#include "workbench/model/base/work.hpp"
#include "workbench/model/judge/quality.hpp"
#include "workbench/recording/recording.hpp"

namespace workbench {

/// One place in one view where more of the squared error lies than of the samples.
struct Failure {
  View view = View::kTime;
  std::string where;          ///< "u just after an ascending reversal"
  double share_of_error = 0;  ///< 0 … 1
  double share_of_samples = 0;
  double mean_residual = 0;  ///< y minus model there, units of the output
  double t_from = 0;         ///< s; the worst stretch of it
  double t_to = 0;
  std::string recording{};  ///< whose time that is; empty where there is only one
  std::size_t first = 0;    ///< the same stretch in samples, [first, last)
  std::size_t last = 0;
};

/// One view: the residual over a coordinate, for pictures.
struct ViewCurve {
  View view = View::kTime;
  std::string coordinate;           ///< axis label with unit
  std::vector<double> position;     ///< middle of each bin, units of the coordinate
  std::vector<double> mean;         ///< mean residual in it, units of the output
  std::vector<double> error_share;  ///< share of the squared error in it
  std::vector<double> sample_share;
};

/// The residual against white noise. Autocorrelations at lags 1 … 20 of white noise lie
/// within 1.96/√N in 19 of 20 cases; `white` asks for the sum of their squares (Ljung
/// and Box 1978, 1 % level).
struct Whiteness {
  bool white = false;
  double bound = 0;  ///< 1.96/√N
  std::vector<double> autocorrelation;
  double effective_samples = 0;  ///< N less what the colour of the residual costs
  bool follows_u = false;        ///< what is left still depends on u
};

struct Comparison {
  FitQuality quality;
  std::vector<std::string> effects;
  /// Those of `effects` that belong to the recording the model was fitted to, which is
  /// another one: not simulated.
  std::vector<std::string> stayed_behind;
  Whiteness residual_test;
  std::vector<Failure> failures;  ///< largest share of the error first
  std::vector<ViewCurve> views;   ///< one for each View
  std::vector<double> simulated;  ///< free run, as long as the recording
  std::vector<double> residual;
};

/// Compares a model with a recording; on another one than it was fitted to only the
/// initial state is estimated. Throws InputError as explain() does, and as Work::check().
/// O(samples).
[[nodiscard]] Comparison compare(const Recording& recording, const Model& model,
                                 const Catalogue& catalogue = standard_catalogue(),
                                 const Work& work = Work::unlimited());

[[nodiscard]] std::string_view name_of(View view);

}  // namespace workbench
