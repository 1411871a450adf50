// write_manual FOLDER [HELP SUMMARY]...: man pages and completion of stickband, and of
// each program whose --help is in the file HELP, into FOLDER.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "workbench/cli/command_line.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/manual/manual.hpp"

namespace {

namespace manual = workbench::manual;

void write(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream out(path);
  out << text;
  if (!out.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

void write_all(const std::filesystem::path& folder, const manual::Program& program) {
  const std::string& name = program.self.name;
  for (const manual::ManPage& page : manual::man_pages(program)) {
    write(folder / "man" / page.file, page.text);
  }
  write(folder / "bash" / name, manual::bash_completion(program));
  write(folder / "zsh" / ("_" + name), manual::zsh_completion(program));
  write(folder / "fish" / (name + ".fish"), manual::fish_completion(program));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: write_manual FOLDER [HELP SUMMARY]...\n";
    return 2;
  }
  try {
    CLI::App app;
    workbench::cli::Action action;
    workbench::cli::describe(app, action);
    write_all(argv[1], manual::of_app(app, STICKBAND_VERSION));
    for (int k = 2; k + 1 < argc; k += 2) {
      std::ifstream help(argv[k]);
      const std::string text(std::istreambuf_iterator<char>(help), {});
      write_all(argv[1], manual::of_help(text, argv[k + 1], STICKBAND_VERSION));
    }
  } catch (const std::exception& error) {
    std::cerr << "write_manual: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
