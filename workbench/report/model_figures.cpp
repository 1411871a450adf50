#include "workbench/report/model_figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "workbench/analysis/wording.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/report/svg_plot.hpp"

namespace workbench {
namespace {

using Values = std::vector<double>;

constexpr int kPanelWidth = 340;
constexpr int kPanelHeight = 210;
constexpr int kStepWidth = 104;

const Values& output_of(const ModelReport& report) {
  return report.recording.values(report.model.output);
}

// Signals over time from sample `first` up to `last`, in one unit of time.
Plot signals(const ModelReport& report, const char* title, int height, std::size_t first,
             std::size_t last,
             const std::vector<std::pair<PlotLine, const Values*>>& lines) {
  const Recording& recording = report.recording;
  const TimeUnit unit =
      time_unit_for(static_cast<double>(last - first) * recording.period_s);
  Plot plot;
  plot.title = title;
  plot.x_label = unit.label;
  plot.height = height;
  for (const auto& [line, values] : lines) {
    PlotLine part = line;
    for (std::size_t k = first; k < last; ++k) {
      part.x.push_back(recording.t[k] / unit.seconds);
      part.y.push_back((*values)[k]);
    }
    plot.lines.push_back(std::move(part));
  }
  return plot;
}

Plot overlay(const ModelReport& report, const char* title, int height, std::size_t first,
             std::size_t last) {
  const std::string name(name_of(report.model.output));
  Plot plot = signals(
      report, title, height, first, last,
      {{{"measured " + name, Ink::kMeasured, {}, {}, Stroke::kBroad}, &output_of(report)},
       {{"simulated " + name + ", from u alone", Ink::kValve, {}, {}},
        &report.comparison.simulated}});
  plot.y_label = name;
  return plot;
}

// Around the first failure that lies somewhere in time.
std::string worst_stretch(const ModelReport& report) {
  const Recording& recording = report.recording;
  for (const Failure& failure : report.comparison.failures) {
    const std::size_t length = failure.last - failure.first;
    if (failure.view == View::kFrequency || length < 2) continue;
    const std::size_t first = failure.first - std::min(failure.first, length);
    const std::size_t last = std::min(failure.last + length, recording.size());
    if (last < first + 12 || 2 * (last - first) > recording.size()) continue;
    const Plot plot =
        overlay(report, "output where the model fails most", 220, first, last);
    return figure(plot, "Closer, where the model fails most: " + failure.where + ".");
  }
  return {};
}

std::string line_break_near_middle(std::string words) {
  const std::size_t middle = words.size() / 2;
  std::size_t best = std::string::npos;
  for (std::size_t i = words.find(' '); i != std::string::npos;
       i = words.find(' ', i + 1)) {
    const auto distance = [middle](std::size_t at) {
      return at > middle ? at - middle : middle - at;
    };
    if (best == std::string::npos || distance(i) < distance(best)) best = i;
  }
  if (best != std::string::npos && words.size() > 14) words[best] = '\n';
  return words;
}

// A step of the history as a name below the curve.
std::string step_name(const std::string& effect) {
  if (effect == "process") return "start";
  if (effect == "refit" || effect == "by hand") return effect;
  if (effect == "refit by hand") return "refit";
  const bool removed = effect.starts_with('-');
  const std::string code = removed ? effect.substr(1) : effect;
  constexpr std::size_t kRoom = 14;
  std::string title = title_of(code);
  if (title.starts_with("a ")) title.erase(0, 2);
  if (title.size() <= kRoom) return (removed ? "without\n" : "+ ") + title;
  // The last word of a code is shorter.
  std::string name = code.substr(code.find('.') + 1);
  std::replace(name.begin(), name.end(), '_', ' ');
  return line_break_near_middle((removed ? "without " : "+ ") + name);
}

// Part of an exchange of several effects: the error rises on the way and falls again.
bool is_on_the_way(const std::vector<HistoryStep>& history,
                   std::vector<HistoryStep>::const_iterator step) {
  constexpr double kHigher = 1.02;
  if (step->effect == "by hand") return false;
  double least = std::numeric_limits<double>::infinity();
  for (auto earlier = history.begin(); earlier != step; ++earlier) {
    if (earlier->recording == step->recording) {
      least = std::min(least, earlier->rmse_validation_after);
    }
  }
  if (!(step->rmse_validation_after > kHigher * least)) return false;
  return std::any_of(step + 1, history.end(), [&](const HistoryStep& later) {
    return later.recording == step->recording &&
           later.rmse_validation_after <= kHigher * least;
  });
}

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
  switch (view) {
    case View::kTime:
      return "Time";
    case View::kPhase:
      return "Phase of the cycle";
    case View::kLevel:
      return "Level of u";
    case View::kDirection:
      return "Direction of u";
    case View::kSpeed:
      return "Speed of u";
    case View::kTravel:
      return "Distance of u since its reversal";
    case View::kFrequency:
      return "Frequency";
    case View::kLag:
      return "Lag behind u";
  }
  return "";
}

// Size of the error in each bin as bars, its mean as a line.
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

std::string panel_html(const ModelReport& report, const Panel& panel) {
  const ViewCurve& curve = *panel.curve;
  Plot plot;
  plot.title = std::string("residual: ") + panel_title(curve.view);
  plot.x_label = curve.coordinate;
  plot.width = kPanelWidth;
  plot.height = kPanelHeight;
  if (curve.view == View::kFrequency) {
    draw_frequencies(curve, plot);
  } else if (curve.view == View::kLag) {
    draw_lags(report, curve, plot);
  } else {
    draw_places(report, curve, plot);
  }
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

std::string title_of(std::string_view effect) {
  const Effect* known = standard_catalogue().find(effect);
  return std::string(known != nullptr ? known->description().title : effect);
}

std::string titled(const std::vector<std::string>& effects, std::string_view last_word) {
  std::string out;
  for (std::size_t i = 0; i < effects.size(); ++i) {
    if (i > 0) out += i + 1 < effects.size() ? ", " : last_word;
    out += title_of(effects[i]);
  }
  return out;
}

std::string output_unit(const ModelReport& report) {
  const std::string& unit = report.recording.unit(report.model.output);
  return unit.empty()
             ? filled("units of {0}", {std::string(name_of(report.model.output))})
             : unit;
}

double refitted_error(const ModelReport& report) {
  constexpr double kVisible = 1e-3;
  if (report.explanation.searched) return 0;  // judged in other samples
  const double as_it_is = report.comparison.quality.rmse_validation;
  const double refitted = report.explanation.rmse_validation;
  const bool same = std::abs(refitted - as_it_is) <= kVisible * as_it_is;
  return refitted > 0 && !same ? refitted : 0;
}

double noise_floor(const ModelReport& report) {
  constexpr double kChance = 1.1;
  const double noise = report.explanation.noise_rmse;
  double least = report.comparison.quality.rmse_validation;
  if (const Candidate* next = report.explanation.best()) {
    least = std::min(least, next->rmse_validation_after);
  }
  return noise > kChance * least ? 0 : noise;
}

std::string overlay_figures(const ModelReport& report) {
  const std::size_t n = report.recording.size();
  Plot u =
      signals(report, "controller output over time", 150, 0, n,
              {{{"controller output u", Ink::kMeasured, {}, {}}, &report.recording.u}});
  u.y_label = "u";
  Plot residual = signals(report, "residual over time", 130, 0, n,
                          {{{"residual, measured minus simulated", Ink::kLinear, {}, {}},
                            &report.comparison.residual}});
  residual.y_label = output_unit(report);
  return figure(overlay(report, "measured and simulated output", 270, 0, n), "") +
         figure(residual, "") + worst_stretch(report) + figure(u, "");
}

std::string ladder_figure(const ModelReport& report) {
  const std::vector<HistoryStep>& history = report.model.history;
  if (history.empty()) return {};
  Plot plot;
  plot.title = "validation error after each step";
  plot.y_label = "validation error, " + output_unit(report);
  plot.height = 316;
  plot.staggered = true;
  plot.include_zero = true;
  PlotLine curve{"", Ink::kTwoPath, {}, {}};
  curve.is_signal = false;
  const auto mark = [&](std::string name, double error) {
    curve.x.push_back(static_cast<double>(plot.names.size()));
    curve.y.push_back(error);
    curve.notes.push_back(number(error, 3));
    plot.names.push_back(std::move(name));
  };
  // Another recording has an error of its own to start from.
  std::string recording = history.front().recording;
  const auto turn_to = [&](const std::string& name, double error) {
    if (name == recording) return;
    recording = name;
    if (std::isfinite(error)) mark("on\n" + name, error);
  };
  bool replaced = false;
  for (auto step = history.begin(); step != history.end(); ++step) {
    turn_to(step->recording, step->rmse_validation_before);
    if (is_on_the_way(history, step)) {
      replaced = true;
      continue;
    }
    mark(step_name(step->effect), step->rmse_validation_after);
  }
  turn_to(report.recording.name, report.comparison.quality.rmse_validation);
  const Candidate* next = report.explanation.best();
  if (next != nullptr) {
    PlotLine promise{"", Ink::kValve, {}, {}, Stroke::kDashed};
    promise.is_signal = false;
    promise.x = {curve.x.back(), curve.x.back() + 1};
    promise.y = {curve.y.back(), next->rmse_validation_after};
    promise.notes = {"", number(next->rmse_validation_after, 3)};
    plot.lines.push_back(std::move(promise));
    plot.names.push_back(step_name(next->effect) + "\nnot yet added");
  }
  plot.lines.push_back(std::move(curve));
  const double noise = noise_floor(report);
  if (noise > 0) plot.levels.push_back({"noise, about " + number(noise, 3), noise});
  plot.width = kStepWidth * std::max(5, static_cast<int>(plot.names.size()));
  std::string caption =
      "Error of the free simulation on the samples that had no part in the fit.";
  if (noise > 0) {
    caption += " The noise is what no model could explain, as far as this one tells.";
  }
  if (replaced) caption += " Effects that were replaced on the way are in the table.";
  return figure(plot, caption);
}

std::string residual_panels(const ModelReport& report) {
  std::vector<Panel> panels;
  for (const Failure& failure : report.comparison.failures) {
    for (const ViewCurve& curve : report.comparison.views) {
      if (curve.view == failure.view) panels.push_back({&curve, &failure});
    }
  }
  for (const ViewCurve& curve : report.comparison.views) {
    const bool shown = std::any_of(panels.begin(), panels.end(),
                                   [&](const Panel& p) { return p.curve == &curve; });
    if (!shown && !curve.position.empty()) panels.push_back({&curve, nullptr});
  }
  std::string out;
  for (const Panel& panel : panels) out += panel_html(report, panel);
  return out.empty() ? out : "<div class=\"panels\">" + out + "</div>\n";
}

}  // namespace workbench
