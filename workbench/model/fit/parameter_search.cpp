#include "workbench/model/fit/parameter_search.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "workbench/model/base/least_squares.hpp"

namespace workbench {
namespace {

constexpr double kSmoothStep = 1e-4;  // of the numeric derivative, search coordinates
constexpr double kLeastGain = 1e-6;   // relative fall of the error worth an iteration

std::vector<std::size_t> searched_slots(const FreeRun& run, std::span<const double> p) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < run.slots().size(); ++i) {
    if (FreeRun::is_searched(run.slots(), p, i)) out.push_back(i);
  }
  return out;
}

// For each effect with several: its jumpy parameters but those of the initial state.
std::vector<std::vector<std::size_t>> traded_slots(const FreeRun& run) {
  std::vector<std::vector<std::size_t>> out;
  for (const Effect* effect : run.effects()) {
    std::vector<std::size_t> jumpy;
    for (std::size_t i = 0; i < run.slots().size(); ++i) {
      const SearchedParameter& parameter = run.slots()[i].parameter;
      if (run.slots()[i].effect == effect && parameter.jumpy && !parameter.constant &&
          !parameter.initial) {
        jumpy.push_back(i);
      }
    }
    if (jumpy.size() > 1) out.push_back(std::move(jumpy));
  }
  return out;
}

double bounded(const SearchedParameter& parameter, double value) {
  return std::clamp(value, parameter.low, parameter.high);
}

double moved(const SearchedParameter& parameter, double value, double step) {
  return bounded(parameter, from_search(parameter, to_search(parameter, value) + step));
}

// Solves (A + lambda·diag A) x = b for a small symmetric A.
std::vector<double> damped_step(const std::vector<double>& a,
                                const std::vector<double>& b, double lambda) {
  const std::size_t n = b.size();
  std::vector<double> damped = a;
  for (std::size_t i = 0; i < n; ++i) damped[i * n + i] *= 1 + lambda;
  const std::vector<double> inverse = inverse_spd(damped, n);
  std::vector<double> x(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) x[i] += inverse[i * n + j] * b[j];
  }
  return x;
}

}  // namespace

double to_search(const SearchedParameter& parameter, double value) {
  if (parameter.logarithmic) return std::log(value);
  const double range = parameter.high - parameter.low;
  return range > 0 ? value / range : value;
}

double from_search(const SearchedParameter& parameter, double coordinate) {
  if (parameter.logarithmic) return std::exp(coordinate);
  const double range = parameter.high - parameter.low;
  return range > 0 ? coordinate * range : coordinate;
}

Edge edge_of(const SearchedParameter& parameter, double value) {
  if (parameter.initial || parameter.open_ends) return Edge::kNone;
  const double low = to_search(parameter, parameter.low);
  const double high = to_search(parameter, parameter.high);
  const double at = to_search(parameter, value);
  const double margin = 1e-3 * (high - low);
  const auto is_off = [&](double edge) {
    return parameter.off && std::abs(*parameter.off - edge) <= 1e-9 * std::abs(edge);
  };
  const bool floor_is_off = parameter.open_floor || is_off(parameter.low) ||
                            parameter.low == 0 ||
                            (parameter.off && *parameter.off < parameter.low);
  if (at > high - margin && !is_off(parameter.high)) return Edge::kHigh;
  if (at < low + margin && !floor_is_off && !is_off(parameter.low)) return Edge::kLow;
  return Edge::kNone;
}

bool has_jumpy(const FreeRun& run) {
  return std::any_of(run.slots().begin(), run.slots().end(), [](const FreeRun::Slot& s) {
    return s.parameter.jumpy && !s.parameter.constant;
  });
}

bool has_trades(const FreeRun& run) {
  return !traded_slots(run).empty();
}

void each(const FreeRun& run, std::size_t count, std::size_t at_once,
          const std::function<void(FreeRun&, std::size_t)>& part) {
  run.work().for_each((count + at_once - 1) / at_once, [&](std::size_t i) {
    FreeRun own = run;
    const std::size_t end = std::min(count, (i + 1) * at_once);
    for (std::size_t k = i * at_once; k < end; ++k) part(own, k);
  });
}

SearchPoint evaluate(FreeRun& run, std::vector<double> p) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    const SearchedParameter& parameter = run.slots()[i].parameter;
    if (!parameter.constant) p[i] = bounded(parameter, p[i]);
  }
  const double error = run.run(p);
  return {std::move(p), error};
}

namespace {

// The residual at a point, its derivative by each free parameter, and their products on
// the estimation blocks.
struct Linearised {
  std::vector<std::vector<double>> jacobian;
  std::vector<bool> fixed;  // parameters that cannot move there
  std::vector<double> a;    // JᵀJ, row by row
  std::vector<double> b;    // −Jᵀe

