#include "workbench/report/figures.hpp"

#include <algorithm>
#include <cstddef>

#include "workbench/recording/statistics.hpp"
#include "workbench/report/step_response.hpp"
#include "workbench/report/svg_plot.hpp"

namespace workbench {
namespace {

using Values = std::vector<double>;

constexpr const char* kTwoPathLabel = "two-path model";
constexpr const char* kValveLabel = "physical valve";

// A part of the analysed window, in one unit of time.
class Excerpt {
 public:
  Excerpt(const Simulation& simulation, std::size_t first, std::size_t count)
      : first_(static_cast<std::ptrdiff_t>(first)),
        count_(static_cast<std::ptrdiff_t>(count)),
        unit_(time_unit_for(static_cast<double>(count) * simulation.period_s)),
        t_(part(simulation.t)) {
    for (double& t : t_) t /= unit_.seconds;
  }

  void add(Plot& plot, const char* label, Ink ink, const Values& values,
           Stroke stroke = Stroke::kSolid) const {
    if (!values.empty()) plot.lines.push_back({label, ink, t_, part(values), stroke});
  }
  [[nodiscard]] Plot plot(const char* title, const char* y_label, int height) const {
    Plot out;
    out.title = title;
    out.x_label = unit_.label;
    out.y_label = y_label;
    out.height = height;
    return out;
  }

 private:
  [[nodiscard]] Values part(const Values& values) const {
    return {values.begin() + first_, values.begin() + first_ + count_};
  }

