// The verdict on the valve as HTML.
#include <gtest/gtest.h>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/report/valve_parts.hpp"

namespace workbench {
namespace {

TEST(ValveParts, NameVerdictNumbersAndCure) {
  const Recording recording = test::simulated(test::SetpointLoop{});
  Analysis analysis(recording);
  const ReportData data{recording, analysis, analysis.simulate(), std::nullopt};
  EXPECT_NE(valve_verdict(data).find("<h1>"), std::string::npos);
  EXPECT_NE(valve_tiles(data).find("class=\"tile\""), std::string::npos);
}

}  // namespace
}  // namespace workbench
