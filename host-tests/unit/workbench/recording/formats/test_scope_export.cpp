#include <gtest/gtest.h>

#include "workbench/recording/formats/scope_export.hpp"

namespace workbench {
namespace {

std::string scope(const std::string& factor = "1", const std::string& time = "0") {
  return "Name;s1\r\nFile;C:\\s1.csv\r\n\r\nName;A.OP;Name;A.PV\r\nUnit;;Unit;\r\n"
         "Unit ScaleFactor;1;Unit ScaleFactor;" +
         factor + "\r\n\r\n" + time + ";1.5;0;2.5\r\n10;1.6;10;2.6\r\n";
}

TEST(ScopeExport, BecomesATableOfAsManyLines) {
  EXPECT_EQ(scope_text(scope()),
            "\n\n\n\n\n\nt [ms];A.OP;t [ms];A.PV\n0;1.5;0;2.5\r\n10;1.6;10;2.6\r\n");
}

TEST(ScopeExport, SaysInANameWhatItsValuesMayStillWant) {
  EXPECT_EQ(scope_text(scope("0.1")),
            "\n\n\n\n\n\nt [ms];A.OP;t [ms];A.PV Unit ScaleFactor 0.1\n"
            "0;1.5;0;2.5\r\n10;1.6;10;2.6\r\n");
}

TEST(ScopeExport, GivesSignalsOfOnePeriodOneTime) {
  EXPECT_EQ(scope_text("Name\ts1\n\nName\tA.OP\tName\tA.PV\tA.SP\n"
                       "SampleTime[ms]\t1\tSampleTime[ms]\t2\t2\n"
                       "IndexOffset\t7\tIndexOffset\t8\t9\n"
                       "Unit\t(None)\tUnit\tl/min (Flow)\t(None)\n\n0\t1\t0\t2\t3\n"),
            "\n\n\n\n\n\nt [ms]\tA.OP\tt [ms]\tA.PV [l/min]\tA.SP\n0\t1\t0\t2\t3\n");
}

TEST(ScopeExport, MayEndLinesWithASeparator) {
  EXPECT_EQ(scope_text("Name\ts1\t\nFile\ts1.csv\t\n\nName\tA.OP\tName\tA.PV\t\n"
                       "SymbolComment\t\tSymbolComment\t\t\n"
                       "SampleTime[ms]\t1\tSampleTime[ms]\t1\n\n0\t1\t0\t2\t\n"),
            "\n\n\n\n\n\nt [ms]\tA.OP\tt [ms]\tA.PV\n0\t1\t0\t2\t\n");
  EXPECT_FALSE(scope_text("Name;A;Name;B;\nUnit;;Unit;;5\n0;1;0;2;\n"));
}

TEST(ScopeExport, IsKnownByItsSymbols) {
  EXPECT_EQ(scope_text("Name,YT Scope Project,\nFile,s1.csv,\n\n\nName,A,Name,B\n"
                       "SampleTime,50,SampleTime,50\nSymbolBased,True,SymbolBased,True\n"
                       "SymbolName,GVL.A,SymbolName,GVL.B\n\n\n0,1,0,2\n"),
            "\n\n\n\n\n\n\n\n\nt [ms],A,t [ms],B\n0,1,0,2\n");
}

TEST(ScopeExport, MayHaveTheTimesOfWindows) {
  EXPECT_EQ(scope_text(scope("1", "133238090039920000"))->substr(6, 16),
            "Time;A.OP;Time;A");
}

TEST(ScopeExport, IsNoneWithoutRowsOrAttributes) {
  EXPECT_FALSE(scope_text(""));
  EXPECT_FALSE(scope_text("Name;Value\nFIC101.OP;1\nFIC101.PV;2\n"));
  EXPECT_FALSE(scope_text("Name;A;Name;B\n0;1;0;2\n"));
  EXPECT_FALSE(scope_text(scope("1", "no time")));
  EXPECT_FALSE(scope_text(scope("1", "0;9")));  // cells without a name
}

}  // namespace
}  // namespace workbench
