// The page's files, built into the program (serve/assets, embed.cmake).
#pragma once

#include <optional>
#include <string_view>

namespace workbench {

struct Asset {
  std::string_view type;  ///< media type
  std::string_view content;
};

/// What is served at `path`: "/" and "/app.js", say. Nothing where there is no such file.
[[nodiscard]] std::optional<Asset> find_asset(std::string_view path);

}  // namespace workbench
