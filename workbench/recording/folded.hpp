// Letters without case and marks, to compare words of any language.
#pragma once

#include <string>
#include <string_view>

namespace workbench {

/// The letters of UTF-8 text small, Latin ones without their marks (Á and ă are a, Ł is
/// l, Æ is ae, ß is ss), ё as е, full-width ones as ASCII; other bytes as they are.
[[nodiscard]] std::string folded(std::string_view text);

}  // namespace workbench
