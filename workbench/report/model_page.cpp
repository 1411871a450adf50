#include "workbench/report/model_page.hpp"

#include "workbench/analysis/wording.hpp"
#include "workbench/model/tell/reconciled.hpp"
#include "workbench/report/model_headline.hpp"
#include "workbench/report/model_parts.hpp"
#include "workbench/report/page_parts.hpp"
#include "workbench/report/valve_parts.hpp"

namespace workbench {

namespace {

// What the reader needs first.
std::string on_the_valve(const ModelReport& report, const ReportData& valve) {
  std::string out = valve_verdict(valve);
  const std::string both =
      reconciled(valve.analysis.result(), report.model, report.explanation.best());
  // The verdict has said its own reason.
  const bool said = both == ident::sentence(valve.analysis.result().reason);
  if (!both.empty() && !said) out += "<p>" + both + "</p>\n";
  return out + valve_tiles(valve) +
         section("The valve", "", side_by_side(path_figure(valve), loop_figure(valve)));
}

}  // namespace

std::string model_page(const ModelReport& report, const ReportData* valve) {
  const std::string said = valve != nullptr
                               ? std::string(headline_of(valve->analysis.result()))
                               : model_headline(report);
  std::string out = page_top("Model of " + std::string(name_of(report.model.output)),
                             report.recording, said);
  if (valve != nullptr) out += on_the_valve(report, *valve);
  out += model_verdict(report) + model_tiles(report);
  out += section("Measured and simulated",
                 "Simulated from u alone; no measured value is fed back.",
                 overlay_figures(report));
  out += section("How the error fell", "",
                 side_by_side(ladder_figure(report), step_table(report.model)));
  out += section(
      "Where the model fails",
      "The residual, measured minus simulated, seen in eight ways, the most telling "
      "first. Each way looks at the whole error, so their shares overlap and do not add "
      "up to 100 %. Bars: size of the error there (root mean square), orange where it is "
      "more than its due; line: its mean; dashed: the error of the whole recording.",
      residual_panels(report));
  out += section("What could be missing",
                 "Every effect that the model lacks, fitted and judged on samples that "
                 "had no part in the fit.",
                 candidate_list(report.explanation));
  out += section("What was identified", "", parameter_table(report));
  out += section("Notes", "", bullet_list(report.recording.resampling.notes));
  return out + page_end(
                   "Intervals are 95 %. Errors are root mean squares of the free "
                   "simulation.");
}

}  // namespace workbench
