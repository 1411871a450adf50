#include "workbench/model/base/blocks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "workbench/recording/rest_before.hpp"

namespace workbench {

Blocks::Blocks(std::size_t samples, double memory_samples, const Split& split,
               std::span<const SampleRange> left_out)
    : Blocks(std::array{Piece{0, samples, {}, 0, false}}, memory_samples, split,
             left_out) {}

Blocks::Blocks(std::span<const Piece> pieces, double memory_samples, const Split& split,
               std::span<const SampleRange> left_out)
    : left_out_(left_out.begin(), left_out.end()) {
  constexpr double kFewestPairs = 6;
  constexpr double kMostPairs = 20;
  constexpr double kMemories = 8;
  constexpr double kFewestWanted = 2;
  constexpr double kShortestPair = 10;  // samples
  constexpr double kFewestOfPiece = 2;  // or it would be fitted first and judge last
  const bool apart = std::ranges::any_of(pieces, [](const Piece& p) { return p.judges; });
  const auto length = [](const Piece& piece) {
    return static_cast<double>(piece.last - piece.first);
  };
  // Each recording as many as it would have alone: beside others it tells no less.
  const auto pairs_for = [&](const Piece& of) {
    double n = 0;
    for (const Piece& piece : pieces) {
      const bool same = apart ? piece.judges : piece.recording == of.recording;
      n += same ? length(piece) : 0;
    }
    const double pairs =
        split.pair_samples > 0
            ? std::clamp(n / std::max(split.pair_samples, kShortestPair), kFewestWanted,
                         std::max(n / kShortestPair, kFewestWanted))
            : std::clamp(n / (kMemories * std::max(memory_samples, 1.0)), kFewestPairs,
                         kMostPairs);
    return pairs * length(of) / n;
  };
  const std::size_t samples = pieces.empty() ? 0 : pieces.back().last;
  std::size_t from = 0;
  for (const SampleRange& range : left_out_) {
    if (range.first > from) kept_.push_back({from, range.first, true});
    from = range.last;
  }
  if (samples > from) kept_.push_back({from, samples, true});
  mask_.assign(samples, 0);
  for (const Piece& piece : pieces) {
    const double share = pairs_for(piece);
    const bool enough = piece.last - piece.first >= kFewestSamples;
    this->split(piece, std::max(std::round(share), enough ? kFewestOfPiece : 1),
                !apart         ? split.estimation_share
                : piece.judges ? 0
                               : 1);
  }
}

void Blocks::split(const Piece& piece, double pairs, double estimation_share) {
  // A rest that was put in front moves nothing: the step behind it begins the first
  // block.
  const std::size_t begin =
      std::min(piece.last, piece.first + (piece.at_rest ? kRestSamples : 0));
  const auto n = static_cast<double>(piece.last - begin);
  const double length = n / pairs;
  const auto at = [begin](double sample) {
    return begin + static_cast<std::size_t>(sample);
  };
  double start = 0;
  for (int i = 0; start < n; ++i) {
    // Golden-ratio steps spread the variation evenly.
    const double phase = 0.618034 * (i + 1) - std::floor(0.618034 * (i + 1));
    double end = start + length * (0.8 + 0.4 * phase);
    if (end > n - length / 2) end = n;
    const std::size_t middle =
        estimation_share < 1 ? at(start + estimation_share * (end - start)) : at(end);
    add(piece, i == 0 ? piece.first : at(start), middle, true);
    add(piece, middle, at(end), false);
    start = end;
  }
}

Blocks Blocks::fitting(SampleRange range) const {
  Blocks out = *this;
  for (Block& block : out.blocks_) {
    if (block.estimation || block.first >= range.last || range.first >= block.last) {
      continue;
    }
    block.estimation = true;
    std::fill(out.mask_.begin() + static_cast<std::ptrdiff_t>(block.first),
              out.mask_.begin() + static_cast<std::ptrdiff_t>(block.last), 1);
    out.estimation_samples_ += block.last - block.first;
  }
  return out;
}

void Blocks::add(const Piece& piece, std::size_t first, std::size_t last,
                 bool estimation) {
  for (const Block& part : kept_) {
    const std::size_t from = std::max(first, part.first);
    const std::size_t to = std::min(last, part.last);
    if (from >= to) continue;
    blocks_.push_back({from, to, estimation, piece.first});
    samples_ += to - from;
    if (!estimation) continue;
    std::fill(mask_.begin() + static_cast<std::ptrdiff_t>(from),
              mask_.begin() + static_cast<std::ptrdiff_t>(to), 1);
    estimation_samples_ += to - from;
  }
}

}  // namespace workbench
