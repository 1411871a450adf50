#include "workbench/analysis/analysis.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>

#include "ident/signal/leap.hpp"
#include "workbench/analysis/alignment.hpp"
#include "workbench/analysis/judged_pieces.hpp"
#include "workbench/analysis/listening.hpp"
#include "workbench/analysis/longest_part.hpp"
#include "workbench/analysis/signal_notes.hpp"
#include "workbench/analysis/start_up.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

// Passes over the window between two calls of `progress`.
constexpr int kSlice = 20;

// What is told twice is no evidence.
bool is_copy(const RecordingView& one, const RecordingView& other) {
  return std::ranges::equal(one.u, other.u) && std::ranges::equal(one.y, other.y);
}

// A slip jump that may be none or all of the band is not known.
void forget_open_jumps(Identification& found) {
  const auto forget = [](ident::Estimate<double>& jump,
                         const ident::Estimate<double>& band) {
    if (jump.known && band.known && jump.low <= 0 && jump.high >= band.value) jump = {};
  };
  forget(found.slip_jump.ascending, found.stick_band.ascending);
  forget(found.slip_jump.descending, found.stick_band.descending);
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
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    const auto seen = std::span(recordings).first(i);
    const auto same = std::ranges::find_if(
        seen, [&](const RecordingView& other) { return is_copy(recordings[i], other); });
    if (same == seen.end()) {
      take(recordings[i]);
      continue;
    }
    ++recordings_;
    notes_.push_back(
        "recording " + std::to_string(recordings_) + " holds the samples of recording " +
        std::to_string(same - seen.begin() + 1) + " once more: it is left out");
  }
  run(progress, kMostWindows);
}

void Analysis::take(const RecordingView& recording) {
  JudgedPieces judged = judged_pieces(recording);
  for (std::string& note : judged.notes) notes_.push_back(std::move(note));
  std::size_t longest = 0;
  double samples = 0;
  for (RecordingView& piece : judged.pieces) {
    const auto before = static_cast<std::size_t>(piece.t.data() - recording.t.data());
    piece = without_start_up(longest_of(piece, before, recording.size()));
    if (piece.size() > judged.pieces[longest].size()) {
      longest = static_cast<std::size_t>(&piece - judged.pieces.data());
    }
    samples += static_cast<double>(piece.size());
  }
  const int late = samples_late(judged.pieces[longest]);
  if (late != 0) {
    notes_.push_back(alignment_note(late));
    for (RecordingView& piece : judged.pieces) piece = aligned(piece, late);
  }
  const int decimation = decimation_of(judged.pieces[longest]);
  for (const RecordingView& piece : judged.pieces) {
    thin_out(piece, decimation);
    sources_.push_back({recordings_, static_cast<double>(piece.size()) / samples});
  }
  ++recordings_;
  samples_ += recording.size();
}

RecordingView Analysis::longest_of(const RecordingView& piece, std::size_t before,
                                   std::size_t whole) {
  const UncutPart part = longest_part(piece);
  const RecordingView alone = piece.part(part.first, part.length);
  if (part.length < piece.size()) {
    notes_.push_back("joined recordings: y and u jump at " +
                     number(piece.t[part.seam_at]) + " s; only the longest part, " +
                     number(alone.t.front()) + " to " + number(alone.t.back()) +
                     " s, is analysed");
    seam_at_ = before + part.seam_at;
  }
  for (std::string& note : signal_notes(alone)) {
    if (alone.size() < whole) {
      note = "from " + number(alone.t.front()) + " to " + number(alone.t.back()) +
             " s: " + note;
    }
    if (std::ranges::find(notes_, note) == notes_.end()) {
      notes_.push_back(std::move(note));
    }
  }
  return alone;
}

RecordingView Analysis::without_start_up(const RecordingView& recording) {
  const std::size_t end = start_up_end(recording.u, recording.y);
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
    const auto [least, most] = std::ranges::minmax_element(signals.u);
    low = std::min(low, *least);
    high = std::max(high, *most);
  }
  span_ = high - low;
  std::vector<Identification> results;
  ident::EvidencePool pool;
  identify_windows(results, pool, progress);
  pooled_ = pool.finding(span_);
  vote(results);
  forget_open_jumps(result_);
  // The steps of a controller that holds its output are regular, too.
  if (result_.reason == ident::Reason::kOneStroke) result_.oscillation.detected = false;
  judge_together(results, pool.windows());
  if (recordings_ > 1) mind_contradictions();
  if (windows() > 1) note_votes();
  mind_detectable();
  mind_one_signal();
  take_health(results);
  constexpr double kPoorly = 50;
  const bool open = result_.verdict == ident::Verdict::kUndecided;
  const bool poor = open && result_.fit_valve_percent < kPoorly;
  const std::string note = poor ? same_sample_note(signals_.front()) : "";
  if (!note.empty()) notes_.push_back(note);
  if (is_fault(result_.verdict) && result_.valve.known &&
      result_.fit_valve_percent < result_.fit_linear_percent) {
    notes_.push_back(
        "running free, where loads add up, a valve that follows its signal explains as "
        "much as the sticking one: the verdict rests on what foretells the next sample");
  }
  const std::chrono::duration<double, std::milli> spent =
      std::chrono::steady_clock::now() - begin;
  runtime_ms_ = spent.count();
}

void Analysis::mind_one_signal() {
  const Recording& shown = signals_.front();
  if (is_fault(result_.verdict) || !is_one_signal(shown.u, shown.y)) return;
  if (result_.verdict == ident::Verdict::kNoStiction) {
    leave_open(ident::Reason::kBandWouldNotShow);
  }
  result_.detectable_band = 0;
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
  const double longest = Identifier::kCapacity / kCyclesOfAWindow;
  const double allowed = std::floor(listen(recording.u).fastest / longest);
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
  for (const Column column : kLoopColumns) {
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

// Of a window the share of samples that the one before does not hold.
float Analysis::new_share(std::size_t window) const {
  const Window& at = windows_[window];
  if (window == 0 || windows_[window - 1].recording != at.recording) return 1;
  const std::size_t known = windows_[window - 1].first + windows_[window - 1].length;
  const std::size_t last = at.first + at.length;
  return static_cast<float>(std::min(last - known, at.length)) /
         static_cast<float>(at.length);
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
  options.weight = new_share(window);
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
          ident::nats_of_stems(result.evidence, std::nan("")),
          result.stick_band,
          result.gain_sign};
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
  return std::ranges::any_of(b, [](double value) { return value != 0; });
}

}  // namespace workbench
