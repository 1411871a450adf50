#include "workbench/recording/candump_log.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include "wire/candump.hpp"
#include "wire/dbc.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/recording/text_file.hpp"

namespace workbench {
namespace {

constexpr std::size_t kMaxLogBytes = std::size_t{512} << 20;
constexpr std::size_t kMaxDbcBytes = std::size_t{32} << 20;
constexpr std::size_t kMaxMessages = 65536;
constexpr std::size_t kMaxSignals = 262144;
constexpr std::size_t kMaxIdsListed = 16;
constexpr std::size_t kMaxIdsKept = 4096;
constexpr double kCyclicShare = 0.9;     // of intervals on time
constexpr double kOnTime = 0.1;          // of a period
constexpr double kMaxOversampling = 20;  // instants per frame of the slowest kind

std::string hex_id(std::uint32_t id, bool extended) {
  std::array<char, 16> text;
  std::snprintf(text.data(), text.size(), extended ? "%08X" : "%03X",
                static_cast<unsigned>(id));
  return text.data();
}

std::size_t occurrences(std::string_view text, std::string_view word, std::size_t most) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string_view::npos && count < most;
       at = text.find(word, at + word.size())) {
    ++count;
  }
  return count;
}

// The DBC file with the storage it needs.
class DbcFile {
 public:
  DbcFile(std::string_view text, const std::string& name)
      : name_(name),
        messages_(occurrences(text, "BO_", kMaxMessages)),
        signals_(occurrences(text, "SG_", kMaxSignals)),
        dbc_(messages_, signals_) {
    const wire::DbcStatus status = dbc_.parse(text);
    if (!status.ok()) fail(status, "repair the DBC file there");
  }

  [[nodiscard]] wire::FrameSignal find(const std::string& reference) const {
    wire::FrameSignal signal;
    const wire::DbcStatus status = dbc_.find(reference, signal);
    if (status.ok()) return signal;
    if (status.error == wire::DbcError::kUnknownMessage) {
      std::string names;
      for (const wire::DbcMessage& m : dbc_.messages()) add_name(names, m.name);
      throw InputError(name_, 0, 0, "a message named " + quoted(status.found),
                       "the messages " + names, "name one of these");
    }
    if (status.error == wire::DbcError::kUnknownSignal) {
      std::string names;
      for (const wire::DbcMessage& m : dbc_.messages()) {
        if (m.line != status.line) continue;
        for (const wire::DbcSignal& s : dbc_.signals_of(m)) add_name(names, s.name);
      }
      throw InputError(
          name_, status.line, 0, "a signal named " + quoted(status.found),
          names.empty() ? "a message without signals" : "the signals " + names,
          "name one of these");
    }
    if (status.error == wire::DbcError::kLayout) {
      throw InputError(
          name_, status.line, 0, wire::expected_at(status.error),
          quoted(status.found) + " of which " + wire::describe(status.layout),
          "check start bit, length and byte order");
    }
    fail(status, status.error == wire::DbcError::kReference
                     ? "write the message and the signal with a dot between"
                     : "choose another signal, or correct the DBC file");
  }

 private:
  [[noreturn]] void fail(const wire::DbcStatus& status, const char* advice) const {
    throw InputError(name_, status.line, status.column, wire::expected_at(status.error),
                     status.found.empty() ? "nothing" : quoted(status.found), advice);
  }

  static void add_name(std::string& names, std::string_view name) {
    constexpr std::size_t kLongestList = 300;
    if (names.size() < kLongestList) names += (names.empty() ? "" : ", ") + quoted(name);
  }

  const std::string& name_;
  std::vector<wire::DbcMessage> messages_;
  std::vector<wire::DbcSignal> signals_;
  wire::Dbc dbc_;
};

// One signal and all it said, in order of time.
struct Series {
  Column column = Column::u;
  std::string reference;
  wire::FrameSignal signal;
  std::vector<double> t;  // s since the first line of the log
  std::vector<double> value;
  std::vector<std::uint32_t> line;
  std::string interface;
  std::size_t frames = 0;
  std::size_t short_frames = 0;
  std::size_t other_pages = 0;
  std::size_t not_available = 0;
  std::size_t outside_limits = 0;
  std::size_t repeated = 0;
  Spacing spacing;  // of t, when there are at least three