  std::ptrdiff_t first_;
  std::ptrdiff_t count_;
  TimeUnit unit_;
  Values t_;
};

Values difference(const Values& a, const Values& b) {
  Values out;
  for (std::size_t i = 0; i < a.size(); ++i) out.push_back(a[i] - b[i]);
  return out;
}

// The recorded stem, shifted to where the identified one lies: u and y do not tell a
// constant shift of x.
Values aligned_stem(const Simulation& s) {
  if (s.x.empty() || s.stem.empty()) return s.x;
  const double shift = mean_of(s.stem) - mean_of(s.x);
  Values out = s.x;
  for (double& value : out) value += shift;
  return out;
}

const char* recorded_stem_label(const ReportData& data) {
  return data.truth ? "true valve position" : "recorded valve position";
}

void add_outputs(const Excerpt& part, Plot& plot, const Simulation& s) {
  part.add(plot, "setpoint", Ink::kSetpoint, s.sp, Stroke::kDashed);
  part.add(plot, "measured y", Ink::kMeasured, s.y, Stroke::kBroad);
  part.add(plot, kTwoPathLabel, Ink::kTwoPath, s.y_two_path);
  part.add(plot, kValveLabel, Ink::kValve, s.y_valve);
}

Plot almost_square(const char* title, const char* x_label, const char* y_label) {
  Plot plot;
  plot.title = title;
  plot.x_label = x_label;
  plot.y_label = y_label;
  plot.width = 520;
  plot.height = 420;
  return plot;
}

}  // namespace

std::string signal_figures(const ReportData& data) {
  const Simulation& s = data.simulation;
  const Excerpt all(s, 0, s.t.size());
  Plot u = all.plot("controller output over time", "u", 190);
  all.add(u, "controller output u", Ink::kMeasured, s.u);
  Plot y = all.plot("process output over time", "y", 260);
  add_outputs(all, y, s);
  std::string out = figure(u, "") + figure(y, "");
  if (s.y_two_path.empty()) return out;
  Plot residual = all.plot("residual over time", "residual", 180);
  all.add(residual, kTwoPathLabel, Ink::kTwoPath, difference(s.y, s.y_two_path),
          Stroke::kFine);
  if (!s.y_valve.empty()) {
    all.add(residual, kValveLabel, Ink::kValve, difference(s.y, s.y_valve),
            Stroke::kFine);
  }
  return out +
         figure(residual,
                "Measured minus simulated: what the models leave unexplained. Where "
                "they are right only noise is left.");
}

std::string closer_figures(const ReportData& data) {
  const Simulation& s = data.simulation;
  const auto& oscillation = data.analysis.result().oscillation;
  const auto shown = static_cast<std::size_t>(3 * oscillation.period_samples);
  if (!oscillation.detected || shown < 12 || 2 * shown > s.t.size()) return {};
  const Excerpt part(s, (s.t.size() - shown) / 2, shown);
  Plot valve = part.plot("three cycles of the valve", "u and x", 240);
  part.add(valve, "controller output u", Ink::kMeasured, s.u);
  part.add(valve, recorded_stem_label(data), Ink::kTruth, aligned_stem(s),
           Stroke::kBroad);
  part.add(valve, "identified stem x", Ink::kValve, s.stem);
  Plot y = part.plot("three cycles of the process output", "y", 240);
  add_outputs(part, y, s);
  return figure(valve,
                "Flat stretches of the stem while u moves on are the stick band; the "
                "step that ends them is the slip jump.") +
         figure(y, "");
}

std::string loop_figure(const ReportData& data) {
  const Simulation& s = data.simulation;
  Plot plot = almost_square("process output over controller output",
                            "controller output u", "process output y");
  plot.lines.push_back({"measured y", Ink::kMeasured, s.u, s.y, Stroke::kFine, false});
  return figure(
      plot,
      "A valve that sticks draws a parallelogram: u runs on while y waits, then "
      "y moves while u hardly does.");
}

std::string path_figure(const ReportData& data) {
  const Simulation& s = data.simulation;
  const Identification& r = data.analysis.result();
  if (s.y_two_path.empty() && s.stem.empty() && s.x.empty()) return {};
  Plot plot = almost_square("valve position over controller output",
                            "controller output u", "valve position x, units of u");
  const auto trace = [&](const char* label, Ink ink, const Values& x, Stroke stroke) {
    if (!x.empty()) plot.lines.push_back({label, ink, s.u, x, stroke, false});
  };
  trace(recorded_stem_label(data), Ink::kTruth, aligned_stem(s), Stroke::kBroad);
  trace("physical valve, its stem", Ink::kValve, s.stem, Stroke::kFine);
  if (!s.y_two_path.empty()) {
    const StemScale scale = stem_scale(r.model, s);
    const auto [low, high] = std::ranges::minmax(s.u);
    const auto path = [&](const char* label, const ident::Path<double>& p,
                          Stroke stroke) {
      PlotLine line{label, Ink::kTwoPath, {}, {}, stroke, false};
      constexpr int kPoints = 240;
      for (int i = 0; i <= kPoints; ++i) {
        const double u = low + (high - low) * i / kPoints;
        line.x.push_back(u);
        line.y.push_back(scale.scale * p.at(u) + scale.shift);
      }
      plot.lines.push_back(std::move(line));
    };
    if (scale.scale > 0) {
      path("two-path model, ascending", r.model.ascending, Stroke::kSolid);
      path("two-path model, descending", r.model.descending, Stroke::kDashed);
    }
  }
  return figure(plot,
                "A valve that follows its signal draws one diagonal. The distance "
                "between the strokes is what it loses at a reversal. A constant shift of "
                "x cannot be seen from u and y; the curves are laid upon each other.");
}

std::string step_figure(const ReportData& data) {
  const Simulation& s = data.simulation;
  const Identification& r = data.analysis.result();
  if (s.y_two_path.empty()) return {};
  const StemScale scale = stem_scale(r.model, s);
  const StepResponse two_path = two_path_step(r, scale, s);
  if (two_path.t.size() < 2) return {};
  const double length = two_path.t.back();
  const TimeUnit unit = time_unit_for(length);
  Plot plot =
      almost_square("step response of the process", unit.label, "y for a stem step of 1");
  plot.include_zero = true;
  const auto add = [&](const char* label, Ink ink, const StepResponse& step,
                       Stroke stroke) {
    PlotLine line{label, ink, step.t, step.y, stroke, true};
    for (double& t : line.x) t /= unit.seconds;
    plot.lines.push_back(std::move(line));
  };
  if (data.truth && data.truth->process) {
    add("true process", Ink::kTruth, true_step(*data.truth->process, s.period_s, length),
        Stroke::kBroad);
  }
  const StepResponse of_valve = valve_step(r, s, length);
  add("behind the physical valve", Ink::kValve, of_valve, Stroke::kSolid);
  if (scale.is_told() || of_valve.t.empty()) {
    add("behind the two-path model", Ink::kTwoPath, two_path, Stroke::kSolid);
  }
  return figure(plot,
                "The process alone, without valve and controller: y after the stem moves "
                "by one unit of u.");
}

}  // namespace workbench
