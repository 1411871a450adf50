#include "workbench/screen/screen_loop.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

#include "workbench/analysis/analysis.hpp"
#include "workbench/recording/stopped.hpp"

namespace workbench {
namespace {

// Valves that stick among those of an oscillating plant, of which nothing else is known.
constexpr double kUsualShare = 0.25;
constexpr double kNoStem = -10;  // nats: a valve that follows its signal fitted best
constexpr double kPictureCycles = 6;
constexpr std::size_t kPictureSamples = 2000;  // where nothing oscillates

std::string month_of(double seconds) {
  const std::chrono::year_month_day date = std::chrono::floor<std::chrono::days>(
      std::chrono::sys_time<std::chrono::duration<double>>(
          std::chrono::duration<double>(seconds)));
  char text[16];
  std::snprintf(text, sizeof text, "%d-%02u", static_cast<int>(date.year()),
                static_cast<unsigned>(date.month()));
  return text;
}

// What is remembered of a recording whose samples are gone.
struct Remembered {
  double begin_s = 0;  // since 1970 at its first sample
  double t0 = 0;
  bool dated = false;
  double seconds = 0;
  RhythmOfRecording heard;
};

class Trend {
 public:
  explicit Trend(const std::vector<Remembered>& recordings) : recordings_(recordings) {}

  std::vector<Stretch> of(const std::vector<WindowFinding>& findings) {
    for (std::size_t r = 0; r < recordings_.size(); ++r) add_time(r);
    for (const WindowFinding& window : findings) add(window);
    std::vector<Stretch> out;
    for (auto& [name, sum] : stretches_) {
      Stretch stretch;
      stretch.name = name;
      std::size_t most = 0;
      for (const auto& [verdict, count] : sum.verdicts) {
        if (count > most) stretch.verdict = verdict;
        most = std::max(most, count);
      }
      stretch.nats = sum.weighed > 0 ? sum.nats : std::nan("");
      stretch.stick_band = sum.bands > 0 ? sum.band / sum.bands : std::nan("");
      stretch.oscillating = sum.all_s > 0 ? std::min(1.0, sum.on_s / sum.all_s) : 0;
      if (!stretch.verdict.empty()) out.push_back(std::move(stretch));
    }
    if (out.size() < 2) out.clear();
    return out;
  }

 private:
  struct Sum {
    std::map<std::string, std::size_t> verdicts;
    double nats = 0;
    int weighed = 0;
    double band = 0;
    int bands = 0;
    double all_s = 0;
    double on_s = 0;
  };

  [[nodiscard]] std::string name_at(std::size_t recording, double after_s) const {
    const Remembered& r = recordings_[recording];
    if (r.dated) return month_of(r.begin_s + after_s);
    std::string name = std::to_string(recording + 1);
    return std::string(4 - std::min<std::size_t>(name.size(), 4), ' ') + name;
  }

  void add_time(std::size_t recording) {
    const Remembered& r = recordings_[recording];
    constexpr int kPieces = 400;
    for (int k = 0; k < kPieces; ++k) {
      Sum& sum = stretches_[name_at(recording, r.seconds * (k + 0.5) / kPieces)];
      sum.all_s += r.seconds / kPieces;
      const std::size_t all = r.heard.oscillates.size();
      if (all > 0 && r.heard.oscillates[static_cast<std::size_t>(k) * all / kPieces]) {
        sum.on_s += r.seconds / kPieces;
      }
    }
  }

  void add(const WindowFinding& window) {
    const Remembered& r = recordings_[window.recording];
    Sum& sum =
        stretches_[name_at(window.recording, (window.from_s + window.to_s) / 2 - r.t0)];
    ++sum.verdicts[std::string(ident::name(window.verdict))];
    if (std::isfinite(window.nats)) {
      sum.nats += window.nats;
      ++sum.weighed;
    }
    if (window.stick_band.both_known()) {
      sum.band += window.stick_band.mean();
      ++sum.bands;
    }
  }

