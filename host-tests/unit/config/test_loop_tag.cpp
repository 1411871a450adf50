#include <gtest/gtest.h>

#include "config/loop_tag.hpp"

namespace config {
namespace {

TEST(LoopTag, IsPlainAndShort) {
  EXPECT_EQ(problem_of_tag("FIC-101/PV_2"), "");
  EXPECT_EQ(problem_of_tag(std::string(kMostTagBytes, 'A')), "");
  EXPECT_EQ(problem_of_tag(std::string(kMostTagBytes + 1, 'A')),
            "expected up to 32 characters, found 33 in \"" +
                std::string(kMostTagBytes + 1, 'A') + "\"; shorten the tag");
}

TEST(LoopTag, NamesTheCharacterThatIsNot) {
  const std::string expected = "expected ASCII characters without blanks and quotes, ";
  const std::string cure = "; leave it out, or write - or _";
  EXPECT_EQ(problem_of_tag("FIC 101"), expected + "found a blank in \"FIC 101\"" + cure);
  EXPECT_EQ(problem_of_tag("Füll-101"), expected + "found \"ü\" in \"Füll-101\"" + cure);
  EXPECT_EQ(problem_of_tag("A\tB"),
            expected + "found a control character in \"A\tB\"" + cure);
  EXPECT_EQ(problem_of_tag("A\"B"), expected + "found a quote in \"A\"B\"" + cure);
}

}  // namespace
}  // namespace config
