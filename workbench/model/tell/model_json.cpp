#include "workbench/model/tell/model_json.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "workbench/model/base/parameter_range.hpp"
#include "workbench/model/tell/curve_of.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/parsed_json.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/recording/text_file.hpp"

namespace workbench {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kKind = "stickband model";
constexpr const char* kCure = "make a model with `stickband model REC -o M.json`";
constexpr std::size_t kMaxBytes = std::size_t{4} << 20;

Json finite(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

// A bound that no physics sets is null.
Json bound(double value) {
  return std::abs(value) < 1e299 ? Json(value) : Json(nullptr);
}

// Walks a document and says where it is when something is not as expected.
class Reader {
 public:
  Reader(const Json& json, std::string file, std::string key)
      : json_(json), file_(std::move(file)), key_(std::move(key)) {}

  [[noreturn]] void fail(const std::string& expected, const std::string& found) const {
    throw InputError(file_, 0, 0, expected + (key_.empty() ? "" : " at '" + key_ + "'"),
                     found, kCure);
  }
  [[nodiscard]] Reader at(const std::string& name) const {
    if (!json_.is_object()) fail("an object", kind());
    if (!json_.contains(name)) {
      fail("the key '" + name + "'", "no such key");
    }
    return {json_.at(name), file_, key_.empty() ? name : key_ + '.' + name};
  }
  [[nodiscard]] bool has(const std::string& name) const {
    return json_.is_object() && json_.contains(name);
  }
  [[nodiscard]] std::string text() const {
    if (!json_.is_string()) fail("a text", kind());
    return json_.get<std::string>();
  }
  [[nodiscard]] double number() const {
    if (!json_.is_number()) fail("a number", kind());
    const double value = json_.get<double>();
    if (!std::isfinite(value)) fail("a finite number", json_.dump());
    return value;
  }
  [[noreturn]] void fail_outside(const ParameterRange& range) const {
    throw InputError(file_, 0, 0,
                     filled("a number from {0} to {1} at {2}",
                            {workbench::number(range.low), workbench::number(range.high),
                             '\'' + key_ + '\''}),
                     json_.dump(), kCure);
  }
  [[nodiscard]] double number_or(double absent) const {
    return json_.is_null() ? absent : number();
  }
  [[nodiscard]] std::size_t count() const {
    if (!json_.is_number_unsigned()) fail("a whole number from 0 on", kind());
    return json_.get<std::size_t>();
  }
  [[nodiscard]] bool truth() const {
    if (!json_.is_boolean()) fail("true or false", kind());
    return json_.get<bool>();
  }
  template <class Visit>
  void each_element(Visit visit) const {
    if (!json_.is_array()) fail("a list", kind());
    for (std::size_t i = 0; i < json_.size(); ++i) {
      visit(Reader(json_.at(i), file_, key_ + '[' + std::to_string(i) + ']'));
    }
  }
  template <class Visit>
  void each_member(Visit visit) const {
    if (!json_.is_object()) fail("an object", kind());
    for (const auto& [name, value] : json_.items()) {
      visit(name, Reader(value, file_, key_ + '.' + name));
    }
  }

 private:
  [[nodiscard]] std::string kind() const {
    return json_.is_primitive() && !json_.is_null()
               ? workbench::quoted(json_.dump(-1, ' ', true))
               : json_.type_name();
  }

  const Json& json_;
  std::string file_;
  std::string key_;
};

std::vector<Parameter> parameters(const Reader& reader) {
  std::vector<Parameter> out;
  reader.each_member([&out](const std::string& name, const Reader& member) {
    Parameter p;
    p.name = name;
    p.value = member.at("value").number();
    p.low = member.at("low").number_or(p.value);
    p.high = member.at("high").number_or(p.value);
    p.unit = member.at("unit").text();
    std::vector<double> bounds;
    member.at("bounds").each_element([&bounds](const Reader& edge) {
      bounds.push_back(edge.number_or(bounds.empty() ? -1e300 : 1e300));
    });
    if (bounds.size() != 2) member.at("bounds").fail("two numbers", "another count");
    p.bound_low = bounds[0];
    p.bound_high = bounds[1];
    p.derived = member.has("derived") && member.at("derived").truth();
    if (!may_be(p, p.value)) member.at("value").fail_outside(range_of(p));
    out.push_back(std::move(p));
  });
  return out;
}

Column output_of(const Reader& reader) {
  const std::string name = reader.text();
  if (name == "y") return Column::y;
  if (name == "x") return Column::x;
  reader.fail("y or x", workbench::quoted(name));
}

std::vector<double> colour_of(const Reader& reader) {
  constexpr std::size_t kMost = 64;
  std::vector<double> out;
  reader.each_element([&out](const Reader& one) { out.push_back(one.number()); });
  if (out.empty() || out.size() > kMost || out[0] != 1) {
    reader.fail("1 to 64 numbers, the first of them 1", "others");
  }
  return out;
}

EffectTerm term_of(const Reader& reader, const Model& model) {
  EffectTerm term;
  term.effect = reader.at("effect").text();
  if (standard_catalogue().find(term.effect) == nullptr) {
    reader.at("effect").fail("one of " + standard_catalogue().codes(),
                             workbench::quoted(term.effect));
  }
  if (model.has(term.effect)) {
    reader.at("effect").fail("each effect once",
                             workbench::quoted(term.effect) + " twice");
  }
  term.parameters = parameters(reader.at("parameters"));
  term.phenomenological = reader.at("phenomenological").truth();
  term.untold = reader.has("untold") && reader.at("untold").truth();
  return term;
}

}  // namespace

Json json_of(const std::vector<Parameter>& list) {
  Json out = Json::object();
  for (const Parameter& p : list) {
    out[p.name] = {{"value", finite(p.value)},
                   {"low", finite(p.low)},
                   {"high", finite(p.high)},
                   {"unit", p.unit},
                   {"bounds", {bound(p.bound_low), bound(p.bound_high)}}};
    if (p.derived) out[p.name]["derived"] = true;
  }
  return out;
}

Json effect_json(const std::string& effect, bool phenomenological,
                 const std::vector<Parameter>& list) {
  Json out = {{"phenomenological", phenomenological}, {"parameters", json_of(list)}};
  if (const std::optional<NamedCurve> curve = curve_of(effect, list)) {
    out["kind"] = curve->kind;
    out["curve"] = curve->points;
  }
  return out;
}

Json ahead_json(const AheadErrors& errors) {
  return {{"rmse_before", errors.before},
          {"rmse_after", errors.after},
          {"error_reduction_percent", 100 * errors.share()}};
}

Json term_json(const EffectTerm& term) {
  Json out = {{"effect", term.effect}};
  out.update(effect_json(term.effect, term.phenomenological, term.parameters));
  if (term.untold) out["untold"] = true;
  return out;
}

Json model_json(const Model& model) {
  Json effects = Json::array();
  for (const EffectTerm& term : model.effects) effects.push_back(term_json(term));
  Json history = Json::array();
  for (const HistoryStep& step : model.history) {
    history.push_back({{"effect", step.effect},
                       {"recording", step.recording},
                       {"rmse_before", finite(step.rmse_before)},
                       {"rmse_after", finite(step.rmse_after)},
                       {"rmse_validation_before", finite(step.rmse_validation_before)},
                       {"rmse_validation_after", finite(step.rmse_validation_after)}});
    if (step.ahead) history.back()["one_sample_ahead"] = ahead_json(*step.ahead);
  }
  Json out = {{"schema", kModelSchema},
              {"kind", kKind},
              {"output", name_of(model.output)},
              {"recording",
               {{"name", model.fitted.name},
                {"samples", model.fitted.samples},
                {"sample_period_s", model.fitted.period_s},
                {"first_u", model.fitted.first_u},
                {"last_u", model.fitted.last_u},
                {"fingerprint", model.fitted.fingerprint}}},
              {"process", json_of(model.process)},
              {"effects", effects},
              {"initial_state", json_of(model.initial_state)},
              {"history", history}};
  if (!model.noise.empty()) out["noise_colour"] = model.noise;
  return out;
}

Model parse_model(const std::string& text, const std::string& name) {
  const Json json = parsed_json<Json>(text);
  const Reader reader(json, name, "");
  if (json.is_discarded()) reader.fail("JSON", "text that is not");
  if (!json.is_object() || json.value("kind", Json()) != kKind) {
    reader.fail(std::string("a model, \"kind\": \"") + kKind + '"', "another document");
  }
  const double schema = reader.at("schema").number();
  if (schema != kModelSchema) {
    throw InputError(name, 0, 0,
                     "version " + std::to_string(kModelSchema) + " at 'schema'",
                     "version " + json.at("schema").dump(),
                     "make the model again with this version of stickband");
  }
  Model model;
  model.output = output_of(reader.at("output"));
  const Reader recording = reader.at("recording");
  model.fitted.name = recording.at("name").text();
  model.fitted.samples = recording.at("samples").count();
  model.fitted.period_s = recording.at("sample_period_s").number();
  model.fitted.first_u = recording.at("first_u").number();
  model.fitted.last_u = recording.at("last_u").number();
  if (recording.has("fingerprint")) {
    model.fitted.fingerprint = recording.at("fingerprint").text();
  }
  model.process = parameters(reader.at("process"));
  reader.at("effects").each_element(
      [&](const Reader& term) { model.effects.push_back(term_of(term, model)); });
  model.initial_state = parameters(reader.at("initial_state"));
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  reader.at("history").each_element([&](const Reader& step) {
    model.history.push_back({step.at("effect").text(), step.at("recording").text(),
                             step.at("rmse_before").number_or(kNone),
                             step.at("rmse_after").number_or(kNone),
                             step.at("rmse_validation_before").number_or(kNone),
                             step.at("rmse_validation_after").number_or(kNone)});
    if (!step.has("one_sample_ahead")) return;
    const Reader ahead = step.at("one_sample_ahead");
    model.history.back().ahead = {ahead.at("rmse_before").number(),
                                  ahead.at("rmse_after").number()};
  });
  if (reader.has("noise_colour")) model.noise = colour_of(reader.at("noise_colour"));
  return model;
}

Model read_model(const std::string& path) {
  return parse_model(read_text_file(path, kMaxBytes), path);
}

}  // namespace workbench
