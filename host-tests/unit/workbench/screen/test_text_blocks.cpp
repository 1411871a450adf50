#include <gtest/gtest.h>

#include <fstream>

#include "support/base/temporary_folder.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/screen/text_blocks.hpp"

namespace workbench {
namespace {

class TextBlocksTest : public ::testing::Test {
 protected:
  std::string write(const std::string& text) {
    std::ofstream(folder.file("f"), std::ios::binary) << text;
    return folder.file("f");
  }
  TemporaryFolder folder;
};

TEST_F(TextBlocksTest, BlocksEndWithLines) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string text;
    for (int i = 0; i < 400; ++i) text += std::to_string(i * i) + ",x" + end;
    const std::string path = write(text);
    for (const std::size_t size : {16U, 17U, 18U, 64U, 100'000U}) {
      TextBlocks blocks(path, size);
      std::string read;
      for (auto block = blocks.next(); !block.empty(); block = blocks.next()) {
        read += block;
        if (read.size() < text.size()) {
          EXPECT_EQ(block.substr(block.size() - end.size()), end) << size;
        }
      }
      EXPECT_EQ(read, text);
      EXPECT_EQ(blocks.bytes_read(), text.size());
    }
  }
}

TEST_F(TextBlocksTest, MarksGoAndUtf16IsConverted) {
  EXPECT_EQ(TextBlocks(write("\xEF\xBB\xBFu,y\n")).next(), "u,y\n");
  EXPECT_EQ(TextBlocks(write(std::string("\xFF\xFEu\0,\0y\0\n\0", 10))).next(), "u,y\n");
}

TEST_F(TextBlocksTest, WhatCannotBeReadIsSaid) {
  EXPECT_THROW(TextBlocks("/no/such/file"), InputError);
  EXPECT_THROW(TextBlocks(folder.path()), InputError);
}

TEST_F(TextBlocksTest, LinesAreTakenOffOverBlocks) {
  std::size_t left = 3;
  EXPECT_EQ(without_lines("a\r\nb\n", left), "");
  EXPECT_EQ(left, 1U);
  EXPECT_EQ(without_lines("c\rd\n", left), "d\n");
  EXPECT_EQ(without_lines("e\n", left), "e\n");
}

TEST_F(TextBlocksTest, TheHeadIsTheFirstLines) {
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += "1234567\n";
  const std::string head = head_of_file(write(text), 10);
  EXPECT_GE(head.size(), 80U);
  EXPECT_LT(head.size(), text.size());
}

}  // namespace
}  // namespace workbench
