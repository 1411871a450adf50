// "a, b, c".
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace workbench {

/// What `words_of` says of each of `things`, with `between` between them.
template <class Things, class WordsOf = std::identity>
[[nodiscard]] std::string listed(const Things& things, std::string_view between = ", ",
                                 WordsOf words_of = {}) {
  std::string out;
  for (const auto& thing : things) {
    if (!out.empty()) out += between;
    out += std::invoke(words_of, thing);
  }
  return out;
}

}  // namespace workbench
