// What a request says of how a recording is read.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/workbench/api_test.hpp"
#include "workbench/serve/api_request.hpp"

namespace workbench {
namespace {

using nlohmann::json;

class ServeApiRequest : public test::ApiTest {};

TEST_F(ServeApiRequest, ReadsARecordingBesideAsTheOneThatIsOpenWhereItCan) {
  const auto renamed = [](const std::string& header) {
    const std::string text = test::csv_of(test::late_recording());
    return header + text.substr(text.find('\n'));
  };
  const std::string two_loops = "t,FIC1.OP,FIC1.PV,FIC2.PV";
  ASSERT_EQ(post("/api/recording", renamed(two_loops),
                 {{"name", "a.csv"}, {"u", "FIC1.OP"}, {"y", "FIC2.PV"}}),
            202);
  EXPECT_EQ(post("/api/beside", renamed(two_loops), {{"name", "b.csv"}}), 200);
  EXPECT_EQ(session_.view().beside.back().source, "b.csv --u FIC1.OP --y FIC2.PV");
  // Other columns: told by their names, or to be named.
  EXPECT_EQ(post("/api/beside", renamed("t,u,y,x"), {{"name", "c.csv"}}), 200);
  EXPECT_EQ(session_.view().beside.back().source, "c.csv");
  EXPECT_EQ(post("/api/beside", renamed("t,A,B,C"), {{"name", "d.csv"}}), 400);
  EXPECT_EQ(post("/api/beside", renamed("t,A,B,C"),
                 {{"name", "d.csv"}, {"u", "A"}, {"y", "B"}}),
            200);
}

TEST_F(ServeApiRequest, KeepsWhichWayTheValveActsWithItsRecording) {
  const std::string csv = test::csv_of(test::late_recording());
  ASSERT_EQ(post("/api/recording", csv, {{"name", "late.csv"}, {"opens", "no"}}), 202);
  EXPECT_EQ(get("/api/state")["opens"], "no");
  EXPECT_EQ(post("/api/explain"), 202);
  const json explained = get("/api/explain");
  EXPECT_EQ(post("/api/direction", R"({"opens":"yes"})"), 200);
  EXPECT_EQ(get("/api/explain"), explained);
  EXPECT_EQ(post("/api/direction", R"({"opens":"perhaps"})"), 400);
  EXPECT_EQ(post("/api/range", R"({"from":0,"to":400,"what":"fit"})"), 202);
  EXPECT_EQ(get("/api/state")["opens"], "yes");
  const std::string saved = ask("GET", "/api/session").body;
  ASSERT_EQ(post("/api/recording", csv, {{"name", "next.csv"}}), 202);
  EXPECT_EQ(get("/api/state")["opens"], "");
  EXPECT_EQ(post("/api/session", saved), 202);
  EXPECT_EQ(get("/api/state")["opens"], "yes");
}

TEST_F(ServeApiRequest, TakesASamplePeriodInPlaceOfTheTimes) {
  const std::string csv = test::csv_of(test::late_recording());
  for (const char* half : {"0.5", "500ms", "500 ms", "0.5 s"}) {
    ASSERT_EQ(post("/api/recording", csv, {{"name", "a.csv"}, {"ts", half}}), 202)
        << half;
    EXPECT_EQ(get("/api/recording")["sample_period_s"], 0.5) << half;
  }
  for (const char* none : {"abc", "-3", "0", "5 apples", "1e400", "nan"}) {
    EXPECT_EQ(post("/api/recording", csv, {{"name", "a.csv"}, {"ts", none}}), 400)
        << none;
    EXPECT_NE(last_["error"]["message"].get<std::string>().find("as the sample period"),
              std::string::npos);
  }
}

TEST_F(ServeApiRequest, HoldsSeveralFilesInOneBody) {
  const std::string op = "Time [s],Value\n0,4\n1,5\n2,4\n3,7\n";
  const std::string pv = "Time [s],Value\n0,1\n1,3\n2,1\n3,2\n";
  const std::string sizes = std::to_string(op.size()) + '\n' + std::to_string(pv.size());
  const std::string names = "FIC1.OP.csv\nFIC1.PV.csv";
  const auto table = [&](const std::string& of, const std::string& bytes) {
    return ask("POST", "/api/table", bytes, {{"names", names}, {"sizes", of}});
  };
  const ApiResponse both = table(sizes, op + pv);
  EXPECT_EQ(both.status, 200);
  EXPECT_NE(both.body.find("FIC1.PV,3,2"), std::string::npos);
  EXPECT_EQ(table(sizes, op).status, 400);
  EXPECT_EQ(table(sizes, op + pv + "more").status, 400);
  EXPECT_EQ(table("4", op + pv).status, 400);
}

}  // namespace
}  // namespace workbench
