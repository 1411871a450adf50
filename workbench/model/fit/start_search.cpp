#include "workbench/model/fit/start_search.hpp"

#include <algorithm>
#include <cmath>

#include "workbench/model/base/noise.hpp"

namespace workbench {
namespace {

int searched_count(const FreeRun& run, const std::vector<double>& p) {
  int count = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    count += FreeRun::is_searched(run.slots(), p, i);
  }
  return count;
}

// From a start to the valley it lies in; where the error is smooth, a shape of many
// parameters is farther from it.
SearchPoint screened(FreeRun& run, SearchPoint point) {
  constexpr int kFewest = 5;
  constexpr int kUsual = 5;
  if (has_jumpy(run)) return descend(run, pattern(run, std::move(point), 30), kFewest);
  const int more = std::max(0, searched_count(run, point.p) - kUsual);
  return descend(run, std::move(point), kFewest + 2 * more);
}

SearchPoint polished(FreeRun& run, SearchPoint point) {
  point = descend(run, std::move(point), 15);
  if (!has_jumpy(run)) return point;
  for (int round = 0; round < 2; ++round) {
    const double before = point.error;
    point = pattern(run, std::move(point), 120);
    point = descend(run, std::move(point), 8);
    if (!(point.error < 0.999 * before)) break;
  }
  point = descend(run, std::move(point), 8, kNarrowStep);
  point = pattern(run, std::move(point), 40);
  return descend(run, std::move(point), 4, kNarrowStep);
}

// True where a point is better than another by more than the parameters that its form has
// above those of the other; the residual is hardly ever white, so they have to earn much.
bool clearly_less(const FreeRun& run, const SearchPoint& point, const SearchPoint& than) {
  constexpr double kEarned = 0.03;  // of the error, each
  const auto dear = [&run](const SearchPoint& p) {
    return (1 + kEarned * searched_count(run, p.p)) * p.error;
  };
  return dear(point) < dear(than);
}

// True where no point of `others` has the same constants as `point`.
bool none_like(const FreeRun& run, std::span<const SearchPoint> others,
               const SearchPoint& point) {
  return std::none_of(others.begin(), others.end(), [&](const SearchPoint& other) {
    for (std::size_t i = 0; i < point.p.size(); ++i) {
      if (run.slots()[i].parameter.constant && other.p[i] != point.p[i]) return false;
    }
    return true;
  });
}

void sort(std::vector<SearchPoint>& points) {
  std::stable_sort(
      points.begin(), points.end(),
      [](const SearchPoint& a, const SearchPoint& b) { return a.error < b.error; });
}

// `p` with the best of the first lags from … to - 1.
SearchPoint with_best_lag(FreeRun& run, std::vector<double> p,
                          const std::vector<double>& lags_s, std::size_t from,
                          std::size_t to) {
  const std::optional<std::size_t> slot = first_lag_slot(run);
  SearchPoint best;
  for (std::size_t i = from; i < std::min(to, lags_s.size()); ++i) {
    if (slot) p[*slot] = lags_s[i];
    SearchPoint point = evaluate(run, p);
    if (i == from || point.error < best.error) best = std::move(point);
  }
  return best;
}

SearchPoint thoroughly(FreeRun& run, SearchPoint point) {
  point = polished(run, std::move(point));
  if (!has_trades(run)) return point;
  constexpr int kMostRounds = 2;
  constexpr double kGain = 0.99;
  for (int round = 0; round < kMostRounds; ++round) {
    point = evaluate(run, std::move(point.p));
    if (is_white(run.residual())) break;
    std::vector<SearchPoint> others = around(run, point, 4);
    each(run, others.size(), 1, [&](FreeRun& own, std::size_t i) {
      others[i] = screened(own, std::move(others[i]));
    });
    SearchPoint best = point;
    for (SearchPoint& other : others) {
      if (other.error < best.error) best = std::move(other);
    }
    if (!(best.error < kGain * point.error)) break;
    point = polished(run, std::move(best));
  }
  return point;
}

}  // namespace

SearchPoint search_on(FreeRun& run, SearchPoint point, Effort effort) {
  return off_edges(run, effort == Effort::kScreen ? screened(run, std::move(point))
                                                  : thoroughly(run, std::move(point)));
}

namespace {

bool is_delay(const SearchedParameter& parameter) {
  return parameter.unit == "s" && !parameter.logarithmic && !parameter.jumpy &&
         !parameter.instant && !parameter.initial;
}

}  // namespace

SearchPoint at_deepest_delay(FreeRun& run, SearchPoint point) {
  constexpr int kRows = 8;
  constexpr int kTimes = 3;
  constexpr int kIterations = 10;
  if (run.weight().empty()) return point;
  const double row_s = run.situation().period_s;
  for (std::size_t i = 0; i < point.p.size(); ++i) {
    if (!is_delay(run.slots()[i].parameter) ||
        !FreeRun::is_searched(run.slots(), point.p, i)) {
      continue;
    }
    for (int time = 0; time < kTimes; ++time) {
      const double here = std::round(point.p[i] / row_s);
      SearchPoint best = point;
      for (int row = -kRows; row <= kRows; ++row) {
        std::vector<double> p = point.p;
        p[i] = row_s * (here + row);
        SearchPoint other = evaluate(run, std::move(p));
        if (other.error < best.error) best = std::move(other);
      }
      if (!(best.error < point.error)) break;
      point = descend(run, std::move(best), kIterations, kNarrowStep);
    }
  }
  return point;
}

