#include "config/toml_reader.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace config {
namespace {

std::string text_of(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

int line_of(const toml::node& node) {
  return static_cast<int>(node.source().begin.line);
}

}  // namespace

std::string found_text(const toml::node& node) {
  if (node.is_table()) return "a table";
  if (const auto* list = node.as_array()) {
    if (list->empty()) return "an empty list";
    return std::string("a list of ") +
           (list->size() == 1 ? "one" : std::to_string(list->size()));
  }
  std::ostringstream text;
  if (const auto* string = node.as_string()) {
    text << "the text \"" << string->get() << '"';
    return text.str().substr(0, 60);
  }
  node.visit([&text](const auto& n) {
    if constexpr (!toml::is_table<decltype(n)> && !toml::is_array<decltype(n)>) text << n;
  });
  constexpr std::size_t kLongest = 40;
  std::string found = text.str();
  if (found.size() > kLongest) found = found.substr(0, kLongest) + "…";
  return found;
}

void Complaints::add(int line, const std::string& key, const std::string& message) {
  std::string text = file_ + ':';
  if (line > 0) text += std::to_string(line) + ':';
  text += ' ';
  if (!key.empty()) text += key + ": ";
  lines_.emplace_back(line, text + message);
}

void Complaints::throw_if_any() {
  if (lines_.empty()) return;
  std::ranges::stable_sort(
      lines_, [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string text;
  for (const auto& line : lines_) text += (text.empty() ? "" : "\n") + line.second;
  throw ConfigError(text);
}

const toml::node* TableReader::find(std::string_view key) {
  known_.emplace_back(key);
  return table_.get(key);
}

bool TableReader::has(std::string_view key) {
  return find(key) != nullptr;
}

bool TableReader::require(std::string_view key, std::string_view expected) {
  if (has(key)) return true;
  complaints_.add(line_of(table_), path_of(key),
                  "expected " + std::string(expected) + ", found nothing; add the key");
  return false;
}

std::string one_of(const std::vector<std::string_view>& choices) {
  std::string names;
  for (const std::string_view choice : choices) {
    names += (names.empty() ? "one of \"" : ", \"") + std::string(choice) + '"';
  }
  return names;
}

std::string TableReader::path_of(std::string_view key) const {
  return name_.empty() ? std::string(key) : name_ + '.' + std::string(key);
}

Place TableReader::place() const {
  return {line_of(table_), name_};
}

Place TableReader::place_of(std::string_view key) const {
  const toml::node* node = table_.get(key);
  return {line_of(node ? *node : static_cast<const toml::node&>(table_)), path_of(key)};
}

void TableReader::complain(std::string_view key, const std::string& message) {
  const Place place = place_of(key);
  complaints_.add(place.line, place.key, message);
}

void TableReader::wrong_type(std::string_view key, std::string_view expected,
                             const toml::node& node) {
  complain(key, "expected " + std::string(expected) + ", found " + found_text(node) +
                    "; correct the value");
}

void TableReader::read(std::string_view key, std::string& value) {
  const toml::node* node = find(key);
  if (!node) return;
  if (const auto text = node->value_exact<std::string>(); text && !text->empty()) {
    value = *text;
  } else {
    wrong_type(key, "a text that is not empty", *node);
  }
}

void TableReader::read(std::string_view key, bool& value) {
  const toml::node* node = find(key);
  if (!node) return;
  if (const auto flag = node->value_exact<bool>()) {
    value = *flag;
  } else {
    wrong_type(key, "true or false", *node);
  }
}

void TableReader::read(std::string_view key, double& value, Range range) {
  const toml::node* node = find(key);
  if (!node) return;
  const auto number = node->is_number() ? node->value<double>() : std::nullopt;
  if (number && std::isfinite(*number) && *number >= range.low && *number <= range.high) {
    value = *number;
  } else {
    const bool bounded = range.high < HUGE_VAL || range.low > -HUGE_VAL;
    wrong_type(key,
               bounded
                   ? "a number from " + text_of(range.low) + " to " + text_of(range.high)
                   : std::string("a finite number"),
               *node);
  }
}

void TableReader::read_integer(std::string_view key, std::int64_t& value,
                               std::int64_t low, std::int64_t high) {
  const toml::node* node = find(key);
  if (!node) return;
  const auto number = node->value_exact<std::int64_t>();
  if (number && *number >= low && *number <= high) {
    value = *number;
  } else {
    wrong_type(
        key, "a whole number from " + std::to_string(low) + " to " + std::to_string(high),
        *node);
  }
}

void TableReader::read_list(std::string_view key, std::vector<double>& value) {
  const toml::node* node = find(key);
  if (!node) return;
  std::vector<double> numbers;
  const toml::array* list = node->as_array();
  for (std::size_t k = 0; list && k < list->size(); ++k) {
    const auto number =
        (*list)[k].is_number() ? (*list)[k].value<double>() : std::nullopt;
    if (number && std::isfinite(*number)) numbers.push_back(*number);
  }
  if (list && !list->empty() && numbers.size() == list->size()) {
    value = numbers;
  } else {
    wrong_type(key, "a list of numbers", *node);
  }
}

void TableReader::read_pair(std::string_view key, std::array<double, 2>& value,
                            bool ascending) {
  const toml::node* node = find(key);
  if (!node) return;
  std::vector<double> numbers;
  const toml::array* list = node->as_array();
  for (std::size_t k = 0; list && k < list->size(); ++k) {
    if ((*list)[k].is_number()) numbers.push_back(*(*list)[k].value<double>());
  }
  const bool two = list && list->size() == 2 && numbers.size() == 2;
  if (two && std::isfinite(numbers[0]) && std::isfinite(numbers[1]) &&
      (ascending ? numbers[0] < numbers[1] : numbers[0] != numbers[1])) {
    value = {numbers[0], numbers[1]};
  } else if (two) {
    complain(key, std::string("expected two ") + (ascending ? "ascending" : "different") +
                      " finite numbers, found [" + text_of(numbers[0]) + ", " +
                      text_of(numbers[1]) + "]; correct the value");
  } else {
    wrong_type(key, "a list of two numbers", *node);
  }
}

void TableReader::read_choice(std::string_view key, std::size_t& value,
                              const std::vector<std::string_view>& choices) {
  const toml::node* node = find(key);
  if (!node) return;
  const auto text = node->value_exact<std::string>();
  const auto at = text ? std::ranges::find(choices, *text) : choices.end();
  if (at != choices.end()) {
    value = static_cast<std::size_t>(at - choices.begin());
    return;
  }
  wrong_type(key, one_of(choices), *node);
}

const toml::table* TableReader::table(std::string_view key) {
  const toml::node* node = find(key);
  if (!node) return nullptr;
  if (!node->is_table()) wrong_type(key, "a table", *node);
  return node->as_table();
}

std::vector<const toml::table*> TableReader::tables(std::string_view key) {
  std::vector<const toml::table*> all;
  const toml::node* node = find(key);
  if (!node) return all;
  const toml::array* list = node->as_array();
  for (std::size_t k = 0; list && k < list->size(); ++k) {
    if ((*list)[k].is_table()) all.push_back((*list)[k].as_table());
  }
  if (!list || all.size() != list->size()) {
    wrong_type(key, "tables, each under [[" + path_of(key) + "]]", *node);
  }
  return all;
}

void TableReader::refuse_unknown() {
  for (const auto& [key, node] : table_) {
    if (std::ranges::find(known_, key.str()) != known_.end()) continue;
    std::vector<std::string> names = known_;
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    complaints_.add(static_cast<int>(key.source().begin.line), path_of(key.str()),
                    "expected one of the keys " + list + ", found \"" +
                        std::string(key.str()) + "\"; correct or remove it");
  }
}

}  // namespace config
