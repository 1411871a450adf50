// One truth: the verdict of a recorded loop is the same over UDS, in the status frame, in
// the JSON of a replay, in the Prometheus file and on the line.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "firmware/gateway_loop.hpp"
#include "firmware/metrics.hpp"
#include "firmware/replay.hpp"
#include "firmware/replay_report.hpp"
#include "support/recordings.hpp"
#include "workbench/recording/csv.hpp"

namespace firmware {
namespace {

// What a view says: number of the verdict, and whether the flag is up.
struct Word {
  int verdict = -1;
  bool flag = false;
  friend bool operator==(const Word&, const Word&) = default;
};

void PrintTo(const Word& word, std::ostream* out) {
  *out << "{verdict " << word.verdict << ", flag " << word.flag << "}";
}

double metric(const std::string& text, const std::string& name) {
  const std::string head = "stickband_loop_" + name + "{loop=\"1\",tag=\"FIC-211\"} ";
  const std::size_t at = text.find(head);
  return at == std::string::npos ? -1 : std::stod(text.substr(at + head.size()));
}

int number_of(const std::string& verdict) {
  for (const wire::LoopField& field : wire::loop_fields()) {
    if (field.name != "verdict") continue;
    for (const wire::Choice& choice : field.choices) {
      if (choice.name == verdict) return choice.value;
    }
  }
  return -1;
}

Word play(const config::Gateway& gateway, const std::string& log) {
  Replay replay(gateway);
  EXPECT_TRUE(replay.play(log, [](const Notice&, double) {})) << replay.error();
  const wire::LoopStatus& status = replay.daemon().loops()[0];
  const Word own{static_cast<int>(status.verdict), status.flag};

  const auto answer = replay.ask(bytes_of("22FD10"));
  EXPECT_EQ(answer.size(), 3U + 20U);
  EXPECT_EQ(answer.at(3), own.verdict) << "UDS";
  EXPECT_EQ(answer.at(4), static_cast<int>(wire::ne107_of(status))) << "UDS";
  const auto summary = replay.ask(bytes_of("22FD00"));
  EXPECT_EQ(summary.at(5), own.flag ? 1 : 0) << "UDS, number of flagged loops";
  const auto dtcs = replay.ask(bytes_of("190208"));
  const bool stuck =
      dtcs.size() >= 7 && dtcs[3] == 0x51 && dtcs[4] == 1 && dtcs[5] == 0x71;
  EXPECT_TRUE(stuck || !own.flag) << "a raised flag has its DTC confirmed";

  const wire::CanFrame frame = wire::broadcast_frame(status);
  EXPECT_EQ(frame.data[0], own.verdict) << "status frame";

  std::string metrics;
  write_metrics({replay.daemon().gateway(), replay.daemon().loops()}, "g", metrics);
  EXPECT_EQ(metric(metrics, "verdict"), own.verdict) << "Prometheus";
  EXPECT_EQ(metric(metrics, "flag"), own.flag) << "Prometheus";

  const auto json = nlohmann::json::parse(summary_line(replay, 0, true));
  EXPECT_EQ(number_of(json["verdict"]), own.verdict) << "JSON";
  EXPECT_EQ(json["stiction_raised"], own.flag) << "JSON";
  EXPECT_EQ(json["gpio"], own.flag ? 1 : 0) << "JSON";
  EXPECT_EQ(replay.line(0).level, own.flag) << "line";

  const double raw = answer.at(7) << 8 | answer.at(8);
  const double band = metric(metrics, "stick_band_ascending_pct");
  if (raw == 0xFFFF) {
    EXPECT_TRUE(std::isnan(band)) << "Prometheus";
    EXPECT_TRUE(json["stick_band_ascending_pct"].is_null()) << "JSON";
  } else {
    EXPECT_DOUBLE_EQ(band, raw / 100) << "Prometheus";
    EXPECT_DOUBLE_EQ(json["stick_band_ascending_pct"], raw / 100) << "JSON";
  }
  return own;
}

constexpr int kOtherOscillation = 2;
constexpr int kUndecided = 3;
constexpr int kStiction = 4;

struct Row {
  const char* name;
  int seed;  // simulated; 0: a recording
  Word expected;
};

void PrintTo(const Row& row, std::ostream* out) {
  *out << row.name << ' ' << row.seed;
}

class GoldenTable : public testing::TestWithParam<Row> {};

TEST_P(GoldenTable, EveryViewSaysTheSame) {
  const Row row = GetParam();
  const GatewayLoop loop(row.name, static_cast<std::uint64_t>(row.seed));
  EXPECT_EQ(play(loop.gateway(), loop.log()), row.expected);
}

INSTANTIATE_TEST_SUITE_P(
    Simulated, GoldenTable,
    testing::Values(Row{"paper-example-1", 1, {kStiction, true}},
                    Row{"paper-example-1-ascending", 1, {kStiction, true}},
                    Row{"paper-example-1-descending", 2, {kStiction, true}},
                    Row{"stiction", 3, {kStiction, true}},
                    Row{"stiction-integrating", 3, {kStiction, true}},
                    Row{"external-sinusoid", 4, {kOtherOscillation, false}},
                    Row{"tight-tuning", 5, {kOtherOscillation, false}},
                    Row{"healthy", 6, {kUndecided, false}},
                    Row{"setpoint", 7, {kOtherOscillation, false}}));

class RecordedTable : public testing::TestWithParam<Row> {};

TEST_P(RecordedTable, EveryViewSaysTheSame) {
  const Row row = GetParam();
  const std::filesystem::path file =
      std::filesystem::path(STICKBAND_RECORDINGS) / row.name;
  if (const std::string why = test::why_unusable(file); !why.empty()) {
    GTEST_SKIP() << why;
  }
  const workbench::Recording recording = workbench::read_csv(file.string());
  workbench::SimulatedLoop loop;
  loop.period_s = recording.period_s;
  loop.t = recording.t;
  loop.u = recording.u;
  loop.y = recording.y;
  loop.sp = recording.has(workbench::Column::sp)
                ? recording.sp
                : std::vector<double>(recording.size(), recording.y.front());
  const GatewayLoop files(loop);
  EXPECT_EQ(play(files.gateway(), files.log()), row.expected);
}

INSTANTIATE_TEST_SUITE_P(
    Data, RecordedTable,
    testing::Values(Row{"isdb/CHEM1.csv", 0, {kStiction, true}},
                    Row{"isdb/CHEM2.csv", 0, {kStiction, false}},
                    Row{"isdb/CHEM10.csv", 0, {kStiction, true}},
                    Row{"isdb/CHEM33.csv", 0, {kUndecided, false}},
                    Row{"isdb/PAP2.csv", 0, {kStiction, true}},
                    Row{"isdb/PAP9.csv", 0, {kOtherOscillation, false}}));

}  // namespace
}  // namespace firmware
