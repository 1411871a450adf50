#include "workbench/recording/word_counts.hpp"

#include <algorithm>

#include "workbench/recording/input_error.hpp"
#include "workbench/recording/text_encoding.hpp"

namespace workbench {

void WordCounts::add(std::string_view word) {
  ++total_;
  const auto known =
      std::ranges::find_if(words_, [word](const auto& w) { return w.first == word; });
  if (known != words_.end()) {
    ++known->second;
  } else if (words_.size() < kMostWords) {
    words_.emplace_back(word, 1);
  }
}

std::string WordCounts::list() const {
  std::string text;
  std::size_t listed = 0;
  for (const auto& [word, count] : words_) {
    text +=
        (text.empty() ? "" : ", ") + quoted(utf8_of(word)) + ' ' + std::to_string(count);
    listed += count;
  }
  if (listed < total_) text += ", others " + std::to_string(total_ - listed);
  return text;
}

}  // namespace workbench
