#include <gtest/gtest.h>

#include <array>
#include <string>

#include "firmware/metrics.hpp"

namespace firmware {
namespace {

TEST(Metrics, ShowEveryNumberOfTheTableAsTheWireDoes) {
  std::array<wire::LoopStatus, 2> loops;
  loops[0].id = 1;
  loops[0].tag.assign("A");
  loops[0].flag = true;
  loops[0].stick_band_pct.ascending = 5.0049;
  loops[1].id = 7;
  loops[1].tag.assign("B\\\"");
  wire::GatewayStatus gateway;
  gateway.name.assign("gw");
  std::string text;
  write_metrics({gateway, loops}, "plant", text);
  for (const char* line :
       {"# HELP stickband_loop_input_status state of the inputs: 0 good, 1 missing, ",
        "# HELP stickband_loop_verdict ", ": 0 not_evaluated, 1 ",
        "# HELP stickband_loop_ne107 ",
        "stickband_gateway_info{group=\"plant\",name=\"gw\"} 1\n",
        "# TYPE stickband_loop_verdict gauge\n", "# TYPE stickband_loop_frames counter\n",
        "# TYPE stickband_gateway_textfile_failures counter\n",
        "# TYPE stickband_gateway_refused_keys counter\n",
        "# TYPE stickband_gateway_uptime_s gauge\n",
        "stickband_loop_flag{loop=\"1\",tag=\"A\"} 1\n",
        "stickband_loop_stick_band_ascending_pct{loop=\"1\",tag=\"A\"} 5\n",
        "stickband_loop_stick_band_ascending_pct{loop=\"7\",tag=\"B\\\\\\\"\"} NaN\n"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line << "not in\n" << text;
  }
  for (const wire::LoopField& field : wire::loop_fields()) {
    const std::string head =
        "\nstickband_loop_" + std::string(field.name) + "{loop=\"7\"";
    EXPECT_EQ(text.find(head) != std::string::npos, field.number != nullptr) << head;
  }
  const std::size_t room = text.capacity();
  write_metrics({gateway, loops}, "plant", text);
  EXPECT_EQ(text.capacity(), room);
  EXPECT_LT(text.size(), room);
}

TEST(Metrics, NamesMayHaveAnyCharacter) {
  wire::GatewayStatus gateway;
  gateway.name.assign("Kessel \"Nord\"");
  std::string text;
  write_metrics({gateway, {}}, "a\\b\nc", text);
  EXPECT_NE(text.find("info{group=\"a\\\\b\\nc\",name=\"Kessel \\\"Nord\\\"\"} 1\n"),
            std::string::npos)
      << text.substr(0, 200);
}

}  // namespace
}  // namespace firmware
