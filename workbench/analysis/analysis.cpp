#include "workbench/analysis/analysis.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <span>

#include "workbench/analysis/longest_part.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

// Passes over the window between two calls of `progress`.
constexpr int kSlice = 20;

std::vector<double> means(const std::vector<double>& values, int count) {
  if (count == 1) return values;
  const auto size = static_cast<std::size_t>(count);
  std::vector<double> out(values.size() / size);
  for (std::size_t i = 0; i < out.size(); ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < size; ++k) sum += values[i * size + k];
    out[i] = sum / count;
  }
  return out;
}

// Period of the largest oscillation in samples, slow ones included; 0 where none is seen.
double oscillation_period(const std::vector<double>& u) {
  constexpr std::size_t kFewest = 256;
  double period = 0;
  double amplitude = 0;
  for (int factor = 1; u.size() / static_cast<std::size_t>(factor) >= kFewest;
       factor *= 16) {
    ident::OscillationDetector<double> detector;
    for (const double value : means(u, factor)) detector.push(value);
    const auto report = detector.report();
    if (report.detected && report.amplitude > amplitude) {
      amplitude = report.amplitude;
      period = report.period_samples * factor;
    }
  }
  return period;
}

double median(std::vector<double> values) {
  const std::size_t middle = values.size() / 2;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(middle),
                   values.end());
  if (values.size() % 2 == 1) return values[middle];
  return (values[middle] +
          *std::max_element(values.begin(),
                            values.begin() + static_cast<std::ptrdiff_t>(middle))) /
         2;
}

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

double mean_band(const Identification& result) {
  return (result.stick_band.ascending.value + result.stick_band.descending.value) / 2;
}

}  // namespace

Analysis::Analysis(const Recording& recording, const Progress& progress)
    : identifier_(std::make_unique<Identifier>()) {
  const auto begin = std::chrono::steady_clock::now();
  const Part part = longest_part(recording);
  if (part.length < recording.size()) {
    const Recording alone = cut_out(recording, part);
    notes_.push_back("joined recordings: y and u jump at " +
                     number(recording.t[part.seam_at]) + " s; only the longest part, " +
                     number(alone.t.front()) + " to " + number(alone.t.back()) +
                     " s, is analysed");
    thin_out(alone);
  } else {
    thin_out(recording);
  }
  const std::size_t size = signals_.size();
  length_ = std::min(size, Identifier::kCapacity);
  const std::size_t windows =
      std::min<std::size_t>((size + length_ - 1) / length_, kMostWindows);
  for (std::size_t i = 0; i < windows; ++i) {
    first_.push_back(windows == 1 ? 0 : i * (size - length_) / (windows - 1));
  }
  std::vector<Identification> results;
  for (std::size_t i = 0; i < windows; ++i) {
    identify(i, progress);
    results.push_back(identifier_->result());
  }
  vote(results);
  take_health(results, part.seam_at);
  const std::chrono::duration<double, std::milli> spent =
      std::chrono::steady_clock::now() - begin;
  runtime_ms_ = spent.count();
}

void Analysis::thin_out(const Recording& recording) {
  const std::size_t size = recording.size();
  if (size > Identifier::kCapacity) {
    const double needed = std::ceil(static_cast<double>(size) / Identifier::kCapacity);
    const double allowed = std::floor(oscillation_period(recording.u) / kSamplesPerCycle);
    decimation_ = static_cast<int>(std::clamp(allowed, 1.0, needed));
  }
  const auto factor = static_cast<std::size_t>(decimation_);
  signals_.period_s = recording.period_s * decimation_;
  signals_.t.resize(size / factor);
  const double to_middle = (decimation_ - 1) * recording.period_s / 2;
  for (std::size_t i = 0; i < signals_.t.size(); ++i) {
    signals_.t[i] = recording.t[i * factor] + to_middle;
  }
  for (const Column column : {Column::u, Column::y, Column::sp, Column::x}) {
    signals_.values(column) = means(recording.values(column), decimation_);
  }
  if (decimation_ > 1) {
    notes_.push_back("long recording: means of " + std::to_string(decimation_) +
                     " samples are analysed, one every " + number(signals_.period_s) +
                     " s");
  }
}

