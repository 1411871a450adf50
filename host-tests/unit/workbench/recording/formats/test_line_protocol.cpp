#include <gtest/gtest.h>

#include "workbench/recording/formats/line_protocol.hpp"
#include "workbench/recording/input_error.hpp"

namespace workbench {
namespace {

TEST(LineProtocol, IsATableOfTagsAndValues) {
  EXPECT_EQ(line_protocol_text("# DML\n"
                               "CREATE DATABASE plant\n"
                               "loop,area=North\\ 4,tag=FIC101 op=44.9,n=3i 1773475200\n"
                               "\r\n"
                               "FIC101.PV value=60,say=\"a b, \\\"c\\\"\" 1773475201\r\n",
                               "f"),
            "time\ttag\tvalue\n"
            "1773475200\tloop.North 4.FIC101.op\t44.9\n"
            "1773475200\tloop.North 4.FIC101.n\t3\n"
            "1773475201\tFIC101.PV.value\t60\n"
            "1773475201\tFIC101.PV.say\ta b, c\n");
}

TEST(LineProtocol, LeavesOtherTexts) {
  for (const char* text :
       {"", "t,u,y\n0,1,2\n", "t u y\n0 1 2\n", "a b=c\n", "a b=c 12\n",
        "(1436509052.249713) vcan0 044#2A366C2BBA\n", "loop,tag op=1 1773475200\n"}) {
    EXPECT_FALSE(line_protocol_text(text, "f")) << text;
  }
}

TEST(LineProtocol, RefusesALineOfAnotherKind) {
  try {
    (void)line_protocol_text("a op=1 1773475200\na op=2\na op=", "f");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.line, 2U);
    EXPECT_EQ(error.found, "'a op=2'");
  }
}

}  // namespace
}  // namespace workbench
