// Pages of roff with the macros of man(7).
#include <algorithm>
#include <cctype>
#include <sstream>

#include "workbench/manual/manual.hpp"

namespace workbench::manual {
namespace {

std::string escaped(std::string_view text) {
  std::string out;
  bool at_begin = true;
  for (const char c : text) {
    if (at_begin && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      out += c;
    }
    at_begin = c == '\n';
  }
  return out;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

// "--option=VALUE" in bold and italics, then its text.
void write_entry(const Entry& entry, std::ostream& out) {
  out << ".TP\n";
  for (std::size_t k = 0; k < entry.names.size(); ++k) {
    out << (k > 0 ? ", " : "") << "\\fB" << escaped(entry.names[k]) << "\\fR";
  }
  if (!entry.value.empty()) out << " \\fI" << escaped(entry.value) << "\\fR";
  out << '\n' << escaped(entry.text);
  if (!entry.choices.empty()) {
    out << " (";
    for (std::size_t k = 0; k < entry.choices.size(); ++k) {
      out << (k > 0 ? ", " : "") << escaped(entry.choices[k]);
    }
    out << ')';
  }
  out << '\n';
}

ManPage page_of(const Program& program, const Command& command, bool whole) {
  const std::string& name = program.self.name;
  const std::string title = whole ? name : name + "-" + command.name;
  const std::string section = std::to_string(program.section);
  std::ostringstream out;
  out << ".TH " << escaped(upper(title)) << ' ' << section << " \"\" \"" << name << ' '
      << program.version << "\" \"" << (program.section == 8 ? "Services" : "Commands")
      << "\"\n.SH NAME\n"
      << escaped(title) << " \\- " << escaped(command.summary) << "\n.SH SYNOPSIS\n\\fB"
      << escaped(whole ? name : name + " " + command.name) << "\\fR "
      << escaped(command.usage) << '\n';
  if (!command.positionals.empty()) {
    out << ".SH ARGUMENTS\n";
    for (const Entry& entry : command.positionals) write_entry(entry, out);
  }
  for (const EntryGroup& group : command.options) {
    out << ".SH \"" << escaped(upper(group.title)) << "\"\n";
    for (const Entry& entry : group.entries) write_entry(entry, out);
  }
  if (whole && !program.commands.empty()) {
    out << ".SH COMMANDS\n";
    for (const Command& other : program.commands) {
      out << ".TP\n\\fB" << escaped(other.name) << "\\fR\n"
          << escaped(other.summary) << ": see " << escaped(name + "-" + other.name) << "("
          << section << ")\n";
    }
  }
  if (!command.notes.empty()) {
    out << ".SH NOTES\n.nf\n" << escaped(command.notes) << "\n.fi\n";
  }
  out << ".SH \"SEE ALSO\"\n";
  if (whole) {
    out << "The documentation in /usr/share/doc/stickband/html.\n";
  } else {
    out << "\\fB" << escaped(name) << "\\fR(" << section << ")\n";
  }
  return {title + "." + section, out.str()};
}

}  // namespace

std::vector<ManPage> man_pages(const Program& program) {
  std::vector<ManPage> pages = {page_of(program, program.self, true)};
  for (const Command& command : program.commands) {
    pages.push_back(page_of(program, command, false));
  }
  return pages;
}

}  // namespace workbench::manual
