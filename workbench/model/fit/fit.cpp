#include "workbench/model/fit/fit.hpp"

#include <algorithm>
#include <array>

#include "workbench/model/base/joined.hpp"
#include "workbench/model/base/noise.hpp"
#include "workbench/model/fit/gain_sign.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/within_row.hpp"

namespace workbench {
namespace {

const char* const kWhatToRecord =
    "record a stretch in which u and the output move, with several reversals";

// Lags up to an eighth of the recording; of a long one means of several samples are
// looked at, so that the cost has a bound.
double memory_of(std::span<const double> y) {
  constexpr std::size_t kMost = 16384;
  const std::size_t each = (y.size() + kMost - 1) / kMost;
  std::vector<double> means(y.size() / each);
  for (std::size_t i = 0; i < means.size(); ++i) {
    for (std::size_t k = 0; k < each; ++k) means[i] += y[i * each + k];
    means[i] /= static_cast<double>(each);
  }
  const std::vector<double> r = autocorrelation(means, means.size() / 8);
  std::size_t lag = 1;
  while (lag <= r.size() && r[lag - 1] > 0.37) ++lag;
  return static_cast<double>(lag * each);
}

std::vector<double> start_values(const FreeRun& run, const Situation& situation) {
  std::vector<double> p;
  for (const FreeRun::Slot& slot : run.slots()) {
    p.push_back(slot.piece == 0 ? slot.parameter.low : 0);
  }
  double sum = 0;
  for (const double u : situation.u) sum += u;
  p[0] = sum / static_cast<double>(situation.samples());
  return p;
}

// The values of `fit` where `run` has the same parameter.
std::vector<double> carried(const FreeRun& run, const Fit& fit, const Situation& s) {
  std::vector<double> p = start_values(run, s);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const FreeRun::Slot& slot = run.slots()[i];
    for (std::size_t j = 0; j < fit.p.size(); ++j) {
      if (fit.slots[j].effect == slot.effect && fit.slots[j].piece == slot.piece &&
          fit.slots[j].parameter.name == slot.parameter.name) {
        p[i] = fit.p[j];
      }
    }
  }
  return p;
}

// `fit` less what belongs to the beginning of its recording.
Fit without_state(Fit fit) {
  for (std::size_t i = fit.p.size(); i-- > 0;) {
    if (!fit.slots[i].parameter.initial) continue;
    fit.p.erase(fit.p.begin() + static_cast<std::ptrdiff_t>(i));
    fit.slots.erase(fit.slots.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return fit;
}

}  // namespace

Fit in_order(Fit fit, const std::vector<const Effect*>& effects) {
  fit.effects = effects;
  return fit;
}

std::size_t Fit::parameters() const {
  std::size_t count = 0;
  for (const FreeRun::Column& column : columns) count += !column.judges;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const SearchedParameter& parameter = slots[i].parameter;
    const bool absent = parameter.optional && parameter.off == p[i];
    count += FreeRun::is_searched(slots, p, i) && !absent;
  }
  return count;
}

std::optional<double> Fit::process_value(std::string_view name) const {
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (slots[i].effect == nullptr && slots[i].parameter.name == name) return p[i];
  }
  return std::nullopt;
}

std::vector<double> Fit::searched_of(const Effect& effect) const {
  std::vector<double> out;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (slots[i].effect == &effect) out.push_back(p[i]);
  }
  return out;
}

std::vector<double> Fit::solved_of(const Effect& effect) const {
  std::vector<double> out;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].effect == &effect) out.push_back(coefficients[i]);
  }
  return out;
}

