// Which samples are fitted and which only judge: blocks interleaved over the recording.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "workbench/recording/recording.hpp"

namespace workbench {

/// A stretch of samples, [first, last).
struct Block {
  std::size_t first = 0;
  std::size_t last = 0;
  bool estimation = true;  ///< false: validation
  std::size_t piece = 0;   ///< first sample of the piece of the recording that it lies in
};

/// Estimation and validation blocks in turns, three to two unless `split` wants another
/// share, so that whatever sets in halfway is seen on both sides. A pair of blocks spans
/// several times `memory_samples` as far as six pairs of each recording remain, or what
/// `split` wants as far as two do; their length varies by a fifth, so that no period of a
/// recording always falls on the same side. Each piece of a recording has pairs of its
/// own, which begin behind a rest that was put in front of it. Where a piece judges, all
/// of it is validation, and all of the others estimation. What is left out is in no
/// block; a block around it becomes two.
class Blocks {
 public:
  /// Fewest samples that can be split.
  static constexpr std::size_t kFewestSamples = 60;

  Blocks() = default;
  Blocks(std::size_t samples, double memory_samples, const Split& split = {},
         std::span<const SampleRange> left_out = {});
  Blocks(std::span<const Piece> pieces, double memory_samples, const Split& split = {},
         std::span<const SampleRange> left_out = {});

  [[nodiscard]] const std::vector<Block>& blocks() const { return blocks_; }
  /// 1 where a sample may be fitted; as long as the recording.
  [[nodiscard]] const std::vector<unsigned char>& estimation() const { return mask_; }
  [[nodiscard]] std::size_t estimation_samples() const { return estimation_samples_; }
  /// In any block.
  [[nodiscard]] std::size_t samples() const { return samples_; }
  [[nodiscard]] std::span<const SampleRange> left_out() const { return left_out_; }
  /// The same with the validation blocks that `range` meets fitted, too.
  [[nodiscard]] Blocks fitting(SampleRange range) const;
  /// All that is not left out, as one kind of block.
  [[nodiscard]] const std::vector<Block>& kept() const { return kept_; }

 private:
  void split(const Piece& piece, double pairs, double estimation_share);
  void add(const Piece& piece, std::size_t first, std::size_t last, bool estimation);

  std::vector<SampleRange> left_out_;
  std::vector<Block> kept_;
  std::vector<Block> blocks_;
  std::vector<unsigned char> mask_;
  std::size_t estimation_samples_ = 0;
  std::size_t samples_ = 0;
};

}  // namespace workbench
