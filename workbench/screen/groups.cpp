#include "workbench/screen/groups.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>

#include "workbench/recording/written_zone.hpp"
#include "workbench/screen/disjoint_sets.hpp"

namespace workbench {
namespace {

using Complex = std::complex<double>;

constexpr double kCyclesPerBlock = 2;
// Frequencies this close, times the common time, hold their phase.
constexpr double kSameFrequency = 0.75;
// Of two loops without any, this share would pass for company.
constexpr double kChance = 1e-3;
constexpr int kLags = 12;
// What a loop's valve, verdict and foresight weigh when the leader is chosen. What a loop
// foretells of the others says more about how fast its process is than about its valve.
constexpr double kSomeNats = 10;
constexpr double kOfBlame = 0.5;
constexpr double kOfForesight = 0.5;
constexpr int kMostCompared = 16;  // loops of a group that are weighed against each other

double end_of(const Rhythm& r) {
  return r.start_s + static_cast<double>(r.y.size()) * r.step_s;
}

// Fourier coefficient at `frequency` over [from, to), mean and slope taken off.
Complex coefficient(const Rhythm& r, const std::vector<float>& values, double frequency,
                    double from, double to) {
  const auto first = static_cast<std::size_t>(
      std::max(0.0, std::ceil((from - r.start_s) / r.step_s - 1e-6)));
  const auto last =
      std::min(values.size(),
               static_cast<std::size_t>(std::max(0.0, (to - r.start_s) / r.step_s)));
  if (last < first + 4) return {};
  const auto count = static_cast<double>(last - first);
  double sum = 0;
  double moment = 0;
  for (std::size_t i = first; i < last; ++i) {
    const double at = static_cast<double>(i - first) - (count - 1) / 2;
    sum += static_cast<double>(values[i]);
    moment += at * static_cast<double>(values[i]);
  }
  const double mean = sum / count;
  const double slope = 12 * moment / (count * (count * count - 1));
  Complex out;
  for (std::size_t i = first; i < last; ++i) {
    const double at = static_cast<double>(i - first) - (count - 1) / 2;
    const double t = r.start_s + (static_cast<double>(i) + 0.5) * r.step_s - from;
    const double value = static_cast<double>(values[i]) - mean - slope * at;
    out += value * std::polar(1.0, -2 * std::numbers::pi * frequency * t);
  }
  return out / count;
}

// The frequency of the highest peak near that of the detector.
double frequency_of(const Rhythm& r) {
  const double duration = static_cast<double>(r.y.size()) * r.step_s;
  const double guess = 1 / r.period_s;
  const double step = 0.125 / duration;
  double best = guess;
  double most = 0;
  for (double f = guess / 1.15; f <= guess * 1.15; f += step) {
    double power = 0;
    for (const auto* values : {&r.u, &r.y}) {
      const double size = std::abs(coefficient(r, *values, f, r.start_s, end_of(r)));
      double square = 0;
      double mean = 0;
      for (const float v : *values) mean += static_cast<double>(v);
      mean /= static_cast<double>(values->size());
      for (const float v : *values) {
        square += (static_cast<double>(v) - mean) * (static_cast<double>(v) - mean);
      }
      if (square > 0) power += size * size / square;
    }
    if (power > most) {
      most = power;
      best = f;
    }
  }
  return best;
}

// How two loops move at their common period.
struct Company {
  double coherence = 0;  // 0 … 1, over blocks of some cycles; 0 where not comparable
  double phase = 0;      // of the second behind the first, radians, of y
  double cycles = 0;     // compared
};

// 0 where their periods differ by more than the common time resolves, where they share
// fewer than kFewestCycles, or where their clocks are not one.
Company compare(const Rhythm& a, double fa, const Rhythm& b, double fb) {
  if (!of_one_clock(a, b)) return {};
  const double from = std::max(a.start_s, b.start_s);
  const double to = std::min(end_of(a), end_of(b));
  const double frequency = (fa + fb) / 2;
  Company out;
  out.cycles = (to - from) * frequency;
  if (out.cycles < kFewestCycles || std::abs(fa - fb) * (to - from) > kSameFrequency) {
    return out;
  }
  const double block = kCyclesPerBlock / frequency;
  for (const bool of_y : {true, false}) {
    Complex cross;
    double power_a = 0;
    double power_b = 0;
    for (double t = from; t + block <= to * (1 + 1e-12); t += block) {
      const Complex ca = coefficient(a, of_y ? a.y : a.u, frequency, t, t + block);
      const Complex cb = coefficient(b, of_y ? b.y : b.u, frequency, t, t + block);
      cross += ca * std::conj(cb);
      power_a += std::norm(ca);
      power_b += std::norm(cb);
    }
    if (!(power_a > 0 && power_b > 0)) continue;
    const double coherence = std::abs(cross) / std::sqrt(power_a * power_b);
    if (of_y) out.phase = std::arg(cross);
    out.coherence = std::max(out.coherence, coherence);
  }
  return out;
}

bool keep_company(const Company& company) {
  const double blocks = company.cycles / kCyclesPerBlock;
  const double by_chance =
      std::sqrt(1 - std::pow(kChance, 1 / std::max(blocks - 1, 1.0)));
  return company.coherence > std::max(kLeastCoherence, by_chance);
}

bool valve_is_blamed(const ScreenedLoop& loop) {
  return loop.verdict == "stiction" || loop.verdict == "backlash";
}

// Own evidence, nats, that the valve sticks: of a band, and of the fitted stem. A loop
// that is shaken may have either, seldom as much, and seldom both.
double own_evidence(const ScreenedLoop& loop) {
  const double nats = std::isfinite(loop.nats) ? loop.nats : 0;
  const double stem = std::isfinite(loop.stem_nats) ? loop.stem_nats : 0;
  return std::max(0.0, nats) + std::max(0.0, stem);
}

class Grouper {
 public:
  explicit Grouper(std::vector<ScreenedLoop>& loops) : loops_(loops) {}

