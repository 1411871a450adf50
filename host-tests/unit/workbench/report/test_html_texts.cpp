// The texts of HTML.
#include <gtest/gtest.h>

#include "workbench/report/html_texts.hpp"

namespace workbench {
namespace {

std::string loud(std::string_view html) {
  return with_texts(html, [](std::string_view text) {
    return text.empty() ? std::string() : '[' + std::string(text) + ']';
  });
}

TEST(ReportHtmlTexts, AreWhatStandsBetweenTags) {
  EXPECT_EQ(loud("a<b title=\"x\">c</b>"), "[a]<b title=\"x\">[c]</b>");
  EXPECT_EQ(loud(""), "");
}

TEST(ReportHtmlTexts, AreNoCodeStyleOrScript) {
  EXPECT_EQ(loud("<code>a</code>b<style>p{}</style><script>1<2</script>"),
            "<code>a</code>[b]<style>p{}</style><script>1<2</script>");
}

TEST(ReportHtmlTexts, EndWithATagThatIsNotClosed) {
  EXPECT_EQ(loud("a<b"), "[a]<b");
  EXPECT_EQ(loud("<code>a"), "<code>a");
}

}  // namespace
}  // namespace workbench
