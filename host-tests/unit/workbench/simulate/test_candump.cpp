#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "support/workbench/tiny_loop.hpp"
#include "wire/candump.hpp"
#include "wire/dbc.hpp"
#include "workbench/simulate/candump.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace workbench {
namespace {

TEST(SimulateCandump, FramesByHand) {
  SimulatedLoop loop = test::tiny_loop();
  loop.u = {1, -1};        // 100000 = 0x000186A0 and its complement
  loop.y = {1, -0.00001};  // and -1
  loop.sp = {1, 1};
  std::ostringstream out;
  write_candump(loop, out);
  std::istringstream lines(out.str());
  std::vector<std::string> frames;
  for (std::string line; std::getline(lines, line);) {
    EXPECT_EQ(line.substr(0, 14),
              frames.size() < 3 ? "(1700000000.00" : "(1700000000.50");
    frames.push_back(line.substr(line.find("can0")));
  }
  EXPECT_EQ(frames, (std::vector<std::string>{"can0 18F#000186A0", "can0 18E#A0860100",
                                              "can0 18D#0000803F", "can0 18F#FFFFFFFF",
                                              "can0 18E#6079FEFF"}));
}

TEST(SimulateCandump, RefusesWhatDoesNotFit) {
  SimulatedLoop loop = test::tiny_loop();
  loop.y[1] = 30000;
  std::ostringstream out;
  EXPECT_THROW(write_candump(loop, out), std::out_of_range);
  loop.y[1] = std::nan("");
  EXPECT_THROW(write_candump(loop, out), std::out_of_range);
}

TEST(SimulateCandump, DbcReadsEveryScenarioBack) {
  std::array<wire::DbcMessage, 8> messages;
  std::array<wire::DbcSignal, 8> signals;
  wire::Dbc dbc(messages, signals);
  const std::string text = dbc_text();
  ASSERT_TRUE(dbc.parse(text).ok());
  wire::FrameSignal op;
  wire::FrameSignal pv;
  wire::FrameSignal sp;
  ASSERT_TRUE(dbc.find("LoopOP.OP", op).ok());
  ASSERT_TRUE(dbc.find("LoopPV.PV", pv).ok());
  ASSERT_TRUE(dbc.find("LoopSP.SP", sp).ok());
  EXPECT_EQ(op.frame_id, kOutputFrame);
  EXPECT_EQ(pv.frame_id, kProcessFrame);

  for (const ScenarioInfo& info : scenarios()) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      SCOPED_TRACE(std::string(info.name) + " " + std::to_string(seed));
      const SimulatedLoop loop = *simulate(info.name, seed);
      EXPECT_GT(loop.truth.noise_std, 5 * kSignalScale);
      std::stringstream log;
      write_candump(loop, log);
      std::size_t us = 0;
      std::size_t ys = 0;
      std::size_t sps = 0;
      std::int64_t last_ns = 0;
      for (std::string line; std::getline(log, line);) {
        wire::CandumpLine entry;
        ASSERT_TRUE(wire::parse_candump(line, entry).ok()) << line;
        ASSERT_GT(entry.time_ns, last_ns);
        last_ns = entry.time_ns;
        const double since =
            static_cast<double>(entry.time_ns - 1'700'000'000'000'000'000) * 1e-9;
        double value = 0;
        if (entry.frame.id == kOutputFrame) {
          ASSERT_EQ(wire::extract(op, entry.frame, value), wire::SignalError::kNone);
          ASSERT_NEAR(value, loop.u.at(us), 0.501 * kSignalScale);
          ASSERT_NEAR(since - loop.t[us], 0.0017, 0.000202);
          ++us;
        } else if (entry.frame.id == kProcessFrame) {
          ASSERT_EQ(wire::extract(pv, entry.frame, value), wire::SignalError::kNone);
          ASSERT_NEAR(value, loop.y.at(ys), 0.501 * kSignalScale);
          ASSERT_NEAR(since - loop.t[ys], 0.0002, 0.000202);
          ++ys;
        } else {
          ASSERT_EQ(wire::extract(sp, entry.frame, value), wire::SignalError::kNone);
          ASSERT_NEAR(value, loop.sp.at(us - 1), 1e-6 * (1 + std::abs(value)));
          ++sps;
        }
      }
      EXPECT_EQ(us, loop.u.size());
      EXPECT_EQ(ys, loop.y.size());
      EXPECT_GE(sps, loop.sp.size() / 10);
    }
  }
}

}  // namespace
}  // namespace workbench
