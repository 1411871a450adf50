// Help for terminals of 80 columns.
#include <gtest/gtest.h>

#include <memory>
#include <sstream>
#include <string>

#include "workbench/cli/narrow_help.hpp"

namespace workbench::cli {
namespace {

TEST(NarrowHelp, BreaksDescriptionsAndParagraphsButNoExamples) {
  const std::string words = "one two three four five six seven eight nine ten eleven";
  const std::string example = "  stickband " + words + ' ' + words;
  CLI::App app;
  app.formatter(std::make_shared<NarrowHelp>());
  app.footer("Examples:\n" + example + "\n\n" + words + '\n' + words);
  std::string file;
  app.add_option("--file", file, words + ' ' + words);
  app.add_subcommand("command", words + ' ' + words);
  std::istringstream lines(app.help());
  bool told = false;
  for (std::string line; std::getline(lines, line);) {
    if (line == example) {
      told = true;
    } else {
      EXPECT_LE(line.size(), 80U) << line;
    }
  }
  EXPECT_TRUE(told);
}

}  // namespace
}  // namespace workbench::cli
