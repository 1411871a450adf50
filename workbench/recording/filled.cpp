#include "workbench/recording/filled.hpp"

namespace workbench {

std::string filled(std::string_view sentence, std::initializer_list<std::string> values) {
  std::string out;
  for (std::size_t i = 0; i < sentence.size(); ++i) {
    const bool gap = i + 2 < sentence.size() && sentence[i] == '{' &&
                     sentence[i + 1] >= '0' && sentence[i + 1] <= '9' &&
                     sentence[i + 2] == '}';
    const auto which = gap ? static_cast<std::size_t>(sentence[i + 1] - '0') : 0;
    if (!gap || which >= values.size()) {
      out += sentence[i];
      continue;
    }
    out += values.begin()[which];
    i += 2;
  }
  return out;
}

}  // namespace workbench