  [[nodiscard]] bool cyclic() const {
    return t.size() >= 3 && spacing.on_time_share >= kCyclicShare;
  }
  [[nodiscard]] std::string title() const {
    return std::string(name_of(column)) + " (" + reference + ")";
  }
};

class LogReader {
 public:
  LogReader(std::string_view text, const std::string& name, std::vector<Series>& series)
      : text_(text), name_(name), series_(series) {}

  void read() {
    std::size_t at = text_.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    while (at < text_.size()) {
      const std::size_t end = std::min(text_.find_first_of("\r\n", at), text_.size());
      ++line_;
      take_line(text_.substr(at, end - at));
      at = end + (text_.substr(end, 2) == "\r\n" ? 2 : 1);
    }
    if (lines_ == 0) {
      fail(1, 1, "lines of a candump log", "an empty file", "record with candump -l");
    }
    for (Series& s : series_) require_samples(s);
  }

  [[nodiscard]] std::size_t unsupported() const { return unsupported_; }
  [[nodiscard]] double start_s() const { return static_cast<double>(base_ns_) * 1e-9; }

 private:
  [[noreturn]] void fail(std::size_t line, std::size_t column, std::string expected,
                         std::string found, std::string advice) const {
    throw InputError(name_, line, column, std::move(expected), std::move(found),
                     std::move(advice));
  }

  void take_line(std::string_view line) {
    if (line.find_first_not_of(" \t") == std::string_view::npos) return;
    wire::CandumpLine parsed;
    const wire::CandumpStatus status = wire::parse_candump(line, parsed);
    const bool unsupported = status.error == wire::CandumpError::kFdFrame ||
                             status.error == wire::CandumpError::kXlFrame;
    if (!status.ok() && !unsupported) {
      const std::string_view rest = line.substr(std::min(status.column - 1, line.size()));
      fail(line_, status.column, wire::expected_at(status.error),
           rest.empty() ? "the end of the line" : quoted(rest),
           "remove the line, or record with candump -l");
    }
    if (lines_++ == 0) base_ns_ = parsed.time_ns;
    if (unsupported) {
      ++unsupported_;
      return;
    }
    note_id(parsed.frame);
    for (Series& s : series_) take_frame(parsed, s);
  }

  void note_id(const wire::CanFrame& frame) {
    if (frame.error || frame.remote) return;
    const std::pair<std::uint32_t, bool> key(frame.id, frame.extended);
    if (ids_.size() < kMaxIdsKept || ids_.contains(key)) ++ids_[key];
  }

  void take_frame(const wire::CandumpLine& line, Series& s) {
    double value = 0;
    const wire::SignalError error = wire::extract(s.signal, line.frame, value);
    if (error == wire::SignalError::kOtherFrame) return;
    ++s.frames;
    if (s.interface.empty()) s.interface = line.interface;
    if (s.interface != line.interface) {
      fail(line_, 0, "frames of " + s.title() + " on one interface",
           "both " + quoted(s.interface) + " and " + quoted(line.interface),
           "keep the lines of one interface");
    }
    switch (error) {
      case wire::SignalError::kShortFrame:
        ++s.short_frames;
        return;
      case wire::SignalError::kNotSelected:
        ++s.other_pages;
        return;
      case wire::SignalError::kNotFinite:
        fail(line_, 0, "a finite value of " + s.title(), "NaN or an infinity",
             "cut the log where the sender had no value");
      default:
        break;
    }
    if (!wire::within_limits(s.signal.signal, value)) {
      if (all_bits_set(s.signal.signal, line.frame)) {
        ++s.not_available;
        return;
      }
      ++s.outside_limits;
    }
    const double t = static_cast<double>(line.time_ns - base_ns_) * 1e-9;
    if (!s.t.empty() && t < s.t.back()) {
      fail(line_, 1, "a time not before the previous frame of " + s.title(),
           "a step back of " + number(s.t.back() - t) + " s",
           "split the log where the clock was set");
    }
    if (!s.t.empty() && t == s.t.back()) {
      ++s.repeated;
      return;
    }
    if (s.t.size() >= kMaxSamples) {
      fail(line_, 0, "at most " + std::to_string(kMaxSamples) + " frames of one signal",
           "more", "split the log");
    }
    s.t.push_back(t);
    s.value.push_back(value);
    s.line.push_back(static_cast<std::uint32_t>(line_));
  }

