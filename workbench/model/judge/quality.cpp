#include "workbench/model/judge/quality.hpp"

#include <cmath>
#include <set>
#include <string>

#include "workbench/model/base/least_squares.hpp"
#include "workbench/model/judge/merit.hpp"

namespace workbench {
namespace {

struct Sums {
  double square = 0;
  double count = 0;

  void add(std::span<const double> residual) {
    square += dot(residual, residual);
    count += static_cast<double>(residual.size());
  }
  [[nodiscard]] double rmse() const { return count > 0 ? std::sqrt(square / count) : 0; }
};

// The samples of a block that is neither left out nor of another piece than `which`.
template <class Which, class Take>
void for_each_block(const Fitter& fitter, const Which& which, const Take& take) {
  for (const Piece& piece : fitter.pieces()) {
    if (!which(piece)) continue;
    for (const Block& block : fitter.blocks().blocks()) {
      if (block.piece == piece.first) take(block);
    }
  }
}

// ‖y − mean(y)‖² over the pieces of `which`.
template <class Which>
double spread_of(const Fitter& fitter, const Which& which) {
  double sum = 0;
  double count = 0;
  for_each_block(fitter, which, [&](const Block& block) {
    for (std::size_t k = block.first; k < block.last; ++k) sum += fitter.y()[k];
    count += static_cast<double>(block.last - block.first);
  });
  const double mean = sum / count;
  double spread = 0;
  for_each_block(fitter, which, [&](const Block& block) {
    for (std::size_t k = block.first; k < block.last; ++k) {
      spread += (fitter.y()[k] - mean) * (fitter.y()[k] - mean);
    }
  });
  return spread;
}

// 100·(1 − ‖e‖/‖y − mean(y)‖) over the pieces of `which`, each recording about its own
// mean: where they lie apart, each starts there, and no model explains it.
template <class Which>
double fit_percent(const Fitter& fitter, const Fit& fit, const Which& which) {
  Sums error;
  for_each_block(fitter, which, [&](const Block& block) {
    error.add(std::span(fit.residual).subspan(block.first, block.last - block.first));
  });
  double spread = 0;
  std::set<std::string> names;
  for (const Piece& first : fitter.pieces()) {
    if (!which(first) || !names.insert(first.recording).second) continue;
    spread += spread_of(fitter, [&](const Piece& piece) {
      return which(piece) && piece.recording == first.recording;
    });
  }
  return 100 * (1 - std::sqrt(error.square / spread));
}

RecordingFit of_recording(const Fitter& fitter, const Fit& fit, const Piece& first) {
  const auto is_its = [&first](const Piece& piece) {
    return piece.recording == first.recording && piece.judges == first.judges;
  };
  Sums all;
  Sums validation;
  for_each_block(fitter, is_its, [&](const Block& block) {
    const auto part =
        std::span(fit.residual).subspan(block.first, block.last - block.first);
    all.add(part);
    if (!block.estimation) validation.add(part);
  });
  return {first.recording, fit_percent(fitter, fit, is_its), all.rmse(),
          validation.rmse(), first.judges};
}

}  // namespace

FitQuality quality(const Fitter& fitter, const Fit& fit) {
  FitQuality out;
  out.fit_percent =
      fit_percent(fitter, fit, [](const Piece& piece) { return !piece.judges; });
  out.rmse = fitter.rmse(fit);
  out.rmse_validation = fitter.rmse_on(fit, false);
  out.output_follows_u = follows_u(fitter, fit);
  const Piece* before = nullptr;
  for (const Piece& piece : fitter.pieces()) {
    if (before == nullptr || piece.recording != before->recording ||
        piece.judges != before->judges) {
      out.recordings.push_back(of_recording(fitter, fit, piece));
    }
    before = &piece;
  }
  return out;
}

}  // namespace workbench
