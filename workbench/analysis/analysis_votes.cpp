// What the windows of an analysis say together.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "ident/verdict/judge.hpp"
#include "ident/verdict/pooled_view.hpp"
#include "workbench/analysis/analysis.hpp"
#include "workbench/analysis/contradiction.hpp"
#include "workbench/analysis/votes.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/recording/statistics.hpp"

namespace workbench {
namespace {

using Estimate = ident::Estimate<double>;
using Strokes = ident::PerStroke<double>;
using Windows = std::vector<const Identification*>;

// The median of each stroke that more than half of the windows know.
Strokes told_by_most(const Windows& results, Strokes Identification::*strokes) {
  const auto told = [&](Estimate Strokes::*stroke) {
    std::vector<Estimate> known;
    for (const Identification* result : results) {
      const Estimate& one = result->*strokes.*stroke;
      if (one.known) known.push_back(one);
    }
    return 2 * known.size() > results.size() ? median_of(known) : Estimate{};
  };
  return {told(&Strokes::ascending), told(&Strokes::descending)};
}

// The cause that more than half of the windows name.
ident::Cause common_cause(const Windows& results) {
  for (const Identification* one : results) {
    const auto votes = std::ranges::count_if(results, [one](const Identification* other) {
      return other->cause == one->cause;
    });
    if (2 * static_cast<std::size_t>(votes) > results.size()) return one->cause;
  }
  return ident::Cause::kUnknown;
}

// A band that one window refutes is not in the others; 0: none does.
double narrowest_detectable(const Windows& results) {
  double narrowest = 0;
  for (const Identification* one : results) {
    const double band = one->detectable_band;
    if (band > 0 && (narrowest <= 0 || band < narrowest)) narrowest = band;
  }
  return narrowest;
}

// A window in manual, or of a plant that stands, has no say.
bool rests(const Identification& result) {
  return result.reason == ident::Reason::kConstant;
}

}  // namespace

// The sum over all windows against what most of them say.
void Analysis::judge_together(const std::vector<Identification>& results, float counted) {
  const ident::PooledView view = ident::view_of(pooled_, counted);
  const bool fault = is_fault(result_.verdict);
  if (view == ident::PooledView::kSticks && !fault &&
      ident::may_stick_together(result_.evidence)) {
    result_.verdict = ident::Verdict::kStiction;
    result_.reason = ident::Reason::kSticksTogether;
    result_.cause = ident::Cause::kValve;
    const Estimate band{true, pooled_.band, pooled_.low, pooled_.high};
    result_.stick_band = {band, band};
    result_.slip_jump = {};
  } else if (view == ident::PooledView::kNothing && fault &&
             ident::nats_of_stems(result_.evidence, 0.0) < ident::kAloneNats) {
    leave_open(ident::Reason::kWindowsDisagree);
    result_.stick_band = result_.slip_jump = {};
  } else if (result_.verdict == ident::Verdict::kNoStiction) {
    double speaks = pooled_.nats;
    double windows = counted;
    double bounded = 0;  // of stems in windows that added nothing for a bounded one
    for (const Identification& one : results) {
      // What a stem told there is the characteristic's.
      if (one.reason == ident::Reason::kCurveExplains) {
        speaks -= std::max(one.evidence.ladder.nats, 0.0);
        continue;
      }
      if (!ident::bound_outweighs(one.evidence)) continue;
      bounded += one.evidence.ladder.nats;
      ++windows;
    }
    if (!(speaks + bounded > ident::kNoNats * std::sqrt(windows))) return;
    leave_open(bounded > speaks ? ident::Reason::kStemBounded
                                : ident::Reason::kEvidenceTooWeak);
  }
}

void Analysis::leave_open(ident::Reason reason) {
  result_.verdict = ident::Verdict::kUndecided;
  result_.reason = reason;
  result_.cause = ident::Cause::kUnknown;
}

// No band is told that none of the recordings has.
void Analysis::mind_contradictions() {
  using Kind = Contradiction::Kind;
  const Contradiction found = contradiction_of(findings_);
  if (found.kind == Kind::kNone) return;
  notes_.push_back(found.note);
  if (found.kind == Kind::kGains ||
      (found.kind == Kind::kRepaired && !found.mostly_sticks)) {
    leave_open(ident::Reason::kWindowsDisagree);
  }
  if (found.kind != Kind::kRepaired || !found.mostly_sticks) {
    result_.stick_band = result_.slip_jump = {};
  }
}

void Analysis::vote(const std::vector<Identification>& results) {
  if (results.size() == 1) {
    result_ = results.front();
    return;
  }
  const bool all_rest = std::ranges::all_of(results, rests);
  Votes votes{};
  Windows heard;
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (rests(results[i]) && !all_rest) continue;
    heard.push_back(&results[i]);
    votes[static_cast<int>(results[i].verdict)] +=
        static_cast<double>(windows_[i].length) *
        signals_[windows_[i].recording].period_s;
  }
  const ident::Verdict verdict = majority_of(votes);
  Windows agreeing;
  std::ranges::copy_if(heard, std::back_inserter(agreeing),
                       [verdict](const auto* one) { return one->verdict == verdict; });
  // Windows that contradict each other may leave none that is undecided itself.
  if (agreeing.empty()) agreeing.push_back(&results.front());
  std::vector<double> bands;
  for (const Identification* result : agreeing)
    bands.push_back(result->stick_band.mean());
  const double middle = median(bands);
  const auto nearest =
      std::ranges::min_element(agreeing, [middle](const auto* a, const auto* b) {
        return std::abs(a->stick_band.mean() - middle) <
               std::abs(b->stick_band.mean() - middle);
      });
  shown_ = static_cast<std::size_t>(*nearest - results.data());
  result_ = results[shown_];
  result_.cause = common_cause(agreeing);
  if (result_.verdict != verdict) {
    result_.verdict = verdict;
    result_.reason = ident::Reason::kEvidenceTooWeak;
    result_.cause = ident::Cause::kUnknown;
  }
  result_.stick_band = result_.slip_jump = {};
  if (is_fault(verdict)) {
    result_.stick_band = told_by_most(agreeing, &Identification::stick_band);
    result_.slip_jump = told_by_most(agreeing, &Identification::slip_jump);
    result_.reason = ident::strokes_that_stick(result_.reason, result_.stick_band);
  } else {
    result_.detectable_band = narrowest_detectable(agreeing);
  }
}

