#include "workbench/serve/html_texts.hpp"

#include <algorithm>
#include <array>

namespace workbench {
namespace {

constexpr std::array<std::string_view, 3> kSilent = {"<code", "<style", "<script"};

}  // namespace

std::string with_texts(std::string_view html,
                       const std::function<std::string(std::string_view)>& change) {
  std::string out;
  while (!html.empty()) {
    const std::size_t begin = std::min(html.find('<'), html.size());
    out += change(html.substr(0, begin));
    html.remove_prefix(begin);
    if (html.empty()) break;
    std::size_t end = std::min(html.find('>'), html.size() - 1) + 1;
    for (const std::string_view tag : kSilent) {
      if (!html.starts_with(tag)) continue;
      const std::string close = "</" + std::string(tag.substr(1));
      end = std::min(html.find(close, end), html.size());
    }
    out += html.substr(0, end);
    html.remove_prefix(end);
  }
  return out;
}

}  // namespace workbench