std::optional<std::size_t> first_lag_slot(const FreeRun& run) {
  if (run.integrating()) return std::nullopt;
  return 1;
}

namespace {

// A point and the squared error that it leaves on the whole recording.
struct WholePoint {
  SearchPoint point;
  double whole = 0;
};

WholePoint on_the_whole(FreeRun& run, std::vector<double> p) {
  WholePoint out{evaluate(run, std::move(p))};
  for (const double r : run.residual()) out.whole += r * r;
  return out;
}

}  // namespace

SearchPoint first_found(FreeRun& run, std::vector<double> p) {
  constexpr int kIterations = 20;
  constexpr double kFarLess = 0.5;
  std::vector<WholePoint> tried = {on_the_whole(run, p)};
  if (const auto slot = first_lag_slot(run)) {
    const SearchedParameter& parameter = run.slots()[*slot].parameter;
    for (double lag_s = parameter.low; lag_s < parameter.high; lag_s *= 2) {
      p[*slot] = lag_s;
      tried.push_back(on_the_whole(run, p));
    }
  }
  const auto error = [](const WholePoint& at) { return at.point.error; };
  const auto ended = [&run](const WholePoint& from) {
    return on_the_whole(run, descend(run, from.point, kIterations).p);
  };
  const auto closest = std::ranges::min_element(tried, {}, error);
  WholePoint best = ended(*closest);
  const double most = kFarLess * closest->whole;
  for (std::size_t i = 1; i + 1 < tried.size(); ++i) {
    const bool valley =
        error(tried[i]) < error(tried[i - 1]) && error(tried[i]) < error(tried[i + 1]);
    if (!valley || !(tried[i].whole < most)) continue;
    WholePoint other = ended(tried[i]);
    if (other.whole < kFarLess * best.whole) best = std::move(other);
  }
  return best.point;
}

std::vector<SearchPoint> judged(const FreeRun& run, const Starts& starts) {
  constexpr std::size_t kClosest = 20;
  constexpr std::size_t kAtOnce = 4;
  const std::size_t all = starts.lags_s.size();
  std::vector<SearchPoint> points(starts.p.size());
  each(run, points.size(), kAtOnce, [&](FreeRun& own, std::size_t i) {
    points[i] = with_best_lag(own, starts.p[i], starts.lags_s, 0, starts.few_lags);
  });
  sort(points);
  if (all <= starts.few_lags) return points;
  each(run, std::min(kClosest, points.size()), kAtOnce, [&](FreeRun& own, std::size_t i) {
    SearchPoint point =
        with_best_lag(own, points[i].p, starts.lags_s, starts.few_lags, all);
    if (point.error < points[i].error) points[i] = std::move(point);
  });
  sort(points);
  return points;
}

// Which of the forms that an effect may take is the right one shows late: one start of
// each is followed (at first sight of one more form), and the best of two are searched to
// the end.
SearchPoint followed(const FreeRun& run, ScreenedStarts& seen, Effort effort,
                     double hopeless_above) {
  const bool thorough = effort == Effort::kThorough;
  constexpr double kNearby = 1.5;
  const std::size_t most = thorough ? 5 : 3;
  std::vector<std::size_t> chosen;
  std::vector<SearchPoint> tried;
  for (std::size_t i = 0; i < seen.points.size(); ++i) {
    const bool new_form = (thorough || tried.size() == most) && tried.size() >= most &&
                          none_like(run, tried, seen.points[i]);
    if (tried.size() >= most && !new_form) continue;
    chosen.push_back(i);
    tried.push_back(seen.points[i]);
  }
  seen.valleys.resize(seen.points.size());
  each(run, tried.size(), 1, [&](FreeRun& own, std::size_t i) {
    std::optional<SearchPoint>& valley = seen.valleys[chosen[i]];
    if (!valley) valley = search_on(own, std::move(tried[i]), Effort::kScreen);
    tried[i] = *valley;
  });
  std::stable_sort(tried.begin(), tried.end(),
                   [&](const SearchPoint& a, const SearchPoint& b) {
                     return clearly_less(run, a, b);
                   });
  if (!thorough || tried[0].error > hopeless_above) return tried[0];
  std::vector<SearchPoint> ends = {tried[0]};
  const auto other =
      std::find_if(tried.begin(), tried.end(), [&](const SearchPoint& point) {
        return none_like(run, {&tried[0], 1}, point);
      });
  if (other != tried.end() && other->error < kNearby * tried[0].error) {
    ends.push_back(*other);
  }
  each(run, ends.size(), 1, [&](FreeRun& own, std::size_t i) {
    ends[i] = search_on(own, std::move(ends[i]), Effort::kThorough);
  });
  return ends.size() > 1 && clearly_less(run, ends[1], ends[0]) ? ends[1] : ends[0];
}

}  // namespace workbench
