// Words of one column and how often each occurs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace workbench {

class WordCounts {
 public:
  void add(std::string_view word);
  [[nodiscard]] std::size_t total() const { return total_; }
  /// "'Stale' 12, 'Last Known' 1, others 3": at most kMostWords words, in the order in
  /// which they came, each cut as quoted() does.
  [[nodiscard]] std::string list() const;

  static constexpr std::size_t kMostWords = 8;

 private:
  std::vector<std::pair<std::string, std::size_t>> words_;
  std::size_t total_ = 0;
};

}  // namespace workbench
