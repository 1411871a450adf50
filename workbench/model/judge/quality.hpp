// How a fit stands against its recordings: all together, and each for itself.
#pragma once

#include <string>
#include <vector>

#include "workbench/model/fit/fit.hpp"

namespace workbench {

/// One file of those that were joined. Units of the output.
struct RecordingFit {
  std::string file;
  double fit_percent = 0;      ///< contract's fit, all of its samples
  double rmse = 0;             ///< all of its samples
  double rmse_validation = 0;  ///< those of them that were not fitted
  bool judges = false;         ///< nothing was fitted to it but its initial state
};

/// How the model of one fit stands against its recording. Units of the output.
struct FitQuality {
  double fit_percent = 0;      ///< contract's fit, all samples, each file about its mean
  double rmse = 0;             ///< all samples
  double rmse_validation = 0;  ///< samples that were not
  bool output_follows_u = false;  ///< follows_u(), merit.hpp
  std::vector<RecordingFit> recordings{};
};

/// Of the recordings in their order. What judges has part in rmse_validation alone.
[[nodiscard]] FitQuality quality(const Fitter& fitter, const Fit& fit);

}  // namespace workbench
