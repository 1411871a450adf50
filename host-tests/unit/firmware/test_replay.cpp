#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "firmware/gateway_loop.hpp"
#include "firmware/replay.hpp"
#include "firmware/replay_report.hpp"

namespace firmware {
namespace {

class Replayed : public testing::Test {
 protected:
  // The log with `seconds` added to the time of its lines from the middle on; with `once`
  // of one line only.
  std::string jumped(double seconds, bool once = false) {
    std::ifstream in(loop.log());
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    const std::string path = loop.folder() + "/jumped.log";
    std::ofstream out(path);
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const bool moved = once ? k == lines.size() / 2 : k >= lines.size() / 2;
      const std::size_t end = lines[k].find(')');
      const double t = std::stod(lines[k].substr(1, end - 1)) + (moved ? seconds : 0);
      char time[64];
      std::snprintf(time, sizeof time, "(%.6f", t);
      out << time << lines[k].substr(end) << '\n';
    }
    return path;
  }
  // Gaps told, s.
  std::vector<double> play(const std::string& log) {
    std::vector<double> gaps;
    Replay replay(loop.gateway());
    EXPECT_TRUE(replay.play(log, [&](const Notice& notice, double) {
      if (notice.kind == NoticeKind::kGap) gaps.push_back(notice.gap_s);
      missed |= notice.kind == NoticeKind::kInputFault;
    })) << replay.error();
    counters = replay.daemon().loops()[0].counters;
    return gaps;
  }

