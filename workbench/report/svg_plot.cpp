#include "workbench/report/svg_plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>

#include "wire/text.hpp"
#include "workbench/analysis/wording.hpp"
#include "workbench/recording/time_unit.hpp"

namespace workbench {
namespace {

constexpr double kLeft = 64;
constexpr double kRight = 14;
constexpr double kTop = 10;
constexpr double kBottom = 40;
constexpr double kLine = 14;   // of text
constexpr double kLower = 28;  // of every second name, where they are staggered

struct Range {
  double low = 0;
  double high = 1;

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

Range range_of(const Plot& plot, std::vector<double> PlotLine::*values) {
  Range range{HUGE_VAL, -HUGE_VAL};
  for (const PlotLine& line : plot.lines) {
    for (const double value : line.*values) range.include(value);
  }
  if (values == &PlotLine::x) {
    for (const PlotBar& bar : plot.bars) {
      range.include(bar.low);
      range.include(bar.high);
    }
  } else {
    for (const PlotBar& bar : plot.bars) {
      range.include(0);
      range.include(bar.value);
    }
    for (const PlotLevel& level : plot.levels) range.include(level.value);
  }
  if (!(range.low <= range.high)) return {};
  if (range.low == range.high) {
    const double margin = std::max(std::abs(range.low) * 0.01, 1e-9);
    range.low -= margin;
    range.high += margin;
  }
  return range;
}

// Maps data to pixels.
struct Axis {
  Range range;
  double first;  // pixel of range.low
  double last;   // pixel of range.high

