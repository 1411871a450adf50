#include "workbench/model/search/told_ahead.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>
#include <string>
#include <utility>

#include "workbench/effects/common.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/base/least_squares.hpp"
#include "workbench/model/judge/intervals.hpp"
#include "workbench/model/judge/merit.hpp"
#include "workbench/model/search/choice.hpp"
#include "workbench/model/search/unsupported.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

constexpr double kWanders = 0.5;     // predictable share of what is left
constexpr double kAsLikelyNats = 3;  // by which a rival may foretell less
constexpr std::array kFirstLags = {0.5, 0.1, 0.03, 0.01, 0.003, 0.001};  // of the longest

// A fit and how likely it makes the output, one sample ahead.
struct Ahead {
  Fit fit;
  NoiseColour colour;
  double fitted = 0;            // nats, on the samples that were fitted
  std::vector<double> judging;  // in each block that judges

  [[nodiscard]] double judged() const { return sum_of(judging); }
  [[nodiscard]] double nats() const { return fitted + judged(); }
  static double sum_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
  }
};

// Huber (1964): what is far out weighs by its size, not by its square. One outlier is no
// proof of anything.
double cost(double squared, double variance) {
  constexpr double kFar = 3;
  const double z = std::sqrt(squared / variance);
  return z < kFar ? z * z : kFar * (2 * z - kFar);
}

// The variance is that of the fitted samples.
Ahead ahead_of(const Fitter& fitter, Fit fit) {
  Ahead out;
  out.colour = colour_of(fit.residual);
  const std::vector<double> e = whitened(out.colour, fit.residual);
  const auto known = [&](const Block& block) {
    const std::size_t first = std::max(block.first, block.piece + out.colour.a.size());
    return std::span(e).subspan(first, block.last - std::min(first, block.last));
  };
  double squares = 0;
  double count = 0;
  for (const Block& block : fitter.blocks().blocks()) {
    if (!block.estimation) continue;
    squares += dot(known(block), known(block));
    count += static_cast<double>(known(block).size());
  }
  out.fit = std::move(fit);
  if (!(squares > 0)) return out;
  const double variance = squares / count;
  for (const Block& block : fitter.blocks().blocks()) {
    double nats = 0;
    for (const double v : known(block)) {
      nats -= 0.5 * (std::log(variance) + cost(v * v, variance));
    }
    if (block.estimation) {
      out.fitted += nats;
    } else {
      out.judging.push_back(nats);
    }
  }
  return out;
}

// Fitted under the colour of what it leaves, in rounds.
Ahead likeliest(const Fitter& fitter, const Fit& start) {
  constexpr int kRounds = 6;
  constexpr double kGain = 0.2;  // nats
  Ahead best = ahead_of(fitter, start);
  for (int round = 0; round < kRounds; ++round) {
    Fit from = best.fit;
    from.weight = best.colour.a;
    Ahead next = ahead_of(fitter, fitter.refine(from));
    const double gain = next.fitted - best.fitted;
    if (round == 0 || gain > 0) best = std::move(next);
    if (round > 0 && gain < kGain) break;
  }
  return best;
}

void take_better(Ahead& best, Ahead other) {
  if (other.fitted > best.fitted) best = std::move(other);
}

// The model as it is, from several first lags: what it lacks must not owe its evidence to
// a search that ended elsewhere.
Ahead without_any(const Fitter& fitter, const Fit& base) {
  Ahead best = likeliest(fitter, base);
  const Fit first = best.fit;
  std::vector<std::optional<Ahead>> others(kFirstLags.size());
  fitter.work().for_each(others.size(), [&](std::size_t k) {
    Fit other = first;
    for (std::size_t i = 0; i < other.p.size(); ++i) {
      const SearchedParameter& parameter = other.slots[i].parameter;
      if (other.slots[i].effect != nullptr || parameter.name != "first_lag") continue;
      other.p[i] = parameter.high * kFirstLags[k];
      others[k] = likeliest(fitter, other);
    }
  });
  for (std::optional<Ahead>& other : others) {
    if (other) take_better(best, std::move(*other));
  }
  return best;
}

Ahead with_one(const Fitter& fitter, const Ahead& alone, const Fit& start,
               const Effect& effect) {
  Ahead best = likeliest(fitter, start);
  if (const auto beside = fitter.extend(alone.fit, effect, Effort::kScreen)) {
    take_better(best, likeliest(fitter, *beside));
  }
  return best;
}

