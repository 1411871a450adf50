// The page's own files, as embed.cmake writes them into a source file.
#pragma once

#include <span>

#include "workbench/serve/embedded.hpp"

namespace workbench {

/// page.css, page.html, page.js.
[[nodiscard]] std::span<const EmbeddedFile> screen_files();

}  // namespace workbench
