// The texts of an HTML document or of a part of one.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace workbench {

using HtmlChange = std::function<std::string(std::string_view)>;

/// `html` with each of its texts as `change` makes it and, where that is given, each tag,
/// its brackets included, as `change_tag` does; what stands in code, style and script
/// stays as it is. What is not closed is taken for a tag to the end.
[[nodiscard]] std::string with_texts(std::string_view html, const HtmlChange& change,
                                     const HtmlChange& change_tag = {});

}  // namespace workbench
