#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>

#include "config/gateway.hpp"
#include "firmware/learn/learn.hpp"
#include "support/base/temporary_folder.hpp"
#include "support/gateway/learnable_bus.hpp"

namespace firmware {
namespace {

class Learning : public testing::Test {
 protected:
  void write(const char* name, const std::string& text) const {
    std::ofstream(files.file(name)) << text << std::flush;
  }
  [[nodiscard]] Learned from_log(const std::string& log, bool with_dbc) const {
    write("bus.log", log);
    write("plant.dbc", workbench::dbc_text());
    return learn({.log = files.file("bus.log"),
                  .dbc = with_dbc ? files.file("plant.dbc") : std::string()});
  }

  TemporaryFolder files;
};

TEST_F(Learning, NamesTheLoopOfADbcFile) {
  const Learned learned = from_log(support::learnable_log("paper-example-1"), true);
  ASSERT_EQ(learned.proposals.size(), 1U) << learned_text(learned);
  const LoopProposal& loop = learned.proposals[0];
  EXPECT_EQ(learned.signals[loop.u].title(), "LoopOP.OP");
  EXPECT_EQ(learned.signals[loop.y].title(), "LoopPV.PV");
  EXPECT_GT(loop.controller_pct, loop.process_pct);
  EXPECT_GT(loop.period_s, 0);
}

TEST_F(Learning, GuessesItWithoutOne) {
  const Learned learned = from_log(support::learnable_log("paper-example-1"), false);
  ASSERT_FALSE(learned.proposals.empty()) << learned_text(learned);
  const LoopProposal& loop = learned.proposals[0];
  EXPECT_EQ(learned.signals[loop.u].signal.frame_id, 0x18EU) << learned_text(learned);
  EXPECT_EQ(learned.signals[loop.y].signal.frame_id, 0x18FU);
  EXPECT_EQ(learned.signals[loop.u].signal.signal.byte_order,
            wire::ByteOrder::kLittleEndian);
  EXPECT_EQ(learned.signals[loop.y].signal.signal.byte_order,
            wire::ByteOrder::kBigEndian);
  for (const SeenSignal& signal : learned.signals) {
    EXPECT_NE(signal.signal.frame_id, 0x300U) << "a counter and a checksum";
    EXPECT_NE(signal.signal.frame_id, 0x302U) << "stands still";
  }
  EXPECT_NE(learned_text(learned).find("Guesses"), std::string::npos);
}

// What is proposed can be pasted: it is a configuration that is valid.
TEST_F(Learning, WhatItProposesIsAConfiguration) {
  for (const bool with_dbc : {true, false}) {
    const Learned learned = from_log(support::learnable_log("paper-example-1"), with_dbc);
    const std::string toml = learned_toml(learned);
    const config::Gateway gateway =
        config::parse_gateway(toml, files.file("gateway.toml"));
    ASSERT_EQ(gateway.loops.size(), learned.proposals.size()) << toml;
    EXPECT_EQ(gateway.loops[0].u.signal.frame_id, 0x18EU) << toml;
    EXPECT_EQ(gateway.buses[0].interface, "can0");
  }
}

// Two loops with names and setpoints that stand still, as a plant numbers them.
std::string two_loops_log() {
  std::array<workbench::SimulatedLoop, 2> loops{
      *workbench::simulate("paper-example-1", 1),
      *workbench::simulate("paper-example-1", 5)};
  std::string log;
  for (std::size_t k = 0; k < loops[0].t.size() && k < loops[1].t.size(); ++k) {
    for (int n = 0; n < 2; ++n) {
      const workbench::SimulatedLoop& loop = loops[static_cast<std::size_t>(n)];
      const auto count = [](double value) {
        return static_cast<unsigned>(std::lround(100 * value + 20'000)) & 0xFFFF;
      };
      const auto swapped = [&](double value) {
        return (count(value) & 0xFF) << 8 | count(value) >> 8;
      };
      char lines[160];
      std::snprintf(lines, sizeof lines,
                    "(%.3f) can0 1%d1#%04X%04X\n(%.3f) can0 1%d0#%04X\n",
                    1000 + loop.t[k] + 0.01 * n, n + 1, swapped(loop.y[k]), swapped(0),
                    1000 + loop.t[k] + 0.01 * n + 0.005, n + 1, swapped(loop.u[k]));
      log += lines;
    }
  }
  return log;
}

constexpr const char* kTwoLoops =
    "VERSION \"\"\n\nBU_: A\n\n"
    "BO_ 272 L1OP: 2 A\n SG_ OP : 0|16@1+ (0.01,-200) [0|0] \"%\" A\n\n"
    "BO_ 273 L1PV: 4 A\n SG_ PV : 0|16@1+ (0.01,-200) [0|0] \"degC\" A\n"
    " SG_ SP : 16|16@1+ (0.01,-200) [0|0] \"degC\" A\n\n"
    "BO_ 288 L2OP: 2 A\n SG_ OP : 0|16@1+ (0.01,-200) [0|0] \"%\" A\n\n"
    "BO_ 289 L2PV: 4 A\n SG_ PV : 0|16@1+ (0.01,-200) [0|0] \"degC\" A\n"
    " SG_ SP : 16|16@1+ (0.01,-200) [0|0] \"degC\" A\n";

TEST_F(Learning, PairsTheSignalsOfOneLoopWithItsOwnSetpoint) {
  write("bus.log", two_loops_log());
  write("plant.dbc", kTwoLoops);
  const Learned learned =
      learn({.log = files.file("bus.log"), .dbc = files.file("plant.dbc")});
  ASSERT_EQ(learned.proposals.size(), 2U) << learned_text(learned);
  for (const LoopProposal& loop : learned.proposals) {
    const std::string number = learned.signals[loop.u].title().substr(0, 2);
    EXPECT_EQ(learned.signals[loop.u].title(), number + "OP.OP");
    EXPECT_EQ(learned.signals[loop.y].title(), number + "PV.PV");
    ASSERT_TRUE(loop.sp) << learned_text(learned);
    EXPECT_EQ(learned.signals[*loop.sp].title(), number + "PV.SP");
  }
}

TEST_F(Learning, TextKeepsTo80Columns) {
  for (const bool with_dbc : {true, false}) {
    const std::string text =
        learned_text(from_log(support::learnable_log("paper-example-1"), with_dbc));
    const std::string table = text.substr(0, text.find("\nTo paste into"));
    std::size_t begin = 0;
    while (begin < table.size()) {
      const std::size_t end = std::min(table.find('\n', begin), table.size());
      std::size_t columns = 0;
      for (const char c : table.substr(begin, end - begin)) {
        columns += (static_cast<unsigned char>(c) & 0xC0) != 0x80 ? 1 : 0;
      }
      EXPECT_LE(columns, 80U) << table.substr(begin, end - begin);
      begin = end + 1;
    }
  }
}

TEST_F(Learning, ReadsCanFd) {
  std::string log;
  for (int k = 0; k < 400; ++k) {
    char line[200];
    std::snprintf(line, sizeof line, "(%.2f) can0 123##1%0124d%02X%02X\n", 1000 + 0.1 * k,
                  0, (k * k / 16) & 0xFF, k * k / 4096 & 0xFF);
    log += line;
  }
  const Learned learned = from_log(log, false);
  ASSERT_EQ(learned.signals.size(), 1U) << learned_text(learned);
  EXPECT_EQ(learned.signals[0].signal.signal.start, 62 * 8);
  EXPECT_TRUE(learned.survey.all()[0]->fd);
  EXPECT_TRUE(learned.proposals.empty());
  EXPECT_EQ(learned_toml(learned), "");
}

TEST_F(Learning, SaysWhatIsWrongWithItsFiles) {
  EXPECT_THROW(static_cast<void>(learn({.log = files.file("none.log")})),
               config::ConfigError);
  EXPECT_THROW(static_cast<void>(from_log("nonsense\n", false)), config::ConfigError);
  EXPECT_THROW(static_cast<void>(from_log("\n", false)), config::ConfigError);
  EXPECT_EQ(from_log("(1.0) can0 123#00\n(1.1) can0 12", false).cut_line, 2U);
  EXPECT_THROW(static_cast<void>(learn({.can = "nocan9"})), std::runtime_error);
  write("bus.log", "(1.0) can0 123#00\n");
  EXPECT_THROW(static_cast<void>(
                   learn({.log = files.file("bus.log"), .dbc = files.file("none.dbc")})),
               config::ConfigError);
}

}  // namespace
}  // namespace firmware
