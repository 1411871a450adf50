#include <gtest/gtest.h>

#include <string>

#include "workbench/recording/input_error.hpp"
#include "workbench/recording/lvm_segments.hpp"

namespace workbench {
namespace {

std::string segment(const std::string& clock, const std::string& names,
                    const std::string& rows) {
  return "\nDate\t2026/05/13\t\nTime\t" + clock + "\t\n***End_of_Header***\t\n" + names +
         '\n' + rows;
}

const std::string kLvmHead = "LabVIEW Measurement\t\n***End_of_Header***\t\n";

TEST(LvmSegments, AreJoinedByTheirClock) {
  const auto text = lvm_segments_text(
      kLvmHead + segment("06:00:00", "X_Value\tOP", "0.0\t1\n3.0\t2\n") +
          segment("06:00:06,5", "X_Value\tOP", "0.0\t3\n"),
      "f.lvm");
  ASSERT_TRUE(text);
  EXPECT_EQ(*text, "\n\n\n\n\n\nX_Value\tOP\n0\t1\n3\t2\n\n\n\n\n\n6.5\t3\n");
}

TEST(LvmSegments, OneIsLeftAsItIs) {
  EXPECT_FALSE(
      lvm_segments_text(kLvmHead + segment("06:00:00", "X_Value\tOP", "0\t1\n"), "f"));
  EXPECT_FALSE(lvm_segments_text("Time,OP\n", "f"));
}

TEST(LvmSegments, OthersAreRefused) {
  const std::string first = kLvmHead + segment("06:00:00", "X_Value\tOP", "0\t1\n");
  for (const std::string& second :
       {segment("06:00:06", "X_Value\tPV", "0\t1\n"),
        segment("", "X_Value\tOP", "0\t1\n"), segment("06:00:06", "OP", "1\n")}) {
    EXPECT_THROW((void)lvm_segments_text(first + second, "f"), InputError);
  }
}

}  // namespace
}  // namespace workbench