void Analysis::identify(std::size_t window, const Progress& progress) {
  const auto part = [&](const std::vector<double>& values) {
    return values.empty() ? std::span<const double>()
                          : std::span(values).subspan(first_[window], length_);
  };
  identifier_->start(part(signals_.u), part(signals_.y), part(signals_.sp));
  identified_ = window;
  while (!identifier_->step(kSlice)) {
    if (progress) progress(static_cast<int>(window) + 1, windows());
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
  constexpr int kVerdicts = 5;
  std::array<int, kVerdicts> votes{};
  for (const Identification& result : results) ++votes[static_cast<int>(result.verdict)];
  const auto count = [&votes](ident::Verdict v) { return votes[static_cast<int>(v)]; };
  // First whether the valve is at fault, then how: windows that disagree on the slip jump
  // agree on the fault.
  const int sticking = count(ident::Verdict::kStiction);
  const int playing = count(ident::Verdict::kBacklash);
  const int faulty = sticking + playing;
  const int healthy = count(ident::Verdict::kNoStiction);
  ident::Verdict verdict = ident::Verdict::kUndecided;
  if (faulty != healthy && 4 * std::max(faulty, healthy) >= windows()) {
    verdict = healthy > faulty     ? ident::Verdict::kNoStiction
              : playing > sticking ? ident::Verdict::kBacklash
                                   : ident::Verdict::kStiction;
  }

  std::vector<const Identification*> agreeing;
  for (const Identification& result : results) {
    if (result.verdict == verdict) agreeing.push_back(&result);
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
  if (verdict == ident::Verdict::kStiction || verdict == ident::Verdict::kBacklash) {
    take_medians(agreeing);
  }
  std::string note = std::to_string(windows()) + " windows of " +
                     std::to_string(length_) + " samples spread over the recording:";
  for (const ident::Verdict v :
       {ident::Verdict::kStiction, ident::Verdict::kBacklash, ident::Verdict::kNoStiction,
        ident::Verdict::kUndecided, ident::Verdict::kBadData}) {
    if (count(v) > 0) {
      note += ' ' + std::to_string(count(v)) + ' ' + std::string(ident::name(v)) + ',';
    }
  }
  note.back() = ';';
  note += " bands and jumps are medians, the models those of the window from " +
          number(signals_.t[first_[shown_]]) + " s on";
  notes_.push_back(note);
}

// What any window saw; the seam as a sample of the recording where it was cut.
void Analysis::take_health(const std::vector<Identification>& results,
                           std::size_t seam_at) {
  ident::RecordHealth<double>& seen = result_.health;
  for (const Identification& result : results) {
    const ident::RecordHealth<double>& one = result.health;
    seen.sensor_sticks = seen.sensor_sticks || one.sensor_sticks;
    seen.swapped = seen.swapped || one.swapped;
    seen.compressed = seen.compressed || one.compressed;
    seen.points_apart = std::max(seen.points_apart, one.points_apart);
    seen.seam_at = std::max(seen.seam_at, one.seam_at);
  }
  if (seam_at > 0) seen.seam_at = seam_at;
}

Simulation Analysis::simulate() {
  if (identified_ != shown_) identify(shown_, {});
  const auto part = [this](const std::vector<double>& values) {
    if (values.empty()) return values;
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first_[shown_]);
    return std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(length_));
  };
  Simulation out;
  out.period_s = signals_.period_s;
  out.t = part(signals_.t);
  out.u = part(signals_.u);
  out.y = part(signals_.y);
  out.sp = part(signals_.sp);
  out.x = part(signals_.x);
  if (has_model(identifier_->result())) {
    out.y_two_path.resize(length_);
    identifier_->simulate_two_path(out.y_two_path);
  }
  if (identifier_->result().valve.known) {
    out.y_valve.resize(length_);
    identifier_->simulate_valve(out.y_valve);
    out.stem.resize(length_);
    identifier_->stem_positions(out.stem);
  }
  return out;
}

bool has_model(const Identification& result) {
  const auto& b = result.model.process.b;
  return std::any_of(b.begin(), b.end(), [](double value) { return value != 0; });
}

}  // namespace workbench
