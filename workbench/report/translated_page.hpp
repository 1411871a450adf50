// A report page in another language.
#pragma once

#include <string>
#include <string_view>

#include "workbench/report/texts.hpp"

namespace workbench {

/// `page`, an HTML document of report_page() or model_page(), with its texts and the
/// attributes that are read translated, and `language` ("de") in place of "en". Code,
/// style and script stay as they are; without entries in `texts` the whole page does.
[[nodiscard]] std::string translated_page(std::string_view page, const Texts& texts,
                                          std::string_view language);

}  // namespace workbench
