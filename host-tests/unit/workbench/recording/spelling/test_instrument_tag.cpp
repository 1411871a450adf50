// Tags of instruments by their letters.
#include <gtest/gtest.h>

#include "workbench/recording/spelling/instrument_tag.hpp"

namespace workbench {
namespace {

using Pieces = std::vector<std::string>;

TEST(InstrumentTag, TransmitterAndValveOfOneNumberAreOneLoop) {
  for (const Pieces& pieces :
       {Pieces{"ft", "211"}, Pieces{"ft211"}, Pieces{"fit", "211"}, Pieces{"fi211"}}) {
    const auto tag = instrument_tag(pieces);
    ASSERT_TRUE(tag) << pieces[0];
    EXPECT_EQ(tag->part, Part::kY);
    EXPECT_EQ(tag->tag, "f211");
  }
  for (const Pieces& pieces : {Pieces{"fv", "211"}, Pieces{"fcv211"}}) {
    const auto tag = instrument_tag(pieces);
    ASSERT_TRUE(tag) << pieces[0];
    EXPECT_EQ(tag->part, Part::kU);
    EXPECT_EQ(tag->tag, "f211");
  }
  EXPECT_EQ(instrument_tag({"unit5", "lt", "106a"})->tag, "unit5l106a");
  EXPECT_EQ(instrument_tag({"unit5", "lt", "106a"})->piece, 1U);
}

TEST(InstrumentTag, OtherNamesAreNone) {
  for (const Pieces& pieces :
       {Pieces{}, Pieces{"ft"}, Pieces{"ft", "2"}, Pieces{"t1"}, Pieces{"pv", "101"},
        Pieces{"cv101"}, Pieces{"fic", "211"}, Pieces{"fitness", "22"}, Pieces{"211"},
        Pieces{"ft", "211abc"}, Pieces{"motor", "12"}}) {
    EXPECT_FALSE(instrument_tag(pieces)) << (pieces.empty() ? "" : pieces[0]);
  }
}

TEST(LoopOfTag, IsTheVariableAndNumberBehindWhatStandsBefore) {
  struct Example {
    Pieces pieces;
    const char* loop;
  };
  for (const Example& e : std::vector<Example>{
           {{"fic101"}, "f101"},
           {{"ft", "101"}, "f101"},
           {{"area1", "fic", "101"}, "area1f101"},
           {{"01", "fic", "101"}, "01f101"},
           {{"10fic101"}, "10f101"},
           {{"fic", "101", "b"}, "f101b"},
           {{"plant", "pdic101", "pid1"}, "plantpd101"},
           {{"unit", "1", "tic205", "ai1"}, "unit1t205"},
       }) {
    EXPECT_EQ(loop_of_tag(e.pieces), e.loop);
  }
}

TEST(LoopOfTag, OfAnInstrumentIsToldFromOthers) {
  EXPECT_EQ(loop_of_instrument(Pieces{"area1", "fic101", "op"}), "area1f101");
  EXPECT_FALSE(loop_of_instrument(Pieces{"loop1", "controller"}));
  EXPECT_FALSE(loop_of_instrument(Pieces{}));
}

TEST(LoopOfTag, NoInstrumentLeavesAllButThePartsOfAnyLoop) {
  EXPECT_EQ(loop_of_tag(Pieces{"loop1", "controller"}), "loop1");
  EXPECT_EQ(loop_of_tag(Pieces{"area1", "pida"}), "area1");
  EXPECT_EQ(loop_of_tag(Pieces{"area1", "reactor"}), "area1reactor");
  EXPECT_EQ(loop_of_tag(Pieces{"pisrv01", "boiler"}), "pisrv01boiler");
  EXPECT_EQ(loop_of_tag(Pieces{"pid"}), "pid");
  EXPECT_EQ(loop_of_tag(Pieces{}), "");
}

}  // namespace
}  // namespace workbench
