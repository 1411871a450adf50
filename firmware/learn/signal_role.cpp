#include "firmware/learn/signal_role.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <string>

#include "wire/text.hpp"

namespace firmware {
namespace {

using Words = std::span<const std::string_view>;

constexpr std::array<std::string_view, 6> kOutputs{"OUTPUT", "VALVE", "OUT",
                                                   "OP",     "CO",    "MV"};
constexpr std::array<std::string_view, 6> kMeasured{"LEVEL", "PRESS", "FLOW",
                                                    "TEMP",  "PV",    "CV"};
constexpr std::array<std::string_view, 3> kSetpoints{"SETPOINT", "SETPT", "SP"};

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

std::string upper(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return out;
}

// A word of two letters has to stand alone.
bool named(std::string_view name, Words words) {
  const std::string text = upper(name);
  return std::ranges::any_of(words, [&](std::string_view word) {
    const std::size_t at = text.find(word);
    if (at == std::string::npos) return false;
    const std::size_t end = at + word.size();
    return word.size() > 2 || ((at == 0 || !is_letter(text[at - 1])) &&
                               (end == text.size() || !is_letter(text[end])));
  });
}

// Letters and digits without the words for parts, which end a run of letters.
std::string loop_of(std::string_view title) {
  std::string out;
  std::string run;
  const auto close = [&] {
    for (const Words words : {Words(kOutputs), Words(kMeasured), Words(kSetpoints)}) {
      const auto part =
          std::ranges::find_if(words, [&](auto word) { return run.ends_with(word); });
      if (part == words.end()) continue;
      run.resize(run.size() - part->size());
      break;
    }
    out += run;
    run.clear();
  };
  for (const char c : upper(title)) {
    if (is_letter(c)) {
      run += c;
      continue;
    }
    close();
    if (wire::is_digit(c)) out += c;
  }
  close();
  return out;
}

std::string digits_of(const std::string& text) {
  std::string out;
  std::copy_if(text.begin(), text.end(), std::back_inserter(out), wire::is_digit);
  return out;
}

}  // namespace

bool named_u(std::string_view name) {
  return named(name, kOutputs);
}
bool named_y(std::string_view name) {
  return named(name, kMeasured);
}
bool named_sp(std::string_view name) {
  return named(name, kSetpoints);
}

SameLoop same_loop(std::string_view one, std::string_view other) {
  const std::string first = loop_of(one);
  const std::string second = loop_of(other);
  const std::string number = digits_of(first);
  const std::string other_number = digits_of(second);
  if (!number.empty() && !other_number.empty()) {
    return number == other_number ? SameLoop::kYes : SameLoop::kNo;
  }
  return !first.empty() && first == second ? SameLoop::kYes : SameLoop::kUnknown;
}

}  // namespace firmware