  void run() {
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      const Rhythm& r = loops_[i].rhythm;
      if (!loops_[i].error.empty() || !(r.period_s > 0) || r.y.size() < 64) continue;
      heard_.push_back({i, frequency_of(r)});
    }
    std::ranges::sort(heard_, [](const Heard& a, const Heard& b) {
      return a.frequency < b.frequency || (a.frequency == b.frequency && a.loop < b.loop);
    });
    together_ = DisjointSets(heard_.size());
    join();
    settle();
  }

 private:
  struct Heard {
    std::size_t loop;
    double frequency;
  };

  void join() {
    for (std::size_t i = 0; i < heard_.size(); ++i) {
      const Rhythm& a = loops_[heard_[i].loop].rhythm;
      const double reach = kSameFrequency / std::max(kFewestCycles * a.period_s, 1e-12);
      for (std::size_t j = i + 1; j < heard_.size(); ++j) {
        if (heard_[j].frequency - heard_[i].frequency > reach) break;
        if (together_.root(i) == together_.root(j)) continue;
        const Rhythm& b = loops_[heard_[j].loop].rhythm;
        if (keep_company(compare(a, heard_[i].frequency, b, heard_[j].frequency))) {
          together_.join(i, j);
        }
      }
    }
  }

  void settle() {
    std::vector<std::vector<std::size_t>> groups(heard_.size());
    for (std::size_t i = 0; i < heard_.size(); ++i)
      groups[together_.root(i)].push_back(i);
    std::erase_if(groups, [](const auto& group) { return group.size() < 2; });
    std::vector<std::pair<double, std::size_t>> order;
    std::vector<std::size_t> leaders;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      leaders.push_back(leader_of(groups[g]));
      order.emplace_back(-loops_[heard_[leaders[g]].loop].cost, g);
    }
    std::ranges::sort(order);
    int number = 0;
    for (const auto& [cost, g] : order) mark(groups[g], leaders[g], ++number);
  }

