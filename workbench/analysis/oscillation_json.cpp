#include "workbench/analysis/oscillation_json.hpp"

namespace workbench {

nlohmann::ordered_json oscillation_json(const ident::OscillationReport<double>& report,
                                        double period_s) {
  const auto known = [&report](double value) {
    return report.detected ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
  };
  return {{"schema", 1},
          {"detected", report.detected},
          {"period_s", known(report.period_samples * period_s)},
          {"regularity", report.regularity},
          {"amplitude", known(report.amplitude)},
          {"cycles", report.cycles}};
}

}  // namespace workbench
