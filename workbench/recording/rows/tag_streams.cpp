#include "workbench/recording/rows/tag_streams.hpp"

#include <algorithm>
#include <deque>
#include <string>
#include <unordered_map>
#include <utility>

#include "workbench/recording/columns/line_table.hpp"
#include "workbench/recording/letters.hpp"
#include "workbench/recording/rows/row_table.hpp"
#include "workbench/recording/rows/rows_without.hpp"
#include "workbench/recording/spelling/bad_value.hpp"
#include "workbench/recording/stopped.hpp"
#include "workbench/recording/tag_stream.hpp"
#include "workbench/recording/times/times_of_rows.hpp"
#include "workbench/recording/written_zone.hpp"

namespace workbench {
namespace {

constexpr std::size_t kMostTags = 100'000;

bool holds_number(std::string_view cell) {
  return kind_of(cell) == CellKind::kNumber;
}

// What programs that join tables leave where one of them has no row.
bool is_blank(std::string_view cell) {
  const std::string lower = lower_case(cell.substr(0, 8));
  return cell.empty() || lower == "nan" || lower == "null" || lower == "na" ||
         lower == "<na>" || lower == "none";
}

// Of a signal whose rows are fewer than those of others; TwinCAT Scope writes EOF.
bool is_over(std::string_view time) {
  return time.empty() || time == "EOF";
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
    for (Stream& stream : streams_) {
      check_stop(source_.options.stop);
      finish(stream, report);
    }
    const TableContext context{source_.file, source_.layout.header_line,
                               source_.options.required};
    bool on_grid = false;
    RowTable table = merged(std::move(streams_), context, report, on_grid);
    check_stop(source_.options.stop);
    hold_values(table, context, report);
    if (times_.dated) out.start = clock_text(times_, table.t.front());
    out.zone = zone_written(times_);
    if (times_.dated && dates_) {
      const double first = table.t.front();
      for (double& t : table.t) t -= first;
    }
    check_stop(source_.options.stop);
    resample(std::move(table), source_.file, out);
    report.resampled = report.resampled || on_grid;
  }

 private:
  void add_sample(RowScanner& rows, Stream& stream, const TimeSlots& slots,
                  std::size_t value, std::optional<std::size_t> quality) {
    require_room(source_, rows, stream.line.size());
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
    StreamOfTag stream_of;
    choose_tags(stream_of, report);
    std::vector<std::size_t> wanted;
    const bool counted = source_.choice.times.empty();
    TimeSlots slots;
    if (!counted) slots = want_time(source_, source_.choice.times[0], wanted);
    const std::vector<std::size_t> keys = want_keys(wanted);
    const std::vector<ValueSlot> values = want_values(wanted);
    std::optional<std::size_t> unit;
    if (source_.choice.unit) unit = want(wanted, *source_.choice.unit);
    std::string tag;
    RowScanner rows(source_.text, source_.file, source_.layout, wanted, false, counted);
    while (rows.next()) {
      check_stop(source_.options.stop);
      const std::string_view key = tag_of(rows, keys, tag);
      const bool is_empty =
          key.empty() && std::ranges::all_of(values, [&](const auto& v) {
            return rows.cell(v.value).empty();
          });
      if (is_empty) {
        rows.reject(rows.error(keys[0], "a tag", "an empty cell", "remove the row"));
        continue;
      }
      for (std::size_t i = 0; i < values.size(); ++i) {
        const auto found = stream_of[i].find(key);
        if (found == stream_of[i].end()) continue;
        Stream& stream = streams_[found->second];
        if (counted) {
          stream.times.add(static_cast<double>(stream.line.size()) * *source_.options.ts);
        } else if (!reader_.append_time(rows, slots, stream.times)) {
          rows.reject(reader_.time_error(rows, slots, stream.times.form()));
          break;
        }
        rows.accept();
        if (unit) check_unit(rows, *unit, stream);
        add_sample(rows, stream, slots, values[i].in(rows), values[i].quality);
      }
    }
    rows.finish(report.notes);
    if (counted) require_equal_counts();
  }

