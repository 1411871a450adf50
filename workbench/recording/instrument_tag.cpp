#include "workbench/recording/instrument_tag.hpp"

#include <algorithm>
#include <string_view>

#include "workbench/recording/letters.hpp"

namespace workbench {
namespace {

// 211, 211a: of a loop, and perhaps one of several alike.
bool is_number(std::string_view text) {
  const auto digits = static_cast<std::size_t>(
      std::find_if_not(text.begin(), text.end(), is_digit) - text.begin());
  return digits >= 2 && text.size() <= digits + 1;
}

Part part_of_letters(std::string_view letters) {
  constexpr std::string_view kMeasured = "fltpad";
  if (letters.size() < 2 || kMeasured.find(letters[0]) == std::string_view::npos ||
      part_named(letters) != Part::kNone) {
    return Part::kNone;
  }
  const std::string_view does = letters.substr(1);
  if (does == "t" || does == "it" || does == "i") return Part::kY;
  return does == "v" || does == "cv" ? Part::kU : Part::kNone;
}

}  // namespace

std::optional<InstrumentTag> instrument_tag(const std::vector<std::string>& pieces) {
  if (pieces.empty()) return std::nullopt;
  std::size_t piece = pieces.size() - 1;
  std::string letters = pieces[piece];
  std::string number;
  if (is_number(letters) && piece > 0) {
    number = letters;
    letters = pieces[--piece];
  } else {
    const auto end = std::find_if(letters.begin(), letters.end(), is_digit);
    number.assign(end, letters.end());
    letters.erase(end, letters.end());
  }
  const Part part = part_of_letters(letters);
  if (part == Part::kNone || !is_number(number)) return std::nullopt;
  InstrumentTag out{part, {}, piece};
  for (std::size_t i = 0; i < piece; ++i) out.tag += pieces[i];
  out.tag += letters.front() + number;
  return out;
}

}  // namespace workbench
