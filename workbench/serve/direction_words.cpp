#include "workbench/serve/direction_words.hpp"

#include "workbench/report/texts.hpp"
#include "workbench/report/translated_page.hpp"

namespace workbench {
namespace {

// With rising output the valve makes the stroke `ascending`, "opening".
Texts words_of(const std::string& ascending, const std::string& descending) {
  Texts texts;
  for (const std::string what : {"Stick band, ", "stick band ", "slip jump "}) {
    texts.take("  '" + what + "ascending': '" + what + ascending + "',\n  '" + what +
               "descending': '" + what + descending + "',\n");
  }
  const bool opens = ascending == "opening";
  const std::string when_opening = "The valve sticks when it opens, not when it closes.";
  const std::string when_closing = "The valve sticks when it closes, not when it opens.";
  texts.take(
      "  'The valve sticks when the controller output rises, not when it falls.': '" +
      (opens ? when_opening : when_closing) +
      "',\n  'The valve sticks when the controller output falls, not when it rises.': '" +
      (opens ? when_closing : when_opening) + "',\n");
  return texts;
}

}  // namespace

std::string in_direction_words(std::string_view html, Opens opens) {
  static const Texts kOpening = words_of("opening", "closing");
  static const Texts kClosing = words_of("closing", "opening");
  if (opens == Opens::unknown) return std::string(html);
  return translated_page(html, opens == Opens::yes ? kOpening : kClosing, "en");
}

}  // namespace workbench