  explicit Linearised(std::size_t n) : jacobian(n) {}
};

void differentiate(FreeRun& run, const SearchPoint& at,
                   const std::vector<std::size_t>& free, double jumpy_step,
                   const std::vector<double>& residual, Linearised& out) {
  const std::size_t n = free.size();
  out.fixed.assign(n, false);
  for (std::size_t j = 0; j < n; ++j) {
    const SearchedParameter& parameter = run.slots()[free[j]].parameter;
    std::vector<double> p = at.p;
    const double here = to_search(parameter, p[free[j]]);
    double step = parameter.jumpy ? jumpy_step : kSmoothStep;
    p[free[j]] = moved(parameter, p[free[j]], step);
    if (to_search(parameter, p[free[j]]) - here < 0.5 * step) {
      p[free[j]] = moved(parameter, at.p[free[j]], -step);
    }
    step = to_search(parameter, p[free[j]]) - here;
    out.fixed[j] = step == 0 || !std::isfinite(run.run(p));
    out.jacobian[j].assign(residual.size(), 0.0);
    if (out.fixed[j]) continue;
    for (std::size_t k = 0; k < residual.size(); ++k) {
      out.jacobian[j][k] = (run.judged()[k] - residual[k]) / step;
    }
  }
}

void linearise(FreeRun& run, const SearchPoint& at, const std::vector<std::size_t>& free,
               double jumpy_step, Linearised& out) {
  run.run(at.p);
  const std::vector<double> residual(run.judged().begin(), run.judged().end());
  differentiate(run, at, free, jumpy_step, residual, out);
  const std::size_t n = free.size();
  out.a.assign(n * n, 0.0);
  out.b.assign(n, 0.0);
  for (const Block& block : run.blocks().blocks()) {
    if (!block.estimation) continue;
    const std::size_t count = block.last - block.first;
    const auto in_block = [&](const std::vector<double>& signal) {
      return std::span<const double>(signal).subspan(block.first, count);
    };
    for (std::size_t i = 0; i < n; ++i) {
      out.b[i] -= dot(in_block(out.jacobian[i]), in_block(residual));
      for (std::size_t j = 0; j <= i; ++j) {
        out.a[i * n + j] += dot(in_block(out.jacobian[i]), in_block(out.jacobian[j]));
        out.a[j * n + i] = out.a[i * n + j];
      }
    }
  }
}

// The damped step; one changes a lag at most sevenfold and crosses half of a range.
std::vector<double> stepped(const FreeRun& run, const SearchPoint& from,
                            const std::vector<std::size_t>& free, const Linearised& here,
                            double lambda) {
  const std::vector<double> step = damped_step(here.a, here.b, lambda);
  std::vector<double> p = from.p;
  for (std::size_t j = 0; j < free.size(); ++j) {
    const SearchedParameter& parameter = run.slots()[free[j]].parameter;
    const double most = parameter.logarithmic ? 2 : 0.5;
    if (!here.fixed[j])
      p[free[j]] = moved(parameter, p[free[j]], std::clamp(step[j], -most, most));
  }
  return p;
}

}  // namespace

SearchPoint descend(FreeRun& run, SearchPoint start, int iterations, double jumpy_step) {
  const std::vector<std::size_t> free = searched_slots(run, start.p);
  if (free.empty()) return start;
  SearchPoint best = std::move(start);
  Linearised here(free.size());
  double lambda = 1e-3;
  int stalled = 0;
  for (int iteration = 0; iteration < iterations && stalled < 2; ++iteration) {
    linearise(run, best, free, jumpy_step, here);
    bool better = false;
    const double before = best.error;
    for (int attempt = 0; attempt < 5 && !better; ++attempt) {
      SearchPoint next = evaluate(run, stepped(run, best, free, here, lambda));
      better = next.error < best.error;
      if (better) {
        best = std::move(next);
        lambda = std::max(lambda / 5, 1e-7);
      } else {
        lambda *= 8;
      }
    }
    if (!better) break;
    stalled = before - best.error < kLeastGain * before ? stalled + 1 : 0;
  }
  return best;
}

