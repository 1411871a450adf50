// Help for terminals of 80 columns.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace workbench::cli {

/// Breaks what stands beside options and commands, and the paragraphs of the footer; its
/// indented lines, the examples, stay as they are written.
class NarrowHelp : public CLI::Formatter {
 public:
  NarrowHelp();
  std::string make_option_desc(const CLI::Option* option) const override;
  std::string make_subcommand(const CLI::App* command) const override;
  std::string make_footer(const CLI::App* app) const override;
};

}  // namespace workbench::cli
