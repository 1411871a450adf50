#include "workbench/screen/screen_advice.hpp"

#include <regex>

#include "workbench/recording/named_signal.hpp"
#include "workbench/recording/option_words.hpp"

namespace workbench {
namespace {

// A word as shell_word() writes it, without its quotes.
std::string bare(const std::string& word) {
  const bool is_quoted = word.size() > 1 && (word[0] == '"' || word[0] == '\'');
  return is_quoted ? word.substr(1, word.size() - 2) : word;
}

void replace(std::string& text, const std::string& part, const std::string& by) {
  const std::size_t at = text.find(part);
  if (at != std::string::npos) text.replace(at, part.size(), by);
}

void name_the_pair(std::string& text) {
  static const std::regex options(
      R"x(--u ("[^"]*"|'[^']*'|[^\s;]+) --y ("[^"]*"|'[^']*'|[^\s;]+)( --sp ("[^"]*"|'[^']*'|[^\s;]+))?)x");
  std::smatch found;
  if (!std::regex_search(text, found, options)) return;
  const std::string u = bare(found[1]);
  const std::string y = bare(found[2]);
  const std::string sp = bare(found[4]);
  const bool speakable = (u + y + sp).find_first_of("/,*'\"") == std::string::npos;
  const std::string rule =
      u == "COLUMN" ? "U/Y" : u + '/' + y + (sp.empty() ? "" : '/' + sp);
  replace(text, found.str(),
          speakable ? "--pairs " + shell_word(rule)
                    : "--pairs LIST.csv with the lines loop,u,y and NAME,\"" + u +
                          "\",\"" + y + '"');
}

// The first of "several: 'Data', 'Data2'".
std::string first_sheet(const std::string& text) {
  static const std::regex several("found several: '([^']*)'");
  std::smatch found;
  return std::regex_search(text, found, several) ? found[1].str() : "NAME";
}

}  // namespace

std::string screen_advice(const std::string& error, const std::string& path) {
  const std::string alone = "stickband identify " + file_word(path);
  std::string text = error;
  replace(text, "give --config FILE, or --dbc FILE --u MESSAGE.SIGNAL --y MESSAGE.SIGNAL",
          "identify it alone; this lists its signals: " + alone + " --dbc FILE");
  replace(text, "name the sheet with --sheet, or remove the others",
          "remove the others, or read one alone: " + alone + " --sheet " +
              shell_word(first_sheet(error)));
  name_the_pair(text);
  const bool left =
      text.find(" --u ") != std::string::npos || text.find(" --y ") != std::string::npos;
  return left ? text + "; these are options of: " + alone : text;
}

}  // namespace workbench
