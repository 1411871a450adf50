#include "workbench/recording/formats/json_table.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "workbench/recording/cell_reader.hpp"
#include "workbench/recording/column_name.hpp"
#include "workbench/recording/formats/json_shapes.hpp"
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
  std::ranges::replace_if(
      text, [](char c) { return c == '\t' || c == '\n' || c == '\r' || c == '"'; }, ' ');
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

// What a series says of itself beside its name: the metric of Prometheus, InfluxDB's
// tags.
Json labels_of(const Json& series, const char* name) {
  if (series[name].is_object()) return series[name];
  return series.contains("tags") && series["tags"].is_object() ? series["tags"]
                                                               : Json::object();
}

// The labels that do not say the same in all series, in the order of their appearance.
std::vector<std::string> telling_labels(const std::vector<Json>& labels) {
  std::map<std::string, bool> known;
  std::vector<std::string> out;
  for (const Json& of_one : labels) {
    for (const auto& [label, value] : of_one.items()) {
      if (label == "__name__" || !known.try_emplace(label, true).second) continue;
      const bool same = std::ranges::all_of(labels, [&label, &value](const Json& other) {
        return other.contains(label) && other[label] == value;
      });
      if (!same) out.push_back(label);
    }
  }
  return out;
}

// The name of the metric among the labels; null where there is none.
Json metric_of(const Json& labels) {
  return labels.contains("__name__") ? labels["__name__"] : Json();
}

// FIC101.op: the labels that tell a series from others, and its name; without the name
// of a metric that all series have.
std::string tag_of(const Json& of, const Json& labels,
                   const std::vector<std::string>& telling, bool one_metric) {
  std::string tag;
  const auto add = [&tag](const Json& part) {
    const std::string text = cell_of(part);
    if (!text.empty()) tag += (tag.empty() ? "" : ".") + text;
  };
  for (const std::string& label : telling) {
    if (labels.contains(label)) add(labels[label]);
  }
  if (!of.is_object()) {
    add(of);
  } else if (tag.empty() || !one_metric) {
    add(metric_of(of));
  }
  return tag.empty() ? of.dump() : tag;
}

