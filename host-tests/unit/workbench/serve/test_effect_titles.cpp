// Effects by their titles in the sentences of the page.
#include <gtest/gtest.h>

#include "workbench/serve/effect_titles.hpp"

namespace workbench {
namespace {

TEST(ServeEffectTitles, StandInSentences) {
  EXPECT_EQ(with_effect_titles("<p>not valve.stiction, but process.dead_time.</p>"),
            "<p>not stiction, but dead time.</p>");
}

TEST(ServeEffectTitles, LeaveTagsCodeAndOtherWordsAlone) {
  for (const char* html :
       {"<li data-effects=\"valve.stiction\"><code>valve.stiction</code></li>",
        "valve.csv and disturbance.measured:TI7.PV, or 1.5 of u.",
        "<style>p.valve.stiction{}</style>", "<p", ""}) {
    EXPECT_EQ(with_effect_titles(html), html);
  }
}

}  // namespace
}  // namespace workbench
