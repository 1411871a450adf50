#include "workbench/model/tell/explanation_json.hpp"

#include "workbench/model/tell/model_json.hpp"

namespace workbench {
namespace {

using Json = nlohmann::ordered_json;

Json candidate_json(const Candidate& c) {
  Json out = {{"effect", c.effect},
              {"with", c.with},
              {"status", name_of(c.status)},
              {"rmse_before", c.rmse_before},
              {"rmse_after", c.rmse_after},
              {"rmse_validation_before", c.rmse_validation_before},
              {"rmse_validation_after", c.rmse_validation_after},
              {"error_reduction_percent", c.error_reduction_percent},
              {"p_value", c.p_value},
              {"indistinguishable_from", c.indistinguishable_from},
              {"would_split", c.would_split ? Json(*c.would_split) : Json(nullptr)},
              {"evidence", c.evidence}};
  if (c.ahead) {
    out["one_sample_ahead"] = ahead_json(*c.ahead);
    out["one_sample_ahead"]["nats"] = c.nats_ahead;
  }
  out.update(effect_json(c.effect, c.phenomenological, c.parameters));
  if (c.partners.empty()) return out;
  out["partners"] = Json::array();
  for (const EffectTerm& term : c.partners) out["partners"].push_back(term_json(term));
  return out;
}

}  // namespace

Json recordings_json(const std::vector<RecordingFit>& recordings) {
  Json out = Json::array();
  for (const RecordingFit& one : recordings) {
    out.push_back({{"file", one.file},
                   {"fit_percent", one.fit_percent},
                   {"rmse", one.rmse},
                   // 0: all of its samples were fitted, and none judges.
                   {"rmse_validation",
                    one.rmse_validation > 0 ? Json(one.rmse_validation) : Json(nullptr)},
                   {"judges", one.judges}});
  }
  return out;
}

Json comparison_json(const Comparison& comparison) {
  Json failures = Json::array();
  for (const Failure& failure : comparison.failures) {
    failures.push_back({{"where", failure.where},
                        {"view", name_of(failure.view)},
                        {"share_of_error", failure.share_of_error},
                        {"share_of_samples", failure.share_of_samples},
                        {"mean_residual", failure.mean_residual},
                        {"t", {failure.t_from, failure.t_to}}});
    if (!failure.recording.empty()) failures.back()["recording"] = failure.recording;
  }
  const Whiteness& test = comparison.residual_test;
  return {{"schema", 1},
          {"effects", comparison.effects},
          {"stayed_behind", comparison.stayed_behind},
          {"fit_percent", comparison.quality.fit_percent},
          {"rmse", comparison.quality.rmse},
          {"rmse_validation", comparison.quality.rmse_validation},
          {"residual",
           {{"white", test.white},
            {"bound", test.bound},
            {"autocorrelation", test.autocorrelation},
            {"effective_samples", test.effective_samples},
            {"follows_u", test.follows_u}}},
          {"failures", failures},
          {"recordings", recordings_json(comparison.quality.recordings)}};
}

Json searched_json(const std::optional<Searched>& searched) {
  if (!searched) return nullptr;
  return {{"samples", searched->samples},
          {"sample_period_s", searched->period_s},
          {"from_s", searched->from_s},
          {"excerpt", searched->is_excerpt}};
}

Json explanation_json(const ExplainResult& result) {
  Json candidates = Json::array();
  for (const Candidate& c : result.candidates) candidates.push_back(candidate_json(c));
  return {{"schema", 1},
          {"complete", result.complete},
          {"explained", result.explained},
          {"left_to_controller", result.left_to_controller},
          {"rmse", result.rmse},
          {"rmse_validation", result.rmse_validation},
          {"noise_rmse", result.noise_rmse},
          {"candidates", candidates},
          {"recordings", recordings_json(result.quality.recordings)},
          {"searched", searched_json(result.searched)}};
}

Json ladder_json(const LadderResult& result) {
  Json steps = Json::array();
  for (const LadderStep& step : result.steps) {
    steps.push_back({{"effect", step.effect},
                     {"removed", step.removed},
                     {"on_the_way", step.on_the_way},
                     {"rmse", step.rmse},
                     {"rmse_validation", step.rmse_validation},
                     {"indistinguishable_from", step.indistinguishable_from}});
    if (step.ahead) steps.back()["one_sample_ahead"] = ahead_json(*step.ahead);
  }
  return {{"schema", 1},
          {"steps", steps},
          {"effects", result.model.effect_codes()},
          {"complete", result.complete},
          {"explained", result.explained},
          {"rmse", result.quality.rmse},
          {"rmse_validation", result.quality.rmse_validation},
          {"fit_percent", result.quality.fit_percent},
          {"noise_rmse", result.last.noise_rmse},
          {"recordings", recordings_json(result.quality.recordings)},
          {"searched", searched_json(result.searched)},
          {"left", explanation_json(result.last)["candidates"]}};
}

namespace {

Json last_step_json(const Model& model, std::string_view effect) {
  const HistoryStep& step = model.history.back();
  Json out = {{"schema", 1},
              {"effect", effect},
              {"rmse_before", step.rmse_before},
              {"rmse_after", step.rmse_after},
              {"rmse_validation_before", step.rmse_validation_before},
              {"rmse_validation_after", step.rmse_validation_after}};
  if (step.ahead) out["one_sample_ahead"] = ahead_json(*step.ahead);
  return out;
}

}  // namespace

Json removed_json(const Model& model) {
  Json out =
      last_step_json(model, std::string_view(model.history.back().effect).substr(1));
  out["effects"] = model.effect_codes();
  return out;
}

Json added_json(const Model& model) {
  const EffectTerm& term = model.effects.back();
  Json out = last_step_json(model, term.effect);
  out.update(effect_json(term.effect, term.phenomenological, term.parameters));
  return out;
}

}  // namespace workbench
