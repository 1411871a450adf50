// Sentences with gaps, so that they can be said in another language.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace workbench {

/// `sentence` with {0}, {1} … replaced by `values`, at most ten. As it stands in the
/// source the sentence is the key of the page's tables of languages
/// (serve/assets/texts): a whole one, whose gaps take numbers, names and sentences.
[[nodiscard]] std::string filled(std::string_view sentence,
                                 std::initializer_list<std::string> values);

}  // namespace workbench