  static bool all_bits_set(const wire::Signal& signal, const wire::CanFrame& frame) {
    if (signal.type != wire::ValueType::kInteger || signal.is_signed) return false;
    const std::uint64_t ones = ~std::uint64_t{0} >> (64U - signal.length);
    return wire::extract_raw(signal, frame) == ones;
  }

  void require_samples(const Series& s) const {
    if (!s.t.empty()) return;
    const std::string id = hex_id(s.signal.frame_id, s.signal.extended);
    if (s.frames == 0) {
      std::string seen;
      std::size_t listed = 0;
      for (const auto& [key, count] : ids_) {
        if (++listed > kMaxIdsListed) break;
        seen += (seen.empty() ? "" : ", ") + hex_id(key.first, key.second) + " (" +
                std::to_string(count) + " frames)";
      }
      if (ids_.size() > kMaxIdsListed) {
        seen += " and " + std::to_string(ids_.size() - kMaxIdsListed) + " more";
      }
      fail(0, 0, "frames " + id + " of " + s.title(),
           seen.empty() ? "no data frame at all" : "only the identifiers " + seen,
           "check the signal, the DBC file and the log");
    }
    std::string why;
    if (s.other_pages > 0) {
      why = std::to_string(s.other_pages) + " with another multiplexor than " +
            std::to_string(s.signal.multiplex_value);
    } else if (s.short_frames > 0) {
      why = std::to_string(s.short_frames) + " too short";
    } else {
      why = std::to_string(s.not_available) + " marked as not available";
    }
    fail(0, 0, "frames " + id + " that hold " + s.title(),
         std::to_string(s.frames) + " frames, " + why,
         "check the signal and the DBC file, or record longer");
  }

  std::string_view text_;
  const std::string& name_;
  std::vector<Series>& series_;
  std::map<std::pair<std::uint32_t, bool>, std::size_t> ids_;
  std::size_t line_ = 0;
  std::size_t lines_ = 0;
  std::size_t unsupported_ = 0;
  std::int64_t base_ns_ = 0;
};

// Part of a period between a nominal y frame and the instant of sampling: where the
// fewest frames arrive, weighted by the fourth power of closeness around the circle.
double quietest_phase(const std::vector<Series>& all, double first, double period) {
  constexpr std::size_t kBins = 40;
  std::array<double, kBins> arrivals{};
  for (const Series& s : all) {
    // Signals faster than that refresh within every period whatever the phase.
    if (!s.cyclic() || s.spacing.period_s < period / 2) continue;
    for (const double t : s.t) {
      const double cycles = (t - first) / period + 0.5 / kBins;
      const double phase = cycles - std::floor(cycles);
      const auto bin = static_cast<std::size_t>(phase * kBins);
      arrivals[std::min(bin, kBins - 1)] += 1 / static_cast<double>(s.t.size());
    }
  }
  std::size_t best = kBins / 2;
  double best_cost = HUGE_VAL;
  for (std::size_t candidate = 0; candidate < kBins; ++candidate) {
    double cost = 0;
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      const std::size_t apart = bin > candidate ? bin - candidate : candidate - bin;
      const std::size_t around = std::min(apart, kBins - apart);
      const double closeness =
          1 - 2 * static_cast<double>(around) / static_cast<double>(kBins);
      cost += arrivals[bin] * std::pow(closeness, 4);
    }
    if (cost < best_cost) {
      best_cost = cost;
      best = candidate;
    }
  }
  return static_cast<double>(best) / kBins;
}

class Sampler {
 public:
  Sampler(const std::vector<Series>& series, const std::string& name)
      : series_(series), name_(name), reference_(reference_series(series)) {}

  void sample(std::optional<double> period_given, Recording& out) {
    choose_period(period_given);
    choose_instants();
    out.period_s = period_;
    ResampleReport& report = out.resampling;
    report.rows = reference_.t.size() + reference_.repeated;
    report.irregular = reference_.spacing.irregular;
    report.resampled = true;
    for (const Series& s : series_) {
      report.repeated += s.repeated;
      if (!s.cyclic() && &s != &reference_) continue;
      for (std::size_t i = 1; i < s.t.size(); ++i) {
        report.longest_gap_s = std::max(report.longest_gap_s, s.t[i] - s.t[i - 1]);
      }
    }
    out.t.resize(count_);
    for (std::size_t k = 0; k < count_; ++k) {
      out.t[k] = first_ + static_cast<double>(k) * period_;
    }
    std::vector<bool> stale(count_, false);
    for (const Series& s : series_) hold(s, out.values(s.column), stale, report);
    report.missing =
        static_cast<std::size_t>(std::count(stale.begin(), stale.end(), true));
    describe(report);
  }

