// Strokes of the valve in the report, as the page names them.
#include <gtest/gtest.h>

#include "workbench/serve/direction_words.hpp"

namespace workbench {
namespace {

constexpr const char* kHtml =
    "<html lang=\"en\"><p>Stick band, ascending</p><td>slip jump descending</td>"
    "<p>The valve sticks when the controller output rises, not when it falls. It is "
    "1.5 wide.</p>";

TEST(ServeDirectionWords, LeaveTheStrokesWhereTheValveIsUnknown) {
  EXPECT_EQ(in_direction_words(kHtml, Opens::unknown),
            "<html lang=\"en\"><p>Stick band, ascending</p><td>slip jump descending</td>"
            "<p>The valve sticks when the controller output rises, not when it falls. It "
            "is 1.5 wide.</p>");
}

TEST(ServeDirectionWords, NameTheStrokeOfTheValveWhereItIsKnown) {
  EXPECT_EQ(in_direction_words(kHtml, Opens::yes),
            "<html lang=\"en\"><p>Stick band, opening</p><td>slip jump closing</td>"
            "<p>The valve sticks when it opens, not when it closes. It is 1.5 wide.</p>");
  EXPECT_EQ(in_direction_words(kHtml, Opens::no),
            "<html lang=\"en\"><p>Stick band, closing</p><td>slip jump opening</td>"
            "<p>The valve sticks when it closes, not when it opens. It is 1.5 wide.</p>");
}

}  // namespace
}  // namespace workbench
