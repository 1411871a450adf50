#include "workbench/report/model_figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/report/svg_plot.hpp"

namespace workbench {
namespace {

using Values = std::vector<double>;

constexpr int kStepWidth = 104;
constexpr std::size_t kStepLetters = 16;  // that it has room for

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

std::size_t longest_line(const std::string& words) {
  std::size_t longest = 0;
  for (std::size_t begin = 0; begin <= words.size();) {
    const std::size_t end = std::min(words.find('\n', begin), words.size());
    longest = std::max(longest, end - begin);
    begin = end + 1;
  }
  return longest;
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
  std::ranges::replace(name, '_', ' ');
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
  const std::string& unit = report.recording.unit(Column::u);
  u.y_label = unit.empty() ? "u" : "u, " + unit;
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
  plot.height = 300;
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
  plot.staggered = std::ranges::any_of(plot.names, [](const std::string& name) {
    return longest_line(name) > kStepLetters;
  });
  plot.width = kStepWidth * std::max(5, static_cast<int>(plot.names.size()));
  std::string caption =
      "Error of the free simulation on the samples that had no part in the fit.";
  if (noise > 0) {
    caption += " The noise is what no model could explain, as far as this one tells.";
  }
  if (replaced) caption += " Effects that were replaced on the way are in the table.";
  return figure(plot, caption);
}

}  // namespace workbench
