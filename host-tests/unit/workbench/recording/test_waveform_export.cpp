#include <gtest/gtest.h>

#include "workbench/recording/waveform_export.hpp"

namespace workbench {
namespace {

std::string waveform(const std::string& columns = "No",
                     const std::string& steps = "0,5\t0,5",
                     const std::string& more = "") {
  return "LabVIEW Measurement\r\nSeparator\tTab\r\nDecimal_Separator\t,\r\nX_Columns\t" +
         columns + "\r\n***End_of_Header***\r\nX0\t2,0\t2,0\r\nDelta_X\t" + steps +
         "\r\n***End_of_Header***\r\n" + more +
         "X_Value\tOP\tPV\r\n\t1,5\t9\r\n\t1,6\t8\r\n";
}

TEST(WaveformExport, HasATimeInEachRow) {
  const std::optional<std::string> text = waveform_text(waveform());
  ASSERT_TRUE(text);
  EXPECT_TRUE(text->ends_with("X_Value\tOP\tPV\r\n2\t1,5\t9\r\n2,5\t1,6\t8\r\n"));
}

TEST(WaveformExport, IsLeftAloneWhereTimesStandOrDiffer) {
  EXPECT_FALSE(waveform_text(waveform("One")));
  EXPECT_FALSE(waveform_text(waveform("No", "0,5\t1,0")));
  EXPECT_FALSE(waveform_text(waveform("No", "0,0\t0,0")));
  EXPECT_FALSE(waveform_text(waveform("No", "0,5\t0,5", "***End_of_Header***\r\n")));
  EXPECT_FALSE(waveform_text("LabVIEW Measurement\r\n***End_of_Header***"));
  EXPECT_FALSE(waveform_text("t,u,y\n0,1,2\n"));
}

}  // namespace
}  // namespace workbench
