#include "workbench/analysis/analysis.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>

#include "ident/signal/leap.hpp"
#include "ident/verdict/judge.hpp"
#include "ident/verdict/pooled_view.hpp"
#include "workbench/analysis/contradiction.hpp"
#include "workbench/analysis/judged_pieces.hpp"
#include "workbench/analysis/listening.hpp"
#include "workbench/analysis/longest_part.hpp"
#include "workbench/analysis/signal_notes.hpp"
#include "workbench/analysis/start_up.hpp"
#include "workbench/analysis/votes.hpp"
#include "workbench/analysis/wording.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/recording/statistics.hpp"

namespace workbench {
namespace {

// Passes over the window between two calls of `progress`.
constexpr int kSlice = 20;

using Estimate = ident::Estimate<double>;
using Quantity = std::function<const Estimate&(const Identification&)>;

Estimate median_of(const std::vector<const Identification*>& results,
                   const Quantity& quantity) {
  std::vector<double> value, low, high;
  for (const Identification* result : results) {
    const Estimate& estimate = quantity(*result);
    if (!estimate.known) continue;
    value.push_back(estimate.value);
    low.push_back(estimate.low);
    high.push_back(estimate.high);
  }
  if (2 * value.size() <= results.size()) return {};
  return {true, median(value), median(low), median(high)};
}

// The cause that more than half of the windows name.
ident::Cause common_cause(const std::vector<const Identification*>& results) {
  for (const Identification* one : results) {
    const auto votes = std::count_if(
        results.begin(), results.end(),
        [one](const Identification* other) { return other->cause == one->cause; });
    if (2 * static_cast<std::size_t>(votes) > results.size()) return one->cause;
  }
  return ident::Cause::kUnknown;
}

// A window in manual, or of a plant that stands, has no say.
bool rests(const Identification& result) {
  return result.reason == ident::Reason::kConstant;
}

double mean_band(const Identification& result) {
  return (result.stick_band.ascending.value + result.stick_band.descending.value) / 2;
}

}  // namespace

Analysis::Analysis(const RecordingView& recording, const Progress& progress,
                   int most_windows)
    : identifier_(std::make_unique<Identifier>()) {
  take(recording);
  run(progress, most_windows);
}

Analysis::Analysis(const std::vector<Recording>& recordings, const Progress& progress,
                   Depth depth)
    : Analysis(std::vector<RecordingView>(recordings.begin(), recordings.end()), progress,
               depth) {}

Analysis::Analysis(const std::vector<RecordingView>& recordings, const Progress& progress,
                   Depth depth)
    : depth_(depth), identifier_(std::make_unique<Identifier>()) {
  for (const RecordingView& recording : recordings) take(recording);
  run(progress, kMostWindows);
}

void Analysis::take(const RecordingView& recording) {
  JudgedPieces judged = judged_pieces(recording);
  for (std::string& note : judged.notes) notes_.push_back(std::move(note));
  std::size_t longest = 0;
  double samples = 0;
  for (RecordingView& piece : judged.pieces) {
    const auto before = static_cast<std::size_t>(piece.t.data() - recording.t.data());
    piece = without_start_up(longest_of(piece, before));
    if (piece.size() > judged.pieces[longest].size()) {
      longest = static_cast<std::size_t>(&piece - judged.pieces.data());
    }
    samples += static_cast<double>(piece.size());
  }
  const int decimation = decimation_of(judged.pieces[longest]);
  for (const RecordingView& piece : judged.pieces) {
    thin_out(piece, decimation);
    sources_.push_back({recordings_, static_cast<double>(piece.size()) / samples});
  }
  ++recordings_;
}

RecordingView Analysis::longest_of(const RecordingView& piece, std::size_t before) {
  const Part part = longest_part(piece);
  const RecordingView alone = piece.part(part.first, part.length);
  if (part.length < piece.size()) {
    notes_.push_back("joined recordings: y and u jump at " +
                     number(piece.t[part.seam_at]) + " s; only the longest part, " +
                     number(alone.t.front()) + " to " + number(alone.t.back()) +
                     " s, is analysed");
    seam_at_ = before + part.seam_at;
  }
  for (std::string& note : signal_notes(alone)) {
    if (std::find(notes_.begin(), notes_.end(), note) == notes_.end()) {
      notes_.push_back(std::move(note));
    }
  }
  return alone;
}

RecordingView Analysis::without_start_up(const RecordingView& recording) {
  const std::size_t end = start_up_end(recording.u);
  if (end == 0) return recording;
  notes_.push_back("a start-up, up to " + number(recording.t[end]) +
                   " s, is left out: u moves much farther there than in the oscillation "
                   "that follows");
  return recording.part(end, recording.size() - end);
}

void Analysis::run(const Progress& progress, int most_windows) {
  const auto begin = std::chrono::steady_clock::now();
  lay_windows(most_windows);
  double low = signals_.front().u.front();
  double high = low;
  for (const Recording& signals : signals_) {
    const auto [least, most] = std::minmax_element(signals.u.begin(), signals.u.end());
    low = std::min(low, *least);
    high = std::max(high, *most);
  }
  span_ = high - low;
  std::vector<Identification> results;
  ident::EvidencePool pool;
  identify_windows(results, pool, progress);
  pooled_ = pool.finding(span_);
  vote(results);
  judge_together(pool.windows());
  if (recordings_ > 1) mind_contradictions();
  if (windows() > 1) note_votes();
  mind_detectable();
  take_health(results);
  constexpr double kPoorly = 50;
  const bool open = result_.verdict == ident::Verdict::kUndecided;
  const bool poor = open && result_.fit_valve_percent < kPoorly;
  const std::string note = poor ? same_sample_note(signals_.front()) : "";
  if (!note.empty()) notes_.push_back(note);
  const std::chrono::duration<double, std::milli> spent =
      std::chrono::steady_clock::now() - begin;
  runtime_ms_ = spent.count();
}

void Analysis::identify_windows(std::vector<Identification>& results,
                                ident::EvidencePool& pool, const Progress& progress) {
  std::vector<ident::EarlierValve> valves;
  for (std::size_t i = 0; i < windows_.size(); ++i) {
    if (i > 0) windows_[i].earlier = handed_on(i - 1, i, valves.back());
    identify(i, &pool, progress);
    results.push_back(identifier_->result());
    findings_.push_back(finding_of(windows_[i]));
    valves.push_back(identifier_->next_start());
  }
  for (std::size_t i = windows_.size(); i-- > 1;) {
    ident::EarlierValve after = handed_on(i, i - 1, valves[i]);
    if (!after.known() || same_valve(valves[i - 1], after)) continue;
    after.trusted = 1;
    windows_[i - 1].earlier = after;
    identify(i - 1, nullptr, progress);
    results[i - 1] = identifier_->result();
    findings_[i - 1] = finding_of(windows_[i - 1]);
    valves[i - 1] = identifier_->next_start();
  }
}

// Another recording may have another sample period.
ident::EarlierValve Analysis::handed_on(std::size_t from, std::size_t to,
                                        ident::EarlierValve valve) const {
  const auto ratio = static_cast<float>(signals_[windows_[from].recording].period_s /
                                        signals_[windows_[to].recording].period_s);
  if (valve.slow > 0) valve.slow *= ratio;
  if (valve.fast > 0) valve.fast *= ratio;
  return valve;
}

// The pieces of one recording share its windows.
void Analysis::lay_windows(int most) {
  for (std::size_t r = 0; r < signals_.size(); ++r) {
    const std::size_t size = signals_[r].size();
    const std::size_t length = std::min(size, Identifier::kCapacity);
    const double share = std::max(1.0, std::round(most * sources_[r].share));
    const std::size_t windows =
        std::min((size + length - 1) / length, static_cast<std::size_t>(share));
    for (std::size_t i = 0; i < windows; ++i) {
      const std::size_t room = size - length;
      windows_.push_back(
          {r, windows == 1 ? room / 2 : i * room / (windows - 1), length, {}});
    }
  }
}

int Analysis::decimation_of(const RecordingView& recording) {
  const std::size_t size = recording.size();
  if (size <= Identifier::kCapacity) return 1;
  const double needed = std::ceil(static_cast<double>(size) / Identifier::kCapacity);
  const double allowed = std::floor(listen(recording.u).fastest / kSamplesPerCycle);
  const auto most = static_cast<std::size_t>(std::clamp(allowed, 1.0, needed));
  return static_cast<int>(ident::thinning_for<double>(recording.u, most));
}

void Analysis::thin_out(const RecordingView& recording, int decimation) {
  const std::size_t size = recording.size();
  const auto factor = static_cast<std::size_t>(decimation);
  Recording signals;
  signals.period_s = recording.period_s * decimation;
  signals.t.resize(size / factor);
  const double to_middle = (decimation - 1) * recording.period_s / 2;
  for (std::size_t i = 0; i < signals.t.size(); ++i) {
    signals.t[i] = recording.t[i * factor] + to_middle;
  }
  for (const Column column : {Column::u, Column::y, Column::sp, Column::x}) {
    signals.values(column) = means(recording.values(column), factor);
  }
  if (decimation > 1 && (sources_.empty() || sources_.back().recording != recordings_)) {
    notes_.push_back("long recording: means of " + std::to_string(decimation) +
                     " samples are analysed, one every " + number(signals.period_s) +
                     " s");
  }
  if (signals_.empty()) decimation_ = decimation;
  signals_.push_back(std::move(signals));
}

void Analysis::identify(std::size_t window, ident::EvidencePool* pool,
                        const Progress& progress) {
  const Window& at = windows_[window];
  const Recording& signals = signals_[at.recording];
  const auto part = [&](const std::vector<double>& values) {
    return values.empty() ? std::span<const double>()
                          : std::span(values).subspan(at.first, at.length);
  };
  ident::WindowOptions options;
  options.pool = pool;
  options.earlier = &at.earlier;
  options.verdict_only = depth_ == Depth::kVerdict;
  if (windows_.size() > 1) options.span = static_cast<float>(span_);
  identifier_->start(part(signals.u), part(signals.y), part(signals.sp), 0, options);
  identified_ = window;
  while (!identifier_->step(kSlice)) {
    if (progress) progress(static_cast<int>(window) + 1, windows());
  }
}

WindowFinding Analysis::finding_of(const Window& window) const {
  const Identification& result = identifier_->result();
  const std::vector<double>& t = signals_[window.recording].t;
  const auto& ladder = result.evidence.ladder;
  return {sources_[window.recording].recording,
          t[window.first],
          t[window.first + window.length - 1],
          result.verdict,
          ladder.predicted > 0 ? ladder.nats : std::nan(""),
          result.stick_band,
          result.gain_sign};
}

// The sum over all windows against what most of them say.
void Analysis::judge_together(float counted) {
  const ident::PooledView view = ident::view_of(pooled_, counted);
  const bool fault = is_fault(result_.verdict);
  if (view == ident::PooledView::kSticks && !fault &&
      ident::moves_output(result_.evidence)) {
    result_.verdict = ident::Verdict::kStiction;
    result_.reason = ident::Reason::kSticksTogether;
    result_.cause = ident::Cause::kValve;
    const Estimate band{true, pooled_.band, pooled_.low, pooled_.high};
    result_.stick_band = {band, band};
    result_.slip_jump = {};
  } else if (view == ident::PooledView::kNothing && fault &&
             ident::nats_of_stems(result_.evidence, 0.0) < ident::kAloneNats) {
    result_.verdict = ident::Verdict::kUndecided;
    result_.reason = ident::Reason::kWindowsDisagree;
    result_.cause = ident::Cause::kUnknown;
    result_.stick_band = result_.slip_jump = {};
  }
}

// No band is told that none of the recordings has.
void Analysis::mind_contradictions() {
  using Kind = Contradiction::Kind;
  const Contradiction found = contradiction_of(findings_);
  if (found.kind == Kind::kNone) return;
  notes_.push_back(found.note);
  if (found.kind == Kind::kGains ||
      (found.kind == Kind::kRepaired && !found.mostly_sticks)) {
    result_.verdict = ident::Verdict::kUndecided;
    result_.reason = ident::Reason::kWindowsDisagree;
    result_.cause = ident::Cause::kUnknown;
  }
  if (found.kind != Kind::kRepaired || !found.mostly_sticks) {
    result_.stick_band = result_.slip_jump = {};
  }
}

void Analysis::take_medians(const std::vector<const Identification*>& agreeing) {
  using R = const Identification&;
  result_.stick_band = {
      median_of(agreeing, [](R r) -> const Estimate& { return r.stick_band.ascending; }),
      median_of(agreeing,
                [](R r) -> const Estimate& { return r.stick_band.descending; })};
  result_.slip_jump = {
      median_of(agreeing, [](R r) -> const Estimate& { return r.slip_jump.ascending; }),
      median_of(agreeing, [](R r) -> const Estimate& { return r.slip_jump.descending; })};
}

void Analysis::vote(const std::vector<Identification>& results) {
  if (results.size() == 1) {
    result_ = results.front();
    return;
  }
  Votes votes{};
  Votes moving{};
  for (const Identification& result : results) {
    ++votes[static_cast<int>(result.verdict)];
    moving[static_cast<int>(result.verdict)] += rests(result) ? 0 : 1;
  }
  const bool any_moves = moving != Votes{};
  const ident::Verdict verdict = majority_of(any_moves ? moving : votes);

  std::vector<const Identification*> agreeing;
  for (const Identification& result : results) {
    const bool heard = !any_moves || !rests(result);
    if (heard && result.verdict == verdict) agreeing.push_back(&result);
  }
  // Windows that contradict each other may leave none that is undecided itself.
  if (agreeing.empty()) agreeing.push_back(&results.front());
  std::vector<double> bands;
  for (const Identification* result : agreeing) bands.push_back(mean_band(*result));
  const double middle = median(bands);
  const auto nearest = std::min_element(
      agreeing.begin(), agreeing.end(), [middle](const auto* a, const auto* b) {
        return std::abs(mean_band(*a) - middle) < std::abs(mean_band(*b) - middle);
      });
  shown_ = static_cast<std::size_t>(*nearest - results.data());
  result_ = results[shown_];
  result_.cause = common_cause(agreeing);
  if (result_.verdict != verdict) {
    result_.verdict = verdict;
    result_.reason = ident::Reason::kEvidenceTooWeak;
    result_.cause = ident::Cause::kUnknown;
  }
  result_.stick_band = {};
  result_.slip_jump = {};
  if (is_fault(verdict)) {
    take_medians(agreeing);
    result_.reason = ident::strokes_that_stick(result_.reason, result_.stick_band);
  }
}

void Analysis::note_votes() {
  Votes votes{};
  for (const WindowFinding& one : findings_) ++votes[static_cast<int>(one.verdict)];
  std::string note = std::to_string(windows()) + " windows of " +
                     (recordings_ == 1 ? "the recording:" : "the recordings:") +
                     listed(votes) + ';';
  note += result_.stick_band.ascending.known
              ? " bands and jumps are medians, the models those of the window from "
              : " the models are those of the window from ";
  note += number(findings_[shown_].from_s) + " s on";
  if (recordings_ > 1) {
    note += " in recording " + std::to_string(findings_[shown_].recording + 1);
  }
  notes_.push_back(note);
}

// Where a band is told that is narrower, what would have shown is not what was seen.
void Analysis::mind_detectable() {
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
    seen.seam_at = std::max(seen.seam_at, one.seam_at);
  }
  if (seam_at_ > 0) seen.seam_at = seam_at_;
}

Simulation Analysis::simulate() {
  if (identified_ != shown_) identify(shown_, nullptr, {});
  const Window& at = windows_[shown_];
  const Recording& signals = signals_[at.recording];
  const auto part = [&at](const std::vector<double>& values) {
    if (values.empty()) return values;
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(at.first);
    return std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(at.length));
  };
  Simulation out;
  out.period_s = signals.period_s;
  out.t = part(signals.t);
  out.u = part(signals.u);
  out.y = part(signals.y);
  out.sp = part(signals.sp);
  out.x = part(signals.x);
  if (has_model(identifier_->result())) {
    out.y_two_path.resize(at.length);
    identifier_->simulate_two_path(out.y_two_path);
  }
  if (identifier_->result().valve.known) {
    out.y_valve.resize(at.length);
    identifier_->simulate_valve(out.y_valve);
    out.stem.resize(at.length);
    identifier_->stem_positions(out.stem);
  }
  return out;
}

bool has_model(const Identification& result) {
  const auto& b = result.model.process.b;
  return std::any_of(b.begin(), b.end(), [](double value) { return value != 0; });
}

}  // namespace workbench
