#include <gtest/gtest.h>

#include "workbench/recording/formats/json_table.hpp"

namespace workbench {
namespace {

constexpr const char* kTable = "t\tu\ty\n0\t1.5\t2\n1\t1.6\t\n";

TEST(JsonTable, OfRowsAndColumns) {
  for (const char* text :
       {R"([{"t":0,"u":1.5,"y":2},{"t":1,"u":1.6,"y":null}])",
        "{\"t\":0,\"u\":1.5,\"y\":2}\n{\"t\":1,\"u\":1.6,\"y\":null}\n",
        R"({"columns":["t","u","y"],"index":[0,1],"data":[[0,1.5,2],[1,1.6,null]]})",
        R"({"schema":{"fields":[]},"data":[{"t":0,"u":1.5,"y":2},{"t":1,"u":1.6}]})",
        R"({"@odata.context":"x","value":[{"t":0,"u":1.5,"y":2},{"t":1,"u":1.6}]})",
        R"({"t":[0,1],"u":[1.5,1.6],"y":[2,null]})",
        R"({"t":{"0":0,"1":1},"u":{"0":1.5,"1":1.6},"y":{"0":2,"1":null}})",
        R"({"0":{"t":0,"u":1.5,"y":2},"1":{"t":1,"u":1.6,"y":null}})"}) {
    EXPECT_EQ(json_text(text), kTable) << text;
  }
}

TEST(JsonTable, OfObjectsInObjects) {
  EXPECT_EQ(
      json_text(R"([{"payload":{"op":1,"pv":2},"ts":3},{"payload":{"op":4},"ts":5}])"),
      "payload.op\tpayload.pv\tts\n1\t2\t3\n4\t\t5\n");
}

TEST(JsonTable, OfSeries) {
  EXPECT_EQ(
      json_text(R"({"Items":[{"Name":"A.OP","Items":[{"Timestamp":"x","Value":1}]},)"
                R"({"Name":"A.PV","Items":[{"Timestamp":"x","Value":)"
                R"({"Name":"Bad Input","Value":2,"IsSystem":true}}]}]})"),
      "tag\tTimestamp\tValue\nA.OP\tx\t1\nA.PV\tx\tBad Input\n");
  EXPECT_EQ(json_text(R"({"data":{"result":[{"metric":{"__name__":"op"},)"
                      R"("values":[[1,"44.9"]]}]}})"),
            "tag\ttime\tvalue\nop\t1\t44.9\n");
  EXPECT_EQ(json_text(R"({"results":[{"series":[{"name":"loop","columns":["time","op"],)"
                      R"("values":[[1,2]]}]}]})"),
            "tag\ttime\top\nloop\t1\t2\n");
}

TEST(JsonTable, OfHomeAssistantsHistory) {
  EXPECT_EQ(
      json_text(R"([[{"entity_id":"sensor.op","state":"4.5","attributes":)"
                R"({"unit_of_measurement":"%"},"last_changed":"a",)"
                R"("last_updated":"a"},{"state":"unavailable","last_changed":"b"}],)"
                R"([],[{"entity_id":"sensor.pv","state":"6","last_changed":"a",)"
                R"("last_updated":"c"}]])"),
      "tag\ttime\tvalue\nsensor.op [%]\ta\t4.5\n"
      "sensor.op [%]\tb\tunavailable\nsensor.pv\tc\t6\n");
  EXPECT_EQ(json_text(R"({"sensor.op":[{"s":"4.5","a":{},"lu":1690000000.125},)"
                      R"({"s":"5","lu":1690000001.5}],"sensor.pv":[]})"),
            "tag\ttime\tvalue\nsensor.op\t1690000000.125\t4.5\n"
            "sensor.op\t1690000001.5\t5\n");
  EXPECT_FALSE(json_text(R"([[],[]])"));
  EXPECT_FALSE(json_text(R"([[{"entity_id":"sensor.op","state":"4.5"}]])"));
}

TEST(JsonTable, OfArraysWithoutNames) {
  EXPECT_EQ(json_text("[[0,1,2],[1,1,3]]"), "0\t1\t2\n1\t1\t3\n");
}

TEST(JsonTable, NothingElse) {
  for (const char* text : {"", "{", "7", "{}", "[]", "[1,2]", R"({"version":1})",
                           R"({"process":{"gain":1},"effects":[]})", R"([{"a":1}])"}) {
    EXPECT_FALSE(json_text(text)) << text;
  }
}

TEST(JsonTable, OfNamesWithoutEndIsNone) {
  std::string text = "[";
  for (int k = 0; k < 6000; ++k) {
    text += (k > 0 ? ",{\"n" : "{\"n") + std::to_string(k) + "\":1}";
  }
  EXPECT_FALSE(json_text(text + "]"));
  EXPECT_FALSE(json_text(std::string(200'000, '[') + std::string(200'000, ']')));
}

TEST(JsonTable, LabelsTellSeriesOfOneName) {
  EXPECT_EQ(
      json_text(R"({"data":{"result":[{"metric":{"__name__":"op","job":"x","loop":"A"},)"
                R"("values":[[1,"4"]]},{"metric":{"__name__":"op","job":"x","loop":"B"},)"
                R"("values":[[1,"5"]]}]}})"),
      "tag\ttime\tvalue\nA.op\t1\t4\nB.op\t1\t5\n");
  EXPECT_EQ(
      json_text(R"({"results":[{"series":[{"name":"op","tags":{"loop":"A"},"columns":)"
                R"(["time","value"],"values":[[1,4]]},{"name":"op","tags":{"loop":"B"},)"
                R"("columns":["time","value"],"values":[[1,5]]}]}]})"),
      "tag\ttime\tvalue\nA.op\t1\t4\nB.op\t1\t5\n");
}

TEST(JsonTable, AMetricThatAllSeriesHaveNamesNone) {
  EXPECT_EQ(
      json_text(R"({"data":{"result":[{"metric":{"__name__":"loop_value","s":"op"},)"
                R"("values":[[1,"4"]]},{"metric":{"__name__":"loop_value","s":"pv"},)"
                R"("values":[[1,"5"]]}]}})"),
      "tag\ttime\tvalue\nop\t1\t4\npv\t1\t5\n");
}

TEST(JsonTable, OfKeysWithSamples) {
  EXPECT_EQ(json_text(R"({"op":[{"ts":1,"value":"4"}],"pv":[{"ts":1,"value":"5"}]})"),
            "tag\ttime\tvalue\nop\t1\t4\npv\t1\t5\n");
}

TEST(JsonTable, NaNIsAGap) {
  EXPECT_EQ(json_text(R"([{"t":0,"u":1.5,"y":2},{"t":1,"u":1.6,"y":NaN}])"), kTable);
  EXPECT_EQ(json_text(R"([{"a":"NaN","b":NaN}])"), "a\tb\nNaN\t\n");
}

}  // namespace
}  // namespace workbench
