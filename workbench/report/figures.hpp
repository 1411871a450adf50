// The pictures of the report.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workbench/analysis/analysis.hpp"
#include "workbench/report/truth_file.hpp"

namespace workbench {

/// What all pictures are drawn from.
struct ReportData {
  const Recording& recording;
  const Analysis& analysis;
  Simulation simulation;
  std::optional<KnownTruth> truth;
  std::vector<std::string> others = {};  ///< recordings of the loop judged with it
};

/// Each returns one or more <figure> elements, or nothing without data for it.
[[nodiscard]] std::string signal_figures(const ReportData& data);
/// Three cycles from the middle; nothing where the whole recording has hardly more.
[[nodiscard]] std::string closer_figures(const ReportData& data);
/// Process output over controller output.
[[nodiscard]] std::string loop_figure(const ReportData& data);
/// Stem position over controller output.
[[nodiscard]] std::string path_figure(const ReportData& data);
[[nodiscard]] std::string step_figure(const ReportData& data);

}  // namespace workbench
