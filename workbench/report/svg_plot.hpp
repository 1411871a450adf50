// Line plots as inline SVG, coloured by the page's style sheet.
#pragma once

#include <string>
#include <vector>

namespace workbench {

/// What a line stands for; the style sheet has one colour for each.
enum class Ink { kMeasured, kSetpoint, kTwoPath, kValve, kLinear, kTruth };
[[nodiscard]] const char* css_class(Ink ink);

enum class Stroke { kSolid, kDashed, kBroad, kFine };

struct PlotLine {
  std::string label;  ///< in the legend; lines with the same label share one entry
  Ink ink = Ink::kMeasured;
  std::vector<double> x;
  std::vector<double> y;  ///< as long as x; finite
  Stroke stroke = Stroke::kSolid;
  /// x rises evenly: long lines are drawn as the smallest and largest value of each
  /// pixel. Otherwise every point is drawn.
  bool is_signal = true;
  /// Written above the points, which are then marked; empty, or as long as x.
  std::vector<std::string> notes = {};
};

/// A bar from 0 to `value` over `low` … `high` of the x axis.
struct PlotBar {
  double low = 0;
  double high = 0;
  double value = 0;
  bool raised = false;  ///< in the colour of what deserves a look
};

/// A dashed line across the whole plot.
struct PlotLevel {
  std::string label;  ///< written above its left end; may be empty
  double value = 0;
};

struct Plot {
  std::string title;    ///< read out by screen readers
  std::string x_label;  ///< with unit
  std::string y_label;
  int width = 1040;  ///< pixels
  int height = 220;
  std::vector<PlotLine> lines;
  bool include_zero = false;  ///< the y axis shows 0
  std::vector<PlotBar> bars = {};
  std::vector<PlotLevel> levels = {};
  /// Written at 0, 1, 2, … below the x axis instead of numbers; a line feed breaks them.
  std::vector<std::string> names = {};
  bool staggered = false;  ///< every second name stands lower, so that it has more room
};

/// The unit of time that gives short numbers over `span_s`.
struct TimeUnit {
  double seconds;
  const char* label;  ///< of an axis
};
[[nodiscard]] TimeUnit time_unit_for(double span_s);

/// Positions of axis labels: multiples of 1, 2 or 5 times a power of ten that lie within
/// low … high, about `count` of them, at least two where low < high.
[[nodiscard]] std::vector<double> ticks(double low, double high, int count);

/// Indices of the points that show a long line at `pixels` pixels: of each bucket the
/// first, smallest, largest and last, in their order. All where there are few.
[[nodiscard]] std::vector<std::size_t> visible_points(const std::vector<double>& y,
                                                      int pixels);

/// A figure: legend, <svg>. Lines without points are left out.
[[nodiscard]] std::string figure(const Plot& plot, const std::string& caption);

/// Text with the characters that mean something to HTML replaced.
[[nodiscard]] std::string escaped(const std::string& text);

}  // namespace workbench
