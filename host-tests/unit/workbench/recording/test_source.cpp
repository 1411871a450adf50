#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/base/temporary_folder.hpp"
#include "workbench/recording/source.hpp"
#include "workbench/recording/stopped.hpp"

namespace workbench {
namespace {

class SourceTest : public testing::Test {
 protected:
  std::string file(const std::string& name, const std::string& text) {
    std::ofstream(folder_.file(name), std::ios::binary) << text;
    return folder_.file(name);
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(SourceTest, ReadsCsv) {
  RecordingSource source;
  source.path = file("rec.csv", "t,u,y\n0,1,2\n1,3,4\n");
  const Recording r = read_recording(source);
  EXPECT_EQ(r.name, "rec.csv");
  EXPECT_EQ(r.size(), 2U);
}

TEST_F(SourceTest, FilesOfOneSignalEachAreOneRecording) {
  std::string rows = "Time,Value\n";
  for (int k = 10; k < 40; ++k) {
    rows +=
        "2026-03-04 00:00:" + std::to_string(k) + ',' + std::to_string(k * 3 % 7) + '\n';
  }
  const std::string op = file("FIC101.OP.csv", rows);
  const std::string pv = file("FIC101.PV.csv", rows);
  const std::vector<RecordingSource> sources = sources_of({}, {op, pv});
  ASSERT_EQ(sources.size(), 1U);
  const Recording r = read_recording(sources[0]);
  EXPECT_EQ(r.name, "FIC101.OP.csv + FIC101.PV.csv");
  EXPECT_EQ(r.size(), 30U);
  RecordingSource alone;
  alone.path = op;
  try {
    (void)read_recording(alone);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("all signals of the loop at once"),
              std::string::npos);
  }
  EXPECT_EQ(sources_of({}, {op, file("rec.csv", "t,u,y\n0,1,2\n1,3,4\n")}).size(), 2U);
}

TEST_F(SourceTest, ReadsCandumpWithDbc) {
  RecordingSource source;
  source.path =
      file("rec.log", "(1.0) can0 001#0102\n(2.0) can0 001#0203\n(3.0) can0 001#0304\n");
  source.dbc = file("plant.dbc",
                    "BO_ 1 M: 2 X\n SG_ U : 0|8@1+ (1,0) [0|0] \"\" X\n"
                    " SG_ Y : 8|8@1+ (1,0) [0|0] \"\" X\n");
  source.names.u = "M.U";
  EXPECT_THROW(static_cast<void>(read_recording(source)), std::invalid_argument);
  source.names.y = "M.Y";
  const Recording r = read_recording(source);
  EXPECT_EQ(r.u, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(r.y, (std::vector<double>{2, 3, 4}));
  source.names.y.clear();
  source.required = {Column::u};
  EXPECT_EQ(read_recording(source).u, (std::vector<double>{1, 2, 3}));
}

TEST_F(SourceTest, EndsWhereAStopIsAskedFor) {
  std::stop_source stop;
  RecordingSource wide;
  wide.path = file("wide.csv", "t,u,y\n0,1,2\n1,3,4\n");
  RecordingSource tags;
  tags.path = file("long.csv",
                   "Tag,Time,Value\nA.OP,2026-03-04 00:00:01,1\n"
                   "A.PV,2026-03-04 00:00:01,2\nA.OP,2026-03-04 00:00:02,3\n"
                   "A.PV,2026-03-04 00:00:02,4\n");
  RecordingSource log;
  log.path = file("rec.log", "(1.0) can0 001#0102\n(2.0) can0 001#0203\n");
  log.dbc = file("plant.dbc",
                 "BO_ 1 M: 2 X\n SG_ U : 0|8@1+ (1,0) [0|0] \"\" X\n"
                 " SG_ Y : 8|8@1+ (1,0) [0|0] \"\" X\n");
  log.names.u = "M.U";
  log.names.y = "M.Y";
  const std::vector<RecordingSource*> all{&wide, &tags, &log};
  for (RecordingSource* source : all) {
    source->stop = stop.get_token();
    EXPECT_NO_THROW((void)read_recording(*source)) << source->path;
  }
  stop.request_stop();
  for (const RecordingSource* source : all) {
    EXPECT_THROW((void)read_recording(*source), Stopped) << source->path;
  }
}

TEST_F(SourceTest, TheSpanIsThatOfTheConfiguredLoop) {
  RecordingSource source;
  source.path = file("rec.log", "(1.0) can0 001#0102\n(2.0) can0 001#0203\n");
  EXPECT_FALSE(configured_span(source));
  const std::string signals =
      "u = { source = \"can\", frame_id = 1, start = 0, length = 8 }\n"
      "y = { source = \"can\", frame_id = 1, start = 8, length = 8 }\n";
  source.config = file("g.toml",
                       "[bus.can0]\nbackend = \"socketcan\"\ninterface = \"can0\"\n"
                       "[[loop]]\nid = 1\ntag = \"A\"\nspan = [-20, 60]\n" +
                           signals + "[[loop]]\nid = 2\ntag = \"B\"\n" + signals +
                           "sample_period_s = 2.0\n");
  source.loop = 1;
  EXPECT_EQ(configured_span(source), (std::array<double, 2>{-20, 60}));
  source.loop = 2;
  EXPECT_EQ(configured_span(source), (std::array<double, 2>{0, 100}));
  source.loop = 3;
  EXPECT_THROW(static_cast<void>(configured_span(source)), std::invalid_argument);
}

TEST_F(SourceTest, ACandumpLogWithoutDbcIsNamedAsSuch) {
  RecordingSource source;
  source.path = file("rec.log", "(1.0) can0 001#0102\n");
  try {
    static_cast<void>(read_recording(source));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(error.advice.find("--dbc"), std::string::npos);
  }
  source.names.u = "M.U";
  EXPECT_THROW(static_cast<void>(read_recording(source)), std::invalid_argument);
}

TEST_F(SourceTest, AModelFileIsNamedAsSuch) {
  RecordingSource source;
  source.path = file("m.json", "\n {\"schema\": 1}\n");
  try {
    static_cast<void>(read_recording(source));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(error.found.find("model file"), std::string::npos);
    EXPECT_NE(error.advice.find("--model"), std::string::npos);
  }
}

}  // namespace
}  // namespace workbench
