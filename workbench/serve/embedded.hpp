// Files as embed.cmake writes them into a source file.
#pragma once

#include <span>
#include <string_view>

namespace workbench {

struct EmbeddedFile {
  std::string_view name;  ///< below serve/assets, "uplot/uPlot.min.css"
  std::string_view content;
};

[[nodiscard]] std::span<const EmbeddedFile> embedded_files();

}  // namespace workbench
