// The report: one self-contained HTML page about one recording.
#pragma once

#include <string>

#include "workbench/report/figures.hpp"

namespace workbench {

/// The page: verdict, numbers with intervals, pictures, evidence, model. No external
/// resources; complete without its script; light, dark and printed.
[[nodiscard]] std::string report_page(const ReportData& data);

}  // namespace workbench
