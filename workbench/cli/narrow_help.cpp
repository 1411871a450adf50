#include "workbench/cli/narrow_help.hpp"

#include <sstream>

#include "workbench/cli/console.hpp"

namespace workbench::cli {
namespace {

constexpr std::size_t kTerminal = 80;
constexpr std::size_t kNames = 28;

std::string beside_names(const std::string& text) {
  return wrapped(text, 0, kTerminal - kNames);
}

}  // namespace

NarrowHelp::NarrowHelp() {
  column_width(kNames);
}

std::string NarrowHelp::make_option_desc(const CLI::Option* option) const {
  return beside_names(Formatter::make_option_desc(option));
}

std::string NarrowHelp::make_subcommand(const CLI::App* command) const {
  std::stringstream out;
  CLI::detail::format_help(out, command->get_name(),
                           beside_names(command->get_description()), kNames);
  return out.str();
}

std::string NarrowHelp::make_footer(const CLI::App* app) const {
  std::istringstream lines(Formatter::make_footer(app));
  std::string out;
  std::string paragraph;
  const auto end_paragraph = [&] {
    if (!paragraph.empty()) out += wrapped(paragraph, 0, kTerminal) + '\n';
    paragraph.clear();
  };
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line.front() != ' ') {
      paragraph += (paragraph.empty() ? "" : " ") + line;
      continue;
    }
    end_paragraph();
    out += line + '\n';
  }
  end_paragraph();
  return out;
}

}  // namespace workbench::cli
