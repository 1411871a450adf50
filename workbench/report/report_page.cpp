#include "workbench/report/report_page.hpp"

#include <algorithm>
#include <span>
#include <vector>

#include "workbench/analysis/wording.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/listed.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/report/page_parts.hpp"
#include "workbench/report/svg_plot.hpp"
#include "workbench/report/valve_parts.hpp"

namespace workbench {
namespace {

using Estimate = ident::Estimate<double>;

struct Row {
  const char* label;
  const Estimate& estimate;
  double truth;
};

std::string numbers_table(const ReportData& data) {
  const Identification& r = data.analysis.result();
  const KnownTruth truth = data.truth.value_or(KnownTruth{});
  const Row rows[] = {
      {"Stick band S, ascending", r.stick_band.ascending, truth.stick_band_ascending},
      {"Stick band S, descending", r.stick_band.descending, truth.stick_band_descending},
      {"Slip jump J, ascending", r.slip_jump.ascending, truth.slip_jump_ascending},
      {"Slip jump J, descending", r.slip_jump.descending, truth.slip_jump_descending},
  };
  const double span = data.analysis.span();
  std::string out =
      "<div class=\"scroll\"><table><tr><th></th><th>units of u</th><th>95 % "
      "interval</th>"
      "<th>% of the range of u</th>";
  if (data.truth) out += "<th>true</th><th>error</th>";
  out += "</tr>";
  for (const Row& row : rows) {
    const Estimate& e = row.estimate;
    const EstimateText t = text_of(e);
    out += std::string("<tr><td>") + row.label + "</td><td>" + t.value + "</td><td>" +
           (e.known ? t.interval : "–") + "</td><td>" +
           (e.known && span > 0 ? fixed(100 * e.value / span, 1) : "–") + "</td>";
    if (data.truth) {
      const bool comparable = e.known && row.truth > 0;
      out += "<td>" + number(row.truth, 4) + "</td><td>" +
             (comparable ? fixed(100 * (e.value / row.truth - 1), 1) + " %" : "–") +
             "</td>";
    }
    out += "</tr>";
  }
  return out + "</table></div>\n";
}

std::string bar(const char* label, const char* ink, double percent) {
  const double width = std::clamp(percent, 0.0, 100.0);
  return std::string("<div class=\"bar\"><span>") + label + "</span><i class=\"" + ink +
         "\" style=\"width:" + fixed(width, 1) + "%\"></i><span>" + fixed(percent, 1) +
         " %</span></div>";
}

std::string evidence(const ReportData& data) {
  const Identification& r = data.analysis.result();
  if (!has_model(r)) return {};
  std::string out;
  if (r.valve.known) out += bar("physical valve", "valve", r.fit_valve_percent);
  out += bar("two-path model", "two-path", r.fit_percent) +
         bar("valve that follows u", "linear", r.fit_linear_percent);
  const auto row = [&out](const char* label, const std::string& value,
                          const char* meaning) {
    out += std::string("<tr><td>") + label + "</td><td>" + value +
           "</td><td class=\"text\">" + meaning + "</td></tr>";
  };
  out += "<div class=\"scroll\"><table><tr><th></th><th>value</th><th></th></tr>";
  const auto& e = r.evidence;
  if (r.aic_linear != 0) {
    row("AIC, linear minus two-path model", fixed(r.aic_linear - r.aic, 0),
        "above 0: the second path is worth its parameters");
  }
  row("Squared error, linear over physical valve", fixed(e.error_ratio, 2),
      "1: nothing gained by a valve that sticks; where it was searched, not over all "
      "samples as the bars");
  row("Squared error, no slip jump over physical valve", fixed(e.jump_ratio, 2),
      "1: play (backlash) explains it as well; where it was searched");
  row("Gain in log-likelihood", fixed(e.score, 1),
      "nats, after the cost of the valve's parameters");
  row("Stick band over swing of u", fixed(e.band_over_swing, 2),
      "share of each swing that the valve loses");
  row("Reversals of u", std::to_string(e.reversals), "events the answer rests on");
  return out + "</table></div>\n";
}

std::string list_of(std::span<const double> values) {
  return listed(values, ", ", [](double value) { return number(value, 5); });
}

std::string model_table(const Identification& r) {
  if (!has_model(r)) return {};
  const ident::TwoPathModel<double>& m = r.model;
  const ident::Process<double>& p = m.process;
  std::string out = "<div class=\"scroll\"><table>";
  const auto row_of = [&out](const char* label, const std::string& html) {
    out += std::string("<tr><td>") + label + "</td><td class=\"text\">" + html +
           "</td></tr>";
  };
  const auto row = [&row_of](const char* label, const std::string& values) {
    row_of(label, "<code>" + values + "</code>");
  };
  const auto size = [](int n) { return static_cast<std::size_t>(n); };
  row("na, nb, nk",
      std::to_string(p.na) + ", " + std::to_string(p.nb) + ", " + std::to_string(p.nk));
  row("a", list_of(std::span(p.a).first(size(p.na))));
  row("b", list_of(std::span(p.b).first(size(p.nb))));
  row("d", number(p.d, 5));
  const auto path = [&](const char* knots, const char* x,
                        const ident::Path<double>& stroke) {
    row(knots, list_of(std::span(stroke.knots).first(size(stroke.segments) + 1)));
    row(x, list_of(std::span(stroke.x).first(size(stroke.segments) + 1)));
  };
  path("ascending, knots of u", "ascending, x", m.ascending);
  path("descending, knots of u", "descending, x", m.descending);
  if (r.valve.known) {
    row_of("physical valve",
           filled("deadband {0}, slip ascending {1}, slip descending {2}",
                  {number(r.valve.friction.deadband, 4),
                   number(r.valve.friction.slip_ascending, 4),
                   number(r.valve.friction.slip_descending, 4)}));
  }
  return out + "</table></div>\n";
}

std::string notes(const ReportData& data) {
  std::vector<std::string> all = data.recording.resampling.notes;
  all.insert(all.end(), data.analysis.notes().begin(), data.analysis.notes().end());
  return bullet_list(all);
}

std::string judged_together(const ReportData& data) {
  if (data.others.empty()) return {};
  return "<p>" +
         escaped(filled("Judged together with {0}. The pictures show {1}.",
                        {listed(data.others), data.recording.name})) +
         "</p>\n";
}

}  // namespace

std::string report_page(const ReportData& data) {
  const Identification& r = data.analysis.result();
  std::string out = page_top("Valve report", data.recording, headline_of(r)) +
                    judged_together(data) + valve_verdict(data) + valve_tiles(data);
  if (r.stick_band.ascending.known || r.stick_band.descending.known || data.truth) {
    out += section("How much it sticks",
                   "Stick band: travel of u after a reversal until the valve moves. Slip "
                   "jump: how far it then jumps. Ascending: about to move with rising u.",
                   numbers_table(data));
  }
  out += section("Over time",
                 "Simulated curves start from u alone; no measured y is fed back.",
                 signal_figures(data));
  out += section("Three cycles, closer", "", closer_figures(data));
  out += section("Valve and process", "",
                 side_by_side(path_figure(data), step_figure(data)));
  out += section("Evidence against a valve that follows its signal",
                 "How much of y each model explains from u alone; 100 % is all of it, "
                 "noise included.",
                 evidence(data));
  out += section("The identified model",
                 "Two paths in front of a linear process; x in the model's own measure.",
                 model_table(r));
  out += section("Notes", "", notes(data));
  return out + page_end(filled("Identified in {0} ms.",
                               {fixed(data.analysis.runtime_ms(), 0)}) +
                        " Intervals are 95 %.");
}

}  // namespace workbench
