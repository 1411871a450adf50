// The residual, seen in all ways.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include "workbench/analysis/wording.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/report/model_figures.hpp"
#include "workbench/report/svg_plot.hpp"

namespace workbench {
namespace {

constexpr int kPanelWidth = 340;
constexpr int kPanelHeight = 210;

// Of what is there never "0 %".
std::string percent(double share) {
  const bool little = share > 0 && share < 0.005;
  return (little ? number(100 * share, 1) : fixed(100 * share, 0)) + " %";
}

struct Panel {
  const ViewCurve* curve;
  const Failure* failure;  // null where the error lies as the samples do
};

std::string panel_text(const Panel& panel, const Comparison& comparison) {
  const View view = panel.curve->view;
  if (view == View::kLag) {
    const Whiteness& test = comparison.residual_test;
    const auto beyond = [&test](double bar) { return std::abs(bar) > test.bound; };
    return test.follows_u
               ? std::ranges::any_of(panel.curve->mean, beyond)
                     ? "The residual still follows u, beyond chance."
                     : "The residual still follows u, beyond chance: no bar alone "
                       "reaches the dashed lines, but all of them together do not come "
                       "by chance."
               : "The residual does not follow u: bars beyond the dashed lines are "
                 "chance, or u answering the output.";
  }
  if (panel.failure == nullptr) return "No place stands out.";
  return "<b>" + percent(panel.failure->share_of_error) +
         " of the squared error</b> in " + percent(panel.failure->share_of_samples) +
         " of the samples: " + escaped(panel.failure->where);
}

const char* panel_title(View view) {
  constexpr std::array kTitles = {"Time",       "Phase of the cycle",
                                  "Level of u", "Direction of u",
                                  "Speed of u", "Distance of u since its reversal",
                                  "Frequency",  "Lag behind u"};
  return kTitles[static_cast<std::size_t>(view)];
}

void draw_places(const ModelReport& report, const ViewCurve& curve, Plot& plot) {
  const Comparison& comparison = report.comparison;
  const double rmse = comparison.quality.rmse;
  const double width =
      curve.position.size() > 1 ? curve.position[1] - curve.position[0] : 1;
  PlotLine mean{"", Ink::kMeasured, {}, {}};
  for (std::size_t i = 0; i < curve.position.size(); ++i) {
    if (!(curve.sample_share[i] > 0)) continue;
    const double at = curve.position[i];
    const double size = rmse * std::sqrt(curve.error_share[i] / curve.sample_share[i]);
    plot.bars.push_back({at - width / 2, at + width / 2, size,
                         curve.error_share[i] > 1.2 * curve.sample_share[i]});
    mean.x.push_back(at);
    mean.y.push_back(curve.mean[i]);
  }
  mean.is_signal = false;
  plot.lines.push_back(std::move(mean));
  plot.levels.push_back({"", rmse});
  plot.y_label = output_unit(report);
}

// Shares by period; the names of some bins only, as many as there is room for.
void draw_frequencies(const ViewCurve& curve, Plot& plot) {
  constexpr std::size_t kMostNames = 6;
  const std::size_t bins = curve.position.size();
  const std::size_t every = bins / kMostNames + 1;
  for (std::size_t i = 0; i < bins; ++i) {
    const auto at = static_cast<double>(i);
    plot.bars.push_back({at - 0.5, at + 0.5, 100 * curve.error_share[i],
                         curve.error_share[i] > curve.sample_share[i] + 0.2});
    const bool named = (bins - 1 - i) % every == 0;
    plot.names.push_back(!named         ? ""
                         : i + 1 < bins ? fixed(curve.position[i], curve.position[i] < 10)
                                        : "longer");
  }
  plot.y_label = "% of the squared error";
}

void draw_lags(const ModelReport& report, const ViewCurve& curve, Plot& plot) {
  const double half = report.recording.period_s / 2;
  const Whiteness& test = report.comparison.residual_test;
  const double bound = test.bound;
  for (std::size_t i = 0; i < curve.position.size(); ++i) {
    plot.bars.push_back({curve.position[i] - half, curve.position[i] + half,
                         curve.mean[i],
                         test.follows_u && std::abs(curve.mean[i]) > bound});
  }
  plot.levels = {{"", bound}, {"", -bound}};
  plot.y_label = "correlation";
}

// Times as on the axes of the charts: since the start where the file says when that was.
void tell_time(const Recording& recording, Plot& plot) {
  const double begin = recording.start.empty() ? 0 : recording.t.front();
  const TimeUnit unit = time_unit_for(recording.t.back() - recording.t.front());
  const auto scaled = [&](double& t) { t = (t - begin) / unit.seconds; };
  for (PlotBar& bar : plot.bars) {
    scaled(bar.low);
    scaled(bar.high);
  }
  for (PlotLine& line : plot.lines) {
    for (double& t : line.x) scaled(t);
  }
  constexpr std::string_view kTime = "time, ";
  plot.x_label = unit.label;
  if (recording.start.empty()) return;
  constexpr std::size_t kToTheMinute = 16;
  std::string start = recording.start.substr(0, kToTheMinute);
  std::ranges::replace(start, 'T', ' ');
  plot.x_label = filled("time, {0} from {1}", {plot.x_label.substr(kTime.size()), start});
}

// What is counted in u, in the unit of u where that is known.
std::string coordinate_in_words(const ViewCurve& curve, const Recording& recording) {
  const std::string& unit = recording.unit(Column::u);
  if (unit.empty()) return curve.coordinate;
  switch (curve.view) {
    case View::kLevel:
      return "u, " + unit;
    case View::kSpeed:
      return filled("speed of u, {0}", {unit + "/s"});
    case View::kTravel:
      return filled("travel of u since its last reversal, {0}", {unit});
    default:
      return curve.coordinate;
  }
}

std::string panel_html(const ModelReport& report, const Panel& panel) {
  const ViewCurve& curve = *panel.curve;
  Plot plot;
  plot.title = std::string("residual: ") + panel_title(curve.view);
  plot.x_label = coordinate_in_words(curve, report.recording);
  plot.width = kPanelWidth;
  plot.height = kPanelHeight;
  if (curve.view == View::kFrequency) {
    draw_frequencies(curve, plot);
  } else if (curve.view == View::kLag) {
    draw_lags(report, curve, plot);
  } else {
    draw_places(report, curve, plot);
  }
  if (curve.view == View::kTime) tell_time(report.recording, plot);
  if (panel.failure == nullptr && curve.view != View::kLag) {
    for (PlotBar& bar : plot.bars) bar.raised = false;
  }
  if (curve.view == View::kDirection) {
    // Bins at -1, 0 and 1, of which the middle one is always empty.
    plot.names = {"falling", "", "rising"};
    for (PlotBar& bar : plot.bars) {
      bar.low += 1.2;
      bar.high += 0.8;
    }
    plot.lines.clear();
  }
  return std::string("<div><h3>") + panel_title(curve.view) + "</h3><p>" +
         panel_text(panel, report.comparison) + "</p>" + figure(plot, "") + "</div>\n";
}

}  // namespace

std::string residual_panels(const ModelReport& report) {
  std::vector<Panel> panels;
  for (const Failure& failure : report.comparison.failures) {
    for (const ViewCurve& curve : report.comparison.views) {
      if (curve.view == failure.view) panels.push_back({&curve, &failure});
    }
  }
  for (const ViewCurve& curve : report.comparison.views) {
    const bool shown =
        std::ranges::any_of(panels, [&](const Panel& p) { return p.curve == &curve; });
    if (!shown && !curve.position.empty()) panels.push_back({&curve, nullptr});
  }
  std::string out;
  for (const Panel& panel : panels) out += panel_html(report, panel);
  return out.empty() ? out : "<div class=\"panels\">" + out + "</div>\n";
}

}  // namespace workbench
