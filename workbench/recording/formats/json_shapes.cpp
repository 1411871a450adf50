#include "workbench/recording/formats/json_shapes.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "workbench/recording/column_name.hpp"
#include "workbench/recording/letters.hpp"
#include "workbench/recording/written_time.hpp"

namespace workbench {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kIndex = "index";

// {"channel": {"field1": "OP"}, "feeds": [{"created_at": ..., "field1": ...}, ...]}
std::optional<Json> of_thing_speak(const Json& root) {
  const bool fits = root.is_object() && root.contains("channel") &&
                    root["channel"].is_object() && root.contains("feeds") &&
                    root["feeds"].is_array() &&
                    all_of_kind(root["feeds"], &Json::is_object);
  if (!fits) return std::nullopt;
  const Json& channel = root["channel"];
  const auto name_of = [&channel](const std::string& field) {
    const bool named = field.starts_with("field") && channel.contains(field) &&
                       channel[field].is_string() && !channel[field].empty();
    return named ? channel[field].get<std::string>() : field;
  };
  Json out = Json::array();
  for (const Json& feed : root["feeds"]) {
    Json row = Json::object();
    for (const auto& [field, value] : feed.items()) {
      const std::string name = name_of(field);
      row[name.empty() || row.contains(name) ? field : name] = value;
    }
    out.push_back(std::move(row));
  }
  return out;
}

bool is_graphite_series(const Json& series) {
  return series.is_object() && series.contains("target") &&
         series["target"].is_string() && series.contains("datapoints") &&
         series["datapoints"].is_array() &&
         std::ranges::all_of(series["datapoints"], [](const Json& point) {
           return point.is_array() && point.size() == 2 && point[1].is_number();
         });
}

std::optional<Json> of_graphite(const Json& root) {
  if (!root.is_array() || root.empty() ||
      !std::ranges::all_of(root, is_graphite_series)) {
    return std::nullopt;
  }
  Json all = Json::array();
  for (const Json& series : root) {
    Json rows = Json::array();
    for (const Json& point : series["datapoints"]) {
      rows.push_back(Json::array({point[1], point[0]}));
    }
    all.push_back({{"metric", series["target"]}, {"values", std::move(rows)}});
  }
  Json out;
  out["data"]["result"] = std::move(all);
  return out;
}

bool is_time(const std::string& key) {
  constexpr std::size_t kSeconds = 10;  // digits since 2001
  if (key.size() >= kSeconds && key[0] == '1' && std::ranges::all_of(key, is_digit)) {
    return true;
  }
  const std::optional<WrittenTime> time = written_time(key);
  return time && time->kind != WrittenTime::Day::kNone;
}

// Not 0, 1, 2, ...
bool tells_more(const Json& index) {
  std::size_t row = 0;
  return !std::ranges::all_of(index, [&row](const Json& one) {
    const std::string number = std::to_string(row++);
    return one.is_string() ? one.get<std::string>() == number : one.dump() == number;
  });
}

// "time" where it holds times and no name of a column says so.
std::string name_of_index(const Json& index, const Json& names) {
  const bool times = std::ranges::all_of(index, [](const Json& one) {
    return is_time(one.is_string() ? one.get<std::string>() : one.dump());
  });
  const bool timed = std::ranges::any_of(names, [](const Json& name) {
    return name.is_string() && column_name(name.get<std::string>()).part == Part::kTime;
  });
  return times && !timed ? "time" : kIndex;
}

Json keys_of(const Json& object) {
  Json out = Json::array();
  for (const auto& [key, value] : object.items()) out.push_back(key);
  return out;
}

// {"columns": ["OP"], "index": [1773735300000], "data": [[52.6]]}
std::optional<Json> of_split(const Json& root) {
  const bool fits =
      root.is_object() && root.contains("columns") && root.contains(kIndex) &&
      root.contains("data") && root["columns"].is_array() && root[kIndex].is_array() &&
      root["data"].is_array() && all_of_kind(root["data"], &Json::is_array) &&
      root["data"].size() == root[kIndex].size();
  if (!fits || !all_of_kind(root[kIndex], &Json::is_primitive) ||
      !tells_more(root[kIndex])) {
    return std::nullopt;
  }
  const std::size_t columns = root["columns"].size();
  Json out = root;
  out["columns"].push_back(name_of_index(root[kIndex], root["columns"]));
  for (std::size_t i = 0; i < out["data"].size(); ++i) {
    if (out["data"][i].size() != columns) return std::nullopt;
    out["data"][i].push_back(root[kIndex][i]);
  }
  out.erase(kIndex);
  return out;
}

// {"OP": {"1773735300000": 52.6}, "PV": {...}}
std::optional<Json> of_columns(const Json& root) {
  const std::string first = root.items().begin().key();
  if (std::ranges::all_of(first, is_digit)) return std::nullopt;  // rows by number
  const Json index = keys_of(root.front());
  const bool alike = std::ranges::all_of(
      root, [&index](const Json& column) { return keys_of(column) == index; });
  if (!alike || root.contains(kIndex) || !tells_more(index)) return std::nullopt;
  Json out = Json::object();
  for (const auto& [name, column] : root.items()) {
    Json values = Json::array();
    for (const Json& value : column) values.push_back(value);
    out[name] = std::move(values);
  }
  out[name_of_index(index, keys_of(root))] = index;
  return out;
}

// {"1773735300000": {"OP": 52.6, "PV": 110.4}, ...}
Json of_rows(const Json& root) {
  const std::string name = name_of_index(keys_of(root), keys_of(root.front()));
  Json out = Json::array();
  for (const auto& [key, row] : root.items()) {
    out.push_back(row);
    out.back()[name] = key;
  }
  return out;
}

std::optional<Json> of_pandas(const Json& root) {
  if (!root.is_object() || root.empty()) return std::nullopt;
  if (root.contains("columns")) return of_split(root);
  if (root.size() < 2 || !all_of_kind(root, &Json::is_object)) return std::nullopt;
  const bool rows = std::ranges::all_of(
      root.items(), [](const auto& row) { return is_time(row.key()); });
  const bool primitive = std::ranges::all_of(
      root, [](const Json& one) { return all_of_kind(one, &Json::is_primitive); });
  if (!primitive) return std::nullopt;
  if (rows) return of_rows(root);
  return of_columns(root);
}

}  // namespace

bool all_of_kind(const Json& values, bool (Json::*kind)() const noexcept) {
  return !values.empty() && std::ranges::all_of(values, [kind](const Json& value) {
    return (value.*kind)();
  });
}

Json known_shape(Json root) {
  for (const auto& shape : {of_thing_speak, of_graphite, of_pandas}) {
    if (std::optional<Json> known = shape(root)) return std::move(*known);
  }
  return root;
}

}  // namespace workbench
