#include "workbench/recording/tag_streams.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <string>
#include <unordered_map>
#include <utility>

#include "workbench/recording/bad_code.hpp"
#include "workbench/recording/line_table.hpp"
#include "workbench/recording/quality_words.hpp"
#include "workbench/recording/row_table.hpp"
#include "workbench/recording/tag_stream.hpp"
#include "workbench/recording/time_order.hpp"

namespace workbench {
namespace {

constexpr std::size_t kMostTags = 100'000;
constexpr double kOnTime = 0.10;   // of an interval: still this instant's sample
constexpr double kLatest = 0.1;    // of the time span before an optional signal begins
constexpr double kMaxGrowth = 20;  // grid instants a sample, plus kFreeGrowth
constexpr double kFreeGrowth = 1000;
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

bool holds_number(std::string_view cell) {
  return kind_of(cell) == CellKind::kNumber;
}

class StreamReader {
 public:
  explicit StreamReader(const CsvSource& source)
      : source_(source), reader_(source.layout, false) {}

  void read(Recording& out) {
    ResampleReport& report = out.resampling;
    if (source_.choice.shape == ColumnChoice::Shape::kLong) {
      read_long(report);
    } else {
      read_pairs(report);
    }
    refuse_doubt();
    for (Stream& stream : streams_) finish(stream, report);
    if (!same_times()) {
      for (Stream& stream : streams_) drop_gaps(stream, report);
    }
    leave_out_late(report);
    if (streams_.empty()) {
      throw InputError(source_.file, source_.layout.header_line, 0, "signals with values",
                       "none in the whole file", "export the values beside their times");
    }
    RowTable table = merged(report);
    const TableContext context{source_.file, source_.layout.header_line,
                               source_.options.required};
    hold_values(table, context, report);
    if (times_.dated) out.start = clock_text(times_, table.t.front());
    if (times_.dated && dates_) {
      const double first = table.t.front();
      for (double& t : table.t) t -= first;
    }
    resample(std::move(table), source_.file, out);
    report.resampled = report.resampled || on_grid_;
  }

 private:
  void add_sample(RowScanner& rows, Stream& stream, const TimeSlots& slots,
                  std::size_t value, std::optional<std::size_t> quality) {
    if (stream.line.size() >= kMaxSamples) {
      throw InputError(source_.file, rows.line(), 0,
                       "at most " + std::to_string(kMaxSamples) + " rows", "more",
                       "split the recording");
    }
    if (stream.line.empty()) {
      stream.first_cell = {rows.line(), rows.column(slots.column),
                           std::string(rows.cell(slots.column))};
    }
    reader_.append(rows, value, stream.signal);
    if (quality) {
      stream.signal.quality.push_back(stream.signal.scale.add(rows.cell(*quality)));
    }
    stream.line.push_back(rows.line());
  }

  void read_long(ResampleReport& report) {
    std::unordered_map<std::string_view, std::size_t> stream_of;
    choose_tags(stream_of, report);
    std::vector<std::size_t> wanted;
    const TimeSlots slots = want_time(source_, source_.choice.times[0], wanted);
    const std::size_t tag = want(wanted, source_.choice.tag);
    const std::size_t value = want(wanted, source_.choice.value);
    std::optional<std::size_t> parameter;
    if (source_.choice.parameter) parameter = want(wanted, *source_.choice.parameter);
    std::string key;
    std::optional<std::size_t> quality;
    if (source_.choice.quality) quality = want(wanted, *source_.choice.quality);
    RowScanner rows(source_.text, source_.file, source_.layout, wanted, false);
    while (rows.next()) {
      if (rows.cell(tag).empty() && rows.cell(value).empty()) {
        rows.reject(rows.error(tag, "a tag", "an empty cell", "remove the row"));
        continue;
      }
      const auto found = stream_of.find(tag_of(rows, tag, parameter, key));
      if (found == stream_of.end()) continue;
      Stream& stream = streams_[found->second];
      if (!reader_.append_time(rows, slots, stream.times)) {
        rows.reject(reader_.time_error(rows, slots, stream.times.form()));
        continue;
      }
      rows.accept();
      add_sample(rows, stream, slots, value, quality);
    }
    for (std::string& note : rows.finish()) report.notes.push_back(std::move(note));
  }