  [[nodiscard]] double scale() const { return (last - first) / (range.high - range.low); }
  [[nodiscard]] double at(double value) const {
    return first + (value - range.low) * scale();
  }
};

std::string pixel(double value) {
  return fixed(value, 1);
}

std::string label(double value, double step) {
  const double size = std::max(std::abs(value), step);
  if (size >= 1e6 || size < 1e-4) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
  }
  int decimals = 0;
  for (double rest = step; decimals < 6 && std::abs(rest - std::round(rest)) > 1e-6;
       rest *= 10) {
    ++decimals;
  }
  return fixed(value, decimals);
}

std::string words_at(double px, double py, const char* anchor, const std::string& words) {
  return "<text x=\"" + pixel(px) + "\" y=\"" + pixel(py) + "\" text-anchor=\"" + anchor +
         "\">" + escaped(words) + "</text>";
}

// The names below the x axis, one below the other where they have several lines.
std::string names(const Plot& plot, const Axis& x, double top) {
  std::string out;
  for (std::size_t i = 0; i < plot.names.size(); ++i) {
    std::string_view rest = plot.names[i];
    const double first = top + 16 + (plot.staggered && i % 2 == 1 ? kLower : 0);
    for (int line = 0; !rest.empty(); ++line) {
      out += words_at(x.at(static_cast<double>(i)), first + kLine * line, "middle",
                      std::string(wire::take_until(rest, '\n')));
    }
  }
  return out;
}

// Room below the x axis.
double below(const Plot& plot) {
  std::ptrdiff_t breaks = 1;
  for (const std::string& name : plot.names) {
    breaks = std::max(breaks, std::ranges::count(name, '\n'));
  }
  return kBottom + (plot.staggered ? kLower : 0) +
         kLine * static_cast<double>(breaks - 1);
}

std::string bars(const Plot& plot, const Axis& x, const Axis& y) {
  std::string out;
  for (const PlotBar& bar : plot.bars) {
    const double left = x.at(bar.low) + 0.5;
    const double right = x.at(bar.high) - 0.5;
    const double top = std::min(y.at(0), y.at(bar.value));
    const double height = std::abs(y.at(0) - y.at(bar.value));
    out += std::string("<rect class=\"") + (bar.raised ? "raised" : "usual") + "\" x=\"" +
           pixel(left) + "\" y=\"" + pixel(top) + "\" width=\"" +
           pixel(std::max(right - left, 0.5)) + "\" height=\"" + pixel(height) + "\"/>";
  }
  return out;
}

std::string levels(const Plot& plot, const Axis& x, const Axis& y) {
  std::string out;
  for (const PlotLevel& level : plot.levels) {
    out += "<path class=\"level\" d=\"M" + pixel(x.first) + ' ' +
           pixel(y.at(level.value)) + 'H' + pixel(x.last) + "\"/>";
    if (level.label.empty()) continue;
    out += "<g class=\"ticks\">" +
           words_at(x.first + 6, y.at(level.value) - 6, "start", level.label) + "</g>";
  }
  return out;
}

// Above its point, or beside that where the line comes from above or goes there.
std::string note(const std::string& words, double x, double y, double y_before,
                 double y_after) {
  constexpr double kSteep = 30;
  const bool from_above = y_before < y - kSteep;
  const bool to_above = y_after < y - kSteep;
  if (from_above && to_above) return words_at(x, y + 20, "middle", words);
  if (from_above) return words_at(x + 8, y - 5, "start", words);
  if (to_above) return words_at(x - 8, y - 5, "end", words);
  return words_at(x, y - 11, "middle", words);
}

// The points of a line that has notes.
std::string marks(const PlotLine& line, const Axis& x, const Axis& y) {
  std::string dots;
  std::string words;
  for (std::size_t i = 0; i < line.notes.size(); ++i) {
    const double px = x.at(line.x[i]);
    const double py = y.at(line.y[i]);
    dots += std::string("<circle class=\"mark ") + css_class(line.ink) + "\" cx=\"" +
            pixel(px) + "\" cy=\"" + pixel(py) + "\" r=\"4.5\"/>";
    words += note(line.notes[i], px, py, i > 0 ? y.at(line.y[i - 1]) : py,
                  i + 1 < line.y.size() ? y.at(line.y[i + 1]) : py);
  }
  return words.empty() ? words : dots + "<g class=\"ticks notes\">" + words + "</g>";
}

std::string axes(const Plot& plot, const Axis& x, const Axis& y) {
  std::string out = "<g class=\"grid\">";
  std::string text;
  const auto draw = [&](const Axis& axis, bool horizontal, int count) {
    const std::vector<double> at = ticks(axis.range.low, axis.range.high, count);
    const double step = at.size() > 1 ? at[1] - at[0] : 1;
    for (const double value : at) {
      const std::string p = pixel(axis.at(value));
      if (horizontal) {
        out += "<path d=\"M" + p + ' ' + pixel(y.last) + 'V' + pixel(y.first) + "\"/>";
        text += "<text x=\"" + p + "\" y=\"" + pixel(y.first + 16) +
                "\" text-anchor=\"middle\">" + label(value, step) + "</text>";
      } else {
        out += "<path d=\"M" + pixel(x.first) + ' ' + p + 'H' + pixel(x.last) + "\"/>";
        text += "<text x=\"" + pixel(x.first - 6) + "\" y=\"" +
                pixel(axis.at(value) + 4) + "\" text-anchor=\"end\">" +
                label(value, step) + "</text>";
      }
    }
  };
  if (plot.names.empty()) {
    draw(x, true, plot.width / 110);
  } else {
    text += names(plot, x, y.first);
  }
  draw(y, false, std::max(4, plot.height / 40));
  const double middle = (y.first + y.last) / 2;
  text += "<text class=\"axis\" x=\"" + pixel((x.first + x.last) / 2) + "\" y=\"" +
          pixel(y.first + 34) + "\" text-anchor=\"middle\">" + escaped(plot.x_label) +
          "</text><text class=\"axis\" transform=\"translate(14 " + pixel(middle) +
          ") rotate(-90)\" text-anchor=\"middle\">" + escaped(plot.y_label) + "</text>";
  return out + "</g><g class=\"ticks\">" + text + "</g>";
}

std::string path(const PlotLine& line, const Axis& x, const Axis& y) {
  std::string d;
  std::string last;
  const auto add = [&](std::size_t i) {
    const std::string point = pixel(x.at(line.x[i])) + ' ' + pixel(y.at(line.y[i]));
    if (point == last) return;
    d += (d.empty() ? 'M' : 'L') + point;
    last = point;
  };
  if (line.is_signal) {
    for (const std::size_t i : visible_points(line.y, static_cast<int>(x.last - x.first)))
      add(i);
  } else {
    for (std::size_t i = 0; i < line.y.size(); ++i) add(i);
  }
  const char* stroke = line.stroke == Stroke::kDashed  ? " dashed"
                       : line.stroke == Stroke::kBroad ? " broad"
                       : line.stroke == Stroke::kFine  ? " fine"
                                                       : "";
  return std::string("<path class=\"line ") + css_class(line.ink) + stroke +
         "\" data-label=\"" + escaped(line.label) + "\" d=\"" + d + "\"/>";
}

std::string legend(const Plot& plot) {
  std::string out;
  std::vector<std::string> seen;
  for (const PlotLine& line : plot.lines) {
    if (line.y.empty() || line.label.empty() ||
        std::ranges::find(seen, line.label) != seen.end())
      continue;
    seen.push_back(line.label);
    out += std::string("<span><i class=\"") + css_class(line.ink) +
           (line.stroke == Stroke::kDashed ? " dashed" : "") + "\"></i>" +
           escaped(line.label) + "</span>";
  }
  return out.empty() ? out : "<div class=\"legend\">" + out + "</div>";
}

bool all_signals(const Plot& plot) {
  return std::ranges::all_of(plot.lines,
                             [](const PlotLine& line) { return line.is_signal; });
}

}  // namespace

const char* css_class(Ink ink) {
  constexpr std::array<const char*, 6> kNames = {"measured", "setpoint", "two-path",
                                                 "valve",    "linear",   "truth"};
  return kNames[static_cast<std::size_t>(ink)];
}

TimeUnit time_unit_for(double span_s) {
  if (span_s < 600) return {1, "time, s"};
  if (span_s < 6 * kHourS) return {60, "time, min"};
  if (span_s < 4 * kDayS) return {kHourS, "time, h"};
  return {kDayS, "time, days"};
}

std::vector<double> ticks(double low, double high, int count) {
  std::vector<double> out;
  const double width = high - low;
  constexpr double kFinest = 1e-12;  // of the values: what doubles can still divide
  const double finest = kFinest * std::max(std::abs(low), std::abs(high));
  if (!(width > finest) || !std::isfinite(width)) return {low};
  double step = std::pow(10, std::floor(std::log10(width / std::max(count, 1))));
  for (const double factor : {2.0, 2.5, 2.0}) {
    if (width / step <= std::max(count, 2)) break;
    step *= factor;
  }
  // Fewer than two labels: the next finer step of 1, 2, 5.
  const auto first = [&] { return std::ceil(low / step - 1e-9); };
  const auto last = [&] { return std::floor(high / step + 1e-9); };
  while (last() - first() < 1) step /= 2;
  for (double k = first(); k <= last(); ++k) out.push_back(k * step + 0.0);  // no −0
  return out;
}

std::vector<std::size_t> visible_points(const std::vector<double>& y, int pixels) {
  std::vector<std::size_t> out;
  const std::size_t buckets = static_cast<std::size_t>(std::max(pixels, 1));
  if (y.size() <= 4 * buckets) {
    for (std::size_t i = 0; i < y.size(); ++i) out.push_back(i);
    return out;
  }
  for (std::size_t b = 0; b < buckets; ++b) {
    const std::size_t begin = b * y.size() / buckets;
    const std::size_t end = (b + 1) * y.size() / buckets;
    const auto [low, high] =
        std::minmax_element(y.begin() + static_cast<std::ptrdiff_t>(begin),
                            y.begin() + static_cast<std::ptrdiff_t>(end));
    std::vector<std::size_t> chosen = {begin, static_cast<std::size_t>(low - y.begin()),
                                       static_cast<std::size_t>(high - y.begin()),
                                       end - 1};
    std::ranges::sort(chosen);
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    out.insert(out.end(), chosen.begin(), chosen.end());
  }
  return out;
}

std::string figure(const Plot& plot, const std::string& caption) {
  Axis x{range_of(plot, &PlotLine::x), kLeft, plot.width - kRight};
  Axis y{range_of(plot, &PlotLine::y), plot.height - below(plot), kTop};
  if (plot.include_zero) y.range.include(0);
  // Notes stand above their points.
  const bool noted = std::ranges::any_of(
      plot.lines, [](const PlotLine& line) { return !line.notes.empty(); });
  const double margin = (noted ? 0.14 : 0.04) * (y.range.high - y.range.low);
  if (!noted) y.range.low -= margin;
  y.range.high += margin;
  if (!plot.names.empty()) {
    x.range = {-0.5, static_cast<double>(plot.names.size()) - 0.5};
  } else if (!all_signals(plot)) {
    const double side = 0.02 * (x.range.high - x.range.low);
    x.range.low -= side;
    x.range.high += side;
  }
  char map[160];
  std::snprintf(map, sizeof map,
                "data-x0=\"%.9g\" data-kx=\"%.9g\" data-y0=\"%.9g\" data-ky=\"%.9g\"",
                x.range.low - x.first / x.scale(), 1 / x.scale(),
                y.range.low - y.first / y.scale(), 1 / y.scale());
  const std::string size = std::to_string(plot.width) + ' ' + std::to_string(plot.height);
  std::string out =
      "<figure>" + legend(plot) +
      "<div class=\"plot\"><svg style=\"min-width:" + std::to_string(plot.width * 5 / 8) +
      "px;max-width:" + std::to_string(plot.width * 5 / 4) + "px\" viewBox=\"0 0 " +
      size + "\" role=\"img\" aria-label=\"" + escaped(plot.title) + "\" " + map +
      (!plot.bars.empty() || !plot.names.empty() ? " data-still=\"1\""
       : all_signals(plot)                       ? " data-signals=\"1\" data-at=\"at\""
                                                 : "") +
      '>' + axes(plot, x, y) + bars(plot, x, y) + levels(plot, x, y);
  for (const PlotLine& line : plot.lines) {
    if (!line.y.empty()) out += path(line, x, y) + marks(line, x, y);
  }
  out += "</svg></div>";
  if (!caption.empty()) out += "<figcaption>" + escaped(caption) + "</figcaption>";
  return out + "</figure>\n";
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

}  // namespace workbench
