#include "workbench/model/search/pairs.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

#include "workbench/effects/effects.hpp"
#include "workbench/model/base/noise.hpp"
#include "workbench/model/judge/merit.hpp"
#include "workbench/model/search/known_first.hpp"

namespace workbench {
namespace {

constexpr double kLeastGain = 0.98;  // squared error with what adds something, of without
constexpr double kFarLess = 0.5;     // than any leaves alone
constexpr std::size_t kClosestPairs = 3;
constexpr std::size_t kPaired = 5;         // candidates that are tried in pairs
constexpr std::size_t kPairedWithAll = 2;  // and, where those leave more than noise
constexpr std::uint64_t kShare = 3;        // of what may be simulated yet, for pairs

// Of those that fit alike, what is in the process comes before what may be elsewhere:
// alone they are the same, but the next effect acts before one and behind the other.
void process_first(std::vector<const Trial*>& order) {
  constexpr double kAlike = 1.001;
  for (auto at = order.begin(); at != order.end(); ++at) {
    if (is_in_process(**at)) continue;
    const double most = kAlike * (*at)->fit->error;
    const auto better = std::find_if(at, order.end(), [most](const Trial* trial) {
      return trial->fit->error > most || is_in_process(*trial);
    });
    if (better == order.end() || (*better)->fit->error > most) continue;
    std::rotate(at, better, better + 1);
  }
}

bool first_lag_is_longest(const Fit& fit) {
  constexpr double kAtBound = 0.99;
  for (std::size_t i = 0; i < fit.slots.size(); ++i) {
    const SearchedParameter& parameter = fit.slots[i].parameter;
    if (fit.slots[i].effect == nullptr && parameter.name == "first_lag") {
      return fit.p[i] >= kAtBound * parameter.high;
    }
  }
  return false;
}

bool stores(const Trial& pair) {
  const Effect* const integrating = &effects::process_integrating();
  return pair.effect == integrating || pair.partner == integrating;
}

bool is_of_recorded(const Trial& pair) {
  return has_recorded_load(members_of(pair));
}

bool can_be_alone(const Trial* trial) {
  return trial->objection.empty() && !trial->edge;
}

// Pairs of the fitted trials, best first: what they came to, tried one after the other.
class PairSearch {
 public:
  PairSearch(const Fitter& fitter, const Fit& base, const std::vector<Trial>& trials,
             double hopeless_above)
      : fitter_(fitter),
        hides_below_(kLeastGain * base.error),
        never_settles_(first_lag_is_longest(base)),
        keep_(fitter.samples_left() - fitter.samples_left() / kShare) {
    for (const Trial& trial : trials) {
      if (trial.fit) order_.push_back(&trial);
    }
    std::sort(order_.begin(), order_.end(), fits_better);
    process_first(order_);
    // What does not come near the best single one explains nothing that it does not; what
    // cannot be alone, however well it fits, is no measure.
    constexpr double kNear = 1.2;
    const auto best = std::find_if(order_.begin(), order_.end(), can_be_alone);
    useful_ = order_.empty() ? 0 : hopeless_above;
    if (best != order_.end()) closest_alone_ = (*best)->fit->error;
    useful_ = std::min(useful_, kNear * closest_alone_);
  }

  // The closest pairs, at first sight.
  std::vector<Trial> screened() {
    const std::size_t few = std::min(kPaired, order_.size());
    for (std::size_t i = 0; i < few; ++i) {
      for (std::size_t j = i + 1; j < few; ++j) ask(i, j);
    }
    // (W20) Neither shows alone; nor does either of a position behind a drive.
    ask_of_integrators([](const Effect& e) {
      return e.description().recorded || &e == &effects::process_second_lag();
    });
    try_waiting();
    // Some effects show only beside another.
    for (const std::size_t i : to_pair_with_all(few)) {
      if (had_their_share()) break;
      for (std::size_t j = 0; j < order_.size(); ++j) {
        if (j >= few || i >= few) ask(std::min(i, j), std::max(i, j));
      }
      try_waiting();
    }
    std::stable_sort(pairs_.begin(), pairs_.end(), [](const Trial& a, const Trial& b) {
      return total_error(*a.fit) < total_error(*b.fit);
    });
    std::stable_partition(pairs_.begin(), pairs_.end(),
                          [this](const Trial& pair) { return may_be(pair); });
    std::vector<Trial> storing;
    if (never_settles_) std::ranges::copy_if(pairs_, std::back_inserter(storing), stores);
    std::optional<Trial> known = of_known_cause();
    if (pairs_.size() > kClosestPairs) pairs_.resize(kClosestPairs);
    constexpr double kFarBehind = 1.5;
    std::erase_if(pairs_, [most = pairs_.empty() ? 0 : kFarBehind * pairs_[0].fit->error](
                              const Trial& pair) { return pair.fit->error > most; });
    std::vector<Trial> closest = std::move(pairs_);
    if (known && std::ranges::none_of(closest, is_of_recorded)) {
      closest.push_back(std::move(*known));
    }
    if (never_settles_) {
      std::optional<Trial> pair = best_storing(std::move(storing));
      if (pair && std::ranges::none_of(closest, stores)) {
        closest.push_back(std::move(*pair));
      }
    }
    return closest;
  }

