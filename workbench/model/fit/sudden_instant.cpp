#include "workbench/model/fit/sudden_instant.hpp"

#include <algorithm>
#include <cmath>

namespace workbench {
namespace {

constexpr std::size_t kNear = 2;  // samples by which an instant may miss its stretch

// The samples that are not fitted around sample `at` of its piece; empty where it and
// those near are.
SampleRange unfitted_around(std::size_t at, const Situation& s) {
  SampleRange piece{0, s.samples()};
  for (const Piece& one : s.pieces) {
    if (at >= one.first && at < one.last) piece = {one.first, one.last};
  }
  const auto is_free = [&s](std::size_t k) { return s.estimation[k] == 0; };
  for (std::size_t away = 0; away <= kNear; ++away) {
    for (const bool later : {false, true}) {
      if (later ? at + away >= piece.last : at < piece.first + away) continue;
      const std::size_t k = later ? at + away : at - away;
      if (!is_free(k)) continue;
      SampleRange out{k, k + 1};
      while (out.first > piece.first && is_free(out.first - 1)) --out.first;
      while (out.last < piece.last && is_free(out.last)) ++out.last;
      return out;
    }
  }
  return {at, at};
}

// True where another parameter of the effect is searched only with this one.
bool frees_another(std::span<const FreeRun::Slot> slots, const FreeRun::Slot& slot) {
  return std::ranges::any_of(slots, [&](const FreeRun::Slot& other) {
    return other.effect == slot.effect &&
           other.parameter.only_with == slot.parameter.name;
  });
}

// The forms that the effect of a slot may take with the parameters it has: each of its
// constants 0 or 1.
std::vector<std::vector<double>> forms_of(std::span<const FreeRun::Slot> slots,
                                          std::size_t slot, std::vector<double> p) {
  std::vector<std::vector<double>> forms = {std::move(p)};
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (slots[i].effect != slots[slot].effect || !slots[i].parameter.constant ||
        frees_another(slots, slots[i])) {
      continue;
    }
    const std::size_t count = forms.size();
    for (std::size_t j = 0; j < count; ++j) {
      forms.push_back(forms[j]);
      forms.back()[i] = 1 - forms.back()[i];
    }
  }
  return forms;
}

// The error with the instant before each sample of the stretch and of those near it.
class Scan {
 public:
  Scan(FreeRun& run, const SuddenInstant& instant, std::vector<double> form)
      : run_(run),
        instant_(instant),
        form_(std::move(form)),
        first_(instant.stretch.first - std::min(kNear, instant.stretch.first)),
        errors_(instant.stretch.last + kNear - first_ + 1, -1) {}

  [[nodiscard]] std::size_t places() const { return errors_.size(); }
  [[nodiscard]] double time(std::size_t place) const {
    const SearchedParameter& parameter = run_.slots()[instant_.slot].parameter;
    const double sample = static_cast<double>(first_ + place) - 0.5;
    return std::clamp(sample * run_.situation().period_s, parameter.low, parameter.high);
  }
  [[nodiscard]] std::vector<double> at(std::size_t place) const {
    std::vector<double> p = form_;
    p[instant_.slot] = time(place);
    return p;
  }
  [[nodiscard]] const std::vector<double>& at_its_own() const { return form_; }
  double error(std::size_t place) {
    if (errors_[place] < 0) errors_[place] = run_.run(at(place));
    return errors_[place];
  }
  // Coarse first: the error rises on both sides with the distance.
  std::size_t best() {
    std::size_t step = coarse();
    std::size_t best = 0;
    std::size_t from = 0;
    std::size_t to = places() - 1;
    while (true) {
      for (std::size_t i = from; i <= to; i += step) {
        if (error(i) < error(best)) best = i;
      }
      if (step == 1) return best;
      from = best > step ? best - step : 0;
      to = std::min(best + step, places() - 1);
      step = std::max<std::size_t>(1, step / 4);
    }
  }
  // The places from the first to the last whose error is at most `most`; none: empty.
  SampleRange within(double most) {
    std::size_t first = places();
    std::size_t last = 0;
    for (std::size_t i = 0; i < places(); ++i) {
      if (errors_[i] < 0 || errors_[i] > most) continue;
      first = std::min(first, i);
      last = i;
    }
    if (first == places()) return {0, 0};
    const auto end = [&](std::size_t inside, std::size_t outside) {
      while (inside + 1 < outside || outside + 1 < inside) {
        const std::size_t middle = (inside + outside) / 2;
        (error(middle) <= most ? inside : outside) = middle;
      }
      return error(outside) <= most ? outside : inside;
    };
    const std::size_t step = coarse();
    return {end(first, first > step ? first - step : 0),
            end(last, std::min(last + step, places() - 1)) + 1};
  }

 private:
  [[nodiscard]] std::size_t coarse() const {
    constexpr std::size_t kCoarse = 16;
    return std::max<std::size_t>(1, places() / kCoarse);
  }

  FreeRun& run_;
  const SuddenInstant& instant_;
  std::vector<double> form_;
  std::size_t first_;  // sample that the first place is before
  std::vector<double> errors_;
};

}  // namespace

std::vector<SuddenInstant> sudden_instants(std::span<const FreeRun::Slot> slots,
                                           std::span<const double> p,
                                           const Situation& situation) {
  std::vector<SuddenInstant> out;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (!slots[i].parameter.sudden || !FreeRun::is_searched(slots, p, i)) continue;
    const auto at = static_cast<std::size_t>(
        std::clamp(std::ceil(p[i] / situation.period_s), 0.0,
                   static_cast<double>(situation.samples() - 1)));
    const SampleRange stretch = unfitted_around(at, situation);
    if (stretch.first < stretch.last) out.push_back({i, stretch});
  }
  return out;
}

SuddenPlace place_of(const SuddenInstant& instant, const Situation& situation,
                     const Blocks& blocks, const std::vector<const Effect*>& effects,
                     std::vector<double> p, const Work& work, double rise) {
  const Blocks all = blocks.fitting(instant.stretch);
  FreeRun run(situation, all, effects, work);
  std::vector<Scan> scans;
  for (std::vector<double>& form : forms_of(run.slots(), instant.slot, std::move(p))) {
    scans.emplace_back(run, instant, std::move(form));
  }
  SuddenPlace out;
  out.p = scans.front().at_its_own();
  double least = run.run(out.p);
  for (Scan& scan : scans) {
    const std::size_t best = scan.best();
    if (scan.error(best) < least) {
      least = scan.error(best);
      out.p = scan.at(best);
    }
  }
  const double half_s = situation.period_s / 2;
  out.low = out.p[instant.slot] - half_s;
  out.high = out.p[instant.slot] + half_s;
  for (Scan& scan : scans) {
    if (!(rise > 0)) break;
    const SampleRange places = scan.within(least + rise);
    if (places.first == places.last) continue;
    out.low = std::min(out.low, scan.time(places.first) - half_s);
    out.high = std::max(out.high, scan.time(places.last - 1) + half_s);
  }
  return out;
}

}  // namespace workbench
