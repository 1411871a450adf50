#include "workbench/recording/scope_export.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "wire/text.hpp"

namespace workbench {
namespace {

constexpr std::size_t kMostLines = 60;

std::string_view without_end(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

// key, value, key, value, …: all keys alike.
struct Attribute {
  std::string_view key;
  std::vector<std::string_view> values;
};

std::optional<Attribute> attribute_of(std::string_view line, char separator) {
  Attribute out;
  std::size_t cell = 0;
  for (std::size_t at = 0; at <= line.size(); ++cell) {
    const std::size_t end = std::min(line.find(separator, at), line.size());
    const std::string_view text = line.substr(at, end - at);
    if (cell == 0) out.key = text;
    if (cell % 2 == 1) out.values.push_back(text);
    if (cell % 2 == 0 && text != out.key) return std::nullopt;
    at = end + 1;
  }
  return cell % 2 == 0 && !out.key.empty() ? std::optional(out) : std::nullopt;
}

bool all_are(const Attribute& attribute, std::string_view wanted) {
  return std::all_of(attribute.values.begin(), attribute.values.end(),
                     [wanted](std::string_view value) { return value == wanted; });
}

std::string header_of(const std::vector<std::string_view>& names, char separator) {
  std::string out;
  for (const std::string_view name : names) {
    if (!out.empty()) out += separator;
    (out += "t [ms]") += separator;
    out += name;
  }
  return out;
}

std::optional<std::string> read_with(std::string_view text, char separator) {
  std::vector<std::string_view> names;
  bool is_scope = false;
  std::size_t lines = 0;
  std::size_t at = 0;
  while (at < text.size() && lines < kMostLines) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = without_end(text.substr(at, end - at));
    if (!names.empty() && !line.empty() && wire::is_digit(line[0])) break;
    const std::optional<Attribute> found = attribute_of(line, separator);
    if (found && found->key == "Name" && found->values.size() > 1) {
      names = found->values;
    } else if (found && !names.empty()) {
      if (found->values.size() != names.size()) return std::nullopt;
      const bool scales = found->key == "ScaleFactor" || found->key == "Unit ScaleFactor";
      const bool offset = found->key == "Offset" || found->key == "Unit Offset";
      if ((scales && !all_are(*found, "1")) || (offset && !all_are(*found, "0"))) {
        return std::nullopt;
      }
      is_scope = is_scope || found->key == "Unit ScaleFactor";
    } else if (!line.empty() && !names.empty()) {
      return std::nullopt;
    }
    at = end + 1;
    ++lines;
  }
  if (!is_scope || names.size() < 2 || at >= text.size() || lines == kMostLines) {
    return std::nullopt;
  }
  std::string out(lines - 1, '\n');
  ((out += header_of(names, separator)) += '\n') += text.substr(at);
  return out;
}

}  // namespace

std::optional<std::string> scope_text(std::string_view text) {
  if (!text.starts_with("Name")) return std::nullopt;
  for (const char separator : {';', '\t', ','}) {
    if (auto out = read_with(text, separator)) return out;
  }
  return std::nullopt;
}

}  // namespace workbench
