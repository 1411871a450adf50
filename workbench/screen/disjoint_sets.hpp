// Which of n things belong together, as pairs of them become known.
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace workbench {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  /// The one that stands for the set of `i`.
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// The root of the set of `i` stands for that of `j`, too.
  void join(std::size_t i, std::size_t j) { parent_[root(j)] = root(i); }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace workbench
