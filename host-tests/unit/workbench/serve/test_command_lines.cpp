// What was done in the page, for a shell.
#include <gtest/gtest.h>

#include "support/workbench/serve_session.hpp"
#include "workbench/serve/command_lines.hpp"
#include "workbench/serve/session_step.hpp"

namespace workbench {
namespace {

using test::late_recording;
using test::wait;
using Lines = std::vector<std::string>;

TEST(ServeCommandLines, NameAFileAsItWasRead) {
  EXPECT_EQ(source_words("loop.csv", {}), "loop.csv");
  CsvOptions options;
  options.names.u = "FIC 101.OP [%]";
  options.names.time = "#1";
  options.ts = 0.5;
  options.date_order = DateOrder::mdy;
  options.decimal = ',';
  options.sheet = "Monday";
  options.names.loads = {"TI 7.PV", "feed"};
  EXPECT_EQ(source_words("my export.csv", options),
            "\"my export.csv\" --time \"#1\" --u \"FIC 101.OP [%]\" --load \"TI 7.PV\" "
            "--load feed --date-order mdy --decimal comma --sheet Monday --ts 0.5");
  EXPECT_EQ(source_words("steps.csv", {}, 0.0), "steps.csv --u-before 0");
}

TEST(ServeCommandLines, GoTheSameWayAsThePage) {
  Session session;
  EXPECT_THROW(static_cast<void>(command_lines(session.view())), NotNow);
  session.open(late_recording(), Column::y, "late.csv --ts 1");
  wait(session);
  session.add({"process.dead_time"});
  wait(session);
  EXPECT_EQ(command_lines(session.view()),
            (Lines{"stickband identify late.csv --ts 1",
                   "stickband model late.csv --ts 1 -o m.json",
                   "stickband add process.dead_time late.csv --ts 1 --model m.json "
                   "-o m2.json",
                   "stickband compare late.csv --ts 1 --model m2.json",
                   "stickband explain late.csv --ts 1 --model m2.json",
                   "stickband report late.csv --ts 1 --model m2.json -o report.html"}));
  session.climb();
  wait(session);
  EXPECT_EQ(command_lines(session.view())[1],
            "stickband ladder late.csv --ts 1 -o m.json");
}

TEST(ServeCommandLines, SayWhatTheCommandLineCannotDo) {
  Session session;
  session.open(late_recording(), Column::y, "late.csv");
  wait(session);
  const std::vector<double> t = session.view().opened().t;
  session.choose(std::pair(t[100], t[400]), Session::Purpose::kFit);
  wait(session);
  EXPECT_EQ(command_lines(session.view())[0].front(), '#');
}

TEST(ServeCommandLines, BeginWithWhatWritesTheFile) {
  Session session;
  session.open(late_recording(), Column::y, "late.csv");
  session.say_maker("stickband simulate setpoint -o late.csv");
  wait(session);
  EXPECT_EQ(command_lines(session.view())[0], "stickband simulate setpoint -o late.csv");
}

TEST(ServeCommandLines, QuoteWhatAShellWouldTakeForItsOwn) {
  EXPECT_EQ(source_words("a $b `c` d!.csv", {}), "'a $b `c` d!.csv'");
  EXPECT_EQ(source_words("K's \"x\".csv", {}), R"('K'\''s "x".csv')");
  EXPECT_EQ(source_words("-v.csv", {}), "./-v.csv");
}

TEST(ServeCommandLines, NameEachFileOfARecordingThatWasPutTogether) {
  EXPECT_EQ(source_words("FIC 1.OP.csv + -v.csv", {}), "\"FIC 1.OP.csv\" ./-v.csv");
  EXPECT_EQ(source_words("a + b.csv", {}), "\"a + b.csv\"");
}

TEST(ServeCommandLines, NameTheRecordingsBesideAsFarAsOneCommandReadsThem) {
  Session session;
  session.open(late_recording(), Column::y, "\"late 1.csv\" --u OP --y PV");
  wait(session);
  Recording other = late_recording(1001);
  other.name = "other.csv";
  session.accompany(other, "other.csv --u OP --y PV");
  other.name = "third one.csv";
  session.accompany(other, "\"third one.csv\" --u OP2 --y PV");
  const Lines lines = command_lines(session.view());
  EXPECT_EQ(
      lines.front(),
      "# \"third one.csv\" was read with --u OP2 --y PV, the first file with --u OP "
      "--y PV; a command reads all alike: name its columns as those of the first");
  EXPECT_EQ(lines[3],
            "stickband compare \"late 1.csv\" --u OP --y PV --model m.json --validate "
            "other.csv --validate \"third one.csv\"");
  EXPECT_EQ(lines[4], "stickband explain \"late 1.csv\" --u OP --y PV --model m.json");
}

TEST(ServeCommandLines, TakeAModelWithValuesSetByHandFromItsFile) {
  Session session;
  session.open(late_recording(), Column::y, "late.csv");
  wait(session);
  Model model = session.view().last().model;
  model.history.push_back({std::string(kSetByHand), "late.csv"});
  session.take(model);
  const Lines lines = command_lines(session.view());
  EXPECT_EQ(lines[1],
            "# save the model, of which values were set by hand: late.model.json");
  EXPECT_EQ(lines[2], "stickband compare late.csv --model late.model.json");
}

TEST(ServeCommandLines, TakeAModelOfAnotherRecordingFromItsFile) {
  Session session;
  session.open(late_recording(), Column::y, "late.csv");
  wait(session);
  Recording other = late_recording(1001);
  other.name = "other.csv";
  session.judge(other, "other.csv");
  const Lines lines = command_lines(session.view());
  EXPECT_EQ(lines[1],
            "# save the model, which was fitted to another recording: other.model.json");
  EXPECT_EQ(lines[2], "stickband compare other.csv --model other.model.json");
}

}  // namespace
}  // namespace workbench
