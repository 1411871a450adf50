// Loads of the recordings that were fitted, where another one judges.
#include <gtest/gtest.h>

#include "support/workbench/cli_process.hpp"
#include "workbench/cli/left_behind.hpp"

namespace workbench::cli {
namespace {

TEST(LeftBehind, IsSaidWhereAnotherRecordingJudges) {
  Recording recording;
  recording.pieces = {{0, 100, "monday.csv", 0, false}};
  Model model;
  model.effects.push_back({.effect = "process.dead_time"});
  model.effects.push_back({.effect = "disturbance.step"});
  EXPECT_EQ(note_on_left_behind(model, recording), "") << "none judges";
  recording.pieces.push_back({100, 200, "friday.csv", 0, true});
  EXPECT_EQ(
      note_on_left_behind(model, recording),
      "disturbance.step belongs to what was fitted: friday.csv is judged without it");
  model.effects.pop_back();
  EXPECT_EQ(note_on_left_behind(model, recording), "") << "dead time goes with the plant";
}

class LeftBehindCli : public CliTest {};

TEST_F(LeftBehindCli, IsSaidByModel) {
  const std::string one = path("one.csv");
  const std::string two = path("two.csv");
  EXPECT_EQ(run({"simulate", "stiction", "--seed", "3", "-o", one}).code, 0);
  EXPECT_EQ(run({"simulate", "stiction", "--seed", "4", "-o", two}).code, 0);
  const Outcome said =
      run({"model", one, "--with", "disturbance.step", "--validate", two});
  EXPECT_NE(said.err.find("two.csv is judged without it"), std::string::npos) << said.err;
}

}  // namespace
}  // namespace workbench::cli
