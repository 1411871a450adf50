#include "workbench/report/page_parts.hpp"

#include "workbench/analysis/wording.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/report/page_style.hpp"
#include "workbench/report/svg_plot.hpp"

namespace workbench {
namespace {

std::string text(std::string_view value) {
  return escaped(std::string(value));
}

const char* css_class(Mood mood) {
  return mood == Mood::kBad ? " bad" : mood == Mood::kGood ? " good" : "";
}

}  // namespace

std::string page_top(std::string_view kind, const Recording& recording,
                     std::string_view headline) {
  const double length = recording.period_s * static_cast<double>(recording.size());
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<title>" +
         escaped(recording.name) + ": " + text(headline) + "</title>\n<style>" +
         kPageStyle + "</style></head>\n<body><main>\n<header><p>" +
         escaped(filled("{0} · {1} · {2} samples, one every {3} s, {4}",
                        {std::string(kind),
                         recording.name +
                             (recording.tags.empty() ? "" : " (" + recording.tags + ')'),
                         std::to_string(recording.size()), number(recording.period_s),
                         duration(length)})) +
         "</p></header>\n";
}

std::string page_end(std::string_view footer) {
  return "<footer>" + text(footer) + "</footer>\n</main>\n<script>" +
         std::string(kPageScript) + "</script>\n</body></html>\n";
}

std::string section(std::string_view title, std::string_view introduction,
                    const std::string& content) {
  if (content.empty()) return {};
  const std::string opening =
      introduction.empty() ? "" : "<p>" + text(introduction) + "</p>\n";
  return "<section><h2>" + text(title) + "</h2>\n" + opening + content + "</section>\n";
}

std::string verdict_box(Mood mood, std::string_view headline,
                        const std::vector<Remark>& remarks) {
  std::string out = std::string("<div class=\"verdict") + css_class(mood) + "\"><h1>" +
                    text(headline) + "</h1>";
  for (const Remark& remark : remarks) {
    if (remark.content.empty()) continue;
    out += "<p>";
    if (!remark.title.empty()) out += "<strong>" + text(remark.title) + "</strong> ";
    out += escaped(remark.content) + "</p>";
  }
  return out + "</div>\n";
}

std::string tile(std::string_view label, std::string_view value,
                 std::string_view detail) {
  return "<div class=\"tile\"><span>" + text(label) + "</span><b>" + text(value) +
         "</b><span>" + text(detail) + "</span></div>";
}

std::string tile_row(const std::string& tiles) {
  return "<div class=\"tiles\">" + tiles + "</div>\n";
}

std::string bullet_list(const std::vector<std::string>& sentences) {
  std::string out;
  for (const std::string& sentence : sentences) {
    out += "<li>" + escaped(sentence) + "</li>";
  }
  return out.empty() ? out : "<ul>" + out + "</ul>\n";
}

std::string side_by_side(const std::string& left, const std::string& right) {
  if (left.empty() && right.empty()) return {};
  return "<div class=\"pair\">" + left + right + "</div>";
}

}  // namespace workbench