  GatewayLoop loop{"paper-example-1", 1};
  wire::LoopCounters counters;
  bool missed = false;
};

TEST_F(Replayed, AJumpOfTheClockIsToldAsAGapAndTheReplayEnds) {
  constexpr double kYear = 365.25 * 86400;
  for (const double seconds : {3 * 86400.0, 10 * kYear, -3 * 86400.0, -kYear}) {
    missed = false;
    const std::vector<double> gaps = play(jumped(seconds));
    ASSERT_EQ(gaps.size(), 1U) << seconds;
    EXPECT_NEAR(gaps[0], seconds, 10);
    EXPECT_TRUE(missed) << "the input was not there meanwhile";
  }
  EXPECT_EQ(play(jumped(20 * kYear, true)).size(), 2U) << "on and back";
  EXPECT_TRUE(play(loop.log()).empty());
}

// u stays where it is; y moves to another bus, into the last bytes of a CAN FD frame.
TEST_F(Replayed, TwoBusesAndCanFdSayWhatOneBusDoes) {
  const auto band_of = [](const config::Gateway& gateway, const std::string& log) {
    Replay replay(gateway);
    EXPECT_TRUE(replay.play(log, [](const Notice&, double) {})) << replay.error();
    const wire::LoopStatus& status = replay.daemon().loops()[0];
    EXPECT_EQ(status.window_verdict, wire::LoopVerdict::kStiction);
    return status.stick_band_pct.ascending;
  };
  const std::string path = loop.folder() + "/two.log";
  std::ifstream in(loop.log());
  std::ofstream out(path);
  for (std::string line; std::getline(in, line);) {
    const std::size_t at = line.find("can0 18F#");
    if (at != std::string::npos) {
      line.replace(at, 9, "can1 18F##1" + std::string(2 * 60, '0'));
    }
    out << line << '\n';
  }
  out.close();
  std::ifstream file(loop.toml());
  std::string text((std::istreambuf_iterator<char>(file)), {});
  const auto swap = [&text](const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
  };
  swap("[uds]", "[bus.can1]\nbackend = \"socketcan\"\ninterface = \"can1\"\n[uds]");
  swap("[uds]\n[broadcast]\n", "");
  swap(R"({ source = "can", dbc)", R"({ source = "can", bus = "can0", dbc)");
  swap(R"({ source = "can", dbc = "loop.dbc", message = "LoopPV", signal = "PV" })",
       R"({ source = "can", bus = "can1", frame_id = 0x18F, start = 487, length = 32, )"
       R"(byte_order = "big_endian", is_signed = true, scale = 0.00001 })");
  swap(R"({ source = "can", dbc)", R"({ source = "can", bus = "can0", dbc)");
  const config::Gateway two = config::parse_gateway(text, loop.toml());
  ASSERT_EQ(two.buses.size(), 2U);
  EXPECT_EQ(band_of(two, path), band_of(loop.gateway(), loop.log()));
}

// The same frames on a second interface, of another unit: mixed, they were a third one.
TEST_F(Replayed, OfTwoInterfacesThatOfTheConfigurationIsUsed) {
  std::ifstream in(loop.log());
  const std::string path = loop.folder() + "/two.log";
  const std::string other = loop.folder() + "/others.log";
  std::ofstream two(path);
  std::ofstream others(other);
  std::string interface;
  for (std::string line; std::getline(in, line);) {
    const std::size_t at = line.find(") ") + 2;
    interface = line.substr(at, line.find(' ', at) - at);
    std::string beside = line;
    beside.replace(at, interface.size(), "can8");
    beside.back() = beside.back() == '0' ? '7' : '0';
    two << line << '\n' << beside << '\n';
    others << beside << '\n';
    beside.replace(at, 4, "can9");
    others << beside << '\n';
  }
  two.close();
  others.close();
  config::Gateway gateway = loop.gateway();
  gateway.buses[0].interface = interface;
  Replay alone(gateway);
  Replay beside(gateway);
  ASSERT_TRUE(alone.play(loop.log(), [](const Notice&, double) {}));
  ASSERT_TRUE(beside.play(path, [](const Notice&, double) {})) << beside.error();
  EXPECT_EQ(alone.frames(), beside.frames());
  EXPECT_EQ(alone.daemon().loops()[0].stick_band_pct.ascending,
            beside.daemon().loops()[0].stick_band_pct.ascending);
  Replay neither(gateway);
  EXPECT_FALSE(neither.play(other, [](const Notice&, double) {}));
  EXPECT_NE(neither.error().find("found can8, can9"), std::string::npos)
      << neither.error();
}

TEST_F(Replayed, SaysThatAModeSuspendsTheEvaluation) {
  std::ifstream file(loop.toml());
  std::string text((std::istreambuf_iterator<char>(file)), {});
  text += "mode = { source = \"can\", frame_id = 0x300, start = 0, length = 8 }\n";
  const std::string path = loop.folder() + "/manual.log";
  std::ifstream in(loop.log());
  std::ofstream out(path);
  for (std::string line; std::getline(in, line);) {
    out << line << '\n' << line.substr(0, line.find("can0")) << "can0 300#02\n";
  }
  out.close();
  const config::Gateway gateway = config::parse_gateway(text, loop.toml());
  Replay replay(gateway);
  std::string told;
  ASSERT_TRUE(replay.play(path, [&](const Notice& notice, double t_s) {
    told += event_line(notice, t_s, gateway, false);
  })) << replay.error();
  EXPECT_NE(told.find("suspended: mode reads 2, automatic is 1\n"), std::string::npos)
      << told;
  const std::string summary = summary_line(replay, 0, false);
  EXPECT_NE(summary.find("suspended: mode reads 2, automatic is 1\n"), std::string::npos)
      << summary;
}

TEST_F(Replayed, ALastLineThatWasCutIsLeftOutAndNamed) {
  const std::string path = loop.folder() + "/cut.log";
  std::ofstream(path) << "(1.0) can0 123#00\n(2.0) can0 123#01\n(3.0) can0 12"
                      << std::flush;
  Replay replay(loop.gateway());
  EXPECT_TRUE(replay.play(path, [](const Notice&, double) {})) << replay.error();
  EXPECT_EQ(replay.frames(), 2U);
  EXPECT_EQ(replay.cut_line(), 3U);
}

TEST_F(Replayed, GapsOfTheGridAreCountedThatArePassedOver) {
  (void)play(jumped(86400));
  EXPECT_GT(counters.gaps, 100'000U) << "two a second";
}

TEST_F(Replayed, NumbersInJsonAreAsShortAsTheyAreExact) {
  std::vector<std::string> lines;
  Replay replay(loop.gateway());
  ASSERT_TRUE(replay.play(loop.log(), [&](const Notice& notice, double t_s) {
    lines.push_back(event_line(notice, t_s, loop.gateway(), true));
  }));
  lines.push_back(summary_line(replay, 0, true));
  int numbers = 0;
  for (const std::string& line : lines) {
    EXPECT_EQ(line.find(".0,"), std::string::npos) << line;
    for (std::size_t at = 0; at < line.size();) {
      const std::size_t end =
          std::min(line.find_first_not_of("0123456789", at), line.size());
      EXPECT_LE(end - at, 10U) << line;
      numbers += end > at ? 1 : 0;
      at = end + 1;
    }
  }
  EXPECT_GT(numbers, 30);
}

TEST_F(Replayed, ALogMayBeCalledAnything) {
  const std::string path = loop.folder() + "/expected.log";
  std::ofstream(path) << std::ifstream(loop.log()).rdbuf();
  EXPECT_TRUE(play(path).empty());
}

// A loop on CAN and, where `more` is one, another.
config::Gateway sources(const std::string& u, const std::string& more = "") {
  const std::string y =
      "y = { source = \"can\", frame_id = 2, start = 0, length = 16 }\n";
  const std::string head = "[[loop]]\nsample_period_s = 0.5\nid = ";
  std::string text = "[bus.a]\nbackend = \"slcan\"\nport = 0\n" + head +
                     "1\ntag = \"A\"\nu = { " + u + " }\n" + y;
  if (!more.empty()) text += head + "2\ntag = \"B\"\nu = { " + more + " }\n" + y;
  return config::parse_gateway(text, "g.toml");
}
constexpr const char* kOnCan = "source = \"can\", frame_id = 1, start = 0, length = 16";
constexpr const char* kConverter =
    "source = \"iio\", name = \"adc\", channel = \"voltage0\"";

TEST_F(Replayed, ALogWithoutTheSourcesOfAnyLoopIsNotPlayed) {
  const config::Gateway gateway = sources(kConverter);
  Replay replay(gateway);
  EXPECT_FALSE(replay.play(loop.log(), [](const Notice&, double) {}));
  EXPECT_EQ(replay.error(),
            "g.toml:8: loop[1].u: expected a signal on CAN, found a converter: a CAN log "
            "has no value of it; replay loops whose u and y are on CAN");
}

TEST_F(Replayed, ALoopBesideCanIsToldAndTheOthersArePlayed) {
  const config::Gateway gateway = sources(kOnCan, kConverter);
  Replay replay(gateway);
  EXPECT_TRUE(replay.play(loop.log(), [](const Notice&, double) {})) << replay.error();
  const std::vector<std::string> told = sources_beside_can(gateway);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0].find("loop[2].u: "), std::string::npos) << told[0];
  EXPECT_TRUE(sources_beside_can(sources(kOnCan)).empty());
}

}  // namespace
}  // namespace firmware
