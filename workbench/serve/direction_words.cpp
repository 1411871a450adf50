#include "workbench/serve/direction_words.hpp"

#include "workbench/report/texts.hpp"
#include "workbench/report/translated_page.hpp"

namespace workbench {
namespace {

void take_bands(Texts& texts, const char* ascending, const char* descending) {
  texts.take(std::string("  'Stick band, ascending': 'Stick band, ") + ascending +
             "',\n  'Stick band, descending': 'Stick band, " + descending + "',\n");
}

// With rising output the valve makes the stroke `ascending`, "opening".
Texts words_of(const std::string& ascending, const std::string& descending) {
  Texts texts;
  take_bands(texts, ascending.c_str(), descending.c_str());
  for (const std::string what : {"stick band ", "slip jump "}) {
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

Texts words_of_output() {
  Texts texts;
  take_bands(texts, "rising", "falling");
  return texts;
}

}  // namespace

std::string in_direction_words(std::string_view html, Opens opens) {
  static const Texts kOutput = words_of_output();
  static const Texts kOpening = words_of("opening", "closing");
  static const Texts kClosing = words_of("closing", "opening");
  return translated_page(html,
                         opens == Opens::unknown ? kOutput
                         : opens == Opens::yes   ? kOpening
                                                 : kClosing,
                         "en");
}

}  // namespace workbench
