#include "firmware/learn/loop_proposal.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "firmware/learn/signal_role.hpp"
#include "ident/base/configurations.hpp"

namespace firmware {
namespace {

using Vector = Eigen::VectorXd;

constexpr Eigen::Index kFewest = 40;  // instants of a grid
constexpr Eigen::Index kMost = 2048;
constexpr double kSeldom = 0.02;      // share of frames with news: no u or y moves less
constexpr double kRelated = 0.4;      // correlation
constexpr double kComputed = 60;      // % of the moves
constexpr double kCopy = 0.995;       // correlation without lag: the same quantity twice
constexpr double kLongestLag = 0.25;  // of the time that was seen

// Time between values that are news.
double spacing_of(const SeenSignal& signal) {
  const double kept =
      (signal.t_s.back() - signal.t_s.front()) /
      static_cast<double>(std::max<std::size_t>(signal.t_s.size() - 1, 1));
  return kept / std::max(signal.moving, 0.05);
}

// Two signals at the same instants.
struct Grid {
  double period_s = 0;
  Vector u;
  Vector y;
  double start_s = 0;
};

Vector held(const SeenSignal& signal, double start_s, double period_s,
            Eigen::Index count) {
  Vector out(count);
  std::size_t at = 0;
  for (Eigen::Index k = 0; k < count; ++k) {
    const double t = start_s + period_s * static_cast<double>(k);
    while (at + 1 < signal.t_s.size() && signal.t_s[at + 1] <= t) ++at;
    out[k] = signal.value[at];
  }
  return out;
}

// The whole time both were seen, or the last kMost instants of it where `whole` is false.
Grid grid_of(const SeenSignal& u, const SeenSignal& y, bool whole) {
  const double begin = std::max(u.t_s.front(), y.t_s.front());
  const double end = std::min(u.t_s.back(), y.t_s.back());
  double period = std::max({spacing_of(u), spacing_of(y), 1e-4});
  if (whole) period = std::max(period, (end - begin) / static_cast<double>(kMost));
  if (!(end > begin)) return {};
  const auto count = std::min(static_cast<Eigen::Index>((end - begin) / period), kMost);
  const double start = end - period * static_cast<double>(count);
  return {period, held(u, start, period, count), held(y, start, period, count), start};
}

double correlation_at(const Grid& grid, Eigen::Index lag) {
  const Eigen::Index count = grid.u.size() - lag;
  const Vector u = grid.u.head(count).array() - grid.u.head(count).mean();
  const Vector y = grid.y.tail(count).array() - grid.y.tail(count).mean();
  const double scale = u.norm() * y.norm();
  return scale > 0 ? u.dot(y) / scale : 0;
}

// Where the correlation is largest; of those that nearly are (a cycle later, too), the
// first.
Eigen::Index lag_of(const Grid& grid) {
  constexpr double kNearly = 0.95;
  const auto longest =
      static_cast<Eigen::Index>(kLongestLag * static_cast<double>(grid.u.size()));
  Vector size(longest + 1);
  for (Eigen::Index lag = 0; lag <= longest; ++lag) {
    size[lag] = std::abs(correlation_at(grid, lag));
  }
  const double enough = kNearly * size.maxCoeff();
  for (Eigen::Index lag = 0; lag <= longest; ++lag) {
    const bool falls = lag == longest || size[lag + 1] <= size[lag];
    const bool rose = lag == 0 || size[lag - 1] <= size[lag];
    if (size[lag] >= enough && falls && rose) return lag;
  }
  return 0;
}

// How much of the moves of `out` its inputs, now and the instant before, explain, %.
double explained_moves(const Vector& out, std::initializer_list<const Vector*> inputs) {
  const Eigen::Index count = out.size() - 3;
  const Vector moves = out.tail(count) - out.segment(2, count);
  const double all = (moves.array() - moves.mean()).matrix().squaredNorm();
  if (!(all > 0)) return 0;
  double best = 0;
  // The newest input may have come after the output was computed.
  for (const Eigen::Index late : {0, 1}) {
    Eigen::MatrixXd terms(count, 1 + 2 * static_cast<Eigen::Index>(inputs.size()));
    Eigen::Index column = 0;
    terms.col(column++).setOnes();
    for (const Vector* in : inputs) {
      terms.col(column++) = in->segment(3 - late, count);
      terms.col(column++) = in->segment(2 - late, count);
    }
    const Vector weights = terms.colPivHouseholderQr().solve(moves);
    const double left = (moves - terms * weights).squaredNorm();
    best = std::max(best, 100 * (1 - left / all));
  }
  return best;
}

// Of a signal that swings about its mean, s; 0 where it does less than three times.
double oscillation_of(const Vector& values, double period_s) {
  const Vector off = values.array() - values.mean();
  const double band =
      0.3 * std::sqrt(off.squaredNorm() / static_cast<double>(off.size()));
  int side = 0;
  Eigen::Index first = -1;
  Eigen::Index last = -1;
  int rises = 0;
  for (Eigen::Index k = 0; k < off.size(); ++k) {
    if (off[k] > band && side <= 0) {
      if (side < 0) {
        if (first < 0) first = k;
        last = k;
        ++rises;
      }
      side = 1;
    } else if (off[k] < -band) {
      side = -1;
    }
  }
  return rises >= 4 ? period_s * static_cast<double>(last - first) / (rises - 1) : 0;
}

// To two digits where that changes little, else to three.
double rounded(double seconds) {
  constexpr double kLittle = 0.01;
  const double unit = std::pow(10.0, std::floor(std::log10(seconds)) - 1);
  const double two = std::round(seconds / unit) * unit;
  return std::abs(two - seconds) <= kLittle * seconds
             ? two
             : std::round(seconds / unit * 10) * unit / 10;
}

// 1, 2 or 5 times a power of ten, not above.
double round_below(double seconds) {
  const double decade = std::pow(10.0, std::floor(std::log10(seconds)));
  for (const double step : {5.0, 2.0}) {
    if (step * decade <= seconds * 1.05) return step * decade;
  }
  return decade;
}

// That of the frames, of which nothing is lost, but for an oscillation so slow that the
// window would hold few cycles of it; or where none was seen: it may be slow.
double sample_period(double oscillation_s, double interval_s) {
  constexpr double kMostPerCycle = ident::kStandardWindow / 10.0;
  constexpr double kPerCycle = 40;
  constexpr double kUsual_s = 1;
  const double own = rounded(std::clamp(interval_s, 0.01, 3600.0));
  if (oscillation_s > 0 && oscillation_s <= kMostPerCycle * own) return own;
  const double wanted = oscillation_s > 0 ? oscillation_s / kPerCycle : kUsual_s;
  return std::max(own, round_below(std::clamp(wanted, 0.01, 3600.0)));
}

bool reads_as_percent(const SeenSignal& signal) {
  return signal.low >= -1 && signal.high <= 105 && signal.high > 10;
}

// A signal among the values of y is its setpoint where it is called so and stands still,
// or where it explains moves of u that y alone does not. What explains them without y is
// the process output of u rather than a setpoint.
void take_setpoint(const std::vector<SeenSignal>& signals, const Grid& grid,
                   LoopProposal& out) {
  constexpr double kMore = 5;  // % of the moves
  const SeenSignal& measured = signals[out.y];
  const double room = measured.high - measured.low;
  bool of_loop = false;  // the setpoint, by its name
  for (std::size_t k = 0; k < signals.size(); ++k) {
    const SeenSignal& candidate = signals[k];
    const SameLoop loop = named_sp(candidate.name)
                              ? same_loop(candidate.title(), measured.title())
                              : SameLoop::kUnknown;
    if (k == out.u || k == out.y || candidate.bus != measured.bus ||
        loop == SameLoop::kNo || named_y(candidate.name) ||
        candidate.unit != measured.unit || candidate.low > measured.high ||
        candidate.high < measured.low || candidate.high - candidate.low > 2 * room) {
      continue;
    }
    if (!(candidate.high > candidate.low)) {
      const bool better = !out.sp || (loop == SameLoop::kYes && !of_loop);
      if (!better || !named_sp(candidate.name)) continue;
      out.sp = k;
      of_loop = loop == SameLoop::kYes;
      continue;
    }
    const Vector sp = held(candidate, grid.start_s, grid.period_s, grid.u.size());
    const double more = explained_moves(grid.u, {&grid.y, &sp});
    if (more < out.controller_pct + kMore || more < kComputed ||
        more < explained_moves(grid.u, {&sp}) + kMore) {
      continue;
    }
    out.controller_pct = more;
    out.process_pct = explained_moves(grid.y, {&grid.u, &sp});
    out.sp = k;
  }
}

std::optional<LoopProposal> examine(const std::vector<SeenSignal>& signals, std::size_t u,
                                    std::size_t y) {
  const SeenSignal& output = signals[u];
  const SeenSignal& measured = signals[y];
  if (output.bus != measured.bus && output.dbc != measured.dbc) return std::nullopt;
  // Numbers of signals whose names say no part may count channels, not loops; even others
  // may be those of frames, so that no pair is excluded by them.
  const bool named = named_u(output.name) && named_y(measured.name);
  const SameLoop loop =
      named ? same_loop(output.title(), measured.title()) : SameLoop::kUnknown;
  const Grid whole = grid_of(output, measured, true);
  if (whole.u.size() < kFewest) return std::nullopt;
  if (std::abs(correlation_at(whole, 0)) > kCopy) return std::nullopt;
  LoopProposal out{.u = u, .y = y};
  const Eigen::Index lag = lag_of(whole);
  out.correlation = correlation_at(whole, lag);
  out.lag_s = static_cast<double>(lag) * whole.period_s;
  const Grid fine = grid_of(output, measured, false);
  out.controller_pct = explained_moves(fine.u, {&fine.y});
  out.process_pct = explained_moves(fine.y, {&fine.u});
  take_setpoint(signals, fine, out);
  if (std::abs(out.correlation) < kRelated && out.controller_pct < kComputed) {
    return std::nullopt;
  }
  out.period_s = oscillation_of(whole.u, whole.period_s);
  out.sample_period_s =
      sample_period(out.period_s, std::max(output.interval_s, measured.interval_s));
  out.names_agree = named && loop != SameLoop::kNo;
  const bool names_disagree = named_y(output.name) || named_u(measured.name) ||
                              named_sp(output.name) || named_sp(measured.name) ||
                              loop == SameLoop::kNo;
  // Shares that are left, against each other; what is left of 100 % is not zero.
  constexpr double kExact = 100.05;
  const double computed =
      std::log10((kExact - out.process_pct) / (kExact - out.controller_pct));
  out.score = std::abs(out.correlation) + std::clamp(computed, -2.0, 2.0) +
              (output.unit == "%" ? 0.1 : 0) + (reads_as_percent(output) ? 0.1 : 0) +
              (out.names_agree ? 1 : 0) + (loop == SameLoop::kYes ? 1 : 0) -
              (names_disagree ? 2 : 0);
  return out;
}

}  // namespace

std::vector<LoopProposal> propose_loops(const std::vector<SeenSignal>& signals) {
  constexpr std::size_t kMostExamined = 60;
  std::vector<std::size_t> moving;
  for (std::size_t k = 0; k < signals.size(); ++k) {
    const SeenSignal& signal = signals[k];
    if (signal.value.size() >= kFewest && signal.moving >= kSeldom &&
        signal.high > signal.low && moving.size() < kMostExamined) {
      moving.push_back(k);
    }
  }
  std::vector<LoopProposal> found;
  for (const std::size_t u : moving) {
    for (const std::size_t y : moving) {
      if (u == y) continue;
      if (const auto proposal = examine(signals, u, y)) found.push_back(*proposal);
    }
  }
  std::ranges::sort(found, [](const LoopProposal& a, const LoopProposal& b) {
    return a.score > b.score;
  });
  std::vector<bool> taken(signals.size());
  std::vector<LoopProposal> out;
  for (LoopProposal proposal : found) {
    if (taken[proposal.u] || taken[proposal.y] || out.size() == kMostProposals) continue;
    if (proposal.sp && taken[*proposal.sp]) proposal.sp.reset();
    taken[proposal.u] = taken[proposal.y] = true;
    if (proposal.sp) taken[*proposal.sp] = true;
    out.push_back(proposal);
  }
  return out;
}

}  // namespace firmware