  std::size_t leader_of(std::vector<std::size_t>& group) {
    // The ones with the most evidence are weighed against each other.
    std::ranges::sort(group, [this](std::size_t a, std::size_t b) {
      const ScreenedLoop& la = loops_[heard_[a].loop];
      const ScreenedLoop& lb = loops_[heard_[b].loop];
      return std::pair(-own_evidence(la), la.loop) <
             std::pair(-own_evidence(lb), lb.loop);
    });
    const std::size_t count = std::min<std::size_t>(group.size(), kMostCompared);
    std::vector<double> score(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
      const ScreenedLoop& a = loops_[heard_[group[i]].loop];
      score[i] += kOfBlame * (valve_is_blamed(a) ? 1 : 0) +
                  std::log(1 + own_evidence(a) / kSomeNats);
      for (std::size_t j = 0; j < i; ++j) {
        const ScreenedLoop& b = loops_[heard_[group[j]].loop];
        const double there = explained_by(a.rhythm, b.rhythm);
        const double back = explained_by(b.rhythm, a.rhythm);
        const double net = (there - back) / (there + back + 20);
        score[i] += kOfForesight * net / static_cast<double>(count - 1);
        score[j] -= kOfForesight * net / static_cast<double>(count - 1);
      }
    }
    const auto best = std::ranges::max_element(score);
    return group[static_cast<std::size_t>(best - score.begin())];
  }

  void mark(const std::vector<std::size_t>& group, std::size_t leader, int number) {
    ScreenedLoop& first = loops_[heard_[leader].loop];
    const bool valve = valve_is_blamed(first);
    for (const std::size_t i : group) {
      ScreenedLoop& loop = loops_[heard_[i].loop];
      loop.group = number;
      if (i == leader) {
        loop.leads = true;
        loop.group_is = valve ? "valve" : "not_a_valve";
        continue;
      }
      const Company company = compare(first.rhythm, heard_[leader].frequency, loop.rhythm,
                                      heard_[i].frequency);
      const double turn = company.phase / (2 * std::numbers::pi);
      loop.lag_s = (turn < 0 ? turn + 1 : turn) / heard_[leader].frequency;
    }
  }

  std::vector<ScreenedLoop>& loops_;
  std::vector<Heard> heard_;
  DisjointSets together_{0};
};

}  // namespace

