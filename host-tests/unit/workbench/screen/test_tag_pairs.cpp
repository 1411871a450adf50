#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "support/base/temporary_folder.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/screen/tag_pairs.hpp"

namespace workbench {
namespace {

std::vector<NamedSignal> tag_signals(const std::vector<std::string>& names) {
  std::vector<NamedSignal> out;
  for (const std::string& name : names) {
    out.push_back({column_name(name), out.size() + 1, 1, true});
  }
  return out;
}

std::string shown(const std::vector<NamedSignal>& from, const TagPairs& pairs) {
  std::string out;
  for (const TagLoop& loop : pairs.loops) {
    out += loop.name + "=" + from[loop.u].name.text + "," + from[loop.y].name.text;
    if (loop.sp) out += "," + from[*loop.sp].name.text;
    out += " ";
  }
  for (const std::size_t i : pairs.unpaired) out += "?" + from[i].name.text + " ";
  return out;
}

std::string paired(const std::vector<std::string>& names, const std::string& rules = "") {
  const std::vector<NamedSignal> from = tag_signals(names);
  return shown(from,
               pair_tags(from, rules.empty() ? PairRules{} : PairRules::parse(rules)));
}

TEST(TagPairs, UsualNamesMakeLoopsAndTheRestIsListed) {
  EXPECT_EQ(
      paired({"FIC101.OP", "FIC101.PV", "FIC101.SP", "TI7.PV", "LIC2.PV", "LIC2.OUT"}),
      "FIC101=FIC101.OP,FIC101.PV,FIC101.SP LIC2=LIC2.OUT,LIC2.PV ?TI7.PV ");
}

TEST(TagPairs, BlocksOfOneLoopMayStandApart) {
  EXPECT_EQ(paired({"FIC101.PIDA.OP", "FIC101.DACA.PV"}),
            "FIC101.PIDA=FIC101.PIDA.OP,FIC101.DACA.PV ");
}

TEST(TagPairs, RulesComeFirstAndKnowNoCase) {
  EXPECT_EQ(paired({"fc1_ao", "FC1_ME", "FC2_AO"}, "*_AO/*_ME"),
            "fc1=fc1_ao,FC1_ME ?FC2_AO ");
}

TEST(TagPairs, ARuleWithoutAStarNamesTheSignals) {
  EXPECT_EQ(paired({"FT_115", "LV_106", "F1.OP", "F1.PV"}, "lv_106/FT_115"),
            "=LV_106,FT_115 F1=F1.OP,F1.PV ");
  EXPECT_EQ(paired({"A", "B", "C", "D"}, "B/A,D/C"), "B=B,A D=D,C ");
  EXPECT_EQ(paired({"A", "B", "C"}, "#3/#1"), "=C,A ?B ");
  EXPECT_EQ(paired({"A", "B"}, "A/A,A/Z,#7/B"), "?A ?B ");
}

TEST(TagPairs, CvBesideMvIsADoubt) {
  const TagPairs pairs = pair_tags(tag_signals({"F1.CV", "F1.PV", "F1.MV"}), {});
  EXPECT_TRUE(pairs.loops.empty());
  ASSERT_EQ(pairs.doubts.size(), 1U);
  EXPECT_NE(pairs.doubts[0].find("'F1.CV' and 'F1.MV'"), std::string::npos);
}

TEST(TagPairs, TwoCandidatesAreADoubtAndNotAGuess) {
  const std::vector<NamedSignal> from = tag_signals({"F1.OUT", "F1.CO", "F1.PV"});
  const TagPairs pairs = pair_tags(from, {});
  EXPECT_TRUE(pairs.loops.empty());
  ASSERT_EQ(pairs.doubts.size(), 1U);
  EXPECT_NE(pairs.doubts[0].find("'F1.OUT' and 'F1.CO'"), std::string::npos);
}

TEST(TagPairs, AListNamesTheLoops) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("loops.csv")) << "loop,u,y,sp\nBoiler,A,B,\nNone,X,Y,Z\n";
  EXPECT_EQ(paired({"A", "B", "F1.OP", "F1.PV"}, folder.file("loops.csv")),
            "Boiler=A,B ?F1.OP ?F1.PV ");
}

TEST(TagPairs, RulesThatAreNoneAreRefused) {
  EXPECT_THROW((void)PairRules::parse("*.OP"), std::invalid_argument);
  for (const char* text : {"*.OP/PV", "OP/", "*.*/*.*", "lists/loops.csv"}) {
    EXPECT_THROW((void)PairRules::parse(text), std::invalid_argument) << text;
  }
  const TemporaryFolder folder;
  std::ofstream(folder.file("loops.csv")) << "tag,u\nA,B\n";
  EXPECT_THROW((void)PairRules::parse(folder.file("loops.csv")), InputError);
}

}  // namespace
}  // namespace workbench
