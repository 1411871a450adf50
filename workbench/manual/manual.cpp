#include "workbench/manual/manual.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace workbench::manual {
namespace {

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \n");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \n") - first + 1));
}

// "ORDER:{dmy,mdy,ymd}" is a value with its choices.
void take_type(const std::string& type, Entry& entry) {
  const std::size_t brace = type.find(":{");
  entry.value = type.substr(0, brace);
  if (brace == std::string::npos) return;
  std::istringstream list(type.substr(brace + 2, type.find('}') - brace - 2));
  for (std::string choice; std::getline(list, choice, ',');) {
    entry.choices.push_back(choice);
  }
}

Entry entry_of(const CLI::Option& option) {
  Entry entry;
  for (const std::string& name : option.get_snames()) entry.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) entry.names.push_back("--" + name);
  entry.text = option.get_description();
  if (entry.names.empty()) {
    entry.names.push_back(option.get_name());
  } else if (option.get_items_expected_max() > 0) {
    take_type(option.get_type_name(), entry);
  }
  return entry;
}

Command command_of(const CLI::App& app) {
  Command command;
  command.name = app.get_name();
  command.summary = app.get_description();
  command.notes = trimmed(app.get_footer());
  if (!app.get_subcommands({}).empty()) {
    command.usage = "COMMAND [OPTIONS]";
  } else {
    command.usage = "[OPTIONS]";
  }
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;  // hidden
    const Entry entry = entry_of(*option);
    if (option->get_positional() && !option->nonpositional()) {
      const bool many = option->get_items_expected_max() > 1;
      const std::string word = entry.names.front() + (many ? "..." : "");
      command.usage += option->get_required() ? " " + word : " [" + word + "]";
      command.positionals.push_back(entry);
      continue;
    }
    const std::string& title = option->get_group();
    auto group = std::ranges::find_if(
        command.options, [&](const EntryGroup& known) { return known.title == title; });
    if (group == command.options.end()) {
      group = command.options.insert(group, EntryGroup{title, {}});
    }
    group->entries.push_back(entry);
  }
  return command;
}

}  // namespace

Program of_app(const CLI::App& app, const std::string& version) {
  Program program{command_of(app), {}, 1, version};
  for (const CLI::App* command : app.get_subcommands({})) {
    program.commands.push_back(command_of(*command));
  }
  return program;
}

Program of_help(std::string_view help, const std::string& summary,
                const std::string& version) {
  std::istringstream lines{std::string(help)};
  std::string line;
  Program program{{}, {}, 8, version};
  Command& self = program.self;
  self.summary = summary;
  EntryGroup options{"Options", {}};
  bool ended = false;  // the options
  while (std::getline(lines, line)) {
    constexpr std::string_view kUsage = "usage: ";
    const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
    if (line.starts_with(kUsage)) {
      const std::size_t space = line.find(' ', kUsage.size());
      self.name = line.substr(kUsage.size(), space - kUsage.size());
      self.usage = space == std::string::npos ? "" : line.substr(space + 1);
    } else if (!ended && indent == 2 && line[indent] == '-') {
      const std::size_t gap = line.find("  ", indent);
      std::istringstream words(line.substr(indent, gap - indent));
      Entry entry;
      for (std::string word; words >> word;) {
        if (word.front() == '-') {
          entry.names.push_back(word.substr(0, word.find(',')));
        } else {
          entry.value = word;
        }
      }
      if (gap != std::string::npos) entry.text = trimmed(line.substr(gap));
      options.entries.push_back(entry);
    } else if (!ended && indent > 2 && !line.empty() && !options.entries.empty()) {
      options.entries.back().text += ' ' + trimmed(line);
    } else if (!options.entries.empty()) {
      ended = true;
      self.notes += line + '\n';
    }
  }
  self.notes = trimmed(self.notes);
  if (self.name.empty() || options.entries.empty()) {
    throw std::runtime_error(
        "expected a help text with \"usage: NAME\" and lines \"  --option\", found "
        "something else");
  }
  self.options.push_back(options);
  return program;
}

}  // namespace workbench::manual
