// One truth: the verdict of a recorded loop is the same over UDS, in the status frame, in
// the JSON of a replay, in the Prometheus file and on the line.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "firmware/gateway_loop.hpp"
#include "firmware/metrics.hpp"
#include "firmware/replay.hpp"
#include "firmware/replay_report.hpp"
#include "support/base/recordings.hpp"
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
  int seed;
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

// Every recorded loop with u and y.
constexpr const char* kRecordings[] = {
    "isdb/BAS6",
    "isdb/CHEM1",
    "isdb/CHEM2",
    "isdb/CHEM3",
    "isdb/CHEM6",
    "isdb/CHEM7",
    "isdb/CHEM9",
    "isdb/CHEM10",
    "isdb/CHEM12",
    "isdb/CHEM13",
    "isdb/CHEM19",
    "isdb/CHEM21",
    "isdb/CHEM22",
    "isdb/CHEM24",
    "isdb/CHEM33",
    "isdb/CHEM35",
    "isdb/CHEM36",
    "isdb/CHEM38",
    "isdb/CHEM58",
    "isdb/PAP1",
    "isdb/PAP2",
    "isdb/PAP9",
    "plant/2111FIC10201-1",
    "plant/2111FIC10201-2",
    "plant/2111FIC10201-3",
    "plant/2111FIC40102C-1",
    "plant/2111FIC40102C-2",
    "plant/2111FIC41004-1",
    "plant/2111FIC46005-1",
    "plant/2111FIC46005-2",
    "plant/2111FIC46005-3",
    "plant/2111LIC31102B-1",
    "plant/2111LIC31102B-2",
    "plant/2111LIC31102B-3",
    "plant/2111LIC31102B-4",
    "plant/2111LIC31102B-5",
    "plant/2111LIC31102B-6",
    "plant/2111LIC31102B-7",
    "plant/2111LIC31102B-8",
    "plant/2111LIC31102B-9",
    "plant/2111LIC33102-1",
    "plant/2111LIC33102-2",
    "plant/2111LIC33102-3",
    "plant/2111LIC33102-4",
    "plant/2111LIC44001-1",
    "plant/2111LIC44001-2",
    "plant/2111PIC10201-1",
    "plant/2111PIC86501-1",
    "plant/2411FIC10104-1",
    "plant/2411FIC20502-1",
    "plant/2411LIC30102-1",
    "plant/2411LIC30102-2",
    "plant/2411LIC30501-1",
    "plant/2411LIC30501-2",
    "plant/2411LIC30501-3",
    "plant/2411LIC30501-4",
    "plant/2411PDIC10321-1",
    "plant/2411PDIC10321-2",
    "plant/RHT-7050-342_FIC11502-1",
    "sacac/other-F-paper-horch-2003",
    "sacac/other-F-paper-horch-2003-2",
    "sacac/quantisation-Q-paper-horch-2003",
    "sacac/saturation-T-oilgas-thornhill-2002",
    "sacac/stiction-F-paper-horch-2003",
    "sacac/stiction-L-power-baccidicapaci-2018",
    "cascaded-tanks/estimation",
    "cascaded-tanks/test",
    "valve-position/lublin-actuator-3",
    "heat-exchanger/exchanger",
    "lab-valve/closing-1",
    "lab-valve/closing-2",
    "lab-valve/opening-1",
    "lab-valve/opening-2",
    "lab-valve/up-and-down",
    "step-test/heater",
};

// Of these, what the gateway says is known.
const std::map<std::string, Word> kKnown = {
    {"isdb/CHEM1", {kStiction, true}},  {"isdb/CHEM2", {kStiction, false}},
    {"isdb/CHEM10", {kStiction, true}}, {"isdb/CHEM33", {kOtherOscillation, false}},
    {"isdb/PAP2", {kStiction, true}},   {"isdb/PAP9", {kOtherOscillation, false}},
};

class RecordedTable : public testing::TestWithParam<const char*> {
 protected:
  static std::filesystem::path folder() { return STICKBAND_RECORDINGS; }
};

TEST_P(RecordedTable, EveryViewSaysTheSame) {
  const std::string name = GetParam();
  const std::filesystem::path file = folder() / (name + ".csv");
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
  const Word word = play(files.gateway(), files.log());
  if (const auto known = kKnown.find(name); known != kKnown.end()) {
    EXPECT_EQ(word, known->second);
  }
  RecordProperty("verdict", word.verdict);
  RecordProperty("flag", word.flag ? 1 : 0);
}

INSTANTIATE_TEST_SUITE_P(Data, RecordedTable, testing::ValuesIn(kRecordings));

TEST(RecordedRows, ThereIsOneForEveryRecordingWithUAndY) {
  const std::filesystem::path folder = STICKBAND_RECORDINGS;
  if (!std::filesystem::exists(folder)) {
    GTEST_SKIP() << "the recordings are absent: " << folder;
  }
  std::set<std::string> rows(std::begin(kRecordings), std::end(kRecordings));
  rows.insert("friction-damper/damper");  // 128 Hz: a loop has 10 ms a sample at least
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".csv") continue;
    std::string header;
    std::getline(std::ifstream(entry.path()), header);
    if (header.find("u,") == std::string::npos || header.find('y') == std::string::npos) {
      continue;
    }
    std::filesystem::path name = entry.path().lexically_relative(folder);
    EXPECT_EQ(rows.erase(name.replace_extension().string()), 1U) << name;
  }
  EXPECT_TRUE(rows.empty()) << "no recording any more: " << *rows.begin();
}

}  // namespace
}  // namespace firmware
