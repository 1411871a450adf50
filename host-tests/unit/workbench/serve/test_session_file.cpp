// A session as a file.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/workbench/serve_session.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/serve/session_file.hpp"

namespace workbench {
namespace {

using nlohmann::json;
using test::late_recording;
using test::wait;

class ServeSessionFile : public ::testing::Test {
 protected:
  ServeSessionFile() {
    Recording recording = late_recording();
    recording.units[static_cast<std::size_t>(Column::y)] = "m3/h";
    recording.loads = {{"feed", "t/h", recording.u}};
    session_.open(std::move(recording), Column::y, "late.csv --ts 1");
    wait(session_);
    session_.add({"process.dead_time"});
    wait(session_);
    session_.add({"process.second_lag"});
    wait(session_);
    session_.undo();
    text_ = session_text(session_.view());
  }
  // What is refused once `change` was made.
  template <class Change>
  std::string refusal_after(Change change) {
    json file = json::parse(text_);
    change(file);
    try {
      static_cast<void>(parse_session(file.dump(), "s.json"));
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  }

  Session session_;
  std::string text_;
};

TEST_F(ServeSessionFile, BringsBackRecordingModelsAndWhatWasUndone) {
  SavedSession saved = parse_session(text_, "s.json");
  Session other;
  other.restore(std::move(saved.recording), saved.source, saved.steps, saved.undone);
  const SessionView before = session_.view();
  const SessionView after = other.view();
  EXPECT_EQ(after.opened().u, before.opened().u);
  EXPECT_EQ(after.opened().unit(Column::y), "m3/h");
  ASSERT_EQ(after.opened().loads.size(), 1U);
  EXPECT_EQ(after.opened().loads[0].name, "feed");
  EXPECT_EQ(after.opened().loads[0].unit, "t/h");
  EXPECT_EQ(after.opened().loads[0].values, before.opened().u);
  EXPECT_EQ(after.source, "late.csv --ts 1");
  ASSERT_EQ(after.steps.size(), 2U);
  EXPECT_EQ(after.undone.size(), 1U);
  EXPECT_EQ(after.last().model.effect_codes(), before.last().model.effect_codes());
  EXPECT_TRUE(after.last().fitted_here);
  EXPECT_DOUBLE_EQ(after.last().comparison.quality.rmse,
                   before.last().comparison.quality.rmse);
  other.redo();
  EXPECT_EQ(other.view().last().model.effects.size(), 2U);
}

TEST_F(ServeSessionFile, RefusesLoadsOfAnotherLength) {
  EXPECT_NE(refusal_after([](json& file) {
              file["recording"]["loads"][0]["values"] = json::array({1, 2});
            }).find("as many values of feed as of t"),
            std::string::npos);
}

TEST_F(ServeSessionFile, RefusesWhatIsNoneByName) {
  for (const char* text : {"", "{}", "[]", "{\"kind\":\"stickband-model\"}", "t,u,y\n"}) {
    EXPECT_THROW(static_cast<void>(parse_session(text, "s.json")), InputError) << text;
  }
  const std::vector<std::string> refusals = {
      refusal_after([](json& file) { file["schema"] = 2; }),
      refusal_after([](json& file) { file["steps"] = json::array(); }),
      refusal_after([](json& file) { file["steps"][0].erase("process"); }),
      refusal_after([](json& file) { file["recording"]["y"].erase(3); }),
      refusal_after([](json& file) { file["recording"].erase("u"); }),
      refusal_after([](json& file) { file["recording"]["u"][3] = "much"; }),
      refusal_after([](json& file) { file["recording"]["t"][3] = 0; }),
      refusal_after([](json& file) { file["recording"]["sample_period_s"] = 0; }),
      refusal_after([](json& file) { file["recording"] = 3; })};
  for (std::size_t i = 0; i < refusals.size(); ++i) {
    EXPECT_EQ(refusals[i].rfind("s.json", 0), 0U) << i << refusals[i];
  }
}

TEST_F(ServeSessionFile, BringsBackRecordingsThatAreFittedTogether) {
  session_.accompany(late_recording());
  session_.fit_together(0, true);
  wait(session_);
  SavedSession saved = parse_session(session_text(session_.view()), "s.json");
  EXPECT_EQ(saved.recording.size(), late_recording().size());
  Session other;
  other.restore(std::move(saved.recording), saved.source, saved.steps, saved.undone,
                saved.beside);
  const SessionView before = session_.view();
  const SessionView after = other.view();
  EXPECT_EQ(after.opened().u, before.opened().u);
  EXPECT_TRUE(after.last().fitted_here);
  EXPECT_DOUBLE_EQ(after.last().comparison.quality.rmse_validation,
                   before.last().comparison.quality.rmse_validation);
}

TEST_F(ServeSessionFile, BringsBackWhatIsLeftOutAndWhatLiesBeside) {
  session_.leave_out(std::pair(100.0, 150.0));
  wait(session_);
  session_.share_out({0.7, 40});
  wait(session_);
  session_.accompany(late_recording());
  text_ = session_text(session_.view());
  const SavedSession saved = parse_session(text_, "s.json");
  ASSERT_EQ(saved.recording.left_out.size(), 1U);
  EXPECT_EQ(saved.recording.left_out[0].last, session_.view().opened().left_out[0].last);
  EXPECT_EQ(saved.recording.split.estimation_share, 0.7);
  EXPECT_EQ(saved.beside.size(), 1U);
  for (const json& bad : {json("x"), json({{5, 2}}), json({{0, 1000000}}),
                          json({{-1, 5}}), json({{10, 20}, {15, 30}})}) {
    EXPECT_NE(refusal_after([&bad](json& file) {
                file["recording"]["left_out"] = bad;
              }).find("left_out"),
              std::string::npos);
  }
  EXPECT_NE(refusal_after([](json& file) {
              file["recording"]["split"]["estimation_share"] = 1.5;
            }).find("split"),
            std::string::npos);
}

TEST_F(ServeSessionFile, RefusesARecordingWithoutSamples) {
  const std::string said = refusal_after([](json& file) {
    file["beside"] = json::array({{{"name", "x.csv"}, {"sample_period_s", 1.0}}});
  });
  EXPECT_NE(said.find("2 samples or more"), std::string::npos) << said;
}

}  // namespace
}  // namespace workbench
