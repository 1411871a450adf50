#include "workbench/recording/json_table.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "workbench/recording/parsed_json.hpp"

namespace workbench {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostBytes = std::size_t{64} << 20;
// A table of more names or cells is none that a controller wrote.
constexpr std::size_t kMostNames = 5000;
constexpr std::size_t kMostCells = 100'000'000;
constexpr std::array kRowsUnder = {"data",    "rows",    "values", "items",
                                   "records", "samples", "Items",  "value"};

std::string cell_of(const Json& value) {
  if (value.is_null()) return "";
  if (!value.is_string()) return value.dump();
  std::string text = value.get<std::string>();
  std::replace_if(
      text.begin(), text.end(),
      [](char c) { return c == '\t' || c == '\n' || c == '\r' || c == '"'; }, ' ');
  return text;
}

// Rows with the names of their cells, in the order of their first appearance.
class Rows {
 public:
  void add_object(const Json& object, const std::string& series) {
    begin(series);
    add_cells(object, "");
  }

  void add_array(const Json& cells, const std::vector<std::string>& names,
                 const std::string& series) {
    begin(series);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      set(i < names.size() ? names[i] : "#" + std::to_string(i + 1), cell_of(cells[i]));
    }
  }

  [[nodiscard]] std::optional<std::string> text() const {
    if (rows_.empty() || names_.size() < 2) return std::nullopt;
    if (has_too_many_ || rows_.size() > kMostCells / names_.size()) return std::nullopt;
    std::string out;
    const bool named = names_.back()[0] != '#' || names_.front()[0] != '#';
    if (named) append(names_, out);
    for (const std::vector<std::string>& row : rows_) {
      append(row, out);
    }
    return out;
  }

 private:
  void begin(const std::string& series) {
    rows_.emplace_back();
    if (!series.empty()) set("tag", series);
  }

  void add_cells(const Json& object, const std::string& before) {
    for (const auto& [name, value] : object.items()) {
      if (!value.is_object()) {
        if (!value.is_array()) set(before + name, cell_of(value));
      } else if (value.contains("IsSystem") && value.contains("Name")) {
        set(before + name, cell_of(value["Name"]));
      } else {
        add_cells(value, before + name + '.');
      }
    }
  }

  void set(const std::string& name, std::string cell) {
    if (names_.size() == kMostNames && !places_.contains(name)) {
      has_too_many_ = true;
      return;
    }
    const auto [at, is_new] = places_.try_emplace(name, names_.size());
    if (is_new) names_.push_back(name);
    std::vector<std::string>& row = rows_.back();
    if (row.size() <= at->second) row.resize(at->second + 1);
    row[at->second] = std::move(cell);
  }

  void append(const std::vector<std::string>& cells, std::string& out) const {
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (i > 0) out += '\t';
      if (i < cells.size()) out += cells[i];
    }
    out += '\n';
  }

  bool has_too_many_ = false;
  std::map<std::string, std::size_t> places_;
  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> rows_;
};

bool all_of_kind(const Json& values, bool (Json::*is)() const noexcept) {
  return !values.empty() && std::all_of(values.begin(), values.end(),
                                        [is](const Json& v) { return (v.*is)(); });
}

std::vector<std::string> names_in(const Json& table) {
  std::vector<std::string> names;
  if (table.contains("columns") && table["columns"].is_array()) {
    for (const Json& name : table["columns"]) {
      if (name.is_string()) names.push_back(name.get<std::string>());
    }
  }
  return names;
}

bool add_rows(const Json& rows, const std::vector<std::string>& names,
              const std::string& series, Rows& out) {
  if (!rows.is_array()) return false;
  const bool arrays = all_of_kind(rows, &Json::is_array);
  if (!arrays && !all_of_kind(rows, &Json::is_object)) return false;
  for (const Json& row : rows) {
    if (arrays) {
      out.add_array(row, names, series);
    } else {
      out.add_object(row, series);
    }
  }
  return true;
}

// Series with a name and rows of their own.
bool add_series(const Json& series, const char* rows, const char* name, Rows& out) {
  if (!series.is_array() || !all_of_kind(series, &Json::is_object)) return false;
  for (const Json& one : series) {
    if (!one.contains(rows) || !one[rows].is_array() || !one.contains(name)) return false;
  }
  for (const Json& one : series) {
    const Json& of = one[name];
    const std::string tag =
        of.is_object() ? of.contains("__name__") ? cell_of(of["__name__"]) : of.dump()
                       : cell_of(of);
    std::vector<std::string> names = names_in(one);
    if (names.empty()) names = {"time", "value"};
    add_rows(one[rows], names, tag, out);
  }
  return true;
}

bool add_known_series(const Json& root, Rows& out) {
  if (root.contains("Items") && add_series(root["Items"], "Items", "Name", out)) {
    return true;
  }
  const Json::json_pointer prometheus("/data/result");
  if (root.contains(prometheus) &&
      add_series(root[prometheus], "values", "metric", out)) {
    return true;
  }
  const Json::json_pointer influx("/results/0/series");
  return root.contains(influx) && add_series(root[influx], "values", "name", out);
}

// {"t": [...], "u": [...]} or {"t": {"0": ...}, "u": {"0": ...}}
bool add_columns(const Json& root, Rows& out) {
  if (root.size() < 2) return false;
  const bool arrays = all_of_kind(root, &Json::is_array);
  if (!arrays && !all_of_kind(root, &Json::is_object)) return false;
  const std::size_t length = root.front().size();
  std::vector<std::string> names;
  std::vector<std::vector<const Json*>> columns;
  for (const auto& [name, column] : root.items()) {
    if (column.size() != length) return false;
    names.push_back(name);
    columns.emplace_back();
    for (const Json& value : column) {
      if (value.is_structured()) return false;
      columns.back().push_back(&value);
    }
  }
  const bool numbered =
      !arrays && names[0].find_first_not_of("0123456789") == std::string::npos;
  if (numbered) {
    for (const Json& row : root) out.add_object(row, "");
    return true;
  }
  for (std::size_t k = 0; k < length; ++k) {
    Json row = Json::array();
    for (const auto& column : columns) row.push_back(*column[k]);
    out.add_array(row, names, "");
  }
  return true;
}

bool add_table(const Json& root, Rows& out) {
  if (root.is_array()) return add_rows(root, {}, "", out);
  if (!root.is_object()) return false;
  if (add_known_series(root, out)) return true;
  for (const char* under : kRowsUnder) {
    if (root.contains(under) && add_rows(root[under], names_in(root), "", out)) {
      return true;
    }
  }
  return add_columns(root, out);
}

// An object a line.
bool add_lines(std::string_view text, Rows& out) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    const Json object = parsed_json<Json>(line);
    if (!object.is_object()) return false;
    out.add_object(object, "");
  }
  return true;
}

}  // namespace

std::optional<std::string> json_text(std::string_view text) {
  if (text.size() > kMostBytes) return std::nullopt;
  Rows rows;
  const Json root = parsed_json<Json>(text);
  const bool found = root.is_discarded() ? add_lines(text, rows) : add_table(root, rows);
  return found ? rows.text() : std::nullopt;
}

}  // namespace workbench
