#include "workbench/report/html_texts.hpp"

#include <algorithm>
#include <array>

namespace workbench {
namespace {

constexpr std::array<std::string_view, 3> kSilent = {"<code", "<style", "<script"};

}  // namespace

std::string with_texts(std::string_view html, const HtmlChange& change,
                       const HtmlChange& change_tag) {
  std::string out;
  while (!html.empty()) {
    const std::size_t begin = std::min(html.find('<'), html.size());
    out += change(html.substr(0, begin));
    html.remove_prefix(begin);
    if (html.empty()) break;
    const std::size_t end = std::min(html.find('>'), html.size() - 1) + 1;
    const std::string_view tag = html.substr(0, end);
    out += change_tag ? change_tag(tag) : std::string(tag);
    html.remove_prefix(end);
    for (const std::string_view silent : kSilent) {
      if (!tag.starts_with(silent)) continue;
      const std::string close = "</" + std::string(silent.substr(1));
      const std::size_t inside = std::min(html.find(close), html.size());
      out += html.substr(0, inside);
      html.remove_prefix(inside);
    }
  }
  return out;
}

}  // namespace workbench