  void refuse_doubt() const {
    const bool settled =
        std::any_of(streams_.begin(), streams_.end(),
                    [](const Stream& stream) { return stream.signal.marks.settled(); });
    for (const Stream& stream : streams_) {
      refuse_doubtful({&stream.signal, 1}, source_.layout.points_may_group() && !settled);
    }
  }

  // The tags of the file in the order of their first rows, and those that are wanted.
  void choose_tags(std::unordered_map<std::string_view, std::size_t>& stream_of,
                   ResampleReport& report) {
    std::unordered_map<std::string_view, std::size_t> known;
    std::vector<NamedSignal> tags;
    std::vector<std::size_t> wanted = {source_.choice.tag, source_.choice.value};
    std::optional<std::size_t> parameter;
    if (source_.choice.parameter) parameter = want(wanted, *source_.choice.parameter);
    RowScanner rows(source_.text, source_.file, source_.layout, wanted, false);
    std::string key;
    while (rows.next()) {
      const std::string_view tag = tag_of(rows, 0, parameter, key);
      if (tag.empty()) continue;
      const auto at = known.find(tag);
      if (at != known.end()) {
        NamedSignal& of_tag = tags[at->second];
        of_tag.measured = of_tag.measured || holds_number(rows.cell(1));
        continue;
      }
      if (tags.size() >= kMostTags) {
        throw rows.error(0, "tags", "more than " + std::to_string(kMostTags) + " names",
                         "export only the tags of one loop");
      }
      known[tag_texts_.emplace_back(tag)] = tags.size();
      tags.push_back({column_name(tag), tags.size() + 1, rows.column(0),
                      holds_number(rows.cell(1))});
    }
    const std::vector<PickedSignal> chosen = choose_signals(
        tags, source_.options.names, source_.options.required, {source_.file, 0, "tags"});
    if (const std::string note = elimination_note(chosen, tags); !note.empty()) {
      report.notes.push_back(note);
    }
    for (const PickedSignal& picked : chosen) {
      stream_of[tag_texts_[picked.index]] = streams_.size();
      add_stream(picked.column, tags[picked.index].name, source_.choice.times[0],
                 source_.choice.quality);
    }
  }

  void add_stream(Column column, const ColumnName& name, const TimePlace& time,
                  std::optional<std::size_t> quality) {
    SignalRows signal;
    signal.column = column;
    signal.name = name.text;
    signal.unit = name.unit;
    if (quality) {
      signal.scale =
          QualityScale(marks_bad(source_.layout.columns[*quality].name.pieces));
    }
    streams_.emplace_back(std::move(signal), time_column_of(source_, time));
  }

  void read_pairs(ResampleReport& report) {
    std::vector<std::size_t> wanted;
    std::vector<TimeSlots> slots;
    std::vector<std::size_t> values;
    std::vector<std::optional<std::size_t>> qualities;
    for (const SignalPlace& place : source_.choice.signals) {
      const TimePlace& time = source_.choice.times[*place.time];
      slots.push_back(want_time(source_, time, wanted));
      values.push_back(want(wanted, place.index));
      qualities.emplace_back();
      if (place.quality) qualities.back() = want(wanted, *place.quality);
      add_stream(place.column, source_.layout.columns[place.index].name, time,
                 place.quality);
    }
    RowScanner rows(source_.text, source_.file, source_.layout, wanted, false);
    while (rows.next()) {
      std::size_t samples = 0;
      std::optional<InputError> error;
      for (std::size_t i = 0; i < streams_.size(); ++i) {
        if (rows.cell(slots[i].column).empty()) continue;
        if (!reader_.append_time(rows, slots[i], streams_[i].times)) {
          error = reader_.time_error(rows, slots[i], streams_[i].times.form());
          continue;
        }
        if (samples++ == 0) rows.accept();
        add_sample(rows, streams_[i], slots[i], values[i], qualities[i]);
      }
      if (error && samples > 0) throw InputError(*error);
      if (error) rows.reject(*error);
    }
    for (std::string& note : rows.finish()) report.notes.push_back(std::move(note));
  }