  const std::vector<Remembered>& recordings_;
  std::map<std::string, Sum> stretches_;
};

void take_pictures(const Recording& last, double period_s, ScreenedLoop& out) {
  const double wanted = period_s > 0 ? kPictureCycles * period_s / last.period_s
                                     : static_cast<double>(kPictureSamples);
  const std::size_t count =
      std::min(last.size(), static_cast<std::size_t>(std::max(wanted, 24.0)));
  out.picture_u = picture_of(last.u, last.size() - count);
  out.picture_y = picture_of(last.y, last.size() - count);
}

// Steps of one direction, and what rests, have a rhythm, too.
bool may_oscillate(ident::Reason reason) {
  return reason != ident::Reason::kOneStroke && reason != ident::Reason::kConstant;
}

// 0 … 1, rising; a half at `middle`.
double rising(double value, double middle, double width) {
  return 1 / (1 + std::exp(-(value - middle) / width));
}

// `out` knows its rhythm, and the share of the time in which u oscillates.
void take_result(const Analysis& analysis, ScreenedLoop& out) {
  const Identification& result = analysis.result();
  out.verdict = ident::name(result.verdict);
  out.reason = ident::sentence(result.reason);
  if (result.cause != ident::Cause::kUnknown) out.cause = ident::name(result.cause);
  out.stick_band = result.stick_band;
  out.slip_jump = result.slip_jump;
  out.detectable_band = result.detectable_band;
  out.span = analysis.span();
  out.windows = analysis.windows();
  const ident::LadderFinding<double>& pooled = analysis.pooled();
  out.nats = pooled.predicted > 0 ? pooled.nats : std::nan("");
  out.stem_nats = ident::nats_of_stems(result.evidence, std::nan(""));
  out.error_ratio = result.evidence.error_ratio;
  out.regularity = result.oscillation.regularity;
  const bool periodic =
      result.oscillation.detected && result.oscillation.period_samples > 0;
  out.period_s = periodic ? result.oscillation.period_samples * analysis.period_s()
                 : out.oscillating_share > 0 ? out.rhythm.period_s
                                             : 0;
}

}  // namespace

void rate(ScreenedLoop& loop) {
  loop.suspicion = loop.cost = 0;
  if (!loop.error.empty()) return;
  const double stem = std::isfinite(loop.stem_nats) ? loop.stem_nats : kNoStem;
  // Where nothing was weighed, nothing speaks against the valve either.
  const double evidence =
      std::isfinite(loop.nats) ? rising(std::max(loop.nats, stem), 20, 15) : kUsualShare;
  const double free_run = rising(loop.error_ratio, 1.3, 0.15);
  const double seen = 0.7 * evidence + 0.3 * free_run;
  if (loop.verdict == "stiction" || loop.verdict == "backlash") {
    loop.suspicion = 0.7 + 0.3 * seen;
  } else if (loop.verdict == "undecided") {
    loop.suspicion = 0.05 + 0.6 * seen;
  } else if (loop.verdict == "no_stiction") {
    loop.suspicion = 0.2 * seen;
  }
  const double width =
      loop.span > 0 ? std::min(1.0, loop.stick_band.mean() / loop.span) : 0;
  loop.cost = 100 * loop.suspicion *
              (0.5 + 0.3 * loop.oscillating_share + 0.2 * std::sqrt(width));
}

ScreenedLoop screen_loop(std::vector<Recording> recordings,
                         const std::vector<std::string>& clocks,
                         const std::function<bool()>& stop) {
  ScreenedLoop out;
  std::vector<Remembered> remembered;
  double all_s = 0;
  double oscillating_s = 0;
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    const Recording& recording = recordings[i];
    Remembered one;
    one.dated = clock_seconds(recording.start, one.begin_s);
    one.t0 = recording.t.front();
    one.seconds = static_cast<double>(recording.size()) * recording.period_s;
    one.heard = rhythm_of(recording, clocks[i]);
    all_s += one.heard.time.all_s;
    oscillating_s += one.heard.time.oscillating_s;
    if (one.heard.rhythm.period_s > 0) out.rhythm = std::move(one.heard.rhythm);
    for (const std::string& note : recording.resampling.notes) {
      if (std::ranges::find(out.notes, note) == out.notes.end()) {
        out.notes.push_back(note);
      }
    }
    remembered.push_back(std::move(one));
  }
  out.unit = recordings.front().unit(Column::u);
  out.from = recordings.front().start;
  out.sample_period_s = recordings.front().period_s;
  take_pictures(recordings.back(), out.rhythm.period_s, out);

  const Analysis analysis(
      std::move(recordings),
      [&stop](int, int) {
        if (stop && stop()) throw Stopped();
      },
      Depth::kVerdict);
  out.samples = static_cast<double>(analysis.samples());
  if (may_oscillate(analysis.result().reason)) {
    out.oscillating_share = all_s > 0 ? std::min(oscillating_s / all_s, 1.0) : 0;
  } else {
    for (Remembered& one : remembered) one.heard.oscillates.clear();
  }
  take_result(analysis, out);
  out.trend = Trend(remembered).of(analysis.findings());
  for (const std::string& note : analysis.notes()) out.notes.push_back(note);
  rate(out);
  return out;
}

}  // namespace workbench
