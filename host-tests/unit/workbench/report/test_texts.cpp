// Sentences in another language: whole, with gaps, listed, one after the other.
#include <gtest/gtest.h>

#include "workbench/report/texts.hpp"

namespace workbench {
namespace {

Texts german() {
  Texts texts;
  texts.take(
      "// German.\n"
      "export default {\n"
      "  '1.5': '1,5',\n"
      "  ' and ': ' und ',\n"
      "  'stiction': 'Haften',\n"
      "  'dead time': 'Totzeit',\n"
      "  'valve\\'s': 'des Ventils',\n"
      "  'across': 'über',\n"
      "  'The valve sticks.': 'Das Ventil klemmt.',\n"
      "  'What would: {0}.': 'Was es könnte: {0}.',\n"
      "  '{0} to {1}': '{0} bis {1}',\n"
      "  '{0} backlash': '{0} × Spiel',\n"
      "  'above u = {1}, below {0}': 'unter {0}, über u = {1}',\n"
      "};\n");
  return texts;
}

TEST(ReportTexts, CapitaliseTheFirstLetterOnly) {
  EXPECT_EQ(capitalised("u in %"), "U in %");
  EXPECT_EQ(capitalised("über u"), "Über u");
  EXPECT_EQ(capitalised(""), "");
}

TEST(ReportTexts, SayWhatTheTableHas) {
  const Texts texts = german();
  EXPECT_EQ(texts.translated("The valve sticks."), "Das Ventil klemmt.");
  EXPECT_EQ(texts.translated("valve's"), "des Ventils");
  EXPECT_EQ(texts.translated("Stiction"), "Haften");
  EXPECT_EQ(texts.translated("Across"), "Über");
  EXPECT_EQ(texts.translated("  dead\n time "), "  Totzeit ");
  EXPECT_EQ(texts.entry("stiction"), "Haften");
  EXPECT_EQ(texts.entry("backlash"), "backlash");
}

TEST(ReportTexts, FillGapsAndTranslateWhatIsInThem) {
  const Texts texts = german();
  EXPECT_EQ(texts.translated("3 backlash"), "3 × Spiel");
  EXPECT_EQ(texts.translated("Dead time and backlash"), "Dead time and backlash");
  EXPECT_EQ(texts.translated("above u = 2.5, below 1.5"), "unter 1,5, über u = 2,5");
  EXPECT_EQ(texts.translated("What would: dead time."), "Was es könnte: Totzeit.");
  EXPECT_EQ(texts.translated("1.2 to 3"), "1,2 bis 3");
  // So short a sentence takes single words.
  EXPECT_EQ(texts.translated("it goes to the end"), "it goes to the end");
}

TEST(ReportTexts, TakeSentencesInTurn) {
  const Texts texts = german();
  EXPECT_EQ(texts.translated("The valve sticks. Nobody knows. What would: stiction."),
            "Das Ventil klemmt. Nobody knows. Was es könnte: Haften.");
}

TEST(ReportTexts, ListNamesAndLeaveCodes) {
  const Texts texts = german();
  EXPECT_EQ(texts.translated("stiction, dead time and stiction"),
            "Haften, Totzeit und Haften");
  EXPECT_EQ(texts.translated("sensor.lag and dead time"), "sensor.lag und Totzeit");
  EXPECT_EQ(texts.translated("stiction and thunder"), "stiction and thunder");
}

TEST(ReportTexts, WriteNumbersWithTheMarkOfTheLanguage) {
  const Texts texts = german();
  EXPECT_EQ(texts.translated("5.03 % of 12.5."), "5,03 % of 12,5.");
  EXPECT_EQ(texts.translated("on 13.05.2026"), "on 13.05.2026");
  EXPECT_EQ(texts.translated("loop-1.5.csv"), "loop-1.5.csv");
}

TEST(ReportTexts, LeaveEverythingWithoutATable) {
  const Texts none;
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none.translated("It is 1.5."), "It is 1.5.");
}

TEST(ReportTexts, PassOverWhatIsNoEntry) {
  Texts texts;
  texts.take("  'open\n  'a': b,\n  'c' 'd'\n  'e': 'f");
  EXPECT_TRUE(texts.empty());
  texts.take("  'a': 'b',\n  'a': 'c',\n");
  EXPECT_EQ(texts.entry("a"), "c");
}

}  // namespace
}  // namespace workbench
