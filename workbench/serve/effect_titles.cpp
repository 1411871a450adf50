#include "workbench/serve/effect_titles.hpp"

#include <cctype>

#include "workbench/effects/catalogue.hpp"
#include "workbench/report/html_texts.hpp"

namespace workbench {
namespace {

// What codes are made of.
bool is_of_code(char c) {
  return std::islower(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
}

std::string titled(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    if (!is_of_code(text[i])) {
      out += text[i++];
      continue;
    }
    std::size_t end = i;
    while (end < text.size() && is_of_code(text[end])) ++end;
    std::string_view word = text.substr(i, end - i);
    while (word.ends_with('.')) word.remove_suffix(1);
    // A measured load's code goes on with the name of its column.
    const bool goes_on = end < text.size() && text[end] == ':' && word.size() == end - i;
    const Effect* effect = word.find('.') != std::string_view::npos && !goes_on
                               ? standard_catalogue().find(word)
                               : nullptr;
    out +=
        effect != nullptr ? std::string(effect->description().title) : std::string(word);
    out += text.substr(i + word.size(), end - i - word.size());
    i = end;
  }
  return out;
}

}  // namespace

std::string with_effect_titles(std::string_view html) {
  return with_texts(html, titled);
}

}  // namespace workbench
