#include "workbench/recording/written_zone.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "workbench/recording/letters.hpp"

namespace workbench {
namespace {

constexpr std::array<std::pair<std::string_view, int>, 36> kZones = {{
    {"z", 0},      {"utc", 0},    {"gmt", 0},    {"cet", 60},   {"mez", 60},
    {"cest", 120}, {"mesz", 120}, {"est", -300}, {"edt", -240}, {"cst", -360},
    {"cdt", -300}, {"mst", -420}, {"mdt", -360}, {"pst", -480}, {"pdt", -420},
    {"wet", 0},    {"bst", 60},   {"ut", 0},     {"west", 60},  {"eet", 120},
    {"oez", 120},  {"eest", 180}, {"oesz", 180}, {"msk", 180},  {"sast", 120},
    {"sgt", 480},  {"hkt", 480},  {"awst", 480}, {"jst", 540},  {"kst", 540},
    {"aest", 600}, {"aedt", 660}, {"nzst", 720}, {"nzdt", 780}, {"brt", -180},
    {"hst", -600},
}};

constexpr std::array kOpenZones = std::to_array<OpenZone>({
    {"CST", "-06:00 or +08:00"},
    {"CDT", "-05:00 or -04:00"},
    {"EST", "-05:00 or +10:00"},
    {"EDT", "-04:00 or +11:00"},
    {"MST", "-07:00 or +08:00"},
    {"PST", "-08:00 or +08:00"},
    {"BST", "+01:00 or +06:00"},
});

constexpr int kHourMin = 60;

// Where summer time follows the standard time of an open zone, or the other way round.
bool is_other_time_of(const KnownZone& open, int minutes) {
  if (open.open->name == "BST") return minutes == 0;
  const bool standard = open.open->name[1] == 'S';
  return minutes == open.minutes + (standard ? kHourMin : -kHourMin);
}

constexpr bool is_letter(char c) {
  return is_capital(c) || is_small(c);
}

class ZoneText {
 public:
  explicit ZoneText(std::string_view text) : text_(text) {}

  std::optional<WrittenZone> read() {
    const std::string_view word = take_word();
    if (!word.empty() && !know(word)) return std::nullopt;
    if (!read_offset()) return std::nullopt;
    if (out_.minutes) skip_remark();
    out_.length = at_;
    return out_;
  }

 private:
  [[nodiscard]] char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  std::string_view take_word() {
    const std::size_t start = at_;
    while (is_letter(peek()) || (at_ > start && (peek() == '/' || peek() == '_'))) ++at_;
    return text_.substr(start, at_ - start);
  }

  bool know(std::string_view word) {
    out_.minutes = zone_named(lower_case(word));
    if (out_.minutes) {
      out_.open = open_zone(lower_case(word));
      return true;
    }
    const bool capitals = std::ranges::all_of(word, is_capital);
    const bool is_short = word.size() >= 3 && word.size() <= 5 && capitals;
    const std::size_t slash = word.find('/');
    const bool region =
        slash != std::string_view::npos && slash > 2 && slash + 3 < word.size();
    out_.unknown = word;
    return is_short || (region && is_capital(word[0]));
  }

  struct Number {
    int value = 0;
    std::size_t digits = 0;
  };

  Number take_number() {
    Number number;
    while (number.digits < 2 && is_digit(peek())) {
      number.value = 10 * number.value + (peek() - '0');
      ++number.digits;
      ++at_;
    }
    return number;
  }

  bool read_offset() {
    if (peek() != '+' && peek() != '-') return true;
    const int sign = peek() == '-' ? -1 : 1;
    ++at_;
    const Number hours = take_number();
    if (hours.digits == 0) return false;
    if (peek() == ':') ++at_;
    const Number minutes = take_number();
    if (hours.value > 14 || minutes.value > 59) return false;
    // CST+08:00 says which; GMT+2 is two hours off.
    if (out_.open != nullptr) out_.minutes = 0;
    out_.open = nullptr;
    out_.minutes = out_.minutes.value_or(0) + sign * (60 * hours.value + minutes.value);
    out_.unknown = {};
    return true;
  }

  void skip_remark() {
    const std::size_t open = text_.find_first_not_of(' ', at_);
    if (open == std::string_view::npos) return;
    const char close = text_[open] == '[' ? ']' : text_[open] == '(' ? ')' : '\0';
    if (close == '\0') return;
    const std::size_t end = text_.find(close, open);
    if (end != std::string_view::npos) at_ = end + 1;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  WrittenZone out_;
};

std::optional<KnownZone> known(std::string_view written) {
  const std::optional<WrittenZone> zone = written_zone(written);
  if (!zone || !zone->minutes) return std::nullopt;
  return KnownZone{*zone->minutes, zone->open};
}

}  // namespace

const OpenZone* open_zone(std::string_view lower) {
  for (const OpenZone& zone : kOpenZones) {
    if (lower_case(zone.name) == lower) return &zone;
  }
  return nullptr;
}

bool go_together(const KnownZone& a, const KnownZone& b) {
  if (a.minutes == b.minutes && a.open == b.open) return true;
  if (a.open == nullptr && b.open == nullptr) return true;
  if (a.open != nullptr && b.open != nullptr) {
    return a.open->name[0] == b.open->name[0];
  }
  const KnownZone& open = a.open != nullptr ? a : b;
  const int other = a.open != nullptr ? b.minutes : a.minutes;
  return other == open.minutes || is_other_time_of(open, other);
}

std::string zone_text(const KnownZone& zone) {
  if (zone.open != nullptr) {
    return std::string(zone.open->name) + " (" + std::string(zone.open->means) + ")";
  }
  const int minutes = std::abs(zone.minutes);
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%c%02d:%02d", zone.minutes < 0 ? '-' : '+',
                minutes / kHourMin, minutes % kHourMin);
  return text.data();
}

std::optional<int> zone_named(std::string_view lower) {
  for (const auto& [name, minutes] : kZones) {
    if (lower == name) return minutes;
  }
  return std::nullopt;
}

std::optional<WrittenZone> written_zone(std::string_view text) {
  return ZoneText(text).read();
}

bool one_clock(std::string_view a, std::string_view b) {
  if (a == b) return true;
  const std::optional<KnownZone> one = known(a);
  const std::optional<KnownZone> other = known(b);
  return one && other && go_together(*one, *other);
}

std::string zone_words(std::string_view written) {
  if (written.empty()) return "no zone";
  const std::optional<KnownZone> zone = known(written);
  return zone ? zone_text(*zone) : std::string(written) + " (not known)";
}

}  // namespace workbench
