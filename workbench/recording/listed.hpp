// "a, b, c"; "a, b and 7 more".
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
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

/// Where a list is cut: behind so many things, or where it has more letters.
struct ListEnd {
  std::size_t things = std::numeric_limits<std::size_t>::max();
  std::size_t letters = std::numeric_limits<std::size_t>::max();
};

/// The same of the first of them, and how many more there are.
template <class Things, class WordsOf = std::identity>
[[nodiscard]] std::string first_listed(const Things& things, ListEnd end,
                                       std::string_view between = ", ",
                                       WordsOf words_of = {}) {
  std::string out;
  std::size_t shown = 0;
  for (const auto& thing : things) {
    if (shown == end.things || out.size() > end.letters) {
      return out + " and " + std::to_string(things.size() - shown) + " more";
    }
    if (shown++ > 0) out += between;
    out += std::invoke(words_of, thing);
  }
  return out;
}

}  // namespace workbench
