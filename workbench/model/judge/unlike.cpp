#include "workbench/model/judge/unlike.hpp"

#include <stdexcept>

#include "workbench/model/base/joined.hpp"
#include "workbench/recording/input_error.hpp"

namespace workbench {
namespace {

constexpr double kFarLess = 0.5;  // of the error

// Only what lies in `file`, as if it had been fitted alone.
Recording alone(const Recording& joined, const std::string& file) {
  std::vector<Piece> pieces;
  for (const Piece& piece : joined.pieces) {
    if (piece.recording != file) continue;
    pieces.push_back(piece);
    pieces.back().judges = false;
  }
  return cut_to(joined, std::move(pieces));
}

}  // namespace

std::vector<Unlike> unlike(const Recording& joined, Column output,
                           const std::vector<RecordingFit>& shared) {
  std::vector<Unlike> out;
  if (shared.size() < 2) return out;
  for (const RecordingFit& one : shared) {
    try {
      const Recording recording = alone(joined, one.file);
      const Fitter fitter(recording, output);
      const FitQuality own = quality(fitter, fitter.start({}));
      if (own.rmse < kFarLess * one.rmse) {
        out.push_back({one.file, own.fit_percent, one.fit_percent});
      }
    } catch (const InputError&) {  // too short to be fitted alone
    } catch (const std::invalid_argument&) {
    }
  }
  return out;
}

}  // namespace workbench
