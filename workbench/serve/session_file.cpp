#include "workbench/serve/session_file.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "workbench/model/tell/model_json.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/parsed_json.hpp"
#include "workbench/serve/session_json.hpp"

namespace workbench {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kKind = "stickband-session";
constexpr int kSchema = 1;

Json recording_as_json(const Recording& recording) {
  Json out = {{"name", recording.name},
              {"sample_period_s", recording.period_s},
              {"start", recording.start},
              {"tags", recording.tags},
              {"begins_at_rest", recording.begins_at_rest},
              {"filled", recording.resampling.missing},
              {"notes", recording.resampling.notes}};
  const auto add = [&out](const char* key, const std::vector<SampleRange>& ranges) {
    if (ranges.empty()) return;
    Json& list = out[key] = Json::array();
    for (const SampleRange& range : ranges) list.push_back({range.first, range.last});
  };
  add("left_out", recording.left_out);
  add("manual", recording.manual);
  out["split"] = {{"estimation_share", recording.split.estimation_share},
                  {"pair_samples", recording.split.pair_samples}};
  for (const Column column : kAllColumns) {
    if (!recording.has(column)) continue;
    out[std::string(name_of(column))] = recording.values(column);
    if (!recording.unit(column).empty()) {
      out["units"][std::string(name_of(column))] = recording.unit(column);
    }
  }
  for (const Load& load : recording.loads) {
    out["loads"].push_back(
        {{"name", load.name}, {"unit", load.unit}, {"values", load.values}});
  }
  return out;
}

class Reader {
 public:
  Reader(const std::string& text, const std::string& name)
      : name_(name), json_(parsed_json<Json>(text)) {}

  SavedSession read() {
    if (!json_.is_object() || json_.value("kind", Json()) != kKind) {
      refuse("a session that this page saved", "something else");
    }
    if (json_.value("schema", Json()) != kSchema) {
      refuse("version " + std::to_string(kSchema) + " of the session file",
             "version " + json_.value("schema", Json()).dump());
    }
    SavedSession out;
    out.recording = recording(json_.value("recording", Json()));
    const Json source = json_.value("source", Json(""));
    if (source.is_string()) out.source = source.get<std::string>();
    const std::string opens = text_in(json_, "opens");
    out.opens = opens == "yes" ? Opens::yes : opens == "no" ? Opens::no : Opens::unknown;
    out.steps = models("steps");
    out.undone = models("undone");
    const Json beside = json_.value("beside", Json::array());
    if (!beside.is_array()) refuse("a list at 'beside'", "something else");
    for (const Json& other : beside) {
      const bool fitted = other.is_object() && other.value("fitted", Json()) == true;
      auto read = std::make_shared<const Recording>(recording(other));
      std::string words = other.contains("source") ? text_in(other, "source") : "";
      out.beside.push_back({std::move(read), fitted, std::move(words)});
    }
    if (out.steps.empty()) refuse("at least one model in 'steps'", "none");
    return out;
  }

 private:
  [[noreturn]] void refuse(const std::string& expected, const std::string& found) const {
    throw InputError(name_, 0, 0, expected, found, "save the session again");
  }

  Recording recording(const Json& json) const {
    if (!json.is_object()) refuse("a recording", json.dump().substr(0, 40));
    Recording out;
    out.name = text_in(json, "name");
    out.start = text_in(json, "start");
    out.tags = json.contains("tags") ? text_in(json, "tags") : "";
    out.begins_at_rest = json.value("begins_at_rest", Json()) == true;
    const Json filled = json.value("filled", Json());
    if (filled.is_number_unsigned()) out.resampling.missing = filled.get<std::size_t>();
    for (const Json& note : json.value("notes", Json::array())) {
      if (note.is_string()) out.resampling.notes.push_back(note.get<std::string>());
    }
    const Json period = json.value("sample_period_s", Json());
    if (!period.is_number() || !(period.get<double>() > 0)) {
      refuse("a positive sample_period_s", period.dump());
    }
    out.period_s = period.get<double>();
    const Json units = json.value("units", Json::object());
    for (const Column column : kAllColumns) {
      const std::string key(name_of(column));
      if (json.contains(key)) out.values(column) = numbers(json[key], key);
      if (units.is_object() && units.contains(key)) {
        out.units[static_cast<std::size_t>(column)] = text_in(units, key.c_str());
      }
    }
    take_loads(json, out);
    check_lengths(out);
    take_choice(json, out);
    return out;
  }

