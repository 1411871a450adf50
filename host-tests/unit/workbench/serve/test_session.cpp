// What the page works on, step by step.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "support/workbench/serve_session.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/serve/session.hpp"
#include "workbench/serve/session_step.hpp"

namespace workbench {
namespace {

using test::late_recording;
using test::wait;
using Codes = std::vector<std::string>;

Recording too_short() {
  Recording recording;
  recording.name = "short.csv";
  recording.period_s = 1;
  recording.t = {0, 1, 2};
  recording.u = recording.y = {1, 2, 1};
  return recording;
}

class ServeSession : public ::testing::Test {
 protected:
  void open() {
    session_.open(late_recording(), Column::y);
    wait(session_);
  }
  Session session_;
};

TEST_F(ServeSession, LeadsFromARecordingToTheExplainedModelAndBack) {
  open();
  const SessionView start = session_.view();
  EXPECT_TRUE(start.last().model.effects.empty());
  EXPECT_FALSE(start.last().explanation);
  session_.explain();
  wait(session_);
  const SessionView explained = session_.view();
  EXPECT_GT(explained.revision, start.revision);
  ASSERT_TRUE(explained.last().explanation);
  ASSERT_NE(explained.last().explanation->best(), nullptr);
  EXPECT_EQ(explained.last().explanation->best()->effect, "process.dead_time");
  session_.add({"process.dead_time"});
  wait(session_);
  const SessionView added = session_.view();
  EXPECT_EQ(added.last().model.effect_codes(), Codes{"process.dead_time"});
  EXPECT_LT(added.last().comparison.quality.rmse_validation,
            start.last().comparison.quality.rmse_validation);
  EXPECT_FALSE(added.last().explanation);
  session_.undo();
  EXPECT_TRUE(session_.view().last().explanation);
  EXPECT_THROW(session_.undo(), NotNow);
  EXPECT_TRUE(start.last().model.effects.empty());
}

TEST_F(ServeSession, ClimbsTheWholeLadderAndBackStepByStep) {
  session_.open(test::drifting_and_coarse(), Column::y);
  wait(session_);
  const SessionView start = session_.view();
  session_.climb();
  wait(session_);
  const SessionView top = session_.view();
  ASSERT_EQ(top.steps.size(), 3U);
  ASSERT_TRUE(top.last().ladder);
  EXPECT_TRUE(top.last().explanation->explained);
  EXPECT_EQ(top.last().model.effects.size(), 2U);
  session_.undo();
  const ModelStep between = session_.view().last();
  ASSERT_EQ(between.model.effects.size(), 1U);
  ASSERT_TRUE(between.explanation);
  EXPECT_TRUE(top.last().model.has(between.explanation->best()->effect));
  EXPECT_FALSE(between.model.has(between.explanation->best()->effect));
  session_.undo();
  EXPECT_EQ(session_.view().steps, start.steps);
}

TEST_F(ServeSession, KeepsTheStepsThatWereDoneWhereTheLadderIsStopped) {
  session_.open(test::drifting_and_coarse(), Column::y);
  wait(session_);
  session_.climb();
  while (session_.progress() && session_.view().steps.size() < 2) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  session_.cancel();
  const SessionView view = session_.view();
  ASSERT_GE(view.steps.size(), 2U);
  EXPECT_EQ(view.steps[1]->model.effects.size(), 1U);
  EXPECT_EQ(view.steps[1]->model.history.size(), 2U);
}

TEST_F(ServeSession, ClimbsTheWholeLadderInOneStep) {
  open();
  session_.climb();
  wait(session_);
  const SessionView top = session_.view();
  ASSERT_TRUE(top.last().ladder);
  EXPECT_TRUE(top.last().explanation->explained);
  EXPECT_EQ(top.last().model.effect_codes(), Codes{"process.dead_time"});
  session_.undo();
  EXPECT_TRUE(session_.view().last().model.effects.empty());
}

TEST_F(ServeSession, JudgesTheValveBesideTheModels) {
  EXPECT_EQ(session_.view().valve, nullptr);
  open();
  test::wait_for_verdict(session_);
  const SessionView first = session_.view();
  ASSERT_NE(first.valve, nullptr);
  EXPECT_NE(first.valve->analysis.result().verdict, ident::Verdict::kStiction);
  session_.add({"process.dead_time"});
  wait(session_);
  EXPECT_EQ(session_.view().valve, first.valve);
  Recording stem_only = late_recording();
  stem_only.y.clear();
  session_.open(stem_only, Column::x);
  EXPECT_EQ(session_.view().opened_count, first.opened_count + 1);
  EXPECT_EQ(session_.view().valve, nullptr);
  EXPECT_FALSE(session_.verdict_progress());
}

TEST_F(ServeSession, BringsBackWhatWasUndoneUntilANewModel) {
  open();
  EXPECT_THROW(session_.redo(), NotNow);
  session_.add({"process.dead_time"});
  wait(session_);
  const SessionView added = session_.view();
  session_.undo();
  session_.redo();
  EXPECT_EQ(session_.view().steps, added.steps);
  session_.undo();
  session_.add({"process.second_lag"});
  wait(session_);
  EXPECT_THROW(session_.redo(), NotNow);
}

TEST_F(ServeSession, StandsAsBeforeWhereWorkIsStopped) {
  open();
  session_.explain();
  wait(session_);
  const SessionView before = session_.view();
  session_.climb();
  session_.cancel();
  EXPECT_FALSE(session_.progress());
  EXPECT_EQ(session_.failure(), nullptr);
  EXPECT_EQ(session_.view().steps, before.steps);
  EXPECT_EQ(session_.view().revision, before.revision);
}

TEST_F(ServeSession, RemembersThatWorkWasStoppedUntilOtherWorkBegins) {
  open();
  session_.cancel();
  EXPECT_TRUE(session_.view().is_stopped()) << "it may just have ended";
  EXPECT_THROW(session_.explain(Asked::no), NotNow);
  session_.climb();
  EXPECT_FALSE(session_.view().is_stopped());
  session_.cancel();
  EXPECT_TRUE(session_.view().is_stopped());
  session_.explain();
  EXPECT_FALSE(session_.view().is_stopped());
  session_.cancel();
  session_.add({"process.second_lag"});
  wait(session_);
  EXPECT_FALSE(session_.view().is_stopped());
}

TEST_F(ServeSession, NeedsARecordingAndAModel) {
  EXPECT_THROW(session_.explain(), NotNow);
  EXPECT_THROW(session_.add({"process.dead_time"}), NotNow);
  EXPECT_THROW(session_.climb(), NotNow);
  EXPECT_THROW(session_.undo(), NotNow);
  EXPECT_THROW(session_.start(Column::y, {}), NotNow);
  EXPECT_THROW(session_.judge(late_recording()), NotNow);
  EXPECT_THROW(static_cast<void>(session_.view().last()), NotNow);
}

TEST_F(ServeSession, KeepsWhatItHasWhereARecordingCannotBeUsed) {
  open();
  const std::uint64_t revision = session_.view().revision;
  EXPECT_THROW(session_.open(too_short(), Column::y), InputError);
  EXPECT_THROW(session_.judge(too_short()), InputError);
  Recording no_stem = late_recording();
  no_stem.x.clear();
  EXPECT_THROW(session_.open(no_stem, Column::x), InputError);
  EXPECT_EQ(session_.view().revision, revision);
  EXPECT_EQ(session_.view().opened().name, "late.csv");
}

// A big file that was asked for first and is read last.
TEST_F(ServeSession, OpensNothingThatAnotherFileHasOvertaken) {
  open();
  session_.await(2);
  session_.await(0);
  EXPECT_THROW(session_.await(1), NotNow);
  const std::uint64_t revision = session_.view().revision;
  EXPECT_THROW(session_.open(late_recording(), Column::y, {}, {}, 1), NotNow);
  EXPECT_THROW(session_.judge(late_recording(), {}, {}, 1), NotNow);
  EXPECT_EQ(session_.view().revision, revision);
  Recording next = late_recording();
  next.name = "next.csv";
  session_.open(next, Column::y, {}, {}, 2);
  EXPECT_EQ(session_.view().opened().name, "next.csv");
}

TEST_F(ServeSession, RefusesEffectsThatCannotBeAdded) {
  open();
  for (const Codes& codes : {Codes{"no.such"}, Codes{"sensor.lag", "sensor.lag"}}) {
    EXPECT_THROW(session_.add(codes), std::invalid_argument);
    EXPECT_THROW(session_.start(Column::y, codes), std::invalid_argument);
  }
  session_.add({"process.dead_time"});
  wait(session_);
  EXPECT_THROW(session_.add({"process.dead_time"}), std::invalid_argument);
  session_.add({"sensor.quantisation"});
  wait(session_);
  EXPECT_NE(session_.failure(), nullptr);
  EXPECT_EQ(session_.view().steps.size(), 2U);
}

TEST_F(ServeSession, TakesOneWorkAtATimeButOpensAtAnyTime) {
  open();
  session_.climb();
  if (session_.progress()) {
    EXPECT_THROW(session_.explain(), NotNow);
  }
  session_.open(late_recording(1001), Column::y);
  wait(session_);
  EXPECT_EQ(session_.view().steps.size(), 1U);
  EXPECT_FALSE(session_.view().last().ladder);
}

TEST_F(ServeSession, JudgesAModelOnAnotherRecording) {
  open();
  session_.add({"process.dead_time"});
  wait(session_);
  Recording other = late_recording(1001);
  other.name = "other.csv";
  session_.judge(std::move(other));
  const SessionView view = session_.view();
  EXPECT_EQ(view.opened().name, "other.csv");
  EXPECT_EQ(view.last().model.fitted.name, "late.csv");
  EXPECT_NEAR(view.last().comparison.quality.rmse, 0.2, 0.05);
  EXPECT_FALSE(view.last().fitted_here);
}

TEST_F(ServeSession, UndoTakesSamplesInAgain) {
  open();
  const double rmse = session_.view().last().comparison.quality.rmse;
  session_.leave_out(std::pair(20.0, 40.0));
  wait(session_);
  EXPECT_EQ(session_.view().opened().left_out.size(), 1U);
  EXPECT_TRUE(session_.view().can_undo());
  session_.undo();
  EXPECT_TRUE(session_.view().opened().left_out.empty());
  EXPECT_EQ(session_.view().last().comparison.quality.rmse, rmse);
  EXPECT_FALSE(session_.view().can_undo());
  EXPECT_THROW(session_.undo(), NotNow);
}

TEST_F(ServeSession, TakesAModelFromAFileAsAStep) {
  open();
  Model model = session_.view().last().model;
  session_.add({"process.dead_time"});
  wait(session_);
  session_.take(std::move(model));
  EXPECT_TRUE(session_.view().last().model.effects.empty());
  session_.undo();
  EXPECT_EQ(session_.view().last().model.effects.size(), 1U);
}

TEST_F(ServeSession, EndsASearchForAModelFromAFile) {
  open();
  Model model = session_.view().last().model;
  session_.explain();
  session_.take(std::move(model));
  EXPECT_FALSE(session_.progress());
  EXPECT_EQ(session_.view().steps.size(), 2U);
  EXPECT_FALSE(session_.view().last().explanation);
}

TEST_F(ServeSession, LeavesOutAStretchAndTakesItInAgain) {
  Recording recording = late_recording();
  for (std::size_t k = 300; k < 360; ++k) recording.y[k] += 40;
  session_.open(recording, Column::y);
  wait(session_);
  const double spoilt = session_.view().last().comparison.quality.rmse;
  session_.leave_out(std::pair(recording.t[290], recording.t[365]));
  wait(session_);
  const SessionView without = session_.view();
  ASSERT_EQ(without.opened().left_out.size(), 1U);
  EXPECT_LT(without.last().comparison.quality.rmse, 0.5 * spoilt);
  EXPECT_EQ(without.last().comparison.residual[320], 0);
  EXPECT_GT(std::abs(without.opened().y[320] - without.last().comparison.simulated[320]),
            20);
  // Beside the first, one that touches it.
  session_.leave_out(std::pair(recording.t[360], recording.t[380]));
  wait(session_);
  ASSERT_EQ(session_.view().opened().left_out.size(), 1U);
  EXPECT_EQ(session_.view().opened().left_out[0].last, 380U);
  session_.leave_out(std::nullopt);
  wait(session_);
  EXPECT_TRUE(session_.view().opened().left_out.empty());
  EXPECT_DOUBLE_EQ(session_.view().last().comparison.quality.rmse, spoilt);
  EXPECT_THROW(session_.leave_out(std::pair(recording.t[0], recording.t.back() + 1)),
               InputError);
}

TEST_F(ServeSession, SharesTheSamplesOutAndKeepsTheVerdict) {
  open();
  test::wait_for_verdict(session_);
  const auto verdict = session_.view().valve;
  session_.share_out({0.8, 50});
  wait(session_);
  EXPECT_EQ(session_.view().opened().split.pair_samples, 50);
  EXPECT_EQ(session_.view().valve, verdict);
  EXPECT_THROW(session_.share_out({0.95, 0}), std::invalid_argument);
  EXPECT_THROW(session_.share_out({0.5, -1}), std::invalid_argument);
}

TEST_F(ServeSession, PreviewsAnEffectAndAddsItAtOnce) {
  open();
  session_.preview({"process.dead_time"});
  wait(session_);
  const SessionView seen = session_.view();
  ASSERT_NE(seen.preview, nullptr);
  EXPECT_TRUE(seen.last().model.effects.empty());
  EXPECT_LT(seen.preview->step->comparison.quality.rmse_validation,
            seen.last().comparison.quality.rmse_validation);
  session_.add({"process.dead_time"});
  EXPECT_FALSE(session_.progress());
  EXPECT_EQ(session_.view().steps.back(), seen.preview->step);
  EXPECT_EQ(session_.view().preview, nullptr);
  EXPECT_THROW(session_.preview({"process.dead_time"}), std::invalid_argument);
}

TEST_F(ServeSession, HasRecordingsBesideTheOneThatIsOpen) {
  EXPECT_THROW(session_.accompany(late_recording()), NotNow);
  open();
  EXPECT_THROW(session_.accompany(too_short()), InputError);
  for (std::size_t i = 0; i < Session::kMostBeside; ++i) {
    session_.accompany(late_recording());
  }
  EXPECT_THROW(session_.accompany(late_recording()), NotNow);
  session_.dismiss(0);
  EXPECT_EQ(session_.view().beside.size(), Session::kMostBeside - 1);
  EXPECT_THROW(session_.dismiss(Session::kMostBeside - 1), NotNow);
  session_.share_out({0.7, 0});
  wait(session_);
  EXPECT_FALSE(session_.view().beside.empty());
  session_.open(late_recording(), Column::y);
  EXPECT_TRUE(session_.view().beside.empty());
}

TEST_F(ServeSession, FitsOneModelToSeveralRecordings) {
  open();
  const double alone = session_.view().last().comparison.quality.rmse_validation;
  Recording other = late_recording();
  for (double& y : other.y) y *= 1.1;
  session_.accompany(other);
  EXPECT_THROW(session_.fit_together(1, true), NotNow);
  session_.fit_together(0, true);
  wait(session_);
  const SessionView both = session_.view();
  ASSERT_NE(both.own, nullptr);
  EXPECT_EQ(both.opened().size(), both.own->size() + other.size());
  ASSERT_EQ(both.steps.size(), 2U);
  EXPECT_TRUE(both.last().fitted_here);
  EXPECT_EQ(both.last().model.history.back().effect, kRefitted);
  // Two of one name are told apart.
  const std::vector<RecordingFit>& parts = both.last().comparison.quality.recordings;
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[1].file, other.name + " (2)");
  EXPECT_DOUBLE_EQ(both.last().model.history.back().rmse_validation_after,
                   both.last().comparison.quality.rmse_validation);
  EXPECT_THROW(session_.choose(std::pair(0.0, 100.0), Session::Purpose::kFit), NotNow);
  EXPECT_THROW(session_.leave_out(std::pair(0.0, 10.0)), NotNow);
  session_.dismiss(0);
  wait(session_);
  const SessionView again = session_.view();
  EXPECT_EQ(again.own, nullptr);
  EXPECT_TRUE(again.beside.empty());
  EXPECT_NEAR(again.last().comparison.quality.rmse_validation, alone, 0.05 * alone);
}

TEST_F(ServeSession, StaysAsItWasWhereRecordingsDoNotFitTogether) {
  open();
  Recording other = late_recording();
  other.units[static_cast<std::size_t>(Column::u)] = "%";
  session_.accompany(other);
  other.units[static_cast<std::size_t>(Column::u)] = "mA";
  session_.accompany(other);
  session_.fit_together(0, true);
  wait(session_);
  EXPECT_THROW(session_.fit_together(1, true), InputError);
  EXPECT_FALSE(session_.view().beside[1].fitted);
  EXPECT_TRUE(session_.view().beside[0].fitted);
}

TEST_F(ServeSession, LeavesOutWhatIsInManual) {
  Recording recording = late_recording();
  session_.open(recording, Column::y);
  wait(session_);
  EXPECT_THROW(session_.leave_out_manual(), NotNow);
  recording.manual = {{100, 120}, {200, 230}};
  session_.open(recording, Column::y);
  wait(session_);
  session_.leave_out_manual();
  wait(session_);
  ASSERT_EQ(session_.view().opened().left_out.size(), 2U);
  EXPECT_EQ(session_.view().opened().left_out[1].last, 230U);
}

}  // namespace
}  // namespace workbench
