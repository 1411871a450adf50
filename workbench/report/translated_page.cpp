#include "workbench/report/translated_page.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "workbench/report/html_texts.hpp"
#include "workbench/report/svg_plot.hpp"

namespace workbench {
namespace {

constexpr std::array<std::string_view, 6> kRead = {
    "aria-label", "title", "placeholder", "data-label", "data-more", "data-at"};
constexpr std::string_view kEnglish = "<html lang=\"en\"";

// The opposite of escaped().
std::string plain(std::string_view html) {
  constexpr std::array<std::pair<std::string_view, char>, 5> kNames = {
      {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&#39;", '\''}}};
  std::string out;
  while (!html.empty()) {
    const auto* const name = std::ranges::find_if(
        kNames, [&](const auto& known) { return html.starts_with(known.first); });
    out += name == kNames.end() ? html.front() : name->second;
    html.remove_prefix(name == kNames.end() ? 1 : name->first.size());
  }
  return out;
}

std::string said(std::string_view html, const Texts& texts) {
  return escaped(texts.translated(plain(html)));
}

// A tag with the attributes that are read in the other language.
std::string tag_in(std::string_view tag, const Texts& texts) {
  std::string out;
  while (true) {
    const std::size_t equals = tag.find("=\"");
    if (equals == std::string_view::npos) break;
    const std::size_t begin = equals + 2;
    const std::size_t end = tag.find('"', begin);
    if (end == std::string_view::npos) break;
    const std::size_t blank = tag.rfind(' ', equals);
    const std::string_view name =
        blank == std::string_view::npos ? "" : tag.substr(blank + 1, equals - blank - 1);
    const bool read = std::ranges::find(kRead, name) != kRead.end();
    out += tag.substr(0, begin);
    out += read ? said(tag.substr(begin, end - begin), texts)
                : std::string(tag.substr(begin, end - begin));
    tag.remove_prefix(end);
  }
  return out + std::string(tag);
}

}  // namespace

std::string translated_page(std::string_view page, const Texts& texts,
                            std::string_view language) {
  if (texts.empty()) return std::string(page);
  bool in_title = false;
  const auto text = [&](std::string_view html) {
    // The title names the recording first.
    const std::size_t name = in_title ? html.find(": ") : std::string_view::npos;
    const std::size_t from = name == std::string_view::npos ? 0 : name + 2;
    return std::string(html.substr(0, from)) + said(html.substr(from), texts);
  };
  const auto tag = [&](std::string_view html) {
    in_title = html == "<title>";
    if (!html.starts_with(kEnglish)) return tag_in(html, texts);
    return "<html lang=\"" + std::string(language) + '"' +
           std::string(html.substr(kEnglish.size()));
  };
  return with_texts(page, text, tag);
}

}  // namespace workbench
