// The report on a model: one self-contained HTML page on where it fails and what helped.
#pragma once

#include <string>

#include "workbench/report/figures.hpp"
#include "workbench/report/model_figures.hpp"

namespace workbench {

/// The page: with `valve` the verdict on the valve and its pictures first; headline,
/// overlay, error after each step, residual in physical coordinates,
/// candidates with their evidence, parameters with intervals and units. No external
/// resources; complete without its script; light, dark and printed.
[[nodiscard]] std::string model_page(const ModelReport& report,
                                     const ReportData* valve = nullptr);

}  // namespace workbench
