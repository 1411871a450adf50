#include <gtest/gtest.h>

#include <string>

#include "workbench/recording/formats/labview_export.hpp"
#include "workbench/recording/input_error.hpp"

namespace workbench {
namespace {

std::string segment(const std::string& clock, const std::string& names,
                    const std::string& rows) {
  return "\nDate\t2026/05/13\t\nTime\t" + clock + "\t\n***End_of_Header***\t\n" + names +
         '\n' + rows;
}

const std::string kLvmHead = "LabVIEW Measurement\t\n***End_of_Header***\t\n";

TEST(LabviewExport, JoinsSegmentsByTheirClock) {
  const auto text =
      labview_text(kLvmHead + segment("06:00:00", "X_Value\tOP", "0.0\t1\n3.0\t2\n") +
                       segment("06:00:06,5", "X_Value\tOP", "0.0\t3\n"),
                   "f.lvm");
  ASSERT_TRUE(text);
  EXPECT_EQ(*text, "\n\n\n\n\n\nX_Value\tOP\n0\t1\n3\t2\n\n\n\n\n\n6.5\t3\n");
}

TEST(LabviewExport, LeavesOneSegmentWithTimes) {
  EXPECT_FALSE(
      labview_text(kLvmHead + segment("06:00:00", "X_Value\tOP", "0\t1\n"), "f"));
  EXPECT_FALSE(labview_text("Time,OP\n", "f"));
}

TEST(LabviewExport, RefusesOtherSegments) {
  const std::string first = kLvmHead + segment("06:00:00", "X_Value\tOP", "0\t1\n");
  for (const std::string& second :
       {segment("06:00:06", "X_Value\tPV", "0\t1\n"),
        segment("", "X_Value\tOP", "0\t1\n"), segment("06:00:06", "OP", "1\n")}) {
    EXPECT_THROW((void)labview_text(first + second, "f"), InputError);
  }
}

std::string waveform(const std::string& columns = "No",
                     const std::string& steps = "0,5\t0,5",
                     const std::string& more = "") {
  return "LabVIEW Measurement\r\nSeparator\tTab\r\nDecimal_Separator\t,\r\nX_Columns\t" +
         columns + "\r\n***End_of_Header***\r\nX0\t2,0\t2,0\r\nDelta_X\t" + steps +
         "\r\n***End_of_Header***\r\n" + more +
         "X_Value\tOP\tPV\r\n\t1,5\t9\r\n\t1,6\t8\r\n";
}

TEST(LabviewExport, GivesEachRowItsTime) {
  const std::optional<std::string> text = labview_text(waveform(), "f");
  ASSERT_TRUE(text);
  EXPECT_TRUE(text->ends_with("X_Value\tOP\tPV\r\n2\t1,5\t9\r\n2,5\t1,6\t8\r\n"));
}

TEST(LabviewExport, LeavesRowsWhereTimesStandOrDiffer) {
  EXPECT_FALSE(labview_text(waveform("One"), "f"));
  EXPECT_FALSE(labview_text(waveform("No", "0,5\t1,0"), "f"));
  EXPECT_FALSE(labview_text(waveform("No", "0,0\t0,0"), "f"));
  EXPECT_THROW(
      (void)labview_text(waveform("No", "0,5\t0,5", "***End_of_Header***\r\n"), "f"),
      InputError);
  EXPECT_FALSE(labview_text("LabVIEW Measurement\r\n***End_of_Header***", "f"));
  EXPECT_FALSE(labview_text("t,u,y\n0,1,2\n", "f"));
}

}  // namespace
}  // namespace workbench