// What was found with it may serve the model without it as well.
void take_back(const Fitter& fitter, const Ahead& with, const Effect& effect,
               Ahead& alone) {
  if (with.fitted > alone.fitted + kAsLikelyNats) {
    take_better(alone, likeliest(fitter, fitter.without(with.fit, effect)));
  }
}

// What lies between u and the reading. A stem, or a limit of its speed, shows where it
// acts, in the free run, too; and what wanders as slowly as the load, as another column,
// a drift or an integrator's sum does, looks like it by chance one sample ahead, too. A
// stem that sticks makes the output slower one way than the other.
bool is_asked(const Trial& trial) {
  const Description& effect = trial.effect->description();
  return trial.partner == nullptr && trial.fit && !effect.is_load() &&
         !effect.is_stem() && effect.place != Place::kRate &&
         effect.place != Place::kRecord &&
         trial.effect != &effects::process_integrating() &&
         trial.effect != &effects::process_directional_lag() &&
         trial.effect != &effects::process_gain_drift();
}

double score_of(const Ahead& ahead) {
  const auto n = static_cast<double>(ahead.fit.residual.size());
  return -2 * ahead.nats() + static_cast<double>(ahead.fit.parameters()) * std::log(n);
}

// Whether `found` tells its effect: by the nats of samples that it was not fitted to,
// which chance exceeds by n with a probability of exp(-n), among `many`; and what the
// effect itself asks for.
Trial judged(const Fitter& fitter, const Ahead& alone, const Ahead& found,
             const Effect& effect, std::size_t many) {
  Trial trial;
  trial.effect = &effect;
  trial.fit = found.fit;
  examine(fitter, alone.fit, trial);
  trial.own = false;
  const double nats = found.judged() - alone.judged();
  trial.test.p_value = std::exp(-std::max(nats, 0.0));
  trial.p_family = std::min(1.0, static_cast<double>(many) * trial.test.p_value);
  trial.candidate.ahead = {rmse_ahead(fitter, alone.fit), rmse_ahead(fitter, found.fit)};
  trial.candidate.nats_ahead = nats;
  check_intervals(fitter, trial);
  return trial;
}

// A load that steps is no noise of any colour: one lucky stretch is no proof, and most
// blocks have to say the same.
bool is_steady(const Ahead& alone, const Ahead& found) {
  constexpr double kByChance = 0.05;
  const std::size_t n = std::min(alone.judging.size(), found.judging.size());
  if (n < 2) return false;
  std::vector<double> gains(n);
  for (std::size_t i = 0; i < n; ++i) gains[i] = found.judging[i] - alone.judging[i];
  const auto blocks = static_cast<double>(n);
  const double mean = Ahead::sum_of(gains) / blocks;
  double squares = 0;
  for (const double gain : gains) squares += (gain - mean) * (gain - mean);
  const double deviation = std::sqrt(squares / (blocks - 1) / blocks);
  return mean > 0 && effects::student_tail(mean / std::max(deviation, 1e-9 * mean),
                                           blocks - 1) < kByChance;
}

// But for what its own values may say against it.
bool may_be(const Trial& trial, const Ahead& alone, const Ahead& found) {
  return is_significant(trial) && is_steady(alone, found) && trial.on && !trial.edge &&
         trial.excitation.acted && score_of(found) < score_of(alone);
}

bool tells(const Trial& trial, const Ahead& alone, const Ahead& found) {
  return may_be(trial, alone, found) && trial.objection.empty();
}

bool wanders(const Fitter& fitter, const Fit& base) {
  return !fitter.is_judged() && predictable_share(base.residual) > kWanders;
}

std::string evidence(const Trial& trial, const std::string& of_effect) {
  const Candidate& c = trial.candidate;
  return of_effect + ' ' +
         filled(
             c.error_reduction_percent > 0
                 ? "Running free the load hides it ({0} of the squared error on samples "
                   "that were not fitted); one sample ahead it takes away {1}, which "
                   "makes those samples 10^{2} times as likely."
                 : "Running free the load hides it, and the error on samples that were "
                   "not fitted does not fall; one sample ahead it takes away {1} of "
                   "the squared error, which makes those samples 10^{2} times as "
                   "likely.",
             {percent(c.error_reduction_percent / 100), percent(c.ahead->share()),
              number(std::floor(c.nats_ahead / std::numbers::ln10), 3)});
}

