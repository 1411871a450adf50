#include "workbench/serve/assets.hpp"

#include <algorithm>

#include "workbench/report/page_style.hpp"
#include "workbench/serve/embedded.hpp"
#include "workbench/serve/languages.hpp"

namespace workbench {
namespace {

std::string_view type_of(std::string_view path) {
  if (path.ends_with(".html")) return "text/html; charset=utf-8";
  if (path.ends_with(".js")) return "text/javascript; charset=utf-8";
  if (path.ends_with(".css")) return "text/css; charset=utf-8";
  if (path.ends_with(".svg")) return "image/svg+xml";
  return "text/plain; charset=utf-8";
}

}  // namespace

std::optional<Asset> find_asset(std::string_view path) {
  if (!path.starts_with('/')) return std::nullopt;
  const std::string_view name = path == "/" ? "index.html" : path.substr(1);
  // One style sheet for the page and for the report.
  if (name == "report.css") return Asset{type_of(name), kPageStyle};
  if (name == "texts/all.js") return Asset{type_of(name), all_texts_script()};
  const auto files = embedded_files();
  const auto found =
      std::find_if(files.begin(), files.end(),
                   [name](const EmbeddedFile& f) { return f.name == name; });
  if (found == files.end()) return std::nullopt;
  return Asset{type_of(name), found->content};
}

}  // namespace workbench
