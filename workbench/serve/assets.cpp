#include "workbench/serve/assets.hpp"

#include <algorithm>
#include <string>

#include "workbench/report/page_style.hpp"
#include "workbench/serve/embedded.hpp"
#include "workbench/serve/languages.hpp"

namespace workbench {
namespace {

constexpr std::string_view kPage = "index.html";
constexpr std::string_view kAllTexts = "texts/all.js";

std::string_view type_of(std::string_view path) {
  if (path.ends_with(".html")) return "text/html; charset=utf-8";
  if (path.ends_with(".js")) return "text/javascript; charset=utf-8";
  if (path.ends_with(".css")) return "text/css; charset=utf-8";
  if (path.ends_with(".svg")) return "image/svg+xml";
  return "text/plain; charset=utf-8";
}

// All modules at once: else the browser hears of each only from the one that imports it.
std::string with_preloads(std::string_view page) {
  std::string links;
  const auto add = [&links](std::string_view name) {
    links.append("<link rel=\"modulepreload\" href=\"/").append(name).append("\">\n");
  };
  for (const EmbeddedFile& file : embedded_files()) {
    const bool classic = file.name.starts_with("uplot/");
    if (file.name.ends_with(".js") && !classic) add(file.name);
  }
  add(kAllTexts);
  std::string out(page);
  return out.insert(out.find("</head>"), links);
}

}  // namespace

std::optional<Asset> find_asset(std::string_view path) {
  if (!path.starts_with('/')) return std::nullopt;
  const std::string_view name = path == "/" ? kPage : path.substr(1);
  // One style sheet for the page and for the report.
  if (name == "report.css") return Asset{type_of(name), kPageStyle};
  if (name == kAllTexts) return Asset{type_of(name), all_texts_script()};
  const auto files = embedded_files();
  const auto found = std::ranges::find_if(
      files, [name](const EmbeddedFile& f) { return f.name == name; });
  if (found == files.end()) return std::nullopt;
  if (name != kPage) return Asset{type_of(name), found->content};
  static const std::string kWhole = with_preloads(found->content);
  return Asset{type_of(name), kWhole};
}

}  // namespace workbench
