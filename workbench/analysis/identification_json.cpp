#include "workbench/analysis/identification_json.hpp"

#include <cmath>
#include <iterator>
#include <span>
#include <string>

namespace workbench {
namespace {

using Json = nlohmann::ordered_json;

Json known(bool is_known, double value) {
  return is_known ? Json(value) : Json(nullptr);
}

Json array_of(std::span<const double> values) {
  Json out = Json::array();
  for (const double value : values) out.push_back(value);
  return out;
}

Json json_of(const ident::Path<double>& path, bool is_known) {
  const std::size_t size = is_known ? static_cast<std::size_t>(path.segments) + 1 : 0;
  return {{"knots", array_of(std::span(path.knots).first(size))},
          {"x", array_of(std::span(path.x).first(size))}};
}

// The nesting stays when there is no model: numbers are null, lists empty.
Json model_json(const ident::TwoPathModel<double>& model, bool is_known) {
  const ident::Process<double>& p = model.process;
  const auto order = [is_known](int n) { return is_known ? Json(n) : Json(nullptr); };
  const auto length = [is_known](int n) {
    return is_known ? static_cast<std::size_t>(n) : std::size_t{0};
  };
  return {{"na", order(p.na)},
          {"nb", order(p.nb)},
          {"nk", order(p.nk)},
          {"a", array_of(std::span(p.a).first(length(p.na)))},
          {"b", array_of(std::span(p.b).first(length(p.nb)))},
          {"d", known(is_known, p.d)},
          {"ascending", json_of(model.ascending, is_known)},
          {"descending", json_of(model.descending, is_known)}};
}

const char* name_of(ident::ValveForm form) {
  constexpr const char* kNames[] = {"linear",           "backlash",
                                    "sticks_ascending", "sticks_descending",
                                    "sticks_alike",     "sticks_unequally"};
  static_assert(std::size(kNames) == ident::kValveForms);
  return kNames[static_cast<int>(form)];
}

Json windows_json(const Analysis& analysis) {
  Json out = Json::array();
  for (const WindowFinding& window : analysis.findings()) {
    out.push_back(
        {{"recording", window.recording + 1},
         {"t", {window.from_s, window.to_s}},
         {"verdict", ident::name(window.verdict)},
         {"nats", known(!std::isnan(window.nats), window.nats)},
         {"stem_nats", known(!std::isnan(window.stem_nats), window.stem_nats)}});
  }
  return out;
}

Json evidence_json(const Analysis& analysis) {
  const ident::Evidence<double>& e = analysis.result().evidence;
  const ident::LadderFinding<double>& pooled = analysis.pooled();
  return {{"nats", known(pooled.predicted > 0, pooled.nats)},
          {"stem_nats",
           known(e.stem_weighed || e.searched.nats > 0, ident::nats_of_stems(e, 0.0))},
          {"windows", windows_json(analysis)},
          {"form", name_of(e.form)},
          {"error_ratio", e.error_ratio},
          {"jump_ratio", e.jump_ratio},
          {"score", e.score},
          {"band_over_swing", e.band_over_swing},
          {"fit_percent", e.fit_percent},
          {"fit_linear_percent", e.fit_linear_percent},
          {"reversals", e.reversals}};
}

Json controller_json(const ident::ControllerAction<double>& c) {
  const bool is_known = c.sign != 0;
  return {{"sign", is_known ? Json(c.sign) : Json(nullptr)},
          {"proportional", known(is_known, c.proportional)},
          {"integral", known(is_known, c.integral)},
          {"r_squared", known(is_known, c.r_squared)}};
}

// What else was seen than a valve. No likelihood is behind these: they are certain or
// not.
Json rivals_json(const Identification& r) {
  Json out = Json::array();
  const auto add = [&out](bool seen, const char* cause) {
    if (seen) out.push_back({{"cause", cause}, {"nats", nullptr}});
  };
  add(r.health.sensor_sticks, "sensor");
  add(r.health.seam_at > 0, "seam");
  add(r.health.swapped, "swapped");
  add(r.health.compressed, "compression");
  add(r.health.cut_off > 0, "cut_off");
  if (ident::repeats(r.evidence)) {
    out.push_back({{"cause", "repeating_load"}, {"nats", r.evidence.cycle.nats}});
  }
  if (ident::bound_outweighs(r.evidence)) {
    const bool travels = r.evidence.bounded.bound == ident::Bound::kTravel;
    out.push_back({{"cause", travels ? "limited_travel" : "limited_speed"},
                   {"nats", r.evidence.bounded.nats}});
  }
  return out;
}

}  // namespace

Json json_of(const ident::Estimate<double>& estimate) {
  return {{"value", known(estimate.known, estimate.value)},
          {"low", known(estimate.known, estimate.low)},
          {"high", known(estimate.known, estimate.high)}};
}

Json json_of(const ident::PerStroke<double>& strokes) {
  return {{"ascending", json_of(strokes.ascending)},
          {"descending", json_of(strokes.descending)}};
}

Json identification_json(const RecordingView& recording, const Analysis& analysis) {
  const Identification& r = analysis.result();
  const bool modelled = has_model(r);
  const bool periodic = r.oscillation.detected && r.oscillation.period_samples > 0;
  Json notes = Json::array();
  for (const std::string& note : recording.notes) notes.push_back(note);
  for (const std::string& note : analysis.notes()) notes.push_back(note);
  return {
      {"schema", 1},
      {"recording",
       {{"samples", analysis.samples()}, {"sample_period_s", recording.period_s}}},
      {"oscillation",
       {{"detected", r.oscillation.detected},
        {"period_s", known(periodic, r.oscillation.period_samples * analysis.period_s())},
        {"regularity", r.oscillation.regularity},
        {"cycles", r.cycles}}},
      {"verdict", ident::name(r.verdict)},
      {"reason", ident::sentence(r.reason)},
      {"cause",
       r.cause == ident::Cause::kUnknown ? Json(nullptr) : Json(ident::name(r.cause))},
      {"stick_band", json_of(r.stick_band)},
      {"slip_jump", json_of(r.slip_jump)},
      {"fit_percent", known(modelled, r.fit_percent)},
      {"fit_linear_percent", known(modelled, r.fit_linear_percent)},
      {"fit_valve_percent", known(r.valve.known, r.fit_valve_percent)},
      {"aic", known(modelled, r.aic)},
      {"aic_linear", known(modelled && r.aic_linear != 0, r.aic_linear)},
      {"model", model_json(r.model, modelled)},
      {"detectable_band",
       {{"value", known(r.detectable_band > 0, r.detectable_band)},
        {"percent_of_span", known(r.detectable_band > 0 && analysis.span() > 0,
                                  100 * r.detectable_band / analysis.span())}}},
      {"evidence", evidence_json(analysis)},
      {"rivals", rivals_json(r)},
      {"controller", controller_json(r.controller)},
      {"windows", analysis.windows()},
      {"decimation", analysis.decimation()},
      {"notes", notes},
      {"runtime_ms", analysis.runtime_ms()},
  };
}

std::string json_line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace workbench
