// Completion: commands, then the options of the command that stands there, then the
// values that an option takes, else files.
#include <sstream>

#include "workbench/manual/manual.hpp"
#include "workbench/recording/listed.hpp"

namespace workbench::manual {
namespace {

// For single quotes of a shell.
std::string quoted(std::string_view text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'') {
      out += "'\\''";
    } else {
      out += c;
    }
  }
  return out + "'";
}

std::vector<Entry> options_of(const Command& command) {
  std::vector<Entry> out;
  for (const EntryGroup& group : command.options) {
    out.insert(out.end(), group.entries.begin(), group.entries.end());
  }
  return out;
}

std::string all_names(const Command& command) {
  std::vector<std::string> names;
  for (const Entry& entry : options_of(command)) {
    names.insert(names.end(), entry.names.begin(), entry.names.end());
  }
  return listed(names, " ");
}

// "M.json" names its ending.
bool takes_file(const Entry& entry) {
  for (const char* word :
       {"FILE", "TEXT", "LOG", "PATH", "TOML", "JSON", "REC", "RULES", "FOLDER"}) {
    if (entry.value == word) return true;
  }
  return entry.value.find('.') != std::string::npos;
}

// The shell would break names at spaces in $(…).
constexpr const char* kBashFiles = "mapfile -t COMPREPLY < <(compgen -f -- \"$word\")";

// Where the option before the word says what the word may be.
void bash_values(const Command& command, std::ostream& out) {
  for (const Entry& entry : options_of(command)) {
    if (entry.value.empty()) continue;
    out << "      " << listed(entry.names, "|") << ") ";
    if (!entry.choices.empty()) {
      out << "COMPREPLY=($(compgen -W " << quoted(listed(entry.choices, " "))
          << " -- \"$word\")); return ;;\n";
    } else if (takes_file(entry)) {
      out << kBashFiles << "; return ;;\n";
    } else {
      out << "return ;;\n";
    }
  }
}

void bash_command(const Command& command, std::ostream& out) {
  out << "    case $before in\n";
  bash_values(command, out);
  out << "    esac\n    names=" << quoted(all_names(command)) << '\n';
}

// "-o+[text]:FILE:_files", the form of _arguments.
std::string zsh_spec(const Entry& entry) {
  std::string text = entry.text;
  for (const char* special : {"[", "]", ":"}) {
    for (std::size_t at = 0; (at = text.find(special, at)) != std::string::npos;
         at += 2) {
      text.insert(at, "\\");
    }
  }
  std::string spec = "[" + text + "]";
  if (!entry.value.empty()) {
    spec += ":" + entry.value + ":";
    if (!entry.choices.empty()) {
      spec += "(" + listed(entry.choices, " ") + ")";
    } else if (takes_file(entry)) {
      spec += "_files";
    }
  }
  return spec;
}

void zsh_arguments(const Command& command, const char* indent, std::ostream& out) {
  out << indent << "_arguments";
  for (const Entry& entry : options_of(command)) {
    for (const std::string& name : entry.names) {
      out << " \\\n" << indent << "  " << quoted("*" + name + zsh_spec(entry));
    }
  }
  out << " \\\n" << indent << "  '*:file:_files'\n";
}

void fish_options(const std::string& program, const Command& command,
                  const std::string& when, std::ostream& out) {
  for (const Entry& entry : options_of(command)) {
    out << "complete -c " << program << when;
    for (const std::string& name : entry.names) {
      const bool is_long = name.starts_with("--");
      out << (is_long ? " -l " : " -s ") << name.substr(is_long ? 2 : 1);
    }
    if (!entry.choices.empty()) {
      out << " -x -a " << quoted(listed(entry.choices, " "));
    } else if (!entry.value.empty()) {
      out << (takes_file(entry) ? " -r -F" : " -x");
    }
    out << " -d " << quoted(entry.text) << '\n';
  }
}

}  // namespace

std::string bash_completion(const Program& program) {
  const std::string& name = program.self.name;
  std::ostringstream out;
  out << "# bash completion for " << name << "\n_" << name
      << "() {\n  local word=${COMP_WORDS[COMP_CWORD]} "
         "before=${COMP_WORDS[COMP_CWORD-1]} names\n  COMPREPLY=()\n";
  if (program.commands.empty()) {
    bash_command(program.self, out);
  } else {
    std::vector<std::string> commands;
    for (const Command& command : program.commands) commands.push_back(command.name);
    out << "  if [ \"$COMP_CWORD\" = 1 ]; then\n    COMPREPLY=($(compgen -W "
        << quoted(listed(commands, " ") + " " + all_names(program.self))
        << " -- \"$word\"))\n    return\n  fi\n  case ${COMP_WORDS[1]} in\n";
    for (const Command& command : program.commands) {
      out << "  " << command.name << ")\n";
      bash_command(command, out);
      out << "    ;;\n";
    }
    out << "  esac\n";
  }
  out << "  case $word in\n  -*) COMPREPLY=($(compgen -W \"$names\" -- \"$word\")) ;;\n"
         "  *) "
      << kBashFiles << " ;;\n  esac\n}\ncomplete -o filenames -F _" << name << ' ' << name
      << '\n';
  return out.str();
}

std::string zsh_completion(const Program& program) {
  const std::string& name = program.self.name;
  std::ostringstream out;
  out << "#compdef " << name << '\n';
  if (program.commands.empty()) {
    zsh_arguments(program.self, "", out);
    return out.str();
  }
  out << "local -a commands\ncommands=(\n";
  for (const Command& command : program.commands) {
    out << "  " << quoted(command.name + ":" + command.summary) << '\n';
  }
  out << ")\nif (( CURRENT == 2 )); then\n  _describe command commands\n  return\nfi\n"
         "local command=$words[2]\nshift words\n(( CURRENT-- ))\ncase $command in\n";
  for (const Command& command : program.commands) {
    out << command.name << ")\n";
    zsh_arguments(command, "  ", out);
    out << "  ;;\n";
  }
  out << "esac\n";
  return out.str();
}

std::string fish_completion(const Program& program) {
  const std::string& name = program.self.name;
  std::ostringstream out;
  for (const Command& command : program.commands) {
    out << "complete -c " << name << " -n __fish_use_subcommand -f -a " << command.name
        << " -d " << quoted(command.summary) << '\n';
  }
  fish_options(name, program.self,
               program.commands.empty() ? "" : " -n __fish_use_subcommand", out);
  for (const Command& command : program.commands) {
    fish_options(name, command, " -n '__fish_seen_subcommand_from " + command.name + "'",
                 out);
  }
  return out.str();
}

}  // namespace workbench::manual
