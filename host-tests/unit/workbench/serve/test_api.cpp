// The workbench over HTTP, without the transport.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "support/workbench/api_test.hpp"
#include "workbench/model/tell/explanation_json.hpp"
#include "workbench/model/tell/model_json.hpp"
#include "workbench/serve/api.hpp"

namespace workbench {
namespace {

using nlohmann::json;

class ServeApi : public test::ApiTest {
 protected:
  void open() {
    ASSERT_EQ(post("/api/recording", test::csv_of(test::late_recording()),
                   {{"name", "late.csv"}}),
              202);
  }
};

TEST_F(ServeApi, GivesTheObjectsOfTheCommandLine) {
  open();
  EXPECT_EQ(get("/api/compare"),
            json::parse(comparison_json(session_.view().last().comparison).dump()));
  EXPECT_EQ(post("/api/explain"), 202);
  const json explained = get("/api/explain");
  EXPECT_EQ(explained["schema"], 1);
  EXPECT_EQ(explained["candidates"][0]["effect"], "process.dead_time");
  EXPECT_EQ(explained["candidates"][0]["status"], "accepted");
  EXPECT_EQ(post("/api/add", R"({"effect":"process.dead_time"})"), 202);
  const json added = get("/api/add");
  EXPECT_LT(added["rmse_validation_after"], added["rmse_validation_before"]);
  EXPECT_NEAR(added["parameters"]["dead_time"]["value"].get<double>(), 6, 0.5);
  EXPECT_EQ(post("/api/explain"), 202);
  EXPECT_EQ(get("/api/explain")["explained"], true);
  EXPECT_EQ(get("/api/state")["explained"], true);
  EXPECT_EQ(post("/api/remove", R"({"effect":"process.dead_time"})"), 202);
  EXPECT_EQ(get("/api/compare")["effects"], json::array());
  EXPECT_EQ(ask("GET", "/api/add").status, 409);
  EXPECT_EQ(post("/api/remove", R"({"effect":"process.dead_time"})"), 400);
  EXPECT_EQ(post("/api/remove", "{}"), 400);
  EXPECT_NE(ask("GET", "/api/commands").body.find("stickband remove process.dead_time"),
            std::string::npos);
  EXPECT_EQ(post("/api/undo"), 200);
  EXPECT_EQ(get("/api/compare")["effects"], json({"process.dead_time"}));
  EXPECT_EQ(post("/api/undo"), 200);
  EXPECT_EQ(get("/api/compare")["effects"], json::array());
  EXPECT_EQ(post("/api/ladder"), 202);
  EXPECT_EQ(get("/api/ladder")["effects"], json({"process.dead_time"}));
}

TEST_F(ServeApi, RefusesWhatIsAskedAboutAnotherRecordingThanTheOneThatIsOpen) {
  open();
  const auto opening = [this] { return get("/api/state")["opening"].dump(); };
  const std::string late = opening();
  EXPECT_EQ(ask("GET", "/api/model", "", {{"opening", late}}).status, 200);
  // What is chosen from a recording is of the same one.
  EXPECT_EQ(post("/api/range", R"({"from":0,"to":400,"what":"fit"})"), 202);
  EXPECT_EQ(post("/api/undo"), 200);
  EXPECT_EQ(opening(), late);
  ASSERT_EQ(post("/api/recording", test::csv_of(test::late_recording(1001)),
                 {{"name", "other.csv"}, {"opening", late}}),
            202);
  EXPECT_NE(opening(), late);
  const std::string model = ask("GET", "/api/model").body;
  for (const char* path : {"/api/add", "/api/undo", "/api/cancel"}) {
    EXPECT_EQ(post(path, R"({"effect":"process.dead_time"})", {{"opening", late}}), 409);
    EXPECT_EQ(last_["error"]["kind"], "other_open");
    EXPECT_EQ(last_["error"]["message"],
              "another recording is open now, in another tab or window: 'other.csv'; "
              "reload the page to see it, or open yours again");
  }
  for (const char* path : {"/api/report", "/api/session", "/api/csv", "/api/model"}) {
    EXPECT_EQ(ask("GET", path, "", {{"opening", late}}).status, 409) << path;
  }
  EXPECT_EQ(ask("GET", "/api/model").body, model);
  EXPECT_EQ(ask("GET", "/api/model", "", {{"opening", "one"}}).status, 400);
}

TEST_F(ServeApi, TellsThatItWasStartedAnew) {
  open();
  const std::string late = get("/api/state")["opening"].dump();
  Session next;
  EXPECT_GT(next.begun(), session_.view().opening);
  const ApiResponse response =
      answer(next, {"POST", "/api/undo", {{"opening", late}}, ""});
  EXPECT_EQ(response.status, 409);
  EXPECT_NE(response.body.find("the program was started anew"), std::string::npos);
}

TEST_F(ServeApi, TriesTheMeasuredLoadsThatAreNamed) {
  Recording recording = test::late_recording();
  for (double& x : recording.x) x = std::sin(1e3 * x);
  ASSERT_EQ(post("/api/recording", test::csv_of(recording),
                 {{"name", "late.csv"}, {"u", "u"}, {"y", "y"}, {"load", "x"}}),
            202);
  EXPECT_EQ(session_.view().source, "late.csv --u u --y y --load x");
  EXPECT_EQ(post("/api/explain"), 202);
  EXPECT_NE(ask("GET", "/api/explain").body.find("\"disturbance.measured:x\""),
            std::string::npos);
  EXPECT_EQ(post("/api/recording", test::csv_of(test::late_recording()),
                 {{"u", "u"}, {"y", "y"}, {"load", "x\nz"}}),
            400);
}

TEST_F(ServeApi, SavesModelAndReport) {
  open();
  const ApiResponse model = ask("GET", "/api/model");
  EXPECT_EQ(model.filename, "late.model.json");
  EXPECT_EQ(parse_model(model.body, "m.json").fitted.name, "late.csv");
  EXPECT_EQ(ask("GET", "/api/report").status, 409);
  EXPECT_EQ(post("/api/explain"), 202);
  const ApiResponse report = ask("GET", "/api/report");
  EXPECT_EQ(report.status, 200);
  EXPECT_EQ(report.filename, "late.report.html");
  EXPECT_NE(report.body.find("The model still lacks dead time."), std::string::npos);
  EXPECT_EQ(post("/api/model", model.body, {{"name", "m.json"}}), 200);
  EXPECT_EQ(session_.view().steps.size(), 2U);
}

TEST_F(ServeApi, GivesTheSectionsOfThePage) {
  open();
  const json early = get("/api/parts");
  EXPECT_TRUE(early["verdict"].is_null());
  EXPECT_TRUE(early["candidates"].is_null());
  EXPECT_NE(early["residual"].get<std::string>().find("<svg"), std::string::npos);
  post("/api/explain");
  const json parts = get("/api/parts");
  EXPECT_NE(parts["verdict"].get<std::string>().find("dead time"), std::string::npos);
  EXPECT_NE(
      parts["candidates"].get<std::string>().find("data-effects=\"process.dead_time\""),
      std::string::npos);
  EXPECT_EQ(parts["revision"], session_.view().revision);
}

TEST_F(ServeApi, SaysWhetherTheValveSticks) {
  EXPECT_EQ(ask("GET", "/api/valve").status, 409);
  EXPECT_EQ(post("/api/example"), 202);
  test::wait_for_verdict(session_);
  EXPECT_EQ(get("/api/state")["verdict"], "stiction");
  const json valve = get("/api/valve");
  EXPECT_EQ(valve["headline"], "The valve sticks.");
  EXPECT_EQ(valve["mood"], "bad");
  EXPECT_EQ(valve["identification"]["verdict"], "stiction");
  EXPECT_FALSE(valve["advice"].get<std::string>().empty());
  const json band = valve["band"]["ascending"];
  EXPECT_LT(band["percent_low"], band["percent"]);
  EXPECT_NEAR(band["percent"].get<double>() * valve["span"].get<double>() / 100,
              band["value"].get<double>(), 1e-9);
  for (const char* signal : {"t", "u", "y", "stem"}) {
    EXPECT_EQ(valve["picture"][signal].size(), valve["picture"]["t"].size()) << signal;
    EXPECT_GT(valve["picture"][signal].size(), 100U) << signal;
    EXPECT_LE(valve["picture"][signal].size(), kMostPictureSamples) << signal;
  }
}

TEST_F(ServeApi, SaysWhereVerdictAndModelDisagree) {
  open();
  test::wait_for_verdict(session_);
  post("/api/explain");
  EXPECT_EQ(get("/api/parts")["missing"], "process.dead_time");
  EXPECT_EQ(get("/api/parts")["reconciled"], "");
  post("/api/add", R"({"effect":"valve.backlash"})");
  post("/api/explain");
  EXPECT_NE(get("/api/parts")["reconciled"].get<std::string>().find("not"),
            std::string::npos);
}

TEST_F(ServeApi, SaysWhereARecordingIsBad) {
  EXPECT_EQ(post("/api/recording", "t,u,y\n0,1,2\n1,abc,3\n", {{"name", "/x/bad.csv"}}),
            400);
  EXPECT_EQ(last_["error"]["file"], "bad.csv");
  EXPECT_EQ(last_["error"]["line"], 3);
  EXPECT_EQ(last_["error"]["column"], 3);
  for (const char* text :
       {"", "u,y\n1,2\n2,3\n", "t,y\n0,1\n1,2\n", "t,u\n0,1\n1,2\n", "t,u,y\n0,1,2\n",
        "t,u,y\n0,1,2\n1,2,3\n2,3,4\n", "(1.5) can0 123#00\n", "\xff\xfe\x00"}) {
    EXPECT_EQ(post("/api/recording", text), 400) << text;
    EXPECT_EQ(last_["error"]["kind"], "bad_input") << text;
    EXPECT_FALSE(last_["error"]["advice"].get<std::string>().empty()) << text;
  }
  EXPECT_TRUE(get("/api/state")["recording"].is_null());
}

TEST_F(ServeApi, TakesTheSamplePeriodAndTheOutputFromTheAddress) {
  const Recording recording = test::late_recording();
  std::string text = "u,x\n";
  for (std::size_t k = 0; k < recording.size(); ++k) {
    text += std::to_string(recording.u[k]) + ',' + std::to_string(recording.x[k]) + '\n';
  }
  EXPECT_EQ(post("/api/recording", text, {{"ts", "0.5"}}), 202);
  EXPECT_EQ(get("/api/recording")["sample_period_s"], 0.5);
  EXPECT_EQ(get("/api/state")["model"]["output"], "x");
  EXPECT_EQ(post("/api/recording", text, {{"ts", "0.5"}, {"output", "y"}}), 400);
  for (const char* ts : {"0", "-1", "nan", "1e999", "1 apple", "fast"}) {
    EXPECT_EQ(post("/api/recording", text, {{"ts", ts}}), 400) << ts;
  }
  EXPECT_EQ(post("/api/recording", text, {{"ts", "0.5"}, {"output", "z"}}), 400);
}

TEST_F(ServeApi, TakesAStepTestThatBeginsWithItsStep) {
  std::string text = "t,u,y\n";
  for (int k = 0; k < 200; ++k) {
    text +=
        std::to_string(k) + ",50," + std::to_string(25 - 25 * std::exp(-k / 30.0)) + '\n';
  }
  EXPECT_EQ(post("/api/recording", text, {{"u_before", "10"}, {"name", "step.csv"}}),
            202);
  EXPECT_GT(get("/api/recording")["samples"], 200);
  EXPECT_EQ(get("/api/commands")["commands"][0],
            "stickband identify step.csv --u-before 10");
  for (const char* u_before : {"50", "none", "nan"}) {
    EXPECT_EQ(post("/api/recording", text, {{"u_before", u_before}}), 400) << u_before;
  }
}

TEST_F(ServeApi, JudgesTheModelOnAnotherRecordingWhenAskedTo) {
  open();
  post("/api/add", R"({"effect":"process.dead_time"})");
  EXPECT_EQ(post("/api/recording", test::csv_of(test::late_recording(1001)),
                 {{"name", "other.csv"}, {"keep", "1"}}),
            202);
  const json state = get("/api/state");
  EXPECT_EQ(state["recording"]["name"], "other.csv");
  EXPECT_EQ(state["model"]["fitted_to"], "late.csv");
  EXPECT_EQ(state["model"]["effects"], json({"process.dead_time"}));
  EXPECT_EQ(state["model"]["fitted_here"], false);
  EXPECT_EQ(state["model"]["belongs_elsewhere"], false);
}

TEST_F(ServeApi, SaysWhereAModelBelongsToAnotherLoop) {
  open();
  const std::string model = ask("GET", "/api/model").body;
  EXPECT_EQ(post("/api/example"), 202);
  EXPECT_EQ(post("/api/model", model, {{"name", "late.model.json"}}), 200);
  EXPECT_EQ(get("/api/state")["model"]["belongs_elsewhere"], true);
  EXPECT_LT(get("/api/state")["model"]["fit_percent"], 0);
}

TEST_F(ServeApi, TriesParametersWithoutChangingTheModel) {
  open();
  const json model = json::parse(ask("GET", "/api/model").body);
  const double gain = model["process"]["gain"]["value"].get<double>();
  EXPECT_EQ(post("/api/try", json({{"process", {{"gain", gain}}}}).dump()), 200);
  const double rmse = get("/api/compare")["rmse"].get<double>();
  EXPECT_NEAR(last_["rmse"].get<double>(), rmse, 1e-6 * rmse);
  EXPECT_EQ(last_["simulated"].size(), session_.view().opened().size());
  const std::string doubled = json({{"process", {{"gain", 2 * gain}}}}).dump();
  EXPECT_EQ(post("/api/try", doubled), 200);
  EXPECT_GT(last_["rmse"].get<double>(), rmse);
  EXPECT_EQ(session_.view().steps.size(), 1U);
  EXPECT_EQ(post("/api/try", doubled, {{"then", "keep"}}), 200);
  EXPECT_EQ(session_.view().steps.size(), 2U);
  EXPECT_EQ(post("/api/try", "{}", {{"then", "refit"}}), 202);
  EXPECT_EQ(session_.view().steps.size(), 3U);
  EXPECT_NEAR(get("/api/compare")["rmse"].get<double>(), rmse, 0.02 * rmse);
  for (const char* body : {R"({"process":{"no":1}})", R"({"process":{"gain":"much"}})",
                           R"({"process":{"first_lag":-5}})", R"({"process":7})"}) {
    EXPECT_EQ(post("/api/try", body), 400) << body;
  }
  const json models = get("/api/models")["models"];
  ASSERT_EQ(models.size(), 3U);
  EXPECT_GT(models[1]["rmse"], models[0]["rmse"]);
  const json drawn = json::parse(ask("GET", "/api/simulated", "", {{"model", "1"}}).body);
  EXPECT_EQ(drawn["simulated"].size(), session_.view().opened().size());
  EXPECT_EQ(ask("GET", "/api/simulated", "", {{"model", "3"}}).status, 400);
}

TEST_F(ServeApi, FitsAndJudgesARangeAndAllOfItAgain) {
  open();
  post("/api/add", R"({"effect":"process.dead_time"})");
  const Recording whole = session_.view().opened();
  EXPECT_EQ(
      post(
          "/api/range",
          json({{"what", "judge"}, {"from", whole.t[100]}, {"to", whole.t[500]}}).dump()),
      202);
  EXPECT_EQ(get("/api/state")["is_range"], true);
  EXPECT_EQ(get("/api/recording")["samples"], 400);
  EXPECT_EQ(get("/api/state")["model"]["effects"], json({"process.dead_time"}));
  EXPECT_EQ(post("/api/range", R"({"what":"fit"})"), 202);
  EXPECT_EQ(get("/api/state")["is_range"], false);
  EXPECT_EQ(get("/api/recording")["samples"], whole.size());
  EXPECT_EQ(get("/api/state")["model"]["effects"], json::array());
  for (const char* body : {R"({"what":"eat"})", R"({"from":1})", R"({"from":1,"to":2})",
                           R"({"from":"a","to":2})"}) {
    EXPECT_EQ(post("/api/range", body), 400) << body;
  }
}

TEST_F(ServeApi, GivesAwaySessionSignalsAndCommands) {
  open();
  const ApiResponse session = ask("GET", "/api/session");
  EXPECT_EQ(session.filename, "late.session.json");
  const ApiResponse csv = ask("GET", "/api/csv");
  EXPECT_EQ(csv.filename, "late.signals.csv");
  EXPECT_EQ(csv.body.rfind("t,u,y,x,simulated,residual\n", 0), 0U);
  EXPECT_EQ(get("/api/commands")["commands"][0], "stickband identify late.csv");
  EXPECT_EQ(post("/api/session", session.body, {{"name", "s.json"}}), 202);
  EXPECT_EQ(get("/api/state")["recording"]["name"], "late.csv");
  EXPECT_EQ(post("/api/session", "{}"), 400);
}

TEST_F(ServeApi, TellsWhatAFileHoldsWithoutOpeningIt) {
  EXPECT_EQ(
      post("/api/columns", test::csv_of(test::late_recording()), {{"name", "late.csv"}}),
      200);
  EXPECT_EQ(last_["signals"].size(), 3U);
  EXPECT_EQ(last_["picked"]["u"], "u");
  EXPECT_TRUE(get("/api/state")["recording"].is_null());
}

TEST_F(ServeApi, RefusesWhatCannotBeNow) {
  for (const char* path :
       {"/api/recording", "/api/signals", "/api/valve", "/api/model", "/api/compare",
        "/api/explain", "/api/add", "/api/ladder", "/api/parts", "/api/report"}) {
    EXPECT_EQ(ask("GET", path).status, 409) << path;
  }
  for (const char* path :
       {"/api/explain", "/api/ladder", "/api/undo", "/api/redo", "/api/model"}) {
    EXPECT_EQ(post(path), 409) << path;
  }
  open();
  for (const char* path : {"/api/explain", "/api/add", "/api/ladder", "/api/report"}) {
    EXPECT_EQ(ask("GET", path).status, 409) << path;
  }
  EXPECT_EQ(post("/api/undo"), 409);
  EXPECT_EQ(post("/api/cancel"), 200);
}

TEST_F(ServeApi, BeginsNoSearchUnaskedThatSomebodyStopped) {
  open();
  session_.climb();
  session_.cancel();
  EXPECT_EQ(get("/api/state")["stopped"], true);
  EXPECT_EQ(post("/api/explain", "", {{"unasked", "1"}}), 409);
  EXPECT_EQ(post("/api/explain"), 202);
  EXPECT_EQ(get("/api/state")["stopped"], false);
  EXPECT_EQ(post("/api/explain", "", {{"unasked", "1"}}), 202);
}

TEST_F(ServeApi, RefusesWhatItDoesNotUnderstand) {
  open();
  for (const char* body :
       {"", "[]", "{", "{}", R"({"effect":1})", R"({"effect":"no.such"})",
        R"({"effect":"sensor.lag","with":"process.dead_time"})",
        R"({"effect":"sensor.lag","with":[1]})",
        R"({"effect":"sensor.lag","with":["sensor.lag"]})"}) {
    EXPECT_EQ(post("/api/add", body), 400) << body;
    EXPECT_FALSE(last_["error"]["message"].get<std::string>().empty()) << body;
  }
  for (const char* body :
       {"[1]", R"({"output":"z"})", R"({"output":3})", R"({"with":["no.such"]})",
        R"({"kind":"stickband-model"})", R"({"kind":7})", R"({"name":"someone"})"}) {
    EXPECT_EQ(post("/api/model", body), 400) << body;
  }
  for (const char* body :
       {"", "{}", "[]", R"({"output":"y"})", R"({"with":[]})", "t,u\n"}) {
    EXPECT_EQ(post("/api/model", body, {{"name", "package.json"}}), 400) << body;
    EXPECT_NE(last_["error"]["message"].get<std::string>().find("package.json"),
              std::string::npos);
  }
  EXPECT_EQ(session_.view().steps.size(), 1U);
  EXPECT_EQ(ask("GET", "/api/no").status, 404);
  EXPECT_EQ(ask("GET", "/api/undo").status, 405);
  EXPECT_EQ(ask("POST", "/api/state").status, 405);
  EXPECT_EQ(ask("DELETE", "/api/model").status, 405);
}

TEST_F(ServeApi, KeepsTheReasonWhyTheDataCannotAnswer) {
  open();
  EXPECT_EQ(post("/api/add", R"({"effect":"sensor.quantisation"})"), 202);
  const json state = get("/api/state");
  EXPECT_EQ(state["error"]["kind"], "cannot_answer");
  EXPECT_EQ(state["model"]["effects"], json::array());
}

TEST_F(ServeApi, ListsEveryEffectWithItsCure) {
  const json effects = get("/api/effects")["effects"];
  EXPECT_EQ(effects.size(), standard_catalogue().effects().size());
  for (const json& effect : effects) {
    EXPECT_FALSE(effect["title"].get<std::string>().empty());
    EXPECT_FALSE(effect["cure"].get<std::string>().empty());
  }
}

TEST_F(ServeApi, HasALoopToPractiseOn) {
  EXPECT_EQ(post("/api/example"), 202);
  EXPECT_EQ(get("/api/recording")["name"], "stiction-setpoint.csv");
  EXPECT_EQ(post("/api/explain"), 202);
  EXPECT_EQ(get("/api/explain")["candidates"][0]["effect"], "valve.stiction");
}

TEST_F(ServeApi, LeavesOutSharesOutAndPreviews) {
  open();
  EXPECT_EQ(get("/api/state")["left_out"], false);
  EXPECT_EQ(post("/api/leave_out", R"({"from":100,"to":150})"), 202);
  EXPECT_EQ(get("/api/state")["left_out"], true);
  EXPECT_EQ(get("/api/signals")["left_out"].size(), 1U);
  EXPECT_EQ(post("/api/leave_out", "{}"), 202);
  EXPECT_EQ(get("/api/signals")["left_out"].size(), 0U);
  EXPECT_EQ(post("/api/split", R"({"estimation_share":0.5,"block_s":100})"), 202);
  EXPECT_EQ(get("/api/state")["split"]["block_s"], 100);
  EXPECT_EQ(post("/api/split", R"({"estimation_share":2,"block_s":0})"), 400);
  EXPECT_EQ(ask("GET", "/api/preview").status, 409);
  EXPECT_EQ(post("/api/preview", R"({"effect":"process.dead_time"})"), 202);
  EXPECT_EQ(get("/api/state")["preview"], json({"process.dead_time"}));
  const json seen = get("/api/preview");
  EXPECT_LT(seen["rmse_validation"], seen["before"]["rmse_validation"]);
  EXPECT_EQ(seen["simulated"].size(), get("/api/signals")["t"].size());
}

TEST_F(ServeApi, JudgesRecordingsThatLieBeside) {
  open();
  const std::string csv = test::csv_of(test::late_recording());
  EXPECT_EQ(post("/api/beside", csv, {{"name", "second.csv"}}), 200);
  EXPECT_EQ(get("/api/state")["beside"], json({"second.csv"}));
  const json beside = get("/api/beside")["recordings"][0];
  EXPECT_GT(beside["fit_percent"], 0);
  EXPECT_EQ(beside["picture"]["t"].size(), beside["picture"]["simulated"].size());
  EXPECT_EQ(post("/api/beside", "t,u\n0,1\n1,2\n"), 400);
  EXPECT_EQ(post("/api/dismiss", R"({"which":-1})"), 400);
  EXPECT_EQ(post("/api/dismiss", R"({"which":1})"), 409);
  EXPECT_EQ(post("/api/dismiss", R"({"which":0})"), 200);
  EXPECT_EQ(get("/api/state")["beside"], json::array());
}

TEST_F(ServeApi, FitsToARecordingBesideAsWell) {
  open();
  const std::string csv = test::csv_of(test::late_recording(7));
  EXPECT_EQ(post("/api/beside", csv, {{"name", "second.csv"}}), 200);
  EXPECT_EQ(get("/api/state")["beside_fitted"], json({false}));
  EXPECT_EQ(post("/api/together", R"({"which":0,"fit":1})"), 400);
  EXPECT_EQ(post("/api/together", R"({"which":1,"fit":true})"), 409);
  EXPECT_EQ(post("/api/together", R"({"which":0,"fit":true})"), 202);
  const json state = get("/api/state");
  EXPECT_EQ(state["beside_fitted"], json({true}));
  EXPECT_EQ(state["beside_own"], "late.csv");
  EXPECT_EQ(state["model"]["fitted_to"], "late.csv, second.csv");
  EXPECT_EQ(get("/api/signals")["pieces"].size(), 2U);
  // Of both what the fit of both says.
  const json beside = get("/api/beside");
  const json parts = get("/api/compare")["recordings"];
  EXPECT_EQ(beside["own"]["rmse"], parts[0]["rmse"]);
  EXPECT_EQ(beside["recordings"][0]["rmse_validation"], parts[1]["rmse_validation"]);
  EXPECT_EQ(get("/api/commands")["commands"][0],
            "stickband identify late.csv second.csv");
  EXPECT_EQ(post("/api/range", R"({"from":1,"to":200})"), 409);
  EXPECT_EQ(post("/api/leave_out", R"({"manual":true})"), 409);
}

TEST_F(ServeApi, WritesTheReportInALanguage) {
  open();
  EXPECT_EQ(post("/api/explain", ""), 202);
  const auto report = [this](const std::string& language) {
    return answer(session_, {"GET", "/api/report", {{"language", language}}, ""});
  };
  EXPECT_NE(report("de").body.find("<html lang=\"de\""), std::string::npos);
  EXPECT_NE(report("en").body.find("<html lang=\"en\""), std::string::npos);
  EXPECT_EQ(report("xx").status, 400);
}

TEST_F(ServeApi, FitsAgainAllButWhatIsFixed) {
  open();
  const double gain = get("/api/models")["models"][0]["process"]["gain"]["value"];
  const std::string value = std::to_string(1.2 * gain);
  EXPECT_EQ(post("/api/try",
                 R"({"process":{"gain":)" + value + R"(},"hold":{"process":["gain"]}})",
                 {{"then", "refit"}}),
            202);
  EXPECT_NEAR(get("/api/models")["models"][1]["process"]["gain"]["value"].get<double>(),
              1.2 * gain, 1e-5);
  EXPECT_EQ(post("/api/try", R"({"hold":[1]})", {{"then", "refit"}}), 400);
}

}  // namespace
}  // namespace workbench
