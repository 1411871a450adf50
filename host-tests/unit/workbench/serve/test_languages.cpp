// The languages of the page and of the reports.
#include <gtest/gtest.h>

#include <algorithm>

#include "workbench/serve/languages.hpp"

namespace workbench {
namespace {

TEST(ServeLanguages, AreEnglishAndTheFilesOfTexts) {
  ASSERT_GE(languages().size(), 2u);
  EXPECT_EQ(languages().front(), "en");
  EXPECT_NE(std::find(languages().begin(), languages().end(), "de"), languages().end());
}

TEST(ServeLanguages, HaveATableEachOfAllItsFiles) {
  EXPECT_TRUE(texts_of("en").empty());
  EXPECT_TRUE(texts_of("xx").empty());
  const Texts& german = texts_of("de");
  EXPECT_EQ(german.translated("The valve sticks."), "Das Ventil klemmt.");
  EXPECT_EQ(german.translated("Valve report"), "Ventilbericht");
  EXPECT_EQ(german.translated("0.5 to 1.5"), "0,5 bis 1,5");
}

TEST(ServeLanguages, AreImportedByThePage) {
  const std::string script(all_texts_script());
  EXPECT_NE(script.find("import de from './de.js';"), std::string::npos) << script;
  EXPECT_NE(script.find("export default {de"), std::string::npos) << script;
}

}  // namespace
}  // namespace workbench