  static void check_unit(const RowScanner& rows, std::size_t slot, Stream& stream) {
    const std::string_view cell = rows.cell(slot);
    if (cell.empty() || cell == stream.unit || says_no_value(cell, true)) return;
    if (!stream.unit.empty()) {
      throw rows.error(slot,
                       "the unit " + quoted(stream.unit) + ", as before, of " +
                           quoted(stream.signal.name),
                       quoted(cell), "export all values of a tag in one unit");
    }
    stream.unit = cell;
  }

  // Counted rows are of one time only where no tag lacks one.
  void require_equal_counts() const {
    for (const Stream& stream : streams_) {
      const Stream& first = streams_.front();
      if (stream.line.size() == first.line.size()) continue;
      const auto rows_of = [](const Stream& of) {
        return std::to_string(of.line.size()) + " of " + quoted(of.signal.name);
      };
      throw InputError(source_.file, source_.layout.header_line, 1,
                       "as many rows of each tag, where --ts counts them",
                       rows_of(first) + " and " + rows_of(stream),
                       "leave --ts out where the file has times, or export them");
    }
  }

  // By number of the value, by the texts of the keys.
  using StreamOfTag = std::vector<std::unordered_map<std::string_view, std::size_t>>;

  struct ValueSlot {
    std::size_t value = 0;
    std::optional<std::size_t> quality;
    std::optional<std::size_t> whole;
    // Where the value of this row stands.
    [[nodiscard]] std::size_t in(const RowScanner& rows) const {
      const bool is_whole =
          whole && is_blank(rows.cell(value)) && !is_blank(rows.cell(*whole));
      return is_whole ? *whole : value;
    }
  };

  [[nodiscard]] std::vector<std::size_t> want_keys(
      std::vector<std::size_t>& wanted) const {
    std::vector<std::size_t> out;
    for (const std::size_t key : source_.choice.keys) out.push_back(want(wanted, key));
    return out;
  }

  [[nodiscard]] std::vector<ValueSlot> want_values(
      std::vector<std::size_t>& wanted) const {
    std::vector<ValueSlot> out;
    for (const ColumnChoice::Value& value : source_.choice.values) {
      out.push_back({want(wanted, value.column), {}, {}});
      if (value.quality) out.back().quality = want(wanted, *value.quality);
      if (value.whole) out.back().whole = want(wanted, *value.whole);
    }
    return out;
  }

  void refuse_doubt() const {
    const bool settled = std::ranges::any_of(
        streams_, [](const Stream& stream) { return stream.signal.marks.settled(); });
    for (const Stream& stream : streams_) {
      refuse_doubtful({&stream.signal, 1}, source_.layout.points_may_group() && !settled);
    }
  }

  // The tags of the file in the order of their first rows, and those that are wanted.
  void choose_tags(StreamOfTag& stream_of, ResampleReport& report) {
    std::unordered_map<std::string_view, std::size_t> known;  // the first tag of the keys
    std::vector<NamedSignal> tags;
    std::vector<std::size_t> wanted;
    const std::vector<std::size_t> keys = want_keys(wanted);
    const std::vector<ValueSlot> values = want_values(wanted);
    const auto& times = source_.choice.times;
    RowScanner rows(source_.text, source_.file, source_.layout, wanted, false,
                    times.empty());
    std::string text;
    while (rows.next()) {
      check_stop(source_.options.stop);
      const std::string_view key = tag_of(rows, keys, text);
      if (key.empty()) continue;
      auto at = known.find(key);
      if (at == known.end()) {
        if (tags.size() + values.size() > kMostTags) {
          throw rows.error(keys[0], "tags",
                           "more than " + std::to_string(kMostTags) + " names",
                           "export only the tags of one loop");
        }
        at = known.try_emplace(tag_texts_.emplace_back(key), tags.size()).first;
        add_tags(key, source_.choice, source_.layout, rows.column(keys[0]), tags);
        for (std::size_t i = at->second; i < tags.size(); ++i) tags[i].measured = false;
      }
      for (std::size_t i = 0; i < values.size(); ++i) {
        NamedSignal& of_tag = tags[at->second + i];
        of_tag.measured = of_tag.measured || holds_number(rows.cell(values[i].in(rows)));
      }
    }
    const std::vector<PickedSignal> chosen = choose_signals(
        tags, source_.options.names, source_.options.required, {source_.file, 0, "tags"});
    if (const std::string note = elimination_note(chosen, tags); !note.empty()) {
      report.notes.push_back(note);
    }
    stream_of.resize(values.size());
    TimePlace counted;
    counted.seconds_only = true;
    for (const PickedSignal& picked : chosen) {
      const std::size_t value = picked.index % values.size();
      stream_of[value][tag_texts_[picked.index / values.size()]] = streams_.size();
      add_stream(picked.column, tags[picked.index].name,
                 times.empty() ? counted : times[0],
                 source_.choice.values[value].quality);
    }
  }

