// Which samples are fitted and which only judge: blocks interleaved over the recording.
#pragma once

#include <cstddef>
#include <vector>

namespace workbench {

/// A stretch of samples, [first, last).
struct Block {
  std::size_t first = 0;
  std::size_t last = 0;
  bool estimation = true;  ///< false: validation
};

/// Estimation and validation blocks in turns, three to two, so that whatever sets in
/// halfway is seen on both sides. A pair of blocks spans several times `memory_samples`
/// as far as six pairs remain; its length varies by a fifth around the mean, so that no
/// period of the recording always falls on the same side.
class Blocks {
 public:
  /// Fewest samples that can be split.
  static constexpr std::size_t kFewestSamples = 60;

  Blocks() = default;
  Blocks(std::size_t samples, double memory_samples);

  [[nodiscard]] const std::vector<Block>& blocks() const { return blocks_; }
  /// 1 where a sample may be fitted; as long as the recording.
  [[nodiscard]] const std::vector<unsigned char>& estimation() const { return mask_; }
  [[nodiscard]] std::size_t estimation_samples() const { return estimation_samples_; }

 private:
  std::vector<Block> blocks_;
  std::vector<unsigned char> mask_;
  std::size_t estimation_samples_ = 0;
};

}  // namespace workbench