  // Times of one signal in s of the common origin, sorted, without gaps and repeats.
  void finish(Stream& stream, ResampleReport& report) {
    refuse_ambiguous(stream.times, source_.file, stream.first_cell);
    dates_ = stream.times.form() != TimeForm::kNumber;
    TimesOfRows times = stream.times.take();
    refuse_absurd_step(times, source_.file, stream.first_cell);
    TimeOrder order = put_in_order(times);
    if (order.turned) {
      std::reverse(stream.line.begin(), stream.line.end());
      std::reverse(stream.signal.values.begin(), stream.signal.values.end());
      std::reverse(stream.signal.quality.begin(), stream.signal.quality.end());
    }
    double shift = 0;
    if (has_origin_) {
      shift = (times.origin_day - times_.origin_day) * 86400.0 +
              (times.origin_seconds - times_.origin_seconds);
    }
    for (double& t : times.t) t += shift;
    stream.t = std::move(times.t);
    if (!has_origin_ && !stream.t.empty()) {
      for (auto* notes : {&times.notes, &order.notes}) {
        report.notes.insert(report.notes.end(), notes->begin(), notes->end());
      }
      times_ = std::move(times);
      has_origin_ = true;
    }
    if (order.step_back) sort(stream);
    drop_repeats(stream, report);
  }

  void drop_repeats(Stream& stream, ResampleReport& report) {
    RowTable one{std::move(stream.t), std::move(stream.line), {std::move(stream.signal)}};
    take_out_bad(one,
                 {source_.file, source_.layout.header_line, source_.options.required});
    take_out_codes(one.signals[0], report);
    note_words(one.signals[0], report);
    ResampleReport of_stream;
    merge_repeats(one, of_stream);
    if (of_stream.repeated > 0) {
      report.repeated += of_stream.repeated;
      report.notes.push_back(quoted(one.signals[0].name) + ": " + of_stream.notes[0]);
    }
    stream.t = std::move(one.t);
    stream.line = std::move(one.line);
    stream.signal = std::move(one.signals[0]);
  }

  [[nodiscard]] bool same_times() const {
    return std::all_of(streams_.begin(), streams_.end(), [this](const Stream& stream) {
      return stream.t == streams_[0].t;
    });
  }

  void leave_out_late(ResampleReport& report) {
    double first = -HUGE_VAL;
    double last = -HUGE_VAL;
    for (const Stream& stream : streams_) {
      if (!is_required(stream) || stream.t.empty()) continue;
      first = std::max(first, stream.t.front());
      last = std::max(last, stream.t.back());
    }
    std::erase_if(streams_, [&](const Stream& stream) {
      const bool late =
          stream.t.empty() || stream.t.front() > first + kLatest * (last - first);
      if (is_required(stream) || !late) return false;
      report.notes.push_back(quoted(stream.signal.name) +
                             (stream.t.empty() ? " has no value at all: taken as absent"
                                               : " begins late: left out"));
      return true;
    });
  }

  [[nodiscard]] bool is_required(const Stream& stream) const {
    const std::vector<Column>& required = source_.options.required;
    return stream.signal.column != Column::t &&
           std::find(required.begin(), required.end(), stream.signal.column) !=
               required.end();
  }

  // Whether how often and how long it was recorded counts for all: what is required does;
  // where nothing is, whatever has samples.
  [[nodiscard]] bool decides(const Stream& stream) const {
    return source_.options.required.empty() ? stream.t.size() > 1 : is_required(stream);
  }