// The errors as they are told, against the model that was asked about.
void accept(const Fitter& fitter, const Fit& base, Trial& trial) {
  Candidate& c = trial.candidate;
  conclude(fitter, base, trial);
  c.p_value = trial.test.p_value;
  c.spoken_against = false;
  c.status = CandidateStatus::kAccepted;
  c.evidence = evidence(trial, evidence_of(fitter, *trial.fit, {trial.effect}));
}

}  // namespace

Trial* tell_ahead(const Fitter& fitter, const Fit& base, std::vector<Trial>& trials) {
  if (!wanders(fitter, base)) return nullptr;
  Ahead alone = without_any(fitter, base);
  std::vector<Trial*> asked;
  for (Trial& trial : trials) {
    if (is_asked(trial)) asked.push_back(&trial);
  }
  std::vector<Ahead> found(asked.size());
  fitter.work().for_each(asked.size(), [&](std::size_t i) {
    found[i] = with_one(fitter, alone, *asked[i]->fit, *asked[i]->effect);
  });
  for (std::size_t i = 0; i < asked.size(); ++i) {
    take_back(fitter, found[i], *asked[i]->effect, alone);
  }
  std::vector<Trial> tried(asked.size());
  fitter.work().for_each(asked.size(), [&](std::size_t i) {
    tried[i] = judged(fitter, alone, found[i], *asked[i]->effect, asked.size());
  });
  // A limit that only the load keeps from view would have to be seen where it is reached.
  const auto is_told = [&](std::size_t i) { return tells(tried[i], alone, found[i]); };
  const auto may_be_first = [&](std::size_t i) {
    return !asked[i]->effect->description().limits && is_told(i);
  };
  std::vector<std::size_t> order(asked.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return score_of(found[i]); });
  const auto first = std::ranges::find_if(order, may_be_first);
  if (first == order.end()) return nullptr;
  std::size_t best = *first;
  const double most = score_of(found[best]) + 2 * kAsLikelyNats;
  // What explains more and cannot be it says that something else is there.
  if (score_of(found[best]) > score_of(found[order.front()]) + 2 * kAsLikelyNats) {
    return nullptr;
  }
  // What is as likely is looked for in the process first.
  for (const std::size_t i : order) {
    const bool as_likely = is_told(i) && score_of(found[i]) < most;
    if (as_likely && is_in_process(tried[i]) && !is_in_process(tried[best])) best = i;
  }
  // Where between u and y it bends, one sample ahead hardly says.
  const bool bent = is_bent(tried[best].effect->description());
  std::vector<Trial*> group = {asked[best]};
  for (const std::size_t i : order) {
    const bool as_likely = score_of(found[i]) < most;
    const bool as_bent = bent && is_bent(tried[i].effect->description());
    if (!is_told(i) || !(as_likely || as_bent)) continue;
    accept(fitter, base, tried[i]);
    tried[i].score = score_of(found[i]) - (i == best ? 2 * kTooRich : 0);
    *asked[i] = std::move(tried[i]);
    if (i != best) group.push_back(asked[i]);
  }
  name_each_other(group);
  for (const std::size_t i : order) {
    const bool beside = !accepted(*asked[i]) && score_of(found[i]) < most &&
                        may_be(tried[i], alone, found[i]);
    if (beside) name_beside(*asked[i], *asked[best]);
  }
  return asked[best];
}

std::optional<ToldAhead> told_ahead(const Fitter& fitter, const Fit& base,
                                    const Fit& start, const Effect& effect,
                                    std::size_t many) {
  Ahead alone = without_any(fitter, base);
  Ahead found = with_one(fitter, alone, start, effect);
  take_back(fitter, found, effect, alone);
  const Trial trial = judged(fitter, alone, found, effect, many);
  if (!tells(trial, alone, found)) return std::nullopt;
  return ToldAhead{std::move(found.fit), *trial.candidate.ahead};
}

void leave_columns_open(const Fitter& fitter, std::vector<Trial>& trials) {
  if (fitter.is_judged()) return;
  fitter.work().for_each(trials.size(), [&](std::size_t i) {
    Trial& trial = trials[i];
    if (!accepted(trial)) return;
    for (const Effect* member : members_of(trial)) {
      if (!member->description().recorded) continue;
      const Fit without = fitter.without(*trial.fit, *member);
      if (told_ahead(fitter, without, *trial.fit, *member, trials.size())) continue;
      leave_in_doubt(trial,
                     "one sample ahead, beside the past of what is left, the column "
                     "foretells no more than chance: what wanders as slowly looks the "
                     "same");
      return;
    }
  });
}

}  // namespace workbench
