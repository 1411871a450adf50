#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "workbench/recording/formats/named_rows.hpp"

namespace workbench {
namespace {

TEST(NamedRows, IsATableOfAllNames) {
  NamedRows rows;
  rows.end_row();
  rows.put("op", "44.9");
  rows.put("say", "\"a\t\\\"b\\\"\"");
  rows.put("op", "7");
  rows.end_row();
  rows.put("pv", "60");
  rows.put("op", "45");
  rows.end_row();
  rows.end_row();
  EXPECT_EQ(rows.rows(), 2U);
  EXPECT_EQ(rows.text(), "op\tsay\tpv\n44.9\ta b\t\n45\t\t60\n");
}

TEST(NamedRows, LeavesOutARowThatIsOpen) {
  NamedRows rows;
  rows.put("op", "1");
  rows.end_row();
  rows.put("op", "2");
  EXPECT_EQ(rows.text(), "op\n1\n");
}

TEST(NamedRows, IsFullOfNames) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i <= NamedRows::kMostNames; ++i) {
    names.push_back("n" + std::to_string(i));
  }
  NamedRows rows;
  for (std::size_t i = 0; i < NamedRows::kMostNames; ++i) rows.put(names[i], "1");
  EXPECT_FALSE(rows.is_full());
  rows.put(names.back(), "1");
  EXPECT_TRUE(rows.is_full());
}

}  // namespace
}  // namespace workbench
