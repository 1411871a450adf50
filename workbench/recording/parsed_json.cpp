#include "workbench/recording/parsed_json.hpp"

namespace workbench {

bool is_too_deep(std::string_view text) {
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    switch (text[i]) {
      case '"':
        quoted = !quoted;
        break;
      case '\\':
        i += quoted ? 1 : 0;
        break;
      case '[':
      case '{':
        if (!quoted && ++depth > kDeepestJson) return true;
        break;
      case ']':
      case '}':
        depth -= quoted ? 0 : 1;
        break;
      default:
        break;
    }
  }
  return false;
}

}  // namespace workbench
