// The verdict on the valve, as HTML, for the reports.
#pragma once

#include <string>

#include "workbench/report/figures.hpp"

namespace workbench {

// Each returns HTML.

/// The box of the verdict with reason, cause and what to do.
[[nodiscard]] std::string valve_verdict(const ReportData& data);
/// Stick bands with intervals or the detectable band, oscillation, fit.
[[nodiscard]] std::string valve_tiles(const ReportData& data);

}  // namespace workbench