  // Whether pairs have had their share of what may be simulated.
  [[nodiscard]] bool had_their_share() const { return fitter_.samples_left() < keep_; }

  // The trial of one effect alone.
  [[nodiscard]] const Trial& alone(const Effect* effect) const {
    return **std::find_if(order_.begin(), order_.end(), [effect](const Trial* trial) {
      return trial->effect == effect;
    });
  }

 private:
  void ask(std::size_t i, std::size_t j) {
    if (asked_.emplace(i, j).second) waiting_.emplace_back(i, j);
  }

  // The integrator with each effect that `beside` says, however far back both are.
  template <class Beside>
  void ask_of_integrators(const Beside& beside) {
    for (std::size_t i = 0; i < order_.size(); ++i) {
      if (order_[i]->effect != &effects::process_integrating()) continue;
      for (std::size_t j = 0; j < order_.size(); ++j) {
        if (j != i && beside(*order_[j]->effect)) ask(std::min(i, j), std::max(i, j));
      }
    }
  }

  // Where a load that nobody measured fits best: the closest with a recorded one, which
  // may be told in its place. `pairs_` are sorted.
  [[nodiscard]] std::optional<Trial> of_known_cause() const {
    if (pairs_.empty() || !has_unknown_cause(members_of(pairs_[0]))) return std::nullopt;
    constexpr double kMost = 4;  // known_first() judges when both are searched to the end
    const auto found = std::ranges::find_if(pairs_, [this](const Trial& pair) {
      return is_of_recorded(pair) && may_be(pair);
    });
    const bool near =
        found != pairs_.end() && found->fit->error < kMost * pairs_[0].fit->error;
    return near ? std::optional(*found) : std::nullopt;
  }

  // (W25) Where the first lag is as long as it may be: the integrator and what holds it
  // back, which show only together, if they leave far less than any effect alone.
  // `pairs`: those that were tried before.
  std::optional<Trial> best_storing(std::vector<Trial> pairs) {
    pairs_ = std::move(pairs);
    ask_of_integrators([](const Effect&) { return true; });
    try_waiting();
    std::erase_if(pairs_, [this](const Trial& pair) { return !may_be(pair); });
    const auto best = std::ranges::min_element(
        pairs_, {}, [](const Trial& pair) { return total_error(*pair.fit); });
    if (best == pairs_.end() || best->fit->error > kFarLess * closest_alone_) {
      return std::nullopt;
    }
    return std::move(*best);
  }

  // None where a pair that may be it leaves noise; else the best few, the loads, recorded
  // or not, which hide more than others do, a limit that the recording shows by itself,
  // and those that would leave noise beside one that it cannot be: the right partner may
  // be further back.
  std::vector<std::size_t> to_pair_with_all(std::size_t few) const {
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < std::min(kPairedWithAll, few); ++i) out.push_back(i);
    for (std::size_t i = kPairedWithAll; i < few; ++i) {
      const Effect* effect = order_[i]->effect;
      if (is_slow_load(*effect) || effect->description().recorded) out.push_back(i);
    }
    for (std::size_t i = few; i < order_.size(); ++i) {
      if (order_[i]->own && order_[i]->effect->description().limits) out.push_back(i);
    }
    for (const Trial& pair : pairs_) {
      if (!is_noise(pair.fit->residual)) continue;
      if (may_be(pair)) return {};
      for (std::size_t i = 0; i < few; ++i) {
        const bool member =
            order_[i]->effect == pair.effect || order_[i]->effect == pair.partner;
        if (member && std::find(out.begin(), out.end(), i) == out.end()) out.push_back(i);
      }
    }
    return out;
  }

  bool may_be(const Trial& pair) const {
    return is_possible(fitter_, *pair.fit, *pair.effect) &&
           is_possible(fitter_, *pair.fit, *pair.partner);
  }

  // The second beside the first. A stem that was found without the load is another one,
  // so beside a load that explains something it is looked for, too; and a recorded load,
  // which moves with u often enough to have bent what was found without it, is not the
  // one that an integrator holds.
  std::optional<Fit> together(const Trial& one, const Trial& other) const {
    auto fit = fitter_.extend(*one.fit, *other.effect, Effort::kScreen);
    const Description& of = other.effect->description();
    const bool hides = of.is_load() && other.fit->error < hides_below_;
    const bool is_hidden = hides && (of.recorded || one.effect->description().sticks);
    const bool is_load_stored = one.effect->description().recorded &&
                                other.effect == &effects::process_integrating();
    if (!is_hidden && !is_load_stored) return fit;
    auto beside = fitter_.extend(*other.fit, *one.effect, Effort::kScreen);
    const bool better = beside && (!fit || beside->error < fit->error);
    return better ? std::move(beside) : std::move(fit);
  }

