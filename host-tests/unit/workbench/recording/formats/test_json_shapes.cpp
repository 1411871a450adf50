#include <gtest/gtest.h>

#include "workbench/recording/formats/json_shapes.hpp"
#include "workbench/recording/formats/json_table.hpp"

namespace workbench {
namespace {

using Json = nlohmann::ordered_json;

TEST(JsonShapes, OfThingSpeakAreRowsWithTheNamesOfTheChannel) {
  EXPECT_EQ(json_text(R"({"channel":{"id":9,"name":"Loop","field1":"OP","field2":"PV"},)"
                      R"("feeds":[{"created_at":"a","entry_id":1,"field1":"4.5",)"
                      R"("field2":"6"},{"created_at":"b","entry_id":2,"field1":"4.6",)"
                      R"("field2":null}]})"),
            "created_at\tentry_id\tOP\tPV\na\t1\t4.5\t6\nb\t2\t4.6\t\n");
  EXPECT_EQ(json_text(R"({"channel":{"field1":"X","field2":"X"},"feeds":)"
                      R"([{"field1":1,"field2":2},{"field1":3,"field2":4}]})"),
            "X\tfield2\n1\t2\n3\t4\n")
      << "of one name twice the second stays as it is";
}

TEST(JsonShapes, OfGraphiteHaveTheValueBeforeTheTime) {
  EXPECT_EQ(json_text(R"([{"target":"A.OP","datapoints":[[4.5,10],[null,11]]},)"
                      R"({"target":"A.PV","tags":{"x":"y"},"datapoints":[[6,10]]}])"),
            "tag\ttime\tvalue\nA.OP\t10\t4.5\nA.OP\t11\t\nA.PV\t10\t6\n");
}

TEST(JsonShapes, OfPandasKeepAnIndexThatIsMoreThanARowNumber) {
  const char* table = "OP\tPV\ttime\n1\t2\t1773735300000\n3\t4\t1773735301000\n";
  for (const char* text :
       {R"({"columns":["OP","PV"],"index":[1773735300000,1773735301000],)"
        R"("data":[[1,2],[3,4]]})",
        R"({"OP":{"1773735300000":1,"1773735301000":3},)"
        R"("PV":{"1773735300000":2,"1773735301000":4}})",
        R"({"1773735300000":{"OP":1,"PV":2},"1773735301000":{"OP":3,"PV":4}})"}) {
    EXPECT_EQ(json_text(text), table) << text;
  }
  EXPECT_EQ(json_text(R"({"OP":{"0.5":1,"1.0":3},"PV":{"0.5":2,"1.0":4}})"),
            "OP\tPV\tindex\n1\t2\t0.5\n3\t4\t1.0\n");
  EXPECT_EQ(json_text(R"({"columns":["Time"],"index":[1773735300000],"data":[["a"]]})"),
            "Time\tindex\na\t1773735300000\n")
      << "the times of the file stay those";
}

TEST(JsonShapes, OthersStayAsTheyAre) {
  for (const char* text : {R"({"columns":["OP"],"index":[0,1],"data":[[1],[3]]})",
                           R"({"OP":{"0":1,"1":3},"PV":{"0":2,"1":4}})",
                           R"({"0":{"time":1,"OP":3},"1":{"time":2,"OP":4}})",
                           R"({"OP":{"5":1,"6":3},"PV":{"5":2,"7":4}})",
                           R"([{"target":"A","datapoints":[[1,"x"]]}])",
                           R"([{"target":"A"}])", R"({"channel":{},"feeds":[]})",
                           R"({"a":{"b":{"c":1}},"d":{"b":{"c":1}}})", "[]", "{}", "7"}) {
    const Json json = Json::parse(text);
    EXPECT_EQ(known_shape(json), json) << text;
  }
}

}  // namespace
}  // namespace workbench
