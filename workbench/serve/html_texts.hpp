// The texts of an HTML document or of a part of one.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace workbench {

/// `html` with each of its texts as `change` makes it; tags, code, style and script stay
/// as they are. What is not closed is taken for a tag to the end.
[[nodiscard]] std::string with_texts(
    std::string_view html, const std::function<std::string(std::string_view)>& change);

}  // namespace workbench