  void add_stream(Column column, const ColumnName& name, const TimePlace& time,
                  std::optional<std::size_t> quality) {
    streams_.emplace_back(rows_of(source_, column, name, quality),
                          time_column_of(source_, time));
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
      check_stop(source_.options.stop);
      std::size_t samples = 0;
      std::optional<InputError> error;
      for (std::size_t i = 0; i < streams_.size(); ++i) {
        if (is_over(rows.cell(slots[i].column))) continue;
        if (source_.choice.own_rows && is_blank(rows.cell(values[i]))) continue;
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
    rows.finish(report.notes);
  }

  // Times of one signal in s of the common origin, sorted, without gaps and repeats.
  void finish(Stream& stream, ResampleReport& report) {
    refuse_ambiguous(stream.times, source_.file, stream.first_cell);
    refuse_other_day(stream);
    dates_ = stream.times.form() != TimeForm::kNumber;
    TimesOfRows times = stream.times.take();
    refuse_doubtful_times(times, source_.file, stream.first_cell);
    refuse_strange_zone(times, stream);
    TimeOrder order = put_in_order(times);
    if (order.turned) {
      std::ranges::reverse(stream.line);
      std::ranges::reverse(stream.signal.values);
      std::ranges::reverse(stream.signal.quality);
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
    if (order.step_back) put_in_order(stream, times_, source_.file, report);
    drop_repeats(stream, report);
  }

  // Letters of several zones, or of none that is known, put the signals apart by hours,
  // or not.
  void refuse_strange_zone(const TimesOfRows& times, const Stream& stream) const {
    if (!has_origin_ || !times.dated || !times_.dated) return;
    const std::string first = zone_written(times_);
    const std::string zone = zone_written(times);
    if (one_clock(first, zone)) return;
    const TimesOfRows::Doubt doubt = doubt_of_zones(zone_words(first), zone_words(zone));
    throw InputError(source_.file, stream.first_cell.line, stream.first_cell.column,
                     doubt.expected, doubt.found, doubt.advice);
  }

  // Days of which each may be two lie apart by what nobody knows.
  void refuse_other_day(const Stream& stream) {
    const std::optional<std::uint32_t> day = stream.times.one_open_day();
    if (&stream == &streams_.front()) open_day_ = day;
    if (day == open_day_) return;
    throw InputError(source_.file, stream.first_cell.line, stream.first_cell.column,
                     "dates with one reading", quoted(stream.first_cell.text),
                     "say which number is the day: --date-order dmy or --date-order mdy");
  }

  void drop_repeats(Stream& stream, ResampleReport& report) {
    RowTable one{
        std::move(stream.t), std::move(stream.line), {std::move(stream.signal)}, {}};
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

  const CsvSource& source_;
  ValueReader reader_;
  std::vector<Stream> streams_;
  std::deque<std::string> tag_texts_;  // of the keys, in the order of the tags
  TimesOfRows times_;
  std::optional<std::uint32_t> open_day_;  // of the first signal
  bool has_origin_ = false;
  bool dates_ = false;
};

}  // namespace

void read_streams(const CsvSource& source, Recording& out) {
  StreamReader(source).read(out);
}

}  // namespace workbench
