#include "workbench/report/model_parts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "workbench/analysis/wording.hpp"
#include "workbench/model/tell/cautions.hpp"
#include "workbench/model/tell/curve_of.hpp"
#include "workbench/model/tell/harm.hpp"
#include "workbench/model/tell/parameter_words.hpp"
#include "workbench/model/tell/what_to_do.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/report/model_headline.hpp"
#include "workbench/report/page_parts.hpp"
#include "workbench/report/svg_plot.hpp"
#include "workbench/report/texts.hpp"

namespace workbench {
namespace {

std::string fall(double before, double after) {
  if (!(before > 0)) return {};
  const double percent = 100 * (after / before - 1);
  const double size = std::abs(percent);
  if (size < 0.05) return "0\u00a0%";
  return (percent > 0 ? "+" : "−") + fixed(size, size < 1 ? 1 : 0) + "\u00a0%";
}

std::string with_minus(double value, int decimals) {
  const std::string text = fixed(value, decimals);
  return text.starts_with('-') ? "−" + text.substr(1) : text;
}

std::string cannot_tell(const Candidate& c) {
  if (c.indistinguishable_from.empty()) return {};
  return filled(c.with.empty()
                    ? "This recording cannot tell it from {0}."
                    : "One of them may as well be {0}: this recording cannot tell.",
                {titled(c.indistinguishable_from, " or ")}) +
         (!c.would_split ? ""
          : c.would_split->ends_with('?')
              ? filled(" What would: {0}", {*c.would_split})
              : filled(" What would: {0}.", {*c.would_split}));
}

// Why the first undecided candidate of the list is not the closest one.
std::string passed_over(const ExplainResult& result, const Candidate& closest) {
  for (const Candidate& c : result.candidates) {
    if (&c == &closest) break;
    if (c.status != CandidateStatus::kUndecided || !(c.error_reduction_percent > 0)) {
      continue;
    }
    const std::string name = capitalised(titled(members_of(c), " with "));
    if (c.spoken_against) {
      return filled(" {0} lowers the error more, but its own values speak against it.",
                    {name});
    }
    return filled(
        " {0} lowers the error more, but this recording cannot tell it from another.",
        {name});
  }
  return {};
}

std::string story(const ModelReport& report) {
  const Comparison& comparison = report.comparison;
  if (const Candidate* missing = report.explanation.best()) {
    const char* words =
        missing->rmse_validation_after >= missing->rmse_validation_before
            ? " The readings show it, not the error: on samples that were not fitted "
              "that goes from {0} to {1} ({2})."
        : missing->with.empty()
            ? " With it the error on samples that were not fitted goes from {0} to {1} "
              "({2})."
            : " With them the error on samples that were not fitted goes from {0} to {1} "
              "({2}).";
    return missing->evidence + filled(words, {number(missing->rmse_validation_before, 3),
                                              number(missing->rmse_validation_after, 3),
                                              fall(missing->rmse_validation_before,
                                                   missing->rmse_validation_after)});
  }
  const std::string left = comparison.residual_test.follows_u
                               ? "What the model leaves over still follows u."
                               : "What the model leaves over does not follow u any more.";
  const std::string found =
      comparison.effects.empty()
          ? "The model is a first-order process behind a valve that follows u. "
          : "";
  if (report.explanation.left_to_controller) return found;
  if (report.explanation.explained) return found + left;
  const Candidate* doubt = report.explanation.closest();
  return found + left +
         (doubt != nullptr
              ? filled(" Closest to an explanation: {0}. ", {title_of(doubt->effect)}) +
                    doubt->evidence + passed_over(report.explanation, *doubt)
              : " No effect of the catalogue explains the rest beyond chance.");
}

Mood mood(const ModelReport& report) {
  if (report.explanation.best() != nullptr) return Mood::kBad;
  return report.explanation.explained && !report.lacks_stem ? Mood::kGood : Mood::kOpen;
}

// What a name alone does not say.
std::string_view explained(std::string_view parameter) {
  if (parameter == "reference") return "the u at which y rests at its offset";
  if (parameter == "offset") return "y where u is at its reference";
  return {};
}

std::string parameter_rows(const std::vector<Parameter>& parameters,
                           const ModelReport& report) {
  std::string out;
  for (const Parameter& p : parameters) {
    std::string name = escaped(name_in_words(p.name));
    const std::string choice = choice_in_words(p);
    const bool interval = p.low < p.high;
    const std::string_view meaning = explained(p.name);
    if (!meaning.empty()) {
      name += "<br><small>" + escaped(std::string(meaning)) + "</small>";
    }
    out += "<tr><td>" + name + "</td><td>" +
           (choice.empty() ? number(p.value, 4) : escaped(choice)) + "</td><td>" +
           (interval ? number(p.low, 4) + " to " + number(p.high, 4) : "–") +
           "</td><td class=\"text\">" +
           escaped(unit_in_words(p, report.recording, report.model.output)) +
           "</td></tr>";
  }
  return out;
}

std::string group_row(const std::string& title, const std::string& code) {
  return "<tr><td class=\"group\" colspan=\"4\">" + escaped(title) +
         (code.empty() ? "" : " <code>" + escaped(code) + "</code>") + "</td></tr>";
}

std::string curve_row(const EffectTerm& term) {
  const std::optional<NamedCurve> curve = curve_of(term.effect, term.parameters);
  return !curve ? ""
                : "<tr><td class=\"text\" colspan=\"4\">" + escaped(curve->words) +
                      "</td></tr>";
}

std::string candidate_item(const Candidate& c) {
  std::string effects = c.effect;
  std::string codes = c.effect;
  for (const std::string& partner : c.with) {
    effects += '\n' + partner;
    codes += " with " + partner;
  }
  std::string out =
      "<li data-effects=\"" + escaped(effects) + "\"><h3><span class=\"badge " +
      std::string(name_of(c.status)) + "\">" +
      (c.status == CandidateStatus::kNotExcited ? "not excited"
                                                : std::string(name_of(c.status))) +
      "</span>" + escaped(capitalised(titled(members_of(c), " with "))) + "<code>" +
      escaped(codes) + "</code></h3><p>" + escaped(c.evidence);
  if (c.rmse_validation_after < c.rmse_validation_before) {
    out += filled(
        " Validation error {0} to {1}, which takes away {2} % of the squared error.",
        {number(c.rmse_validation_before, 3), number(c.rmse_validation_after, 3),
         number(c.error_reduction_percent, 3)});
  }
  const std::string group = cannot_tell(c);
  if (!group.empty()) out += " " + escaped(group);
  return out + "</p></li>\n";
}

// The unit of the errors, and what to measure them by.
std::string in_units(const ModelReport& report, double refitted, double noise) {
  std::string out = output_unit(report);
  if (refitted > 0) out = filled("{0}, {1} after a refit", {out, number(refitted, 3)});
  if (noise > 0) out = filled("{0}, noise about {1}", {out, number(noise, 3)});
  return out;
}

// Why what did not lower the error is in the model all the same.
void say_why_it_stays(const ModelReport& report, std::vector<Remark>& remarks) {
  for (const std::string& code : report.comparison.effects) {
    const HistoryStep* harm = harm_of(report.model, code);
    if (harm == nullptr) continue;
    remarks.push_back(
        {"Why it stays.",
         capitalised(filled(
             is_in_doubt(*harm)
                 ? "{0} takes the error of all samples from {1} to {2}, but that of "
                   "samples that were not fitted from {3} to {4}: take it out where a "
                   "simpler model will do."
                 : "{0} was asked for. It takes the error of all samples from {1} to {2} "
                   "and that of samples that were not fitted from {3} to {4}: better "
                   "take it out.",
             {title_of(code), number(harm->rmse_before, 3), number(harm->rmse_after, 3),
              number(harm->rmse_validation_before, 3),
              number(harm->rmse_validation_after, 3)}))});
  }
}

// From what to what its error one sample ahead went.
std::string ahead_cell(const HistoryStep& step) {
  if (!step.ahead) return "";
  const auto [before, after] = *step.ahead;
  return filled("{0} to {1}, {2}",
                {number(before, 4), number(after, 4), fall(before, after)});
}

// The row above the parameters of an effect.
std::string_view remark_on(const EffectTerm& term) {
  if (term.phenomenological) {
    return "{0} (phenomenological: helps only at the edge of its physical range)";
  }
  return term.untold ? "{0} (uncertain: its intervals reach to where it would be absent)"
                     : "{0}";
}

}  // namespace

std::string model_verdict(const ModelReport& report) {
  std::vector<Remark> remarks = {{"", story(report)}};
  say_why_it_stays(report, remarks);
  if (const double refitted = refitted_error(report); refitted > 0) {
    const double before = report.comparison.quality.rmse_validation;
    remarks.push_back(
        {"Refit.",
         filled(
             refitted > before
                 ? "Candidates are judged after the model was fitted again to this "
                   "recording, which agrees better with the samples that are fitted but "
                   "takes the validation error up from {0} to {1}: for other samples the "
                   "model as it is serves better."
                 : "Candidates are judged after the model was fitted again to this "
                   "recording, which takes the validation error from {0} to {1}.",
             {number(before, 3), number(refitted, 3)})});
  }
  if (const std::optional<Searched>& searched = report.explanation.searched) {
    const std::string samples = std::to_string(searched->samples);
    const std::string period = number(searched->period_s);
    remarks.push_back(
        {"A long recording.",
         searched->is_excerpt
             ? filled(
                   "Candidates are judged in the {0} samples from t = {1} on, where u "
                   "moves most, one every {2} s; the fit above is that of all samples.",
                   {samples, instant(searched->from_s, searched->period_s) + " s",
                    period})
             : filled(
                   "Candidates are judged in {0} samples, one every {1} s; the fit above "
                   "is that of all samples.",
                   {samples, period})});
  }
  if (const Candidate* missing = report.explanation.best()) {
    remarks.push_back({"Cannot be told apart.", cannot_tell(*missing)});
    std::string_view title = "What to do.";
    for (const std::string& said : what_to_do(*missing, report.lacks_stem)) {
      remarks.push_back({std::exchange(title, ""), said});
    }
  }
  for (const std::string& caution :
       report.explanation.with_best
           ? cautions(*report.explanation.with_best, report.recording,
                      report.explanation.with_best_quality,
                      report.explanation.left_to_controller)
           : cautions(report.model, report.recording, report.comparison.quality,
                      report.explanation.left_to_controller)) {
    remarks.push_back({"Mind this.", caution});
  }
  if (!report.explanation.explained && !report.comparison.failures.empty()) {
    const Failure& worst = report.comparison.failures.front();
    remarks.push_back({"Where it fails most.",
                       filled("{0} % of the squared error lies in {1}.",
                              {fixed(100 * worst.share_of_error, 0), worst.where})});
  }
  return verdict_box(mood(report), model_headline(report), remarks);
}

std::string model_tiles(const ModelReport& report) {
  const Comparison& comparison = report.comparison;
  const double now = comparison.quality.rmse_validation;
  const double noise = noise_floor(report);
  const double refitted = refitted_error(report);
  std::string out =
      tile("Explained by the model", with_minus(comparison.quality.fit_percent, 1) + " %",
           "from u alone, free simulation of all samples") +
      tile("Validation error", number(now, 3), in_units(report, refitted, noise));
  const std::vector<HistoryStep>& history = report.model.history;
  const bool comparable = std::ranges::all_of(history, [&](const HistoryStep& step) {
    return step.recording == report.recording.name;
  });
  if (history.size() > 1 && comparable && history.front().rmse_validation_after > 0) {
    const double start = history.front().rmse_validation_after;
    out += tile("Since the start", fall(start, history.back().rmse_validation_after),
                "validation error, from " + number(start, 3));
  }
  out += tile(
      "Effects in the model", std::to_string(comparison.effects.size()),
      comparison.effects.empty() ? "a textbook model" : titled(comparison.effects, ", "));
  return tile_row(out);
}

std::string step_table(const Model& model) {
  const bool any_ahead = std::ranges::any_of(
      model.history, [](const HistoryStep& step) { return step.ahead.has_value(); });
  std::string out =
      "<div class=\"scroll\"><table><tr><th>step</th><th>validation error</th>"
      "<th>change</th>";
  out += any_ahead ? "<th>one sample ahead</th></tr>" : "</tr>";
  std::string recording;
  double before = 0;
  for (const HistoryStep& step : model.history) {
    const std::string name =
        step.effect == "process"         ? "first-order process"
        : step.effect == "refit"         ? filled("fitted anew to {0}", {step.recording})
        : step.effect == "by hand"       ? "values set by hand"
        : step.effect == "refit by hand" ? "fitted from values set by hand"
        : step.effect.starts_with('-')   ? "without " + title_of(step.effect.substr(1))
                                         : title_of(step.effect);
    if (step.recording != recording) before = step.rmse_validation_before;
    recording = step.recording;
    const double now = step.rmse_validation_after;
    const std::string change = fall(std::exchange(before, now), now);
    out += "<tr><td>" + escaped(name) + "</td><td>" + number(now, 4) + "</td><td>" +
           (change.empty() ? "–" : change) + "</td>";
    if (any_ahead) out += "<td>" + ahead_cell(step) + "</td>";
    out += "</tr>";
  }
  if (model.history.empty()) return "";
  out += "</table></div>\n";
  if (any_ahead) {
    out +=
        "<p>Running free, a load hides what tells itself one sample ahead: there the "
        "error says little of it, and may rise.</p>\n";
  }
  return out;
}

std::string candidate_list(const ExplainResult& result) {
  std::string open;
  std::string closed;
  std::size_t count = 0;
  for (const Candidate& c : result.candidates) {
    const bool shown =
        c.status == CandidateStatus::kAccepted || c.status == CandidateStatus::kUndecided;
    (shown ? open : closed) += candidate_item(c);
    if (!shown) ++count;
  }
  if (open.empty()) {
    open = "<li><p>None of the effects that the model lacks is supported.</p></li>";
  }
  std::string out =
      "<ul class=\"candidates\" data-more=\"More of them in the page itself.\">" + open +
      "</ul>\n";
  if (closed.empty()) return out;
  return out + "<details><summary>" + std::to_string(count) +
         " more: rejected, or never exercised by this recording</summary>"
         "<ul class=\"candidates\">" +
         closed + "</ul></details>\n";
}

std::string parameter_table(const ModelReport& report) {
  const Model& model = report.model;
  std::string out =
      "<div class=\"scroll\"><table><tr><th></th><th>value</th><th>95 % interval</th>"
      "<th class=\"text\">unit</th></tr>";
  for (const EffectTerm& term : model.effects) {
    out += group_row(capitalised(filled(remark_on(term), {title_of(term.effect)})),
                     term.effect) +
           curve_row(term) + parameter_rows(told_parameters(term), report);
  }
  return out + group_row("Process", "") + parameter_rows(model.process, report) +
         "</table></div>\n";
}

}  // namespace workbench