  // Stretches of samples in their order.
  std::vector<SampleRange> ranges_in(const Json& json, const char* key,
                                     const Recording& recording) const {
    const Json ranges = json.value(key, Json::array());
    if (!ranges.is_array()) {
      refuse(std::string("a list at '") + key + '\'', "something else");
    }
    std::vector<SampleRange> out;
    std::size_t from = 0;
    for (const Json& range : ranges) {
      const bool pair = range.is_array() && range.size() == 2 &&
                        range[0].is_number_unsigned() && range[1].is_number_unsigned();
      const SampleRange next =
          pair ? SampleRange{range[0].get<std::size_t>(), range[1].get<std::size_t>()}
               : SampleRange{};
      if (next.first < from || next.last <= next.first || next.last > recording.size()) {
        refuse(std::string("stretches of samples in their order at '") + key + '\'',
               range.dump());
      }
      out.push_back(next);
      from = next.last;
    }
    return out;
  }

  // What is left out, and how the rest is shared out.
  void take_choice(const Json& json, Recording& recording) const {
    recording.left_out = ranges_in(json, "left_out", recording);
    recording.manual = ranges_in(json, "manual", recording);
    const Json split = json.value("split", Json::object());
    const Json share =
        split.is_object() ? split.value("estimation_share", Json()) : Json();
    const Json length = split.is_object() ? split.value("pair_samples", Json()) : Json();
    if (!share.is_number() || !length.is_number()) return;
    const Split wish{share.get<double>(), length.get<double>()};
    if (!(wish.estimation_share >= 0.2 && wish.estimation_share <= 0.9) ||
        !(wish.pair_samples >= 0)) {
      refuse("a share of 0.2 to 0.9 and a length at 'split'", split.dump());
    }
    recording.split = wish;
  }

  void take_loads(const Json& json, Recording& recording) const {
    for (const Json& load : json.value("loads", Json::array())) {
      if (!load.is_object()) refuse("loads with their values", load.dump().substr(0, 40));
      recording.loads.push_back({text_in(load, "name"), text_in(load, "unit"),
                                 numbers(load.value("values", Json()), "loads")});
    }
  }

  void check_lengths(const Recording& recording) const {
    if (recording.size() < 2) {
      refuse("2 samples or more in each recording", std::to_string(recording.size()));
    }
    for (const Load& load : recording.loads) {
      if (load.values.size() == recording.size()) continue;
      refuse("as many values of " + load.name + " as of t",
             std::to_string(load.values.size()));
    }
    for (const Column column : kAllColumns) {
      const std::size_t size = recording.values(column).size();
      const bool may_lack = column != Column::t && column != Column::u;
      if (size == recording.size() || (size == 0 && may_lack)) continue;
      refuse("as many values of " + std::string(name_of(column)) + " as of t",
             std::to_string(size));
    }
    for (std::size_t k = 1; k < recording.size(); ++k) {
      if (!(recording.t[k] > recording.t[k - 1])) {
        refuse("times that rise", "a step back at sample " + std::to_string(k + 1));
      }
    }
  }

  std::vector<double> numbers(const Json& list, const std::string& key) const {
    if (!list.is_array()) refuse("a list of numbers at '" + key + '\'', "something else");
    std::vector<double> out;
    out.reserve(list.size());
    for (const Json& item : list) {
      if (!item.is_number() || !std::isfinite(item.get<double>())) {
        refuse("a number in '" + key + '\'', item.dump().substr(0, 40));
      }
      out.push_back(item.get<double>());
    }
    return out;
  }

  std::string text_in(const Json& json, const char* key) const {
    const Json value = json.value(key, Json(""));
    if (!value.is_string()) refuse(std::string("a text at '") + key + '\'', "another");
    return value.get<std::string>();
  }

  std::vector<Model> models(const char* key) const {
    const Json list = json_.value(key, Json::array());
    if (!list.is_array()) refuse(std::string("a list at '") + key + '\'', "another");
    std::vector<Model> out;
    for (const Json& model : list) out.push_back(parse_model(model.dump(), name_));
    return out;
  }

  const std::string& name_;
  Json json_;
};

}  // namespace

std::string session_text(const SessionView& view) {
  static_cast<void>(view.last());
  const Recording& own = view.own != nullptr ? *view.own : view.opened();
  Json out = {{"schema", kSchema},
              {"kind", kKind},
              {"source", view.source},
              {"opens", word_of(view.opens)},
              {"recording", recording_as_json(own)}};
  const auto models = [](const auto& steps) {
    Json list = Json::array();
    for (const auto& step : steps) list.push_back(model_json(step->model));
    return list;
  };
  out["steps"] = models(view.steps);
  out["undone"] = models(view.undone);
  out["beside"] = Json::array();
  for (const BesideRecording& other : view.beside) {
    out["beside"].push_back(recording_as_json(*other.recording));
    if (other.fitted) out["beside"].back()["fitted"] = true;
    out["beside"].back()["source"] = other.source;
  }
  return out.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

SavedSession parse_session(const std::string& text, const std::string& name) {
  return Reader(text, name).read();
}

}  // namespace workbench
