// Effects by their titles where the page and its report speak of them.
#pragma once

#include <string>
#include <string_view>

namespace workbench {

/// HTML with the titles of effects in place of their codes, "dead time" for
/// process.dead_time; tags, code, style and script stay as they are.
[[nodiscard]] std::string with_effect_titles(std::string_view html);

}  // namespace workbench
