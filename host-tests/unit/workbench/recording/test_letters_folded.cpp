#include <gtest/gtest.h>

#include "workbench/recording/letters.hpp"

namespace workbench {
namespace {

TEST(Folded, LatinLettersLoseCaseAndMarks) {
  EXPECT_EQ(folded("Wartość ZADANA"), "wartosc zadana");
  EXPECT_EQ(folded("Skutečná"), "skutecna");
  EXPECT_EQ(folded("Çıkış"), "cikis");
  EXPECT_EQ(folded("Măsură ieșire țintă"), "masura iesire tinta");
  EXPECT_EQ(folded("Måleværdi ß"), "malevaerdi ss");
}

TEST(Folded, CyrillicLettersLoseCase) {
  EXPECT_EQ(folded("Ёмкость ВЫХОД Й"), "емкость выход й");
}

TEST(Folded, OthersStay) {
  EXPECT_EQ(folded("操作量"), "操作量");
  EXPECT_EQ(folded("ＰＶ１"), "pv1");
  EXPECT_EQ(folded("a\xFF\xC3"), "a\xFF\xC3");
  EXPECT_EQ(folded(""), "");
}

}  // namespace
}  // namespace workbench
