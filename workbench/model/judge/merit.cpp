#include "workbench/model/judge/merit.hpp"

#include <algorithm>
#include <cmath>

#include "workbench/model/base/least_squares.hpp"

namespace workbench {
namespace {

constexpr double kVisibleShare = 0.1;  // of the squared error that u must explain
constexpr double kVisible = 4;         // z above which u is seen to move the output

// What is left of the output when u is ignored: of an integrating process less a level of
// each piece and a trend.
std::vector<double> without_u(const Fitter& fitter, const Fit& fit,
                              std::span<const double> y) {
  const std::size_t n = y.size();
  std::vector<std::vector<double>> columns = {std::vector<double>(n, 1.0)};
  std::vector<Block> rows = fitter.blocks().blocks();
  if (fit.integrating) {
    columns.assign(1 + fitter.pieces().size(), std::vector<double>(n, 0.0));
    for (std::size_t i = 0; i < fitter.pieces().size(); ++i) {
      const Piece& piece = fitter.pieces()[i];
      for (std::size_t k = piece.first; k < piece.last; ++k) {
        columns[0][k] = static_cast<double>(k - piece.first);
        columns[1 + i][k] = 1;
      }
      if (piece.judges) rows.push_back({piece.first, piece.last, true});
    }
  }
  const std::vector<std::span<const double>> all(columns.begin(), columns.end());
  const std::vector<double> c = least_squares(all, y, rows);
  std::vector<double> residual(y.begin(), y.end());
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < columns.size(); ++i) residual[k] -= c[i] * columns[i][k];
  }
  return residual;
}

double p_without(const Fitter& fitter, const Fit& fit, const Effect& effect) {
  const Fit less = fitter.without(fit, effect);
  return test_difference(less.residual, fit.residual, fitter.blocks()).p_steady;
}

}  // namespace

double total_error(const Fit& fit) {
  return dot(fit.residual, fit.residual);
}

double score_of(const Fit& fit, const NoiseColour& colour) {
  const std::vector<double> e = whitened(colour, fit.residual);
  const auto n = static_cast<double>(e.size());
  return n * std::log(std::max(dot(e, e) / n, 1e-300)) +
         static_cast<double>(fit.parameters()) * std::log(n);
}

double rmse_ahead(const Fitter& fitter, const Fit& fit) {
  const NoiseColour colour = colour_of(fit.residual);
  const std::vector<double> e = whitened(colour, fit.residual);
  double sum = 0;
  double count = 0;
  for (const Block& block : fitter.blocks().blocks()) {
    if (block.estimation) continue;
    for (std::size_t k = std::max(block.first, block.piece + colour.a.size());
         k < block.last; ++k) {
      sum += e[k] * e[k];
      ++count;
    }
  }
  return count > 0 ? std::sqrt(sum / count) : 0;
}

bool as_good(const Fitter& fitter, const Fit& other, const Fit& best) {
  constexpr double kTellable = 2;  // z that data from `best` would show on average
  const DifferenceTest test =
      test_difference(other.residual, best.residual, fitter.blocks());
  return test.p_value > kAsLikely || test.z < kTellable * test.slope;
}

bool is_seen(const DifferenceTest& ahead) {
  constexpr double kMost = 1.5;  // times what is simulated
  return ahead.p_value <= kAsLikely && ahead.slope * (1 - 2 / ahead.z) <= kMost;
}

bool earns_parameters(const Fitter& fitter, const Fit& less, const Fit& more) {
  double count = 0;
  for (const Block& block : fitter.blocks().blocks()) {
    if (block.estimation) count += static_cast<double>(block.last - block.first);
  }
  const double added =
      static_cast<double>(more.parameters()) - static_cast<double>(less.parameters());
  return count * std::log(less.error / more.error) > 2 * added;
}