double explained_by(const Rhythm& leader, const Rhythm& follower) {
  if (!of_one_clock(leader, follower) || leader.y.empty() || follower.y.empty()) {
    return 0;
  }
  const auto at_time = [&leader](double t) -> std::optional<std::size_t> {
    const double at = (t - leader.start_s) / leader.step_s;
    if (!(at >= 0 && at < static_cast<double>(leader.y.size()))) return std::nullopt;
    return static_cast<std::size_t>(at);
  };
  constexpr int kOwn = 2 * kLags + 1;
  constexpr int kAll = kOwn + 2 * kLags;
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(kAll + 1, kAll + 1);
  Eigen::VectorXd row(kAll + 1);
  double rows = 0;
  const auto scaled = [](const std::vector<float>& values) {
    Eigen::VectorXd out(static_cast<Eigen::Index>(values.size()));
    for (std::size_t i = 0; i < values.size(); ++i) {
      out[static_cast<Eigen::Index>(i)] = static_cast<double>(values[i]);
    }
    out.array() -= out.mean();
    const double size = out.norm() / std::sqrt(static_cast<double>(out.size()));
    if (size > 0) out /= size;
    return out;
  };
  const Eigen::VectorXd fu = scaled(follower.u);
  const Eigen::VectorXd fy = scaled(follower.y);
  const Eigen::VectorXd lu = scaled(leader.u);
  const Eigen::VectorXd ly = scaled(leader.y);
  for (std::size_t k = kLags; k < follower.y.size(); ++k) {
    // What the leader had done when this step of the follower began.
    const double begin = follower.start_s + static_cast<double>(k) * follower.step_s;
    const auto now = at_time(begin - 0.5 * leader.step_s);
    if (!now || *now + 1 < kLags) continue;
    for (int lag = 1; lag <= kLags; ++lag) {
      const auto own = static_cast<Eigen::Index>(k) - lag;
      row[lag - 1] = fy[own];
      row[kLags + lag - 1] = fu[own];
      const auto other = static_cast<Eigen::Index>(*now) - (lag - 1);
      row[kOwn + lag - 1] = ly[other];
      row[kOwn + kLags + lag - 1] = lu[other];
    }
    row[2 * kLags] = 1;
    row[kAll] = fy[static_cast<Eigen::Index>(k)];
    gram.selfadjointView<Eigen::Lower>().rankUpdate(row);
    rows += 1;
  }
  if (rows < 4 * kAll) return 0;
  const auto error = [&gram, rows](int columns) {
    Eigen::MatrixXd a = gram.topLeftCorner(columns, columns);
    a.triangularView<Eigen::StrictlyUpper>() = a.transpose();
    a.diagonal().array() += 1e-6 * rows;
    const Eigen::VectorXd b = gram.row(kAll).head(columns).transpose();
    const Eigen::VectorXd solved = a.ldlt().solve(b);
    return std::max(gram(kAll, kAll) - b.dot(solved), 1e-9 * rows);
  };
  const double nats = rows / 2 * std::log(error(kOwn) / error(kAll)) -
                      static_cast<double>(kAll - kOwn) / 2 * std::log(rows);
  return std::max(nats, 0.0);
}

void find_groups(std::vector<ScreenedLoop>& loops) {
  Grouper(loops).run();
}

void note_zones(std::vector<ScreenedLoop>& loops) {
  std::map<std::string, const Rhythm*> zones;
  for (const ScreenedLoop& loop : loops) {
    const Rhythm& r = loop.rhythm;
    if (r.period_s > 0 && r.clock.empty()) zones.try_emplace(r.zone, &r);
  }
  for (ScreenedLoop& loop : loops) {
    if (!(loop.rhythm.period_s > 0 && loop.rhythm.clock.empty())) continue;
    std::string others;
    for (const auto& [zone, rhythm] : zones) {
      if (of_one_clock(loop.rhythm, *rhythm)) continue;
      others += (others.empty() ? "" : ", ") + zone_words(zone);
    }
    if (others.empty()) continue;
    loop.notes.push_back("the times have " + zone_words(loop.rhythm.zone) +
                         ", those of other loops " + others +
                         ": not compared with these in time; export all times in one "
                         "zone, or with offsets, as 14:30:00+08:00");
  }
}

// A neighbour is shaken rather than sick; what it costs to leave it, its leader costs.
constexpr double kOfFollower = 0.6;
constexpr double kPerFollower = 0.1;

void share_costs(std::vector<ScreenedLoop>& loops) {
  std::map<int, int> followers;
  for (const ScreenedLoop& loop : loops) {
    if (loop.group > 0 && !loop.leads) ++followers[loop.group];
  }
  std::set<int> led_by_valve;
  for (ScreenedLoop& loop : loops) {
    if (!loop.leads || loop.group_is != "valve") continue;
    led_by_valve.insert(loop.group);
    loop.cost = std::min(100.0, loop.cost * (1 + kPerFollower * followers[loop.group]));
  }
  for (ScreenedLoop& loop : loops) {
    if (loop.leads || !led_by_valve.contains(loop.group)) continue;
    loop.cost *= kOfFollower;
    loop.suspicion *= kOfFollower;
  }
}

}  // namespace workbench
