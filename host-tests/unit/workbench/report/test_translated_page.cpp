// A page in another language: what is read changes, what is not stays.
#include <gtest/gtest.h>

#include "workbench/report/translated_page.hpp"

namespace workbench {
namespace {

Texts german_texts() {
  Texts texts;
  texts.take(
      "  'The valve sticks.': 'Das Ventil klemmt.',\n"
      "  'u < y & \"x\"': 'x > \"u\"',\n"
      "  'at': 'bei',\n");
  return texts;
}

TEST(ReportTranslatedPage, TranslatesTextsAndWhatIsReadOfTags) {
  EXPECT_EQ(translated_page(
                "<!DOCTYPE html>\n<html lang=\"en\"><head>"
                "<title>at.csv: The valve sticks.</title></head><body>"
                "<h1 class=\"at\">The valve sticks.</h1>"
                "<p>u &lt; y &amp; &quot;x&quot;</p>"
                "<svg aria-label=\"at\" data-at=\"at\" viewBox=\"0 0 1 1\"/></body>",
                german_texts(), "de"),
            "<!DOCTYPE html>\n<html lang=\"de\"><head>"
            "<title>at.csv: Das Ventil klemmt.</title></head><body>"
            "<h1 class=\"at\">Das Ventil klemmt.</h1>"
            "<p>x &gt; &quot;u&quot;</p>"
            "<svg aria-label=\"bei\" data-at=\"bei\" viewBox=\"0 0 1 1\"/></body>");
}

TEST(ReportTranslatedPage, LeavesCodeStyleAndScript) {
  const std::string page =
      "<style>at{}</style><script>if (1 < 2) at();</script><code>at</code>";
  EXPECT_EQ(translated_page(page, german_texts(), "de"), page);
}

TEST(ReportTranslatedPage, IsThePageItselfInEnglish) {
  const std::string page = "<html lang=\"en\"><p>1.5 & more";
  EXPECT_EQ(translated_page(page, Texts(), "en"), page);
}

TEST(ReportTranslatedPage, EndsWhereATagDoesNot) {
  EXPECT_EQ(translated_page("<p>at</p><p", german_texts(), "de"), "<p>bei</p><p");
  EXPECT_EQ(translated_page("<style>at", german_texts(), "de"), "<style>at");
}

}  // namespace
}  // namespace workbench
