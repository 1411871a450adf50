// Style sheet and script of the report page; no external resources.
#pragma once

#include <string_view>

namespace workbench {

/// The content of <style>.
extern const std::string_view kPageStyle;
/// The content of <script>: values under the pointer. The page is complete without it.
extern const std::string_view kPageScript;

}  // namespace workbench