 private:
  static const Series& reference_series(const std::vector<Series>& series) {
    for (const Column column : {Column::y, Column::x, Column::u, Column::sp}) {
      for (const Series& s : series) {
        if (s.column == column) return s;
      }
    }
    return series.front();
  }

  [[noreturn]] void fail(std::size_t line, std::string expected, std::string found,
                         std::string advice) const {
    throw InputError(name_, line, 0, std::move(expected), std::move(found),
                     std::move(advice));
  }

  void choose_period(std::optional<double> given) {
    const Series& r = reference_;
    if (r.t.size() < 2) {
      fail(r.line.front(), "at least 2 samples of " + r.title(), "1",
           "record for longer");
    }
    double natural = r.spacing.period_s;
    for (const Series& s : series_) {
      if (s.column == Column::u && s.cyclic() && r.cyclic()) {
        natural = std::max(natural, s.spacing.period_s);
      }
    }
    period_ = given.value_or(natural);
    if (!(period_ >= 1e-9) || !(period_ * kMaxOversampling >= r.spacing.period_s)) {
      fail(r.line[1],
           "frames of " + r.title() + " at most " + number(kMaxOversampling) +
               " sample periods apart",
           "a median interval of " + number(r.spacing.period_s) + " s and a period of " +
               number(period_) + " s",
           "choose a longer sample period");
    }
  }

  void choose_instants() {
    const Series& r = reference_;
    double known = r.t.front();
    for (const Series& s : series_) known = std::max(known, s.t.front());
    const double delay = quietest_phase(series_, r.t.front(), period_) * period_;
    const auto start = std::find_if(r.t.begin(), r.t.end(),
                                    [&](double t) { return t + delay >= known; });
    double last = r.t.back();
    for (const Series& s : series_) {
      if (&s == &reference_ || s.column == Column::sp || !s.cyclic()) continue;
      last = std::min(last, s.t.back() + std::max(period_, s.spacing.period_s) - delay);
    }
    const double instants =
        start == r.t.end() ? 0 : std::floor((last - *start) / period_ + kOnTime) + 1;
    if (!(instants >= 2)) {
      fail(0, "all signals during at least 2 sample periods of " + number(period_) + " s",
           "hardly any common time", "record for longer, or check the signals");
    }
    if (!(period_ > 8 * std::numeric_limits<double>::epsilon() * std::abs(last))) {
      fail(0, "times that tell samples " + number(period_) + " s apart",
           number(last) + " s since the first line", "split the log");
    }
    const double limit =
        std::min(static_cast<double>(kMaxSamples),
                 kMaxOversampling * static_cast<double>(r.t.size()) + 1000);
    if (instants > limit) {
      std::size_t widest = 1;
      for (std::size_t i = 2; i < r.t.size(); ++i) {
        if (r.t[i] - r.t[i - 1] > r.t[widest] - r.t[widest - 1]) widest = i;
      }
      fail(r.line[widest], "a log without long holes",
           "a gap of " + number(r.t[widest] - r.t[widest - 1]) + " s in " + r.title() +
               " and " + number(instants) + " sample periods of " + number(period_) +
               " s",
           "split the log at the gap");
    }
    first_ = *start;
    delay_ = delay;
    count_ = static_cast<std::size_t>(instants);
  }

  void hold(const Series& s, std::vector<double>& out, std::vector<bool>& stale,
            ResampleReport& report) const {
    const bool should_refresh =
        &s == &reference_ || (s.column != Column::sp && s.cyclic());
    const bool every_instant = should_refresh && s.spacing.period_s <= 1.5 * period_;
    out.resize(count_);
    std::size_t row = 0;
    std::size_t unrefreshed = 0;
    for (std::size_t k = 0; k < count_; ++k) {
      const double instant = first_ + delay_ + static_cast<double>(k) * period_;
      const std::size_t before = row;
      while (row + 1 < s.t.size() && s.t[row + 1] <= instant) ++row;
      out[k] = s.value[row];
      if (every_instant && k > 0 && row == before) {
        stale[k] = true;
        ++unrefreshed;
      }
    }
    if (unrefreshed > 0) {
      report.notes.push_back(std::to_string(unrefreshed) +
                             " instants without a new frame of " + s.title() +
                             ": the value before is held");
    }
  }

