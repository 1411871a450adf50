// The parts of a page: what is escaped, and what is left out.
#include <gtest/gtest.h>

#include "workbench/report/page_parts.hpp"

namespace workbench {
namespace {

TEST(ReportPageParts, EscapePlainText) {
  EXPECT_EQ(section("a < b", "c & d", "<i>kept</i>"),
            "<section><h2>a &lt; b</h2>\n<p>c &amp; d</p>\n<i>kept</i></section>\n");
  EXPECT_EQ(tile("<", ">", "&"),
            "<div class=\"tile\"><span>&lt;</span><b>&gt;</b><span>&amp;</span></div>");
  EXPECT_EQ(bullet_list({"1 < 2"}), "<ul><li>1 &lt; 2</li></ul>\n");
}

TEST(ReportPageParts, LeaveOutWhatIsEmpty) {
  EXPECT_EQ(section("title", "introduction", ""), "");
  EXPECT_EQ(bullet_list({}), "");
  EXPECT_EQ(side_by_side("", ""), "");
  EXPECT_EQ(verdict_box(Mood::kGood, "Well.", {{"Cause.", ""}, {"", "Fine."}}),
            "<div class=\"verdict good\"><h1>Well.</h1><p>Fine.</p></div>\n");
}

}  // namespace
}  // namespace workbench