SearchPoint off_edges(FreeRun& run, SearchPoint point) {
  constexpr double kInside = 0.02;  // of the range
  // Half a nat.
  const double same = 1.0 / static_cast<double>(run.blocks().estimation_samples());
  for (const std::size_t i : searched_slots(run, point.p)) {
    const SearchedParameter& parameter = run.slots()[i].parameter;
    const Edge edge = parameter.jumpy ? edge_of(parameter, point.p[i]) : Edge::kNone;
    if (edge == Edge::kNone) continue;
    const double range =
        to_search(parameter, parameter.high) - to_search(parameter, parameter.low);
    std::vector<double> p = point.p;
    p[i] = moved(parameter, p[i], (edge == Edge::kHigh ? -kInside : kInside) * range);
    SearchPoint inside = evaluate(run, std::move(p));
    if (inside.error <= (1 + same) * point.error) point = std::move(inside);
  }
  return point;
}

SearchPoint pattern(FreeRun& run, SearchPoint start, int evaluations) {
  const std::vector<std::size_t> free = searched_slots(run, start.p);
  struct Direction {
    std::vector<std::pair<std::size_t, double>> moves;  // slot, sense
    double step;
    double smallest;
  };
  std::vector<Direction> directions;
  for (const std::size_t i : free) {
    const SearchedParameter& parameter = run.slots()[i].parameter;
    const double step = parameter.logarithmic ? 0.15 : 0.03;
    directions.push_back({{{i, 1.0}}, step, 1e-3 * step});
  }
  // Trades between the jumpy parameters of one effect: all together, and the first
  // against the others.
  for (const std::vector<std::size_t>& jumpy : traded_slots(run)) {
    Direction together{{}, 0.03, 3e-5};
    Direction against{{}, 0.03, 3e-5};
    for (const std::size_t i : jumpy) {
      together.moves.push_back({i, 1.0});
      against.moves.push_back({i, i == jumpy[0] ? 1.0 : -1.0});
    }
    directions.push_back(together);
    directions.push_back(against);
  }
  SearchPoint best = std::move(start);
  int left = evaluations;
  bool alive = true;
  while (left > 0 && alive) {
    alive = false;
    for (Direction& direction : directions) {
      if (left <= 0) break;
      if (direction.step < direction.smallest) continue;
      alive = true;
      bool better = false;
      for (const double sense : {1.0, -1.0}) {
        std::vector<double> p = best.p;
        for (const auto& [slot, sign] : direction.moves) {
          p[slot] =
              moved(run.slots()[slot].parameter, p[slot], sense * sign * direction.step);
        }
        if (p == best.p) continue;
        SearchPoint next = evaluate(run, std::move(p));
        --left;
        if (next.error < best.error) {
          best = std::move(next);
          better = true;
          if (sense < 0) {
            for (auto& move : direction.moves) move.second = -move.second;
          }
          break;
        }
      }
      direction.step *= better ? 1.8 : 0.45;
    }
  }
  return best;
}

namespace {

// The jumpy parameters of an effect scaled, and a share of the first of them traded for
// the others; smallest error of three first lags.
SearchPoint traded(FreeRun& run, std::vector<double> p,
                   const std::vector<std::size_t>& jumpy, double scale, double share) {
  double least = p[jumpy[1]];
  for (std::size_t k = 2; k < jumpy.size(); ++k) least = std::min(least, p[jumpy[k]]);
  const double first = scale * (p[jumpy[0]] + least) * share;
  for (std::size_t k = 1; k < jumpy.size(); ++k) {
    p[jumpy[k]] = scale * (p[jumpy[0]] + p[jumpy[k]]) - first;
  }
  p[jumpy[0]] = first;
  SearchPoint best = evaluate(run, p);
  for (const double factor : {0.8, 1.25}) {
    if (run.integrating()) break;
    std::vector<double> other = p;
    other[1] *= factor;
    SearchPoint point = evaluate(run, std::move(other));
    if (point.error < best.error) best = std::move(point);
  }
  return best;
}

}  // namespace

std::vector<SearchPoint> around(const FreeRun& run, const SearchPoint& start,
                                std::size_t count) {
  constexpr std::size_t kScales = 13;
  constexpr double kScale = 0.02;
  constexpr std::size_t kShares = 7;
  std::vector<SearchPoint> out;
  for (const std::vector<std::size_t>& jumpy : traded_slots(run)) {
    std::vector<SearchPoint> grid(kScales * kShares);
    each(run, grid.size(), kShares, [&](FreeRun& own, std::size_t i) {
      const double step = static_cast<double>(i / kShares) - kScales / 2;
      const double share = static_cast<double>(i % kShares) / kShares;
      grid[i] = traded(own, start.p, jumpy, 1 + kScale * step, share);
    });
    std::move(grid.begin(), grid.end(), std::back_inserter(out));
  }
  std::sort(out.begin(), out.end(),
            [](const SearchPoint& a, const SearchPoint& b) { return a.error < b.error; });
  out.resize(std::min(count, out.size()));
  return out;
}

}  // namespace workbench