  void describe(ResampleReport& report) const {
    std::string note = "sampled every " + number(period_) + " s by zero-order hold";
    for (const Series& s : series_) {
      note += "; " + s.title() + ": " + std::to_string(s.t.size()) + " values";
      if (s.t.size() >= 2)
        note += ", median interval " + number(s.spacing.period_s) + " s";
      if (!s.cyclic()) note += ", not cyclic";
    }
    if (reference_.spacing.irregular > 0) {
      note += "; " + std::to_string(reference_.spacing.irregular) + " intervals of " +
              reference_.title() + " are more than 1 % off";
    }
    report.notes.push_back(note);
    const auto say = [&report](std::size_t count, const Series& s, const char* what) {
      if (count > 0) {
        report.notes.push_back(std::to_string(count) + " frames of " + s.title() + ' ' +
                               what);
      }
    };
    for (const Series& s : series_) {
      say(s.repeated, s, "repeat the time of the one before: dropped");
      say(s.short_frames, s, "are too short for the signal: ignored");
      say(s.not_available, s, "have all bits set, outside the limits: not available");
      say(s.outside_limits, s, "hold a value outside the limits of the DBC file: kept");
    }
  }

  const std::vector<Series>& series_;
  const std::string& name_;
  const Series& reference_;
  double period_ = 0;
  double first_ = 0;  // nominal time of the first instant
  double delay_ = 0;  // from there to the instant of sampling
  std::size_t count_ = 0;
};

Recording sample_log(std::string_view log, const std::string& log_name,
                     const std::vector<CandumpSignal>& signals,
                     std::optional<double> period_s) {
  if (period_s && !(std::isfinite(*period_s) && *period_s > 0)) {
    throw std::invalid_argument("the sample period must be a positive number of seconds");
  }
  if (signals.empty()) throw std::invalid_argument("no signal is named");
  std::vector<Series> series;
  for (const CandumpSignal& signal : signals) {
    Series s;
    s.column = signal.column;
    s.reference = signal.title;
    s.signal = signal.signal;
    series.push_back(std::move(s));
  }
  LogReader reader(log, log_name, series);
  reader.read();
  for (Series& s : series) {
    if (s.t.size() >= 2) s.spacing = spacing_of(s.t);
  }
  Recording out;
  out.name = log_name;
  Sampler(series, log_name).sample(period_s, out);
  out.resampling.notes.push_back("t = 0 is " + number(reader.start_s(), 16) +
                                 " s in the log");
  if (reader.unsupported() > 0) {
    out.resampling.notes.push_back(std::to_string(reader.unsupported()) +
                                   " CAN FD or CAN XL lines: not supported, ignored");
  }
  return out;
}

}  // namespace

Recording parse_candump_log(std::string_view log, const std::string& log_name,
                            std::string_view dbc, const std::string& dbc_name,
                            const CandumpOptions& options) {
  const DbcFile file(dbc, dbc_name);
  std::vector<CandumpSignal> signals;
  for (const auto& [column, reference] :
       {std::pair<Column, const std::string&>(Column::u, options.u),
        std::pair<Column, const std::string&>(Column::y, options.y),
        std::pair<Column, const std::string&>(Column::sp, options.sp),
        std::pair<Column, const std::string&>(Column::x, options.x)}) {
    if (!reference.empty()) signals.push_back({column, reference, file.find(reference)});
  }
  return sample_log(log, log_name, signals, options.period_s);
}

Recording read_candump(const std::string& path, const std::vector<CandumpSignal>& signals,
                       std::optional<double> period_s) {
  Recording recording =
      sample_log(read_text_file(path, kMaxLogBytes), path, signals, period_s);
  recording.name = file_name(path);
  return recording;
}

Recording read_candump(const std::string& path, const std::string& dbc_path,
                       const CandumpOptions& options) {
  const std::string dbc = read_text_file(dbc_path, kMaxDbcBytes);
  Recording recording =
      parse_candump_log(read_text_file(path, kMaxLogBytes), path, dbc, dbc_path, options);
  recording.name = file_name(path);
  return recording;
}

}  // namespace workbench