Fitter::Fitter(const Recording& recording, Column output, const Work& work)
    : recording_(&recording), work_(&work), output_(output) {
  const std::vector<double>& y = recording.values(output);
  const std::string name(name_of(output));
  if (recording.u.empty() || y.empty()) {
    throw InputError(recording.name, 0, 0, "the columns u and " + name,
                     "no " + (recording.u.empty() ? std::string("u") : name),
                     "choose a recording that has them");
  }
  if (recording.size() < Blocks::kFewestSamples) {
    throw CannotAnswer(recording.name, 0, 0,
                       "at least " + std::to_string(Blocks::kFewestSamples) + " samples",
                       std::to_string(recording.size()), kWhatToRecord);
  }
  Parts parts = parts_of(recording);
  pieces_ = std::move(parts.pieces);
  u_ = recording.u;
  // A stem is read in the row of its signal, and so is what is quicker than the rows.
  const bool within_row = output == Column::x || answers_within_row(recording.u, y);
  for (const Piece& piece : pieces_) {
    if (!within_row) break;
    const auto next =
        std::span(recording.u).subspan(piece.first + 1, piece.last - piece.first - 1);
    std::ranges::copy(next, std::span(u_).subspan(piece.first).begin());
  }
  base_ = situation_of(u_, y, recording.period_s);
  base_.pieces = pieces_;
  if (output == Column::y) base_.sp = recording.sp;
  base_.loads = recording.loads;
  base_.filled_share = static_cast<double>(recording.resampling.missing) /
                       static_cast<double>(recording.size());
  if (output == Column::y) base_.gain_sign = gain_sign_of(recording, pieces_);
  if (!(base_.u_span() > 0)) {
    throw CannotAnswer(recording.name, 0, 0, "u and " + name + " that move",
                       "a constant u",
                       std::string(kWhatToRecord) +
                           "; of a step test that begins with its step, say where u "
                           "rested before, --u-before");
  }
  if (!(base_.y_span() > 0)) {
    throw CannotAnswer(recording.name, 0, 0, "u and " + name + " that move",
                       "a constant " + name, kWhatToRecord);
  }
  const Piece& longest = *std::max_element(
      pieces_.begin(), pieces_.end(), [](const Piece& a, const Piece& b) {
        return a.judges != b.judges ? a.judges : a.last - a.first < b.last - b.first;
      });
  memory_samples_ =
      memory_of(std::span(y).subspan(longest.first, longest.last - longest.first));
  blocks_ = Blocks(pieces_, memory_samples_, recording.split, parts.left_out);
  if (blocks_.samples() < Blocks::kFewestSamples) {
    throw InputError(recording.name, 0, 0,
                     "at least " + std::to_string(Blocks::kFewestSamples) +
                         " samples that are not left out",
                     std::to_string(blocks_.samples()), "leave out less");
  }
  base_.estimation = blocks_.estimation();
}

// What `run` simulated last.
void Fitter::record(const FreeRun& run, double error, Fit& fit) {
  fit.error = error;
  fit.coefficients.assign(run.coefficients().begin(), run.coefficients().end());
  fit.residual.assign(run.residual().begin(), run.residual().end());
  fit.aside.assign(run.aside().begin(), run.aside().end());
  fit.weight = run.weight();
  if (!fit.weight.empty()) fit.weighed.assign(run.judged().begin(), run.judged().end());
}

Fit Fitter::taken(FreeRun& run, std::vector<const Effect*> effects,
                  std::vector<double> p) const {
  Fit fit;
  find_judging_start(run, p);
  const double error = run.run(p);
  fit.effects = std::move(effects);
  fit.slots = run.slots();
  fit.p = std::move(p);
  fit.columns = run.columns();
  record(run, error, fit);
  fit.integrating = run.integrating();
  return fit;
}

Fit Fitter::at(const Fit& fit, std::vector<double> p) const {
  FreeRun run(base_, blocks_, fit.effects, *work_, fit.weight);
  return taken(run, fit.effects, std::move(p));
}

std::optional<Fit> Fitter::built(const std::vector<const Effect*>& effects,
                                 const Effect*& missing) const {
  // What shapes the process without being searched belongs in from the beginning.
  std::vector<const Effect*> structural;
  for (const Effect* effect : effects) {
    if (effect->searched(base_).empty() && effect->solved().empty()) {
      structural.push_back(effect);
    }
  }
  FreeRun run(base_, blocks_, structural, *work_);
  Fit fit = found(run, structural, first_found(run, start_values(run, base_)).p);
  for (const Effect* effect : effects) {
    if (contains(structural, *effect)) continue;
    auto next = extend(fit, *effect, Effort::kThorough);
    missing = effect;
    if (!next) return std::nullopt;
    fit = std::move(*next);
  }
  return fit.effects.size() > 1 ? reconsider(std::move(fit), nullptr) : fit;
}

