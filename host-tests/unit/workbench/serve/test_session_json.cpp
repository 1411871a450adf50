// How a session stands, as JSON.
#include <gtest/gtest.h>

#include <cmath>

#include "support/workbench/serve_session.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/serve/session_json.hpp"

namespace workbench {
namespace {

using nlohmann::json;

TEST(ServeSessionJson, SaysNullWhereThereIsNothing) {
  Session session;
  const json state = json::parse(state_json(session).dump());
  EXPECT_EQ(state["schema"], 1);
  for (const char* key : {"recording", "model", "explained", "job", "error"}) {
    EXPECT_TRUE(state[key].is_null()) << key;
  }
  EXPECT_EQ(state["can_undo"], false);
}

TEST(ServeSessionJson, DescribesRecordingAndModel) {
  Session session;
  session.open(test::late_recording(), Column::y);
  test::wait(session);
  const json state = json::parse(state_json(session).dump());
  EXPECT_EQ(state["recording"]["name"], "late.csv");
  EXPECT_EQ(state["recording"]["samples"], test::late_recording().size());
  EXPECT_EQ(state["model"]["output"], "y");
  EXPECT_EQ(state["model"]["effects"], json::array());
  EXPECT_EQ(state["model"]["history"].size(), 1U);
  EXPECT_TRUE(state["explained"].is_null());
}

TEST(ServeSessionJson, SaysWhereInputIsBad) {
  const json bad = error_json(std::make_exception_ptr(
      InputError("a.csv", 3, 5, "a number", "'abc'", "repair the cell")));
  EXPECT_EQ(bad["kind"], "bad_input");
  EXPECT_EQ(bad["line"], 3);
  EXPECT_EQ(bad["column"], 5);
  EXPECT_EQ(bad["advice"], "repair the cell");
  const auto kind = [](const auto& error) -> json {
    return error_json(std::make_exception_ptr(error))["kind"];
  };
  EXPECT_EQ(kind(std::invalid_argument("nothing looks like it")), "cannot_answer");
  EXPECT_EQ(kind(std::runtime_error("disk full")), "failed");
  EXPECT_EQ(kind(7), "failed");
}

TEST(ServeSessionJson, SendsSignalsAsTheyAre) {
  Session session;
  session.open(test::late_recording(), Column::y);
  const json early = json::parse(signals_json(session.view()));
  EXPECT_EQ(early["t"].size(), early["samples"]);
  test::wait(session);
  const json signals = json::parse(signals_json(session.view()));
  const Recording& recording = session.view().opened();
  for (const char* key : {"t", "u", "measured", "simulated", "residual"}) {
    EXPECT_EQ(signals[key].size(), recording.size()) << key;
  }
  EXPECT_GT(signals["blocks"].size(), 5U);
  EXPECT_TRUE(signals["marks"].is_array());
  EXPECT_EQ(
      json::parse(simulated_json(session.view(), session.view().last()))["simulated"],
      signals["simulated"]);
  EXPECT_NEAR(signals["u"][7].get<double>(), recording.u[7], 1e-5);
  EXPECT_NEAR(
      signals["measured"][7].get<double>() - signals["simulated"][7].get<double>(),
      signals["residual"][7].get<double>(), 1e-4);
}

TEST(ServeSessionJson, ThinsLongSignalsButKeepsEveryPeak) {
  const std::size_t samples = 3 * kMostDrawnSamples;
  auto recording = std::make_shared<Recording>();
  recording->period_s = 1;
  for (std::size_t k = 0; k < samples; ++k) {
    recording->t.push_back(static_cast<double>(k));
    recording->u.push_back(std::sin(0.01 * static_cast<double>(k)));
    recording->y.push_back(0);
  }
  recording->y[123'457] = 9;
  SessionView view;
  view.recording = recording;
  const json signals = json::parse(signals_json(view));
  EXPECT_EQ(signals["samples"], samples);
  EXPECT_LE(signals["t"].size(), kMostDrawnSamples);
  EXPECT_EQ(signals["u"].size(), signals["t"].size());
  double highest = 0;
  double before = -1;
  for (std::size_t i = 0; i < signals["t"].size(); ++i) {
    highest = std::max(highest, signals["measured"][i].get<double>());
    EXPECT_GT(signals["t"][i].get<double>(), before);
    before = signals["t"][i].get<double>();
  }
  EXPECT_EQ(highest, 9);
}

}  // namespace
}  // namespace workbench
