// The languages that serve/assets/texts has, English besides.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "workbench/report/texts.hpp"

namespace workbench {

/// "en", then the others by their code. One for each file texts/CODE.js.
[[nodiscard]] const std::vector<std::string>& languages();

/// The table of a language, of texts/CODE.js and the files texts/CODE-*.js beside it;
/// empty for English and for codes that languages() lacks. Read once.
[[nodiscard]] const Texts& texts_of(std::string_view language);

/// A script that imports every table and exports them by their code: texts/all.js.
[[nodiscard]] std::string_view all_texts_script();

}  // namespace workbench