std::optional<Fit> Fitter::start_if(const std::vector<const Effect*>& effects) const {
  const Effect* missing = nullptr;
  return built(effects, missing);
}

// The first effect is found without the others, which may mislead it: another order may
// lead elsewhere.
std::optional<Fit> Fitter::built_either_way(const std::vector<const Effect*>& effects,
                                            const Effect*& missing) const {
  std::optional<Fit> best = built(effects, missing);
  if (effects.size() < 2) return best;
  const Effect* missing_then = nullptr;
  std::optional<Fit> other = built({effects.rbegin(), effects.rend()}, missing_then);
  if (!other || (best && best->error <= other->error)) return best;
  return in_order(std::move(*other), effects);
}

Fit Fitter::start(const std::vector<const Effect*>& effects) const {
  const Effect* missing = nullptr;
  if (auto fit = built_either_way(effects, missing)) return std::move(*fit);
  throw CannotAnswer(
      recording_->name, 0, 0, "a recording that shows " + std::string(missing->code()),
      "nothing to start from",
      "leave the effect out, or: " + std::string(missing->description().split));
}

// No start, no points.
std::vector<SearchPoint> Fitter::judged_starts(const FreeRun& run, const Fit& base,
                                               const Effect& effect) const {
  Situation here = situation(base);
  std::vector<SeenStem> stems;
  if (effect.description().sticks) stems = stems_behind(base);
  here.stems = stems;
  const std::vector<Values> values = effect.starts(here);
  const std::vector<double> carried_p = carried(run, base, base_);
  const auto first = static_cast<std::ptrdiff_t>(run.first_slot(effect));
  // Many starts are looked at with two lags first.
  constexpr std::size_t kMany = 100;
  Starts starts;
  starts.lags_s = lags_to_try(run, carried_p, stems);
  starts.few_lags = (values.size() > kMany ? 2 : 3) + stems.size();
  for (const Values& of_effect : values) {
    starts.p.push_back(carried_p);
    std::copy(of_effect.begin(), of_effect.end(), starts.p.back().begin() + first);
  }
  return judged(run, starts);
}

std::optional<Fit> Fitter::extend(const Fit& base, const Effect& effect, Effort effort,
                                  double hopeless_above, ScreenedStarts* seen) const {
  std::vector<const Effect*> effects = base.effects;
  effects.push_back(&effect);
  FreeRun run(base_, blocks_, effects, *work_, base.weight);
  ScreenedStarts own;
  if (seen == nullptr) seen = &own;
  if (seen->points.empty()) seen->points = judged_starts(run, base, effect);
  if (seen->points.empty()) return std::nullopt;
  if (!affordable()) effort = Effort::kScreen;
  SearchPoint best = followed(run, *seen, effort, hopeless_above);
  return found(run, std::move(effects), std::move(best.p));
}

std::uint64_t Fitter::samples_left() const {
  constexpr std::uint64_t kMostSamples = 250'000'000;  // some 10 s of a core
  constexpr std::uint64_t kMostOfLong = 400'000'000;
  constexpr std::uint64_t kMostRuns = 80'000;
  const std::uint64_t most =
      std::clamp(kMostRuns * y().size(), kMostSamples, kMostOfLong);
  return most - std::min(most, Work::spent() - spent_before_);
}

Fit Fitter::on_the_whole(const Fit& other, const Shortened& from) const {
  return taken_over(other, from.is_excerpt,
                    [&from](double seconds) { return from.in_whole(seconds); });
}

Fit Fitter::on_the_short(const Fit& other, const Shortened& to) const {
  return taken_over(other, to.is_excerpt,
                    [&to](double seconds) { return to.in_short(seconds); });
}

