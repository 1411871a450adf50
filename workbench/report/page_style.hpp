// Style sheet and script of the report page; no external resources.
#pragma once

#include <string>
#include <string_view>

namespace workbench {

/// The colours of every page, bright and dark: variables of :root.
extern const std::string_view kPalette;
/// The content of <style>, with the palette.
extern const std::string kPageStyle;
/// The content of <script>: values under the pointer. The page is complete without it.
extern const std::string_view kPageScript;

}  // namespace workbench
