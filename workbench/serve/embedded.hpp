// Files as embed.cmake writes them into a source file.
#pragma once

#include <span>
#include <string_view>

namespace workbench {

struct EmbeddedFile {
  std::string_view name;  ///< below its folder of assets, "uplot/uPlot.min.css"
  std::string_view content;
};

/// serve/assets.
[[nodiscard]] std::span<const EmbeddedFile> embedded_files();
/// screen/assets: page.css, page.html, page.js.
[[nodiscard]] std::span<const EmbeddedFile> screen_files();

}  // namespace workbench
