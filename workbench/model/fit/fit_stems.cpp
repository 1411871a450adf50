// Fitter: the stems that the identification sees in the recording, and the lags that go
// with them.
#include <algorithm>
#include <cmath>

#include "workbench/model/fit/fit.hpp"
#include "workbench/model/fit/stem_search.hpp"

namespace workbench {
namespace {

constexpr std::size_t kMostStems = 64;  // outputs that stems are remembered of

// Squared difference of two outputs, but for their level.
double apart(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  double squares = 0;
  for (std::size_t t = 0; t < a.size(); ++t) {
    const double between = a[t] - b[t];
    sum += between;
    squares += between * between;
  }
  return squares - sum * sum / static_cast<double>(a.size());
}

}  // namespace

// What was seen of the same output, or of a settled one that differs by less than the fit
// leaves unexplained.
const Fitter::StemsOf* Fitter::known_stems(const Fit& fit,
                                           const std::vector<double>& y) const {
  const StemsOf* nearest = nullptr;
  double least = dot(fit.residual, fit.residual);
  for (const StemsOf& known : stems_) {
    if (known.y == y) return &known;
    if (!known.settled) continue;
    const double between = apart(known.y, y);
    if (between >= least) continue;
    least = between;
    nearest = &known;
  }
  return nearest;
}

void Fitter::settle_stems() const {
  for (StemsOf& known : stems_) known.settled = true;
}

// The output less the loads of a fit, as the identification sees it. It looks at all
// samples, but only proposes: the estimation blocks decide. Behind a load, which is one
// of many that are tried, its first cycles have to do.
std::vector<SeenStem> Fitter::stems_behind(const Fit& fit) const {
  std::vector<double> y(base_.y.begin(), base_.y.end());
  add_loads(fit, -1, y);
  {
    const std::lock_guard lock(stems_mutex_);
    if (const StemsOf* known = known_stems(fit, y)) return known->stems;
  }
  std::vector<SeenStem> stems = stems_in_pieces(y, std::ranges::equal(y, base_.y));
  const std::lock_guard lock(stems_mutex_);
  if (stems_.size() < kMostStems) stems_.push_back({std::move(y), stems});
  return stems;
}

// One valve has to serve all pieces: what two of them show alike is proposed once.
std::vector<SeenStem> Fitter::stems_in_pieces(std::span<const double> y,
                                              bool later_cycles) const {
  constexpr double kAlike = 0.1;  // of the band
  constexpr std::size_t kMostPieces = 4;
  std::vector<const Piece*> longest;
  for (const Piece& piece : pieces_) {
    if (!piece.judges) longest.push_back(&piece);
  }
  std::stable_sort(longest.begin(), longest.end(), [](const Piece* a, const Piece* b) {
    return a->last - a->first > b->last - b->first;
  });
  longest.resize(std::min(longest.size(), kMostPieces));
  std::vector<SeenStem> out;
  for (const Piece* piece : longest) {
    const std::size_t count = piece->last - piece->first;
    for (SeenStem stem : stems_seen(std::span(u_).subspan(piece->first, count),
                                    y.subspan(piece->first, count), base_.period_s,
                                    later_cycles, *work_)) {
      if (piece->first > 0) stem.start = 0;  // that of the first piece is asked for
      const auto alike = [&stem](const SeenStem& other) {
        const auto near = [&](double SeenStem::*part) {
          const double band =
              other.deadband + std::max(other.slip_ascending, other.slip_descending);
          return std::abs(other.*part - stem.*part) < kAlike * band;
        };
        return near(&SeenStem::deadband) && near(&SeenStem::slip_ascending) &&
               near(&SeenStem::slip_descending);
      };
      if (std::none_of(out.begin(), out.end(), alike)) out.push_back(stem);
    }
  }
  return out;
}

// A missing effect pulls the first lag away; starts are judged with other ones, too.
std::vector<double> Fitter::lags_to_try(const FreeRun& run, const std::vector<double>& p,
                                        std::span<const SeenStem> stems) const {
  const auto slot = first_lag_slot(run);
  if (!slot) return {0};
  const double own = p[*slot];
  const double all = base_.duration_s();
  std::vector<double> lags = {own,     0.2 * own,    0.015 * all, 0.5 * own,
                              2 * own, 0.0015 * all, 0.005 * all, 0.05 * all};
  for (const SeenStem& stem : stems) {
    if (stem.lag_s > 0) lags.insert(lags.begin(), stem.lag_s);
  }
  return lags;
}

}  // namespace workbench
