#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "workbench/cli/command_line.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/manual/manual.hpp"

namespace workbench::manual {
namespace {

const Program& stickband() {
  static const Program program = [] {
    static CLI::App app;
    static cli::Action action;
    cli::describe(app, action);
    return of_app(app, "1.2.3");
  }();
  return program;
}

constexpr const char* kHelp = R"(usage: gaterd --config FILE [--check]

  --config FILE   the configuration,
                  in two lines
  --check, -c     looks only

Exit codes: 0 done.
)";

TEST(Manual, KnowsEveryCommandAndItsOptions) {
  CLI::App app;
  cli::Action action;
  cli::describe(app, action);
  const auto commands = app.get_subcommands({});
  ASSERT_EQ(stickband().commands.size(), commands.size());
  for (std::size_t k = 0; k < commands.size(); ++k) {
    const Command& command = stickband().commands[k];
    EXPECT_EQ(command.name, commands[k]->get_name());
    EXPECT_FALSE(command.summary.empty());
    std::size_t entries = command.positionals.size();
    for (const EntryGroup& group : command.options) entries += group.entries.size();
    EXPECT_EQ(entries, commands[k]->get_options().size()) << command.name;
  }
}

TEST(Manual, TakesChoicesFromTheOption) {
  const Command& identify = stickband().commands.front();
  ASSERT_EQ(identify.name, "identify");
  const auto& columns = identify.options.at(1).entries;
  const auto order = std::find_if(columns.begin(), columns.end(), [](const Entry& entry) {
    return entry.names.front() == "--date-order";
  });
  ASSERT_NE(order, columns.end());
  EXPECT_EQ(order->value, "ORDER");
  EXPECT_EQ(order->choices, (std::vector<std::string>{"dmy", "mdy", "ymd"}));
}

TEST(Manual, ReadsAHelpText) {
  const Program program = of_help(kHelp, "guards a gate", "1.2.3");
  EXPECT_EQ(program.self.name, "gaterd");
  EXPECT_EQ(program.self.usage, "--config FILE [--check]");
  const auto& entries = program.self.options.at(0).entries;
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[0].value, "FILE");
  EXPECT_EQ(entries[0].text, "the configuration, in two lines");
  EXPECT_EQ(entries[1].names, (std::vector<std::string>{"--check", "-c"}));
  EXPECT_EQ(program.self.notes, "Exit codes: 0 done.");
  EXPECT_THROW((void)of_help("what?", "", ""), std::runtime_error);
}

TEST(Manual, WritesAPageForEachCommand) {
  const auto pages = man_pages(stickband());
  ASSERT_EQ(pages.size(), 1 + stickband().commands.size());
  EXPECT_EQ(pages[1].file, "stickband-identify.1");
  EXPECT_NE(pages[1].text.find("\\fB\\-\\-date\\-order\\fR"), std::string::npos);
  EXPECT_NE(pages[0].text.find("stickband\\-identify(1)"), std::string::npos);
  const auto service = man_pages(of_help(kHelp, "guards a gate", "1"));
  EXPECT_EQ(service.at(0).file, "gaterd.8");
}

TEST(Manual, CompletesCommandsOptionsAndValues) {
  const std::string bash = bash_completion(stickband());
  EXPECT_NE(bash.find("'identify oscillation"), std::string::npos);
  EXPECT_NE(bash.find("'dmy mdy ymd'"), std::string::npos);
  const std::string zsh = zsh_completion(stickband());
  EXPECT_EQ(zsh.rfind("#compdef stickband", 0), 0U);
  EXPECT_NE(zsh.find("(dmy mdy ymd)"), std::string::npos);
  const std::string fish = fish_completion(stickband());
  EXPECT_NE(
      fish.find("__fish_seen_subcommand_from identify' -l date-order -x -a 'dmy mdy"),
      std::string::npos);
}

// Every value that is a file, by whatever word; and a name with a space stays one.
TEST(Manual, CompletesFiles) {
  const std::string bash = bash_completion(stickband());
  const std::string files = "mapfile -t COMPREPLY < <(compgen -f -- \"$word\")";
  for (const char* option :
       {"-o|--output-file", "--model", "--validate", "--truth", "--pairs", "--dbc"}) {
    EXPECT_NE(bash.find(std::string(option) + ") " + files), std::string::npos) << option;
  }
  EXPECT_NE(bash.find("  *) " + files + " ;;"), std::string::npos);
  EXPECT_EQ(bash.find("($(compgen -f"), std::string::npos);
  EXPECT_NE(bash.find("--ts) return ;;"), std::string::npos);
  EXPECT_NE(zsh_completion(stickband()).find(":M.json:_files"), std::string::npos);
  EXPECT_NE(fish_completion(stickband()).find("-l model -r -F"), std::string::npos);
}

}  // namespace
}  // namespace workbench::manual