bool lowers_error(const Fitter& fitter, const Fit& less, const Fit& more) {
  if (!earns_parameters(fitter, less, more)) return false;
  const double before = fitter.rmse_on(less, false);
  const double after = fitter.rmse_on(more, false);
  return after * after < (1 - kLeastMissed) * before * before &&
         test_difference(less.residual, more.residual, fitter.blocks()).p_value <
             kAsLikely;
}

bool stands_in(const Fitter& fitter, const Fit& less, const Fit& fit) {
  const auto is_pushed_out = [&](const Effect* effect) {
    return at_edge(less, *effect) && !at_edge(fit, *effect);
  };
  return fit.parameters() < less.parameters() &&
         std::ranges::any_of(less.effects, is_pushed_out) && as_good(fitter, fit, less);
}

std::string objection_to(const Effect& effect, const Fit& fit, const Situation& here) {
  const bool cycle_is_explained =
      std::any_of(fit.effects.begin(), fit.effects.end(),
                  [](const Effect* other) { return other->description().sticks; });
  if (effect.description().is_load() && cycle_is_explained) return {};
  return effect.objection(here, fit.searched_of(effect), fit.solved_of(effect));
}

bool shows_itself(const Fitter& fitter, const Fit& fit, const Fit& without,
                  const Effect& effect) {
  constexpr double kSure = 0.005;
  // Of the squared error: a model is coarse as its readings are, but no worse for it.
  constexpr double kHarmless = -0.02;
  constexpr double kEqual = 1e-6;  // of the error: another effect does the same already
  const double all = total_error(fit);
  if (std::abs(total_error(without) - all) <= kEqual * all) return false;
  const auto p_value = effect.own_test(fitter.situation(fit), fit.searched_of(effect));
  const double before = fitter.rmse_on(without, false);
  const double after = fitter.rmse_on(fit, false);
  const double share = 1 - after * after / (before * before);
  return p_value && *p_value < kSure &&
         share > std::max(effect.description().least_share, kHarmless);
}

bool is_excited(const Effect& effect, const Excitation& seen, double p_value) {
  const bool beyond_doubt = p_value <= kBeyondDoubt && !effect.description().is_load();
  return seen.acted && (beyond_doubt || seen.events >= seen.least);
}

bool is_possible(const Fitter& fitter, const Fit& fit, const Effect& effect) {
  const Situation here = fitter.situation(fit);
  if (at_edge(fit, effect) || !objection_to(effect, fit, here).empty()) return false;
  const Excitation seen = effect.excitation(here, fit.searched_of(effect));
  return is_excited(effect, seen, 1) ||
         is_excited(effect, seen, p_without(fitter, fit, effect));
}

namespace {

double share_of_u(const Fitter& fitter, const Fit& fit,
                  const std::vector<double>& ignored) {
  double with = 0;
  double without = 0;
  for (const Block& block : fitter.blocks().blocks()) {
    if (block.estimation) continue;
    for (std::size_t k = block.first; k < block.last; ++k) {
      with += fit.residual[k] * fit.residual[k];
      without += ignored[k] * ignored[k];
    }
  }
  return without > 0 ? 1 - with / without : 0;
}

}  // namespace

double share_of_u(const Fitter& fitter, const Fit& fit) {
  return share_of_u(fitter, fit, without_u(fitter, fit, fitter.y()));
}

namespace {

bool is_seen(const Fitter& fitter, const Fit& fit, const std::vector<double>& ignored,
             double share) {
  const DifferenceTest test = test_difference(ignored, fit.residual, fitter.blocks());
  return test.z > kVisible && share_of_u(fitter, fit, ignored) > share;
}

}  // namespace

bool u_is_seen(const Fitter& fitter, const Fit& fit) {
  return is_seen(fitter, fit, without_u(fitter, fit, fitter.y()), kVisibleShare);
}

bool follows_u(const Fitter& fitter, const Fit& fit) {
  constexpr double kMost = 0.5;
  std::vector<double> y(fitter.y().begin(), fitter.y().end());
  fitter.add_loads(fit, -1, y);
  return is_seen(fitter, fit, without_u(fitter, fit, y), kMost);
}

}  // namespace workbench