// Series with a name and rows of their own.
bool add_series(const Json& series, const char* rows, const char* name, Rows& out) {
  if (!series.is_array() || !all_of_kind(series, &Json::is_object)) return false;
  std::vector<Json> labels;
  for (const Json& one : series) {
    if (!one.contains(rows) || !one[rows].is_array() || !one.contains(name)) return false;
    labels.push_back(labels_of(one, name));
  }
  const std::vector<std::string> telling = telling_labels(labels);
  // A metric "op" of several loops still says what the value is.
  const Json metric = labels.empty() ? Json() : metric_of(labels.front());
  const bool one_metric =
      !metric.is_null() && !is_signal(column_name(cell_of(metric)).part) &&
      std::ranges::all_of(labels,
                          [&](const Json& of) { return metric_of(of) == metric; });
  for (std::size_t i = 0; i < series.size(); ++i) {
    std::vector<std::string> names = names_in(series[i]);
    if (names.empty()) names = {"time", "value"};
    add_rows(series[i][rows], names,
             tag_of(series[i][name], labels[i], telling, one_metric), out);
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

// What Home Assistant calls a state and when it was, as a service or over its websocket.
struct StateKeys {
  const char* state;
  std::array<const char*, 2> times;  // the first that all states of an entity have
};
constexpr StateKeys kOfService = {"state", {"last_updated", "last_changed"}};
constexpr StateKeys kOfSocket = {"s", {"lu", "lu"}};

const char* time_of_states(const Json& states, const StateKeys& keys) {
  if (!states.is_array()) return nullptr;
  for (const char* time : keys.times) {
    const bool all = std::ranges::all_of(states, [&](const Json& one) {
      return one.is_object() && one.contains(keys.state) && one.contains(time) &&
             one[time].is_primitive() && one[keys.state].is_primitive();
    });
    if (all) return time;
  }
  return nullptr;
}

void add_states(const Json& states, const std::string& entity, const StateKeys& keys,
                Rows& out) {
  if (states.empty()) return;
  const char* time = time_of_states(states, keys);
  const char* attributes = states.front().contains("a") ? "a" : "attributes";
  const Json::json_pointer unit(std::string("/") + attributes + "/unit_of_measurement");
  const Json& first = states.front();
  std::string tag = entity;
  if (first.contains(unit) && first[unit].is_string()) {
    tag += " [" + cell_of(first[unit]) + ']';
  }
  for (const Json& one : states) {
    out.add_array({one[time], one[keys.state]}, {"time", "value"}, tag);
  }
}

// [[{"entity_id": ..., "state": ..., "last_changed": ...}, {"state": ...}], ...], or
// {"sensor.x": [{"s": ..., "lu": ...}, ...], ...}
bool add_home_assistant(const Json& root, Rows& out) {
  if (root.empty() || !root.is_structured()) return false;
  const StateKeys& keys = root.is_array() ? kOfService : kOfSocket;
  const bool fits = std::ranges::all_of(root, [&](const Json& states) {
    const bool named =
        root.is_object() || states.empty() ||
        (states.is_array() && states.front().is_object() &&
         states.front().contains("entity_id") && states.front()["entity_id"].is_string());
    return named && time_of_states(states, keys) != nullptr;
  });
  if (!fits) return false;
  for (const auto& [name, states] : root.items()) {
    const bool first_names = root.is_array() && !states.empty();
    add_states(states, first_names ? cell_of(states.front()["entity_id"]) : name, keys,
               out);
  }
  return true;
}

// {"op": [{"ts": 1773475200000, "value": "4.5"}, ...], ...}, as ThingsBoard has it.
bool add_keys(const Json& root, Rows& out) {
  if (!root.is_object() || !all_of_kind(root, &Json::is_array)) return false;
  for (const Json& samples : root) {
    const bool fits = std::ranges::all_of(samples, [](const Json& one) {
      return one.is_object() && one.contains("ts") && one.contains("value") &&
             one["ts"].is_primitive() && one["value"].is_primitive();
    });
    if (!fits) return false;
  }
  for (const auto& [key, samples] : root.items()) {
    for (const Json& one : samples) {
      out.add_array({one["ts"], one["value"]}, {"time", "value"}, key);
    }
  }
  return true;
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
  if (add_home_assistant(root, out)) return true;
  if (root.is_array()) return add_rows(root, {}, "", out);
  if (!root.is_object()) return false;
  if (add_known_series(root, out) || add_keys(root, out)) return true;
  for (const char* under : kRowsUnder) {
    if (root.contains(under) && add_rows(root[under], names_in(root), "", out)) {
      return true;
    }
  }
  return add_columns(root, out);
}

// NaN, which JSON does not have and Python writes, as null; not within texts.
std::string without_nan(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\' && quoted && i + 1 < text.size()) {
      out += text[i++];
    } else if (text[i] == '"') {
      quoted = !quoted;
    } else if (!quoted && text.substr(i).starts_with("NaN")) {
      out += "null";
      i += 2;
      continue;
    }
    out += text[i];
  }
  return out;
}

// An object a line.
bool add_lines(std::string_view text, Rows& out) {
  while (!text.empty()) {
    const std::string_view line = take_whole_line(text);
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
  Json root = parsed_json<Json>(text);
  if (root.is_discarded() && text.find("NaN") != std::string_view::npos) {
    const std::string finite = without_nan(text);
    root = parsed_json<Json>(finite);
  }
  if (!root.is_discarded()) root = known_shape(std::move(root));
  const bool found = root.is_discarded() ? add_lines(text, rows) : add_table(root, rows);
  return found ? rows.text() : std::nullopt;
}

}  // namespace workbench
