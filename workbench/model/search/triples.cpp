#include "workbench/model/search/triples.hpp"

#include <algorithm>
#include <utility>

#include "workbench/model/base/noise.hpp"
#include "workbench/model/judge/intervals.hpp"
#include "workbench/model/judge/merit.hpp"
#include "workbench/model/judge/off_profile.hpp"

namespace workbench {
namespace {

constexpr double kMostLeft = 0.25;   // of the squared error, beside a pair
constexpr std::size_t kWidened = 3;  // pairs that get a third
constexpr std::size_t kPursued = 4;  // thirds that are searched to the end
constexpr std::size_t kAnew = 6;     // beside which the stem of a pair is looked for anew
constexpr std::uint64_t kShare = 3;  // of what may be simulated yet, for thirds
constexpr double kLeastGain = 0.9;   // squared error with the third, of without

// One third beside one pair.
struct Try {
  const Trial* pair = nullptr;
  const Effect* third = nullptr;
  std::optional<Fit> fit = {};
  std::optional<Fit> others = {};  // without the stem, where the third helps there
};

double error_of(const Try& one) {
  return one.fit ? one.fit->error : 0;
}

// A step up and one down show how each of them is answered: two shapes.
bool moves_for_three(const Situation& s) {
  return count_moves(s.u, s.u_span() / 8) > 2;
}

// One load that follows slow noise is enough.
bool is_second_load(const Trial& pair, const Effect& third) {
  const auto is_load = [](const Effect* effect) {
    return effect->description().is_unmeasured_load();
  };
  return is_load(&third) && (is_load(pair.effect) || is_load(pair.partner));
}

const Effect* stem_of(const Trial& pair) {
  for (const Effect* member : members_of(pair)) {
    if (member->description().sticks) return member;
  }
  return nullptr;
}

// Since a stem that was found without the third is another one: the stem beside the other
// two, where those are the closest of all that the third helps without it.
void look_for_stems_anew(const Fitter& fitter, std::vector<Try>& tries) {
  std::vector<Try*> closest;
  for (Try& one : tries) {
    if (one.others) closest.push_back(&one);
  }
  std::ranges::stable_sort(closest, {},
                           [](const Try* one) { return one->others->error; });
  closest.resize(std::min(kAnew, closest.size()));
  fitter.work().for_each(closest.size(), [&](std::size_t i) {
    Try& one = *closest[i];
    auto anew = fitter.extend(*one.others, *stem_of(*one.pair), Effort::kScreen);
    if (anew && (!one.fit || anew->error < one.fit->error)) one.fit = std::move(anew);
  });
}

std::vector<Try> tries_of(const Fitter& fitter, const std::vector<Trial>& trials,
                          const std::vector<Trial>& pairs) {
  std::vector<Try> tries;
  std::vector<std::optional<Fit>> without_stem(pairs.size());
  for (std::size_t i = 0; i < std::min(kWidened, pairs.size()); ++i) {
    if (const Effect* stem = stem_of(pairs[i])) {
      without_stem[i] = fitter.without(*pairs[i].fit, *stem);
    }
    for (const Trial& trial : trials) {
      if (trial.partner != nullptr || !trial.fit || is_member(trial, pairs[i]) ||
          is_second_load(pairs[i], *trial.effect)) {
        continue;
      }
      tries.push_back({.pair = &pairs[i], .third = trial.effect});
    }
  }
  const std::uint64_t keep = fitter.samples_left() - fitter.samples_left() / kShare;
  constexpr std::size_t kAtOnce = 8;
  for (std::size_t from = 0; from < tries.size(); from += kAtOnce) {
    if (fitter.samples_left() < keep) break;
    const std::size_t count = std::min(kAtOnce, tries.size() - from);
    fitter.work().for_each(count, [&](std::size_t i) {
      Try& one = tries[from + i];
      one.fit = fitter.extend(*one.pair->fit, *one.third, Effort::kScreen);
      const auto& rest = without_stem[static_cast<std::size_t>(one.pair - pairs.data())];
      if (!rest) return;
      one.others = fitter.extend(*rest, *one.third, Effort::kScreen);
      if (one.others && one.others->error > kLeastGain * rest->error) one.others.reset();
    });
  }
  look_for_stems_anew(fitter, tries);
  std::erase_if(tries, [](const Try& one) { return !one.fit; });
  return tries;
}

}  // namespace

Trial in_told_order(std::vector<const Effect*> members, Fit fit) {
  std::ranges::stable_sort(members, [](const Effect* a, const Effect* b) {
    return a->description().is_told_before(b->description());
  });
  Trial out;
  out.effect = members[0];
  out.partner = members[1];
  out.third = members.size() > 2 ? members[2] : nullptr;
  out.fit = std::move(fit);
  return out;
}

bool each_is_needed(const Fitter& fitter, Trial& trial) {
  const FitIntervals intervals = intervals_of(fitter, *trial.fit);
  for (const Effect* member : members_of(trial)) {
    if (!is_possible(fitter, *trial.fit, *member) ||
        !excludes_off(fitter, *trial.fit, intervals, *member)) {
      return false;
    }
    const Fit rest = fitter.without(*trial.fit, *member);
    if (!lowers_error(fitter, rest, *trial.fit)) return false;
    if (!is_bent(member->description())) continue;
    const DifferenceTest ahead =
        test_given_past(rest.residual, trial.fit->residual,
                        fitter.situation(*trial.fit).u, fitter.blocks());
    if (!is_seen(ahead)) return false;
    trial.test.p_value = std::max(trial.test.p_value, ahead.p_value);
    if (member->description().sticks) trial.p_ahead = ahead.p_value;
  }
  return true;
}

std::vector<Trial> triples_of(const Fitter& fitter, const Fit& base,
                              const std::vector<Trial>& trials,
                              std::vector<Trial> pairs) {
  std::stable_sort(pairs.begin(), pairs.end(), [](const Trial& a, const Trial& b) {
    return a.fit->error < b.fit->error;
  });
  if (pairs.empty() || !(pairs[0].fit->error < kMostLeft * base.error) ||
      is_noise(pairs[0].fit->residual) || !moves_for_three(fitter.situation(base))) {
    return {};
  }
  std::vector<Try> tries = tries_of(fitter, trials, pairs);
  std::ranges::stable_sort(tries, {}, error_of);
  const std::size_t tried = tries.size();
  const double least = kLeastGain * pairs[0].fit->error;
  std::erase_if(tries, [least](const Try& one) { return error_of(one) >= least; });
  tries.resize(std::min(kPursued, tries.size()));
  if (tries.empty()) return {};
  fitter.work().for_each(
      tries.size(), [&](std::size_t i) { tries[i].fit = fitter.refine(*tries[i].fit); });
  std::ranges::stable_sort(tries, {}, error_of);
  const Try& best = tries[0];
  Trial triple = in_told_order({best.pair->effect, best.pair->partner, best.third},
                               fitter.reconsider(*best.fit, nullptr));
  examine(fitter, base, triple);
  triple.visible = u_is_seen(fitter, *triple.fit);
  if (!each_is_needed(fitter, triple)) return {};
  triple.test.p_value = std::min(1.0, triple.test.p_value * static_cast<double>(tried));
  std::vector<Trial> out;
  out.push_back(std::move(triple));
  return out;
}

}  // namespace workbench
