// What a program's --help says, as data, and written as a man page and as completion for
// bash, zsh and fish. The build writes them for the packages (write_manual.cpp).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace workbench::manual {

struct Entry {
  std::vector<std::string> names;    ///< "-o", "--output"; a positional has one: "REC"
  std::string value;                 ///< "FILE"; empty: takes none
  std::vector<std::string> choices;  ///< all values that are taken, where they are known
  std::string text;
};

struct EntryGroup {
  std::string title;  ///< "Options"
  std::vector<Entry> entries;
};

struct Command {
  std::string name;     ///< "identify"; of the program itself: "stickband"
  std::string summary;  ///< one line
  std::string usage;    ///< what follows the name: "[OPTIONS] REC"
  std::vector<Entry> positionals;
  std::vector<EntryGroup> options;
  std::string notes;  ///< examples, exit codes: as it is printed
};

struct Program {
  Command self;
  std::vector<Command> commands;  ///< sub-commands; may be none
  int section = 1;                ///< of the manual
  std::string version;
};

/// Of a command line that CLI11 parses.
[[nodiscard]] Program of_app(const CLI::App& app, const std::string& version);
/// Of a help text: "usage: NAME …", lines "  --option VALUE  text", then notes. Throws
/// std::runtime_error for a text without usage or options.
[[nodiscard]] Program of_help(std::string_view help, const std::string& summary,
                              const std::string& version);

struct ManPage {
  std::string file;  ///< "stickband-identify.1"
  std::string text;  ///< roff
};
/// One for the program and one for each command.
[[nodiscard]] std::vector<ManPage> man_pages(const Program& program);

[[nodiscard]] std::string bash_completion(const Program& program);
[[nodiscard]] std::string zsh_completion(const Program& program);
[[nodiscard]] std::string fish_completion(const Program& program);

}  // namespace workbench::manual
