#include "workbench/serve/column_preview.hpp"

#include <algorithm>
#include <exception>
#include <utility>
#include <vector>

#include "workbench/recording/column_name.hpp"
#include "workbench/recording/csv_layout.hpp"
#include "workbench/recording/text_encoding.hpp"
#include "workbench/report/svg_plot.hpp"
#include "workbench/serve/session_json.hpp"

namespace workbench {
namespace {

using Json = nlohmann::ordered_json;

Json signal_json(const Load& signal) {
  const auto [low, high] = std::ranges::minmax_element(signal.values);
  Json points = Json::array();
  for (const std::size_t k : visible_points(signal.values, kPreviewPixels)) {
    points.push_back({k, signal.values[k]});
  }
  return {{"name", signal.name},
          {"unit", signal.unit},
          {"low", *low},
          {"high", *high},
          {"points", points}};
}

// Every signal as a load, none of them needed.
Recording all_signals(std::string_view text, const std::string& name,
                      CsvOptions options) {
  options.required.clear();
  options.names = {options.names.time, {}, {}, {}, {}, {"all"}};
  return parse_csv(text, name, options);
}

Json picked_json(const Recording& recording, const Recording& all) {
  Json out = Json::object();
  for (const Column column : kLoopColumns) {
    if (!recording.has(column)) continue;
    const auto same = std::ranges::find_if(all.loads, [&](const Load& load) {
      return load.values.size() == recording.size() &&
             load.values == recording.values(column);
    });
    if (same != all.loads.end()) out[std::string(name_of(column))] = same->name;
  }
  return out;
}

// Which of them belong together by their tags.
Json loops_json(const std::vector<Load>& signals) {
  std::vector<std::pair<std::string, Json>> loops;
  for (const Load& signal : signals) {
    const ColumnName name = column_name(signal.name);
    const char* role = name.part == Part::kU || name.part == Part::kMv ? "u"
                       : name.part == Part::kY                         ? "y"
                       : name.part == Part::kSp                        ? "sp"
                       : name.part == Part::kX                         ? "x"
                                                                       : nullptr;
    if (role == nullptr) continue;
    auto loop = std::ranges::find_if(
        loops, [&name](const auto& l) { return l.first == name.tag; });
    if (loop == loops.end()) {
      loops.push_back({name.tag, {{"name", name.prefix}}});
      loop = loops.end() - 1;
    }
    if (!loop->second.contains(role)) loop->second[role] = signal.name;
  }
  Json out = Json::array();
  for (const auto& [tag, loop] : loops) {
    if (loop.contains("u") && loop.contains("y")) out.push_back(loop);
  }
  return out;
}

std::optional<Recording> readable(std::string_view text, const std::string& name,
                                  const CsvOptions& options, Json& problem) {
  try {
    return all_signals(text, name, options);
  } catch (const std::exception&) {
    problem = error_json(std::current_exception());
    return std::nullopt;
  }
}

// By the first column that rises evenly, which may count seconds; else row by row, so
// that the signals can be seen. `options` as it was read then.
std::optional<Recording> without_times(std::string_view text, const std::string& name,
                                       const CsvLayout& layout, CsvOptions& options,
                                       Json& out) {
  Json ignored;
  if (const auto counter = counter_of(layout)) {
    options.names.time = '#' + std::to_string(*counter + 1);
    if (auto read = readable(text, name, options, ignored)) {
      out["time"] = options.names.time;
      return read;
    }
    options.names.time.clear();
  }
  options.ts = 1;
  auto read = readable(text, name, options, ignored);
  out["needs_time"] = read.has_value();
  return read;
}

}  // namespace

Json column_preview(std::string_view text, const std::string& name, CsvOptions options) {
  std::string converted;
  SheetChoice sheet = sheet_wanted(options);
  text = text_of(text, name, converted, sheet);
  options.sheet.clear();
  LayoutWish wish{{Column::t}, {}, options.decimal};
  const CsvLayout layout = layout_of(text, name, wish);
  Json columns = Json::array();
  for (const LayoutColumn& column : layout.columns) columns.push_back(column.name.text);
  Json out = {{"schema", 1},
              {"name", name},
              {"header_line", layout.header_line},
              {"columns", columns},
              {"problem", nullptr},
              {"picked", Json::object()},
              {"signals", Json::array()},
              {"loops", Json::array()},
              {"time", nullptr},
              {"needs_time", false}};
  std::optional<Recording> read = readable(text, name, options, out["problem"]);
  if (!read && out["problem"].value("expected", "") == with_aliases(Column::t)) {
    read = without_times(text, name, layout, options, out);
  }
  if (!read) return out;
  const Recording& all = *read;
  out["rows"] = all.resampling.rows;
  out["samples"] = all.size();
  out["sample_period_s"] = out["needs_time"] ? Json(nullptr) : Json(all.period_s);
  out["start"] = all.start.empty() ? Json(nullptr) : Json(all.start);
  out["notes"] = all.resampling.notes;
  out["loops"] = loops_json(all.loads);
  const std::size_t shown = std::min(all.loads.size(), kMostPreviewed);
  for (std::size_t i = 0; i < shown; ++i) {
    out["signals"].push_back(signal_json(all.loads[i]));
  }
  try {
    CsvOptions wanted = options;
    wanted.required = {Column::u, Column::y};
    out["picked"] = picked_json(parse_csv(text, name, wanted), all);
  } catch (const std::exception&) {
    out["problem"] = error_json(std::current_exception());
  }
  return out;
}

}  // namespace workbench
