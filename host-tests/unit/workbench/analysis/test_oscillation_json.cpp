// The detector's JSON.
#include <gtest/gtest.h>

#include "workbench/analysis/oscillation_json.hpp"

namespace workbench {
namespace {

TEST(OscillationJson, TellsPeriodInSeconds) {
  ident::OscillationReport<double> report;
  report.detected = true;
  report.period_samples = 40;
  report.regularity = 3;
  report.amplitude = 1.5;
  report.cycles = 12;
  EXPECT_EQ(oscillation_json(report, 0.5).dump(),
            R"({"schema":1,"detected":true,"period_s":20.0,"regularity":3.0,)"
            R"("amplitude":1.5,"cycles":12})");
}

TEST(OscillationJson, KnowsNoPeriodWithoutOscillation) {
  ident::OscillationReport<double> report;
  report.period_samples = 40;
  const auto json = oscillation_json(report, 0.5);
  EXPECT_TRUE(json["period_s"].is_null());
  EXPECT_TRUE(json["amplitude"].is_null());
}

}  // namespace
}  // namespace workbench