  void try_waiting() {
    std::vector<Trial> tried(waiting_.size());
    fitter_.work().for_each(waiting_.size(), [&](std::size_t k) {
      const auto [i, j] = waiting_[k];
      tried[k].effect = order_[i]->effect;
      tried[k].partner = order_[j]->effect;
      tried[k].fit = together(*order_[i], *order_[j]);
    });
    for (std::size_t k = 0; k < waiting_.size(); ++k) {
      const Trial& first = *order_[waiting_[k].first];
      const double alone = first.fit->error;
      const bool gains = tried[k].fit && (tried[k].fit->error < kLeastGain * alone ||
                                          stands_in(fitter_, *first.fit, *tried[k].fit));
      if (gains && tried[k].fit->error < useful_) {
        pairs_.push_back(std::move(tried[k]));
      }
    }
    waiting_.clear();
  }

  const Fitter& fitter_;
  double hides_below_;
  bool never_settles_;
  std::uint64_t keep_;  // samples, for the steps that follow
  std::vector<const Trial*> order_;
  double closest_alone_ = std::numeric_limits<double>::infinity();
  double useful_ = 0;
  std::set<std::pair<std::size_t, std::size_t>> asked_;
  std::vector<std::pair<std::size_t, std::size_t>> waiting_;
  std::vector<Trial> pairs_;
};

// Two loads that do not swing make a curve that follows most slow noise: each has to
// stand out from what the other one takes away, too.
double two_loads_by_chance(const Fitter& fitter, const Trial& pair) {
  double p_value = 0;
  for (const Effect* member : {pair.effect, pair.partner}) {
    const Effect* const other = member == pair.effect ? pair.partner : pair.effect;
    std::vector<double> noise = pair.fit->residual;
    fitter.add_loads(*pair.fit, 1, noise, other);
    Situation here = fitter.situation(*pair.fit);
    here.residual = noise;
    p_value = std::max(p_value, member->noise_test(here, pair.fit->searched_of(*member),
                                                   pair.fit->solved_of(*member)));
  }
  return p_value;
}

// Whether one of the two adds nothing to the other. A load and what bends it imitate one
// another: what bends must be seen beside the other one sample ahead, and the pair is as
// likely by chance as that.
bool has_idle_member(const Fitter& fitter, const PairSearch& search, Trial& pair) {
  for (const Effect* member : {pair.effect, pair.partner}) {
    const Effect* const other = member == pair.effect ? pair.partner : pair.effect;
    const Trial& alone = search.alone(member);
    if (stands_in(fitter, *alone.fit, *pair.fit)) continue;
    if (!lowers_error(fitter, *alone.fit, *pair.fit)) return true;
    if (!is_bent(member->description())) continue;
    const DifferenceTest ahead =
        test_given_past(search.alone(other).fit->residual, pair.fit->residual,
                        fitter.situation(*pair.fit).u, fitter.blocks());
    if (!is_seen(ahead)) return true;
    pair.test.p_value = std::max(pair.test.p_value, ahead.p_value);
  }
  return false;
}

}  // namespace

std::vector<Trial> pairs_of(const Fitter& fitter, const Fit& base,
                            const std::vector<Trial>& trials, double hopeless_above,
                            std::vector<Trial>& closest) {
  PairSearch search(fitter, base, trials, hopeless_above);
  std::vector<Trial> pairs = search.screened();
  fitter.settle_stems();
  fitter.work().for_each(
      pairs.size(), [&](std::size_t i) { pairs[i].fit = fitter.refine(*pairs[i].fit); });
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Trial& a, const Trial& b) { return fits_better(&a, &b); });
  // Beside many effects this costs more than all that went before.
  const auto reconsider = [&](std::size_t i) {
    pairs[i].fit = fitter.reconsider(std::move(*pairs[i].fit), nullptr);
  };
  if (!pairs.empty()) reconsider(0);
  if (!search.had_their_share() && pairs.size() > 1) {
    fitter.work().for_each(pairs.size() - 1, [&](std::size_t i) { reconsider(i + 1); });
  }
  for (Trial& pair : pairs) {
    if (pair.partner->description().is_told_before(pair.effect->description())) {
      std::swap(pair.effect, pair.partner);
    }
  }
  closest = pairs;
  std::erase_if(pairs, [&](Trial& pair) {
    examine(fitter, base, pair);
    if (is_slow_load(*pair.effect) && is_slow_load(*pair.partner)) {
      pair.test.p_value = std::max(pair.test.p_value, two_loads_by_chance(fitter, pair));
    }
    pair.visible = u_is_seen(fitter, *pair.fit);
    return has_idle_member(fitter, search, pair);
  });
  return pairs;
}

}  // namespace workbench
