#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/base/temporary_folder.hpp"
#include "wire/candump.hpp"
#include "workbench/recording/can/candump_log.hpp"
#include "workbench/simulate/candump.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace workbench {
namespace {

constexpr std::string_view kDbc =
    "BO_ 399 LoopOP: 8 PLC\n"
    " SG_ OP : 7|16@0+ (0.01,0) [0|100] \"%\" GW\n"
    " SG_ Page M : 16|8@1+ (1,0) [0|0] \"\" GW\n"
    " SG_ Travel m2 : 32|32@1- (1,0) [0|0] \"%\" GW\n"
    " SG_ Other m3 : 32|32@1- (1,0) [0|0] \"%\" GW\n"
    "BO_ 2566852608 LoopPV: 4 PLC\n"
    " SG_ PV : 0|16@1- (0.1,0) [-1000|1000] \"C\" GW\n"
    " SG_ SP : 16|16@1+ (0.1,0) [0|6000] \"C\" GW\n"
    "SIG_VALTYPE_ 399 Travel : 1;\n";

const CandumpOptions kLoop{"LoopOP.OP", "LoopPV.PV", "", "", {}};

struct Frame {
  double t;
  std::uint32_t id;
  std::vector<std::uint8_t> data;
  const char* interface = "can0";
};

Frame op(double t, int percent, std::uint8_t page = 0) {
  const int raw = percent * 100;
  return {t,
          399,
          {static_cast<std::uint8_t>(raw >> 8), static_cast<std::uint8_t>(raw), page, 0,
           0, 0, 0x80, 0x3F}};
}
Frame pv(double t, int value, int setpoint = 0) {
  const int raw = value * 10;
  const int sp = setpoint * 10;
  return {t,
          0x18FF1000,
          {static_cast<std::uint8_t>(raw), static_cast<std::uint8_t>(raw >> 8),
           static_cast<std::uint8_t>(sp), static_cast<std::uint8_t>(sp >> 8)}};
}

std::string log_of(std::vector<Frame> frames) {
  std::stable_sort(frames.begin(), frames.end(),
                   [](const Frame& a, const Frame& b) { return a.t < b.t; });
  std::string text;
  for (const Frame& f : frames) {
    wire::CandumpLine line;
    line.time_ns = 1'000'000'000'000 + std::llround(f.t * 1e6) * 1000;
    line.interface = f.interface;
    line.frame.id = f.id;
    line.frame.extended = f.id > 0x7FF;
    line.frame.dlc = static_cast<std::uint8_t>(f.data.size());
    std::copy(f.data.begin(), f.data.end(), line.frame.data.begin());
    std::array<char, wire::kMaxCandumpLine> out;
    text.append(out.data(), wire::format_candump(line, out));
    text += '\n';
  }
  return text;
}

Recording parse_log(const std::string& log, const CandumpOptions& options = kLoop,
                    std::string_view dbc = kDbc) {
  return parse_candump_log(log, "rec.log", dbc, "plant.dbc", options);
}

InputError error_of_log(const std::string& log, const CandumpOptions& options = kLoop,
                        std::string_view dbc = kDbc) {
  try {
    static_cast<void>(parse_log(log, options, dbc));
  } catch (const InputError& error) {
    return error;
  }
  return {"no error", 0, 0, "", "", ""};
}

TEST(CandumpLog, FramesOfOneCycleArePairedWhateverTheirOrderAndJitter) {
  std::vector<Frame> frames;
  for (int k = 0; k < 50; ++k) {
    const double jitter = 0.002 * ((k * 7) % 5 - 2);
    frames.push_back(op(k + 0.001 + jitter, k));
    frames.push_back(pv(k - (k > 0 ? jitter : 0), 2 * k, 7));
  }
  CandumpOptions options = kLoop;
  options.sp = "LoopPV.SP";
  const Recording r = parse_log(log_of(frames), options);
  EXPECT_NEAR(r.period_s, 1, 1e-3);
  ASSERT_EQ(r.size(), 50U);
  for (int k = 0; k < 50; ++k) {
    EXPECT_EQ(r.u[k], k);
    EXPECT_EQ(r.y[k], 2 * k);
    EXPECT_EQ(r.sp[k], 7);
  }
  EXPECT_EQ(r.resampling.missing, 0U);
  EXPECT_TRUE(r.resampling.resampled);
}

TEST(CandumpLog, AFasterOutputIsHeldAtTheRateOfTheSlowerSignal) {
  std::vector<Frame> frames;
  for (int k = 0; k < 40; ++k) frames.push_back(pv(k, k));
  for (int k = 0; k < 400; ++k) frames.push_back(op(0.1 * k + 0.03, k / 10));
  const Recording r = parse_log(log_of(frames));
  EXPECT_EQ(r.period_s, 1);
  ASSERT_GE(r.size(), 39U);
  for (std::size_t k = 0; k < 39; ++k) {
    EXPECT_EQ(r.y[k], static_cast<double>(k));
    EXPECT_EQ(r.u[k], static_cast<double>(k));
  }
}

TEST(CandumpLog, ASlowerOutputSetsThePeriod) {
  std::vector<Frame> frames;
  for (int k = 0; k < 40; ++k) frames.push_back(op(k + 0.55, k));
  for (int k = 0; k < 400; ++k) frames.push_back(pv(0.1 * k, k));
  const Recording r = parse_log(log_of(frames));
  EXPECT_EQ(r.period_s, 1);
  CandumpOptions options = kLoop;
  options.period_s = 0.1;
  EXPECT_EQ(parse_log(log_of(frames), options).period_s, 0.1);
}

TEST(CandumpLog, AnOutputSentOnChangeIsHeldAtTheRateOfY) {
  std::vector<Frame> frames;
  for (int k = 0; k < 100; ++k) frames.push_back(pv(k, k));
  for (const int k : {0, 3, 10, 12, 40, 77}) frames.push_back(op(k + 0.5, k));
  const Recording r = parse_log(log_of(frames));
  EXPECT_EQ(r.period_s, 1);
  EXPECT_EQ(r.size(), 100U);
  EXPECT_EQ(r.u.back(), 77);
  EXPECT_EQ(r.resampling.missing, 0U);
}

TEST(CandumpLog, GapsAreHeldAndCounted) {
  std::vector<Frame> frames;
  for (int k = 0; k < 100; ++k) {
    if (k >= 40 && k < 45) continue;
    frames.push_back(op(k, k));
    if (k != 70) frames.push_back(pv(k + 0.01, k));
  }
  const Recording r = parse_log(log_of(frames));
  ASSERT_EQ(r.size(), 100U);
  EXPECT_EQ(r.u[44], 39);
  EXPECT_EQ(r.u[45], 45);
  EXPECT_EQ(r.y[70], 69);
  EXPECT_EQ(r.resampling.missing, 6U);
  EXPECT_EQ(r.resampling.longest_gap_s, 6);
}

// A triangle of 80 samples; both signals are silent for a quarter of it.
TEST(CandumpLog, ALongSilenceIsAGap) {
  std::vector<Frame> frames;
  for (int k = 0; k < 400; ++k) {
    if (k >= 200 && k < 220) continue;
    const int value = std::abs(k % 80 - 40);
    frames.push_back(op(k, value));
    frames.push_back(pv(k + 0.01, value));
  }
  const Recording r = parse_log(log_of(frames));
  ASSERT_EQ(r.size(), 400U);
  ASSERT_EQ(r.resampling.gaps.size(), 1U);
  EXPECT_EQ(r.resampling.gaps[0].first, 200U);
  EXPECT_EQ(r.resampling.gaps[0].last, 220U);
  EXPECT_EQ(r.resampling.missing, 20U);
  EXPECT_NE(r.resampling.notes[3].find("1 long gap is not judged"), std::string::npos);
}

TEST(CandumpLog, TheHighestRawNumberFarOutIsNotAvailableWithoutLimits) {
  std::string dbc(kDbc);
  dbc.replace(dbc.find("[0|100]"), 7, "[0|0]");
  std::vector<Frame> frames;
  for (int k = 0; k < 20; ++k) {
    frames.push_back(op(k, k));
    if (k == 5) frames.back().data[0] = frames.back().data[1] = 0xFF;
    frames.push_back(pv(k + 0.3, k));
  }
  EXPECT_EQ(parse_log(log_of(frames), kLoop, dbc).u[5], 4);
  for (int k = 0; k < 20; ++k) {
    frames[static_cast<std::size_t>(2 * k)] = op(k, 30 * k);
  }
  frames[10].data[0] = frames[10].data[1] = 0xFF;
  EXPECT_NEAR(parse_log(log_of(frames), kLoop, dbc).u[5], 655.35, 1e-9)
      << "as likely as any other";
}

TEST(CandumpLog, ACyclicOutputThatFallsSilentEndsTheRecording) {
  std::vector<Frame> frames;
  for (int k = 0; k < 100; ++k) {
    if (k < 60) frames.push_back(op(k, k));
    frames.push_back(pv(k + 0.3, k));
  }
  EXPECT_EQ(parse_log(log_of(frames)).size(), 60U);
}

TEST(CandumpLog, MultiplexedSignalsOnlyFromTheirPage) {
  std::vector<Frame> frames;
  for (int k = 0; k < 20; ++k) {
    frames.push_back(op(k, k, k % 2 == 0 ? 2 : 7));
    frames.push_back(pv(k + 0.3, k));
  }
  CandumpOptions options = kLoop;
  options.x = "LoopOP.Travel";
  EXPECT_EQ(parse_log(log_of(frames), options).x.at(3), 1.0);
  options.x = "LoopOP.Other";
  const InputError e = error_of_log(log_of(frames), options);
  EXPECT_NE(e.found.find("20 with another multiplexor than 3"), std::string::npos)
      << e.what();
}

TEST(CandumpLog, AllBitsSetOutsideTheLimitsMeansNotAvailable) {
  std::vector<Frame> frames;
  for (int k = 0; k < 20; ++k) {
    frames.push_back(op(k, k));
    if (k == 5) frames.back().data[0] = frames.back().data[1] = 0xFF;
    if (k == 7) frames.back().data[0] = 0xF0;
    frames.push_back(pv(k + 0.3, k));
  }
  const Recording r = parse_log(log_of(frames));
  EXPECT_EQ(r.u[5], 4);
  EXPECT_EQ(r.u[7], 6) << "outside the limits, as the gateway does";
  EXPECT_EQ(r.resampling.missing, 2U);
}

TEST(CandumpLog, ASwingThatLimitsCutOffIsKept) {
  std::vector<Frame> frames;
  for (int k = 0; k < 20; ++k) {
    frames.push_back(op(k, 90 + k));
    frames.push_back(pv(k + 0.3, k));
  }
  const Recording r = parse_log(log_of(frames));
  EXPECT_EQ(r.u[15], 105);
  bool noted = false;
  for (const std::string& note : r.resampling.notes) {
    noted |= note.find(
                 "9 frames of u (LoopOP.OP) hold a value just outside its limits, 0 "
                 "to 100: kept") == 0;
  }
  EXPECT_TRUE(noted);
}

TEST(CandumpLog, MostlyHeldIsRefused) {
  std::vector<Frame> frames;
  for (int k = 0; k < 200; ++k) {
    frames.push_back(op(k, k % 90));
    if (k % 12 < 5) frames.push_back(pv(k + 0.01, k));
  }
  const InputError e = error_of_log(log_of(frames));
  EXPECT_NE(e.found.find("instants without one"), std::string::npos) << e.what();
}

TEST(CandumpLog, MostValuesOutsideTheLimitsAreRefused) {
  std::vector<Frame> frames;
  for (int k = 0; k < 20; ++k) {
    frames.push_back(op(k, k));
    if (k % 3 > 0) frames.back().data[0] = 0xF0;
    frames.push_back(pv(k + 0.3, k));
  }
  const InputError e = error_of_log(log_of(frames));
  EXPECT_NE(e.found.find("13 of 20 frames outside"), std::string::npos) << e.what();
}

TEST(CandumpLog, MalformedLinesAreNamed) {
  const InputError e =
      error_of_log("(1.0) can0 18F#0000000000000000\n\n(2.0) can0 18F#00000000zz\n");
  EXPECT_EQ(e.line, 3U);
  EXPECT_EQ(e.column, 24U);
  EXPECT_EQ(e.file, "rec.log");
  EXPECT_EQ(error_of_log("").line, 1U);
}

TEST(CandumpLog, ALastLineThatWasCutIsLeftOutAndNoted) {
  std::vector<Frame> frames;
  for (int k = 0; k < 4; ++k) {
    frames.push_back(op(k, 50 + k));
    frames.push_back(pv(k + 0.1, 200));
  }
  const std::string whole = log_of(frames);
  const Recording cut = parse_log(whole + "(1004.000000) can0 18");
  EXPECT_EQ(cut.size(), parse_log(whole).size());
  EXPECT_EQ(cut.resampling.notes.back(),
            "line 9, the last of the log, is cut and was left out");
  EXPECT_EQ(error_of_log(whole + "(1004.000000) can0 18\n").line, 9U);
}

TEST(CandumpLog, SaysWhichIdentifiersThereAre) {
  const InputError e = error_of_log(
      "(1.0) can0 123#00\n(2.0) can0 123#00\n(2.0) can0 00000123#\n"
      "(2.0) can0 18F#81:00:12345678#11\n");
  EXPECT_NE(e.expected.find("18F of u (LoopOP.OP)"), std::string::npos) << e.what();
  EXPECT_NE(e.found.find("123 (2 frames), 00000123 (1 frames)"), std::string::npos)
      << e.what();
}

TEST(CandumpLog, DbcErrorsNameTheDbcFile) {
  const InputError e = error_of_log("", kLoop, "BO_ 1 A: 8 X\n SG_ S : 0|8@7+\n");
  EXPECT_EQ(e.file, "plant.dbc");
  EXPECT_EQ(e.line, 2U);
  EXPECT_EQ(e.column, 14U);
  CandumpOptions options = kLoop;
  options.u = "Nope.OP";
  EXPECT_NE(error_of_log("", options).found.find("'LoopOP', 'LoopPV'"),
            std::string::npos);
  options.u = "LoopOP.Nope";
  EXPECT_NE(error_of_log("", options).found.find("'OP', 'Page'"), std::string::npos);
  options.u = "LoopOP";
  EXPECT_NE(error_of_log("", options).expected.find("MESSAGE.SIGNAL"), std::string::npos);
}

TEST(CandumpLog, RefusesTwoInterfacesAndStepsBack) {
  std::vector<Frame> frames = {op(0, 1), op(1, 2), pv(0, 1), pv(1, 2)};
  frames[1].interface = "can1";
  EXPECT_NE(error_of_log(log_of(frames)).found.find("can1"), std::string::npos);
  EXPECT_EQ(
      error_of_log("(2.0) can0 18F#0000000000000000\n(1.0) can0 18F#0000000000000000\n")
          .line,
      2U);
}

TEST(CandumpLog, TakesTheGivenInterfaceWhereTheLogHasIt) {
  std::vector<Frame> frames;
  for (int k = 0; k < 20; ++k) {
    for (Frame frame : {op(k, k), pv(k + 0.3, k)}) {
      frames.push_back(frame);
      frame.interface = "can1";
      frame.data.assign(frame.data.size(), 0);
      frames.push_back(frame);
    }
  }
  const TemporaryFolder folder;
  const std::string path = folder.file("two.log");
  std::ofstream(path) << log_of(frames);
  wire::FrameSignal u{.frame_id = 399, .signal = {.length = 16, .scale = 0.01}};
  u.signal.start = 7;
  u.signal.byte_order = wire::ByteOrder::kBigEndian;
  const auto last_of = [&](const char* interface) {
    return read_candump(path, {{Column::u, "u", u, interface}}, {}).u.back();
  };
  EXPECT_EQ(last_of("can0"), 19);
  EXPECT_EQ(last_of("can1"), 0);
  EXPECT_THROW((void)last_of("vcan7"), InputError) << "which of the two is not known";
}

TEST(CandumpLog, NamesLogsOfOtherKinds) {
  const TemporaryFolder folder;
  const std::string path = folder.file("other.csv");
  std::ofstream(path) << "Time Stamp,ID,Extended,Bus,LEN,D1\n1,00000106,false,0,1,00\n";
  try {
    (void)read_candump(path, std::vector<CandumpSignal>{{Column::u, "u", {}}}, {});
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(error.expected, "a candump log");
    EXPECT_NE(error.found.find("SavvyCAN"), std::string::npos) << error.what();
  }
}

TEST(CandumpLog, AParameterGroupOfTwoSendersIsRefused) {
  const std::string dbc =
      "BO_ 2566852862 LoopPV: 4 PLC\n"  // 18FF10FE
      " SG_ PV : 0|16@1- (0.1,0) [0|0] \"C\" GW\n";
  CandumpOptions options;
  options.y = "LoopPV.PV";
  std::vector<Frame> frames;
  for (int k = 0; k < 20; ++k) frames.push_back(pv(k, k));
  EXPECT_EQ(parse_log(log_of(frames), options, dbc).y[7], 7);
  frames[9].id += 0x21;
  const InputError e = error_of_log(log_of(frames), options, dbc);
  EXPECT_NE(e.found.find("0x00 and 0x21"), std::string::npos) << e.what();
}

TEST(CandumpLog, SaysThatTheTimesTellNothing) {
  const InputError same = error_of_log(log_of({op(1, 1), op(1, 2), pv(1, 1), pv(1, 2)}));
  EXPECT_NE(same.found.find("2 frames at the same"), std::string::npos) << same.what();
  std::vector<Frame> bursts;
  for (int k = 0; k < 60; ++k) {
    bursts.push_back(pv(k, k));
    bursts.push_back(pv(k + 1e-5, k));
  }
  CandumpOptions options;
  options.y = "LoopPV.PV";
  const InputError burst = error_of_log(log_of(bursts), options);
  EXPECT_NE(burst.advice.find("--ts 1"), std::string::npos) << burst.what();
}

TEST(CandumpLog, RefusesTooLittleAndTooMuch) {
  EXPECT_FALSE(error_of_log(log_of({op(0, 1), pv(0, 1)})).expected.empty());
  EXPECT_FALSE(error_of_log(log_of({op(0, 1), op(1, 1), op(2, 1), pv(50, 1), pv(51, 1)}))
                   .expected.empty());
  const InputError hole =
      error_of_log(log_of({op(0, 1), op(1, 1), op(2, 1), op(1e7, 1), pv(0, 1), pv(1, 1),
                           pv(2, 1), pv(1e7, 1)}));
  EXPECT_NE(hole.found.find("gap"), std::string::npos) << hole.what();
  CandumpOptions options = kLoop;
  options.period_s = 1e-6;
  EXPECT_NE(error_of_log(log_of({op(0, 1), op(1, 1), pv(0, 1), pv(1, 1)}), options)
                .advice.find("longer"),
            std::string::npos);
  options.period_s = -1;
  EXPECT_THROW(static_cast<void>(parse_log("", options)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(parse_log("", {})), std::invalid_argument);
}

TEST(CandumpLog, XlLinesAndRepeatsAreCounted) {
  std::vector<Frame> frames;
  for (int k = 0; k < 10; ++k) {
    frames.push_back(op(k, k));
    frames.push_back(pv(k, k));
  }
  frames.push_back(pv(4, 99));
  const Recording r = parse_log(log_of(frames) + "(1010.0) can0 7FF#81:00:12345678#11\n");
  EXPECT_EQ(r.resampling.repeated, 1U);
  EXPECT_EQ(r.y[4], 4);
  bool noted = false;
  for (const std::string& note : r.resampling.notes) {
    noted |= note.find("1 CAN XL") != std::string::npos;
  }
  EXPECT_TRUE(noted);
}

TEST(CandumpLog, ASimulatedLoopReadsBackFromItsFrames) {
  for (const ScenarioInfo& scenario : scenarios()) {
    SCOPED_TRACE(scenario.name);
    const SimulatedLoop loop = *simulate(scenario.name, 1);
    std::ostringstream log;
    write_candump(loop, log);
    const CandumpOptions options{"LoopOP.OP", "LoopPV.PV", "LoopSP.SP", "", {}};
    const Recording r = parse_log(log.str(), options, dbc_text());
    ASSERT_EQ(r.size(), loop.t.size());
    EXPECT_NEAR(r.period_s, loop.period_s, 1e-4 * loop.period_s);
    EXPECT_EQ(r.resampling.missing, 0U);
    for (std::size_t k = 0; k < r.size(); ++k) {
      ASSERT_NEAR(r.u[k], loop.u[k], 1e-5) << k;
      ASSERT_NEAR(r.y[k], loop.y[k], 1e-5) << k;
      ASSERT_NEAR(r.sp[k], loop.sp[k], 1e-5 * (1 + std::abs(loop.sp[k]))) << k;
    }
  }
}

}  // namespace
}  // namespace workbench
