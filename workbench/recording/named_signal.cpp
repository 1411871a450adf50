#include "workbench/recording/named_signal.hpp"

#include <algorithm>
#include <stdexcept>

#include "workbench/recording/listed.hpp"

namespace workbench {
namespace {

constexpr std::size_t kLongestName = 60;

// Pieces that all names have in front.
std::size_t common_pieces(const std::vector<NamedSignal>& candidates) {
  const NamedSignal* first = nullptr;
  std::size_t common = 0;
  for (const NamedSignal& candidate : candidates) {
    if (candidate.name.pieces.empty()) continue;
    if (first == nullptr) {
      first = &candidate;
      common = candidate.name.pieces.size() - 1;
      continue;
    }
    const std::size_t most = std::min(common, candidate.name.pieces.size() - 1);
    common = 0;
    while (common < most && candidate.name.pieces[common] == first->name.pieces[common]) {
      ++common;
    }
  }
  return common;
}

bool ends_with(const std::vector<std::string>& pieces,
               const std::vector<std::string>& end) {
  return !end.empty() && end.size() <= pieces.size() &&
         std::equal(end.rbegin(), end.rend(), pieces.rbegin());
}

bool holds(const std::vector<std::string>& pieces, const std::vector<std::string>& part) {
  return !part.empty() && std::search(pieces.begin(), pieces.end(), part.begin(),
                                      part.end()) != pieces.end();
}

}  // namespace

std::string cut_name(const std::string& name) {
  if (name.size() <= kLongestName) return name;
  std::size_t end = kLongestName;
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0) == 0x80) --end;
  return name.substr(0, end) + "…";
}

std::string shell_word(const std::string& name) {
  const bool plain =
      name.find_first_of(" \t\r\n'\"$&|;()[]{}<>*?#\\`!~%") == std::string::npos;
  if (plain && !name.empty()) return name;
  // What double quotes would not keep from a shell.
  if (name.find_first_of("\"$\\`!") == std::string::npos) return '"' + name + '"';
  std::string out = "'";
  for (const char c : name) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

std::string list_of(const std::vector<NamedSignal>& candidates,
                    const ChoiceContext& context) {
  return "the " + std::string(context.candidates) + ' ' + list_of(candidates) +
         (context.beside.empty() ? "" : " (" + context.beside + ')');
}

std::string option_word(const std::string& name, std::size_t number) {
  return shell_word(name.empty() ? '#' + std::to_string(number) : cut_name(name));
}

std::string list_of(const std::vector<NamedSignal>& candidates) {
  std::string text = first_listed(candidates, {.letters = kLongestList}, " ",
                                  [](const NamedSignal& candidate) {
                                    return "'" + cut_name(candidate.name.text) + "'";
                                  });
  if (!candidates.empty() && candidates[0].name.text == "#1") text += " without a header";
  return text;
}

std::vector<std::size_t> best_fitting(const ColumnName& wanted,
                                      const std::vector<NamedSignal>& candidates) {
  const std::size_t common = common_pieces(candidates);
  const auto without_common = [common](const ColumnName& column) {
    std::string key;
    for (std::size_t i = common; i < column.pieces.size(); ++i) key += column.pieces[i];
    return key;
  };
  const auto fits = [&](int level, const ColumnName& column) {
    switch (level) {
      case 0:
        return column.text == wanted.text;
      case 1:
        return !wanted.key.empty() && column.key == wanted.key;
      case 2:
        return common > 0 && without_common(column) == wanted.key;
      case 3:
        return ends_with(column.pieces, wanted.pieces);
      default:
        return holds(column.pieces, wanted.pieces);
    }
  };
  constexpr int kLevels = 5;
  std::vector<std::size_t> found;
  for (int level = 0; level < kLevels && found.empty(); ++level) {
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (fits(level, candidates[i].name)) found.push_back(i);
    }
  }
  return found;
}

std::size_t candidate_named(const std::string& name, const char* option,
                            const std::vector<NamedSignal>& candidates,
                            const ChoiceContext& context) {
  const std::string given = std::string(option) + ' ' + shell_word(name);
  if (name.size() > 1 && name[0] == '#' &&
      std::all_of(name.begin() + 1, name.end(),
                  [](char c) { return c >= '0' && c <= '9'; })) {
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (std::to_string(candidates[i].number) == name.substr(1)) return i;
    }
    throw std::invalid_argument(given + ": " + context.file + " has " +
                                list_of(candidates, context));
  }
  const std::vector<std::size_t> found = best_fitting(column_name(name), candidates);
  if (found.size() == 1) return found[0];
  if (found.size() > 1) {
    std::vector<NamedSignal> several;
    std::string numbers;
    for (const std::size_t i : found) {
      several.push_back(candidates[i]);
      if (numbers.size() < 60) {
        numbers += (numbers.empty() ? "#" : ", #") + std::to_string(candidates[i].number);
      }
    }
    throw std::invalid_argument(
        given + " fits several " + context.candidates + " of " + context.file + ": " +
        list_of(several) + "; give more of the name, or its number (" + numbers + ")");
  }
  throw std::invalid_argument(given + ": no such name; " + context.file + " has " +
                              list_of(candidates, context));
}

}  // namespace workbench
