#include "hidden/outcome.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <mutex>
#include <thread>

namespace hidden {
namespace {

std::vector<Interval> intervals_of(const Truth& truth, const Named& named) {
  std::vector<Interval> all;
  for (const EffectTruth& effect : truth.effects) {
    for (const TrueParameter& parameter : effect.parameters) {
      for (const FoundParameter& found : named.parameters) {
        if (found.effect == code_of(effect.effect) && found.name == parameter.name) {
          all.push_back(
              {found.effect + " " + found.name, parameter.value, found.low, found.high});
        }
      }
    }
  }
  return all;
}

double added_noise(const HiddenCase& one) {
  const std::vector<double> sensed = recorded(one.truth.setup, one.truth.trace.sensed);
  double squares = 0;
  for (std::size_t k = 0; k < sensed.size(); ++k) {
    squares += (one.recording.y[k] - sensed[k]) * (one.recording.y[k] - sensed[k]);
  }
  return std::sqrt(squares / static_cast<double>(sensed.size()));
}

Outcome run_case(const CaseKey& key) {
  Outcome outcome;
  outcome.key = key;
  HiddenCase one;
  try {
    one = make_case(key);
  } catch (const std::exception&) {
    outcome.possible = false;
    return outcome;
  }
  std::vector<std::string> codes;
  outcome.noise = added_noise(one);
  outcome.size = one.truth.effects.empty() ? 0 : one.truth.effects[0].size;
  for (const EffectTruth& effect : one.truth.effects) {
    codes.emplace_back(code_of(effect.effect));
    outcome.size = std::min(outcome.size, effect.size);
  }
  const auto start = std::chrono::steady_clock::now();
  outcome.named = name_effects(one.recording);
  outcome.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  outcome.intervals = intervals_of(one.truth, outcome.named);
  if (one.truth.excited && !codes.empty()) {
    try {
      outcome.true_model_rmse = refit_error(one.recording, codes);
    } catch (const std::exception& error) {
      outcome.named.error = error.what();
    }
  }
  return outcome;
}

/// Whether hidden effect `i` and those after it can be given to different added effects;
/// returns how many. At most two are hidden.
int assign(const Outcome& outcome, std::size_t i, std::vector<bool>& used) {
  if (i == outcome.key.effects.size()) {
    return 0;
  }
  int most = assign(outcome, i + 1, used);
  for (std::size_t k = 0; k < outcome.named.added.size(); ++k) {
    if (!used[k] && outcome.named.added[k].names(code_of(outcome.key.effects[i]))) {
      used[k] = true;
      most = std::max(most, 1 + assign(outcome, i + 1, used));
      used[k] = false;
    }
  }
  return most;
}

std::string text_of(const std::vector<AddedEffect>& all) {
  std::string text;
  for (const AddedEffect& added : all) {
    text += (text.empty() ? "" : " + ") + added.effect;
    for (std::size_t i = 0; i < added.indistinguishable_from.size(); ++i) {
      text += (i == 0 ? " (or " : ", ") + added.indistinguishable_from[i];
    }
    text += added.indistinguishable_from.empty() ? "" : ")";
  }
  return text + ";";
}

}  // namespace

bool Interval::covers() const {
  const double slack = 1e-9 * std::max(1.0, std::abs(truth));
  return low - slack <= truth && truth <= high + slack;
}

bool right_first(const Outcome& outcome) {
  return !outcome.named.first.empty() &&
         outcome.named.first[0].names(code_of(outcome.key.effects[0]));
}

bool wrong_first(const Outcome& outcome) {
  return !outcome.named.first.empty() && !right_first(outcome);
}

int hidden_found(const Outcome& outcome) {
  std::vector<bool> used(outcome.named.added.size(), false);
  return assign(outcome, 0, used);
}

int needless(const Outcome& outcome) {
  return static_cast<int>(outcome.named.added.size()) - hidden_found(outcome);
}

double error_ratio(const Outcome& outcome) {
  return outcome.named.rmse_validation / outcome.true_model_rmse;
}

std::vector<Outcome> run_cases(const std::vector<CaseKey>& keys,
                               const std::function<void(const Outcome&)>& done) {
  constexpr int kThreads = 2;
  std::vector<Outcome> outcomes(keys.size());
  std::atomic<std::size_t> next = 0;
  std::mutex reporting;
  std::vector<std::thread> workers;
  for (int worker = 0; worker < kThreads; ++worker) {
    workers.emplace_back([&] {
      for (std::size_t i = next++; i < keys.size(); i = next++) {
        outcomes[i] = run_case(keys[i]);
        const std::scoped_lock lock(reporting);
        done(outcomes[i]);
      }
    });
  }
  for (std::thread& worker : workers) {
    worker.join();
  }
  return outcomes;
}

std::string describe(const Outcome& outcome) {
  std::string text = describe(outcome.key) + ":";
  if (!outcome.possible) {
    return text + " impossible";
  }
  if (!outcome.named.error.empty()) {
    return text + " error: " + outcome.named.error;
  }
  text += outcome.named.first.empty() ? " nothing;"
                                      : " first " + text_of(outcome.named.first);
  if (!outcome.named.added.empty()) {
    text += " final " + text_of(outcome.named.added);
  }
  if (outcome.key.effects.size() == 1) {
    for (const Judged& judged : outcome.named.others) {
      text += judged.effect == code_of(outcome.key.effects[0])
                  ? " truth " + judged.status + ";"
                  : "";
    }
  }
  char figures[160];
  std::snprintf(figures, sizeof figures,
                " size %.3f; error over noise: ladder %.3f, true model %.3f; %.2f s",
                outcome.size, outcome.named.rmse_validation / outcome.noise,
                outcome.true_model_rmse / outcome.noise, outcome.seconds);
  text += figures;
  for (const Interval& interval : outcome.intervals) {
    if (!interval.covers()) {
      char missed[160];
      std::snprintf(missed, sizeof missed, "; %s %.5g not in %.5g to %.5g",
                    interval.parameter.c_str(), interval.truth, interval.low,
                    interval.high);
      text += missed;
    }
  }
  return text;
}

}  // namespace hidden