void Analysis::note_votes() {
  VoteCounts votes{};
  for (const WindowFinding& one : findings_) ++votes[static_cast<int>(one.verdict)];
  std::string note = std::to_string(windows()) + " windows of " +
                     (recordings_ == 1 ? "the recording:" : "the recordings:") +
                     listed(votes) + ';';
  note += result_.stick_band.ascending.known
              ? " bands and jumps are medians, the models those of the window from "
              : " the models are those of the window from ";
  note += instant(findings_[shown_].from_s, period_s()) + " s on";
  if (recordings_ > 1) {
    note += " in recording " + std::to_string(findings_[shown_].recording + 1);
  }
  notes_.push_back(note);
  if (recordings_ > 1 || !is_fault(result_.verdict)) return;
  const std::string ended = ended_note(findings_);
  if (!ended.empty()) notes_.push_back(ended);
}

// Where a band is told that is narrower, what would have shown is not what was seen.
void Analysis::mind_detectable() {
  constexpr double kTells = 0.5;  // of the span: what hides below it matters
  if (result_.detectable_band > kTells * span_) result_.detectable_band = 0;
  double narrowest = 0;
  for (const Estimate* band :
       {&result_.stick_band.ascending, &result_.stick_band.descending}) {
    if (!band->known) continue;
    narrowest = narrowest > 0 ? std::min(narrowest, band->value) : band->value;
  }
  if (is_fault(result_.verdict) && result_.detectable_band > narrowest) {
    result_.detectable_band = 0;
  }
}

// What any window saw; the seam as a sample of the recording where it was cut.
void Analysis::take_health(const std::vector<Identification>& results) {
  ident::RecordHealth<double>& seen = result_.health;
  for (const Identification& result : results) {
    const ident::RecordHealth<double>& one = result.health;
    seen.sensor_sticks = seen.sensor_sticks || one.sensor_sticks;
    seen.swapped = seen.swapped || one.swapped;
    seen.compressed = seen.compressed || one.compressed;
    seen.points_apart = std::max(seen.points_apart, one.points_apart);
    seen.cut_off = std::max(seen.cut_off, one.cut_off);
    seen.seam_at = std::max(seen.seam_at, one.seam_at);
  }
  if (seam_at_ > 0) seen.seam_at = seam_at_;
}

}  // namespace workbench