Fit Fitter::taken_over(Fit other, bool from_elsewhere,
                       const std::function<double(double)>& moved) const {
  constexpr int kIterations = 10;
  for (std::size_t i = 0; i < other.p.size(); ++i) {
    if (other.slots[i].parameter.instant) other.p[i] = moved(other.p[i]);
  }
  if (from_elsewhere) other = without_state(std::move(other));
  FreeRun run(base_, blocks_, other.effects, *work_);
  const std::vector<double> start = carried(run, other, base_);
  if (!other.weight.empty()) {  // that of other samples
    run.run(start);
    run.weigh_by(colour_of(run.residual()).a);
  }
  SearchPoint point = evaluate(run, start);
  point =
      other.weight.empty()
          ? descend(run, std::move(point), kIterations, kNarrowStep)
          : at_deepest_delay(run, search_on(run, std::move(point), Effort::kThorough));
  return found(run, other.effects, std::move(point.p));
}

Fit Fitter::refine(const Fit& base, std::span<const FreeRun::Held> held) const {
  FreeRun run(base_, blocks_, base.effects, *work_, base.weight);
  run.hold(held);
  SearchPoint point = evaluate(run, carried(run, base, base_));
  point = at_deepest_delay(run, search_on(run, std::move(point), Effort::kThorough));
  return found(run, base.effects, std::move(point.p));
}

Fit Fitter::reconsider(Fit base, const Effect* last) const {
  constexpr double kGain = 0.995;
  constexpr double kHopeless = 1.5;  // of the error, before the search goes to the end
  const std::vector<const Effect*> effects = base.effects;
  for (const Effect* effect : effects) {
    if (effect == last || effect->searched(base_).empty()) continue;
    if (!affordable()) break;
    // With the others as they are, and as they would be without it.
    std::array<std::optional<Fit>, 2> anew;
    work_->for_each(anew.size(), [&](std::size_t i) {
      const Fit rest = i == 0 ? less(base, *effect) : without(base, *effect);
      anew[i] = extend(rest, *effect, Effort::kThorough, kHopeless * base.error);
    });
    const bool second = anew[1] && (!anew[0] || anew[1]->error < anew[0]->error);
    std::optional<Fit>& best = anew[second ? 1 : 0];
    if (!best || !(best->error < kGain * base.error)) continue;
    base = refine(in_order(std::move(*best), effects));
  }
  return base;
}

namespace {

std::vector<const Effect*> all_but(const Effect& effect, const Fit& fit) {
  std::vector<const Effect*> out = fit.effects;
  std::erase(out, &effect);
  return out;
}

}  // namespace

Fit Fitter::less(const Fit& base, const Effect& effect) const {
  std::vector<const Effect*> effects = all_but(effect, base);
  FreeRun run(base_, blocks_, effects, *work_, base.weight);
  Fit fit = taken(run, std::move(effects), carried(run, base, base_));
  for (std::size_t i = 0; i < fit.columns.size(); ++i) {
    for (std::size_t j = 0; j < base.columns.size(); ++j) {
      if (base.columns[j].effect == fit.columns[i].effect &&
          base.columns[j].piece == fit.columns[i].piece &&
          base.columns[j].name == fit.columns[i].name) {
        fit.coefficients[i] = base.coefficients[j];
      }
    }
  }
  record(run, run.run_with(fit.p, fit.coefficients, FreeRun::Rows::kEstimation), fit);
  return fit;
}

Fit Fitter::without(const Fit& base, const Effect& effect) const {
  std::vector<const Effect*> effects = all_but(effect, base);
  FreeRun run(base_, blocks_, effects, *work_, base.weight);
  const std::vector<double> p = carried(run, base, base_);
  SearchPoint best = search_on(run, evaluate(run, p), Effort::kThorough);
  if (const auto slot = first_lag_slot(run)) {
    for (const double factor : {0.3, 3.0}) {
      std::vector<double> other = p;
      other[*slot] = std::max(p[*slot], base_.period_s) * factor;
      SearchPoint point = search_on(run, evaluate(run, other), Effort::kScreen);
      if (point.error < best.error) best = std::move(point);
    }
  }
  return found(run, std::move(effects), std::move(best.p));
}

}  // namespace workbench