  [[nodiscard]] RowTable merged(ResampleReport& report) {
    double start = -HUGE_VAL;
    double end = -HUGE_VAL;
    double first_end = HUGE_VAL;
    double period = HUGE_VAL;
    std::size_t samples = 0;
    for (const Stream& stream : streams_) {
      if (stream.t.size() < 2 && is_required(stream)) {
        throw InputError(source_.file, source_.layout.header_line, 0,
                         "at least 2 samples of " + quoted(stream.signal.name),
                         std::to_string(stream.t.size()),
                         "export a longer time, or another tag");
      }
      start = std::max(start, stream.t.front());
      if (!decides(stream)) continue;
      end = std::max(end, stream.t.back());
      first_end = std::min(first_end, stream.t.back());
      period = std::min(period, spacing_of(stream.t).period_s);
      samples = std::max(samples, stream.t.size());
    }
    RowTable table;
    if (same_times()) {
      table.t = streams_[0].t;
      table.line = streams_[0].line;
      for (Stream& stream : streams_) table.signals.push_back(std::move(stream.signal));
      return table;
    }
    const double instants = std::floor((end - start) / period + kOnTime) + 1;
    const double most = std::min(static_cast<double>(kMaxSamples),
                                 kMaxGrowth * static_cast<double>(samples) + kFreeGrowth);
    if (!(start < first_end && instants >= 2 && instants <= most)) {
      throw InputError(source_.file, source_.layout.header_line, 0,
                       "signals recorded over the same time, without long holes",
                       number(std::max(first_end - start, 0.0)) +
                           " s in common, samples " + number(period) + " s apart",
                       "export all tags of the loop over one stretch of time");
    }
    fill_grid(start, period, static_cast<std::size_t>(instants), table, report);
    return table;
  }

  void fill_grid(double start, double period, std::size_t instants, RowTable& table,
                 ResampleReport& report) {
    std::vector<bool> own(instants, false);
    table.t.resize(instants);
    for (std::size_t k = 0; k < instants; ++k) {
      table.t[k] = start + static_cast<double>(k) * period;
    }
    std::string names;
    for (Stream& stream : streams_) {
      std::vector<double> values(instants);
      std::size_t row = 0;
      std::size_t before = static_cast<std::size_t>(-1);
      const bool first = &stream == &streams_.front();
      const double silent_s = stream.is_of_loop() ? longest_pause_s(stream) : HUGE_VAL;
      if (first) table.line.resize(instants);
      for (std::size_t k = 0; k < instants; ++k) {
        const double latest = table.t[k] + kOnTime * period;
        while (row + 1 < stream.t.size() && stream.t[row + 1] <= latest) ++row;
        if (row != before && stream.is_of_loop()) own[k] = true;
        before = row;
        const bool silent =
            next_time(stream, row, table.t.back()) - stream.t[row] > silent_s;
        const bool own_instant = table.t[k] < stream.t[row] + (1 - kOnTime) * period;
        const bool nothing = silent && !own_instant;
        values[k] = nothing ? kNothing : stream.signal.values[row];
        if (nothing) own[k] = true;  // not held: left without a value
        if (first) table.line[k] = stream.line[row];
      }
      if (names.size() < 200)
        names += (names.empty() ? "" : ", ") + quoted(stream.signal.name);
      stream.signal.values = std::move(values);
      table.signals.push_back(std::move(stream.signal));
    }
    const auto missing =
        static_cast<std::size_t>(std::count(own.begin(), own.end(), false));
    report.missing += missing;
    on_grid_ = true;
    report.notes.push_back(names + " have times of their own: put on one grid every " +
                           number(period) + " s by zero-order hold; " +
                           counted(missing, "instant holds", "instants hold") +
                           " the values before");
  }

  const CsvSource& source_;
  ValueReader reader_;
  std::vector<Stream> streams_;
  std::deque<std::string> tag_texts_;  // in the order of the tags
  TimesOfRows times_;
  bool has_origin_ = false;
  bool dates_ = false;
  bool on_grid_ = false;
};

}  // namespace

void read_streams(const CsvSource& source, Recording& out) {
  StreamReader(source).read(out);
}

}  // namespace workbench
