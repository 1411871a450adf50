// What a file holds, before it is decided what is u and y.
#include <gtest/gtest.h>

#include <cmath>

#include "workbench/recording/input_error.hpp"
#include "workbench/serve/column_preview.hpp"

namespace workbench {
namespace {

using nlohmann::json;

std::string table(const std::string& header, int columns) {
  std::string text = header + '\n';
  for (int k = 0; k < 50; ++k) {
    text += std::to_string(k);
    for (int i = 0; i < columns; ++i) text += ',' + std::to_string(std::sin(k + i));
    text += '\n';
  }
  return text;
}

json preview(const std::string& text, const CsvOptions& options = {}) {
  return json::parse(column_preview(text, "a.csv", options).dump());
}

TEST(ServeColumnPreview, ListsEverySignalWithAPlotAndWhatWouldBeTaken) {
  const json found = preview(table("t,FIC1.OP,FIC1.PV,FIC1.SP", 3));
  ASSERT_EQ(found["signals"].size(), 3U);
  for (const json& signal : found["signals"]) {
    EXPECT_LT(signal["low"], signal["high"]);
    EXPECT_EQ(signal["points"].size(), 50U);
  }
  EXPECT_EQ(found["picked"]["u"], "FIC1.OP");
  EXPECT_EQ(found["picked"]["y"], "FIC1.PV");
  EXPECT_EQ(found["picked"]["sp"], "FIC1.SP");
  EXPECT_TRUE(found["problem"].is_null());
  EXPECT_EQ(found["rows"], 50);
}

TEST(ServeColumnPreview, SaysWhyNothingIsTakenOfSeveralLoops) {
  const json found = preview(table("t,A.OP,A.PV,B.OP,B.PV", 4));
  EXPECT_EQ(found["signals"].size(), 4U);
  EXPECT_TRUE(found["picked"].empty());
  EXPECT_EQ(found["problem"]["kind"], "bad_input");
  EXPECT_NE(found["problem"]["found"].get<std::string>().find("2 loops"),
            std::string::npos);
  ASSERT_EQ(found["loops"].size(), 2U);
  EXPECT_EQ(found["loops"][1]["name"], "B");
  EXPECT_EQ(found["loops"][1]["u"], "B.OP");
  EXPECT_EQ(found["loops"][1]["y"], "B.PV");
}

TEST(ServeColumnPreview, AsksForTheOrderOfDatesAndTakesIt) {
  const std::string text =
      "Time,OP,PV\n03/04/2026 10:00:00,1,2\n04/05/2026 10:00:00,2,3\n"
      "05/06/2026 10:00:00,1,2\n";
  const json asked = preview(text);
  EXPECT_TRUE(asked["signals"].empty());
  EXPECT_NE(asked["problem"]["expected"].get<std::string>().find("dates"),
            std::string::npos);
  CsvOptions options;
  options.date_order = DateOrder::dmy;
  EXPECT_EQ(preview(text, options)["signals"].size(), 2U);
}

TEST(ServeColumnPreview, TakesAPeriodWhereThereIsNoTime) {
  CsvOptions options;
  options.ts = 0.5;
  const json found = preview("valve,flow\n1,2\n2,3\n1,4\n", options);
  EXPECT_EQ(found["signals"].size(), 2U);
  EXPECT_EQ(found["sample_period_s"], 0.5);
}

TEST(ServeColumnPreview, ShowsSignalsThatHaveNoTimes) {
  std::string text = "Ventil,Druck\n";
  for (int k = 0; k < 50; ++k) {
    text += std::to_string(k / 10 % 2) + ',' + std::to_string(std::sin(k)) + '\n';
  }
  const json found = preview(text);
  EXPECT_EQ(found["needs_time"], true);
  EXPECT_TRUE(found["sample_period_s"].is_null());
  EXPECT_EQ(found["signals"].size(), 2U);
  EXPECT_EQ(found["problem"]["kind"], "bad_input");
  CsvOptions options;
  options.ts = 0.5;
  EXPECT_EQ(preview(text, options)["needs_time"], false);
}

TEST(ServeColumnPreview, TakesAColumnThatRisesEvenlyAsSeconds) {
  const json found = preview(table("when,a,b", 2));
  EXPECT_EQ(found["time"], "#1");
  EXPECT_EQ(found["needs_time"], false);
  EXPECT_EQ(found["sample_period_s"], 1);
  EXPECT_EQ(found["signals"].size(), 2U);
}

TEST(ServeColumnPreview, RefusesWhatHasNoHeader) {
  EXPECT_THROW(static_cast<void>(column_preview("", "a.csv", {})), InputError);
}

}  // namespace
}  // namespace workbench
