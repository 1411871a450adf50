#include "workbench/recording/rows/wide_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "workbench/recording/columns/mode_column.hpp"
#include "workbench/recording/rows/cut_times.hpp"
#include "workbench/recording/rows/restarts.hpp"
#include "workbench/recording/rows/row_table.hpp"
#include "workbench/recording/rows/rows_without.hpp"
#include "workbench/recording/stopped.hpp"
#include "workbench/recording/times/times_of_rows.hpp"

namespace workbench {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

class WideReader {
 public:
  explicit WideReader(const CsvSource& source)
      : source_(source),
        plain_(source.choice.plain),
        reader_(source.layout, plain_),
        times_(TimeForm::kNumber, 1, true, {}) {
    if (!source.choice.times.empty()) {
      slots_ = want_time(source, source.choice.times[0], wanted_);
      times_ = time_column_of(source, source.choice.times[0]);
      has_time_ = true;
    }
    for (const SignalPlace& place : source.choice.signals) {
      table_.signals.push_back(rows_of(
          source, place.column, source.layout.columns[place.index].name, place.quality));
      value_slots_.push_back(want(wanted_, place.index));
      quality_slots_.push_back(place.quality ? want(wanted_, *place.quality) : kNone);
    }
    if (source.choice.mode) {
      SignalRows mode;
      mode.column = Column::t;
      mode.name = source.layout.columns[*source.choice.mode].name.text;
      mode.is_mode = true;
      table_.signals.push_back(std::move(mode));
      value_slots_.push_back(want(wanted_, *source.choice.mode));
      quality_slots_.push_back(kNone);
    }
  }

  bool read(Recording& out) {
    RowScanner rows(source_.text, source_.file, source_.layout, wanted_, plain_,
                    !has_time_);
    reserve(rows.likely_rows());
    while (rows.next()) {
      check_stop(source_.options.stop);
      read_row(rows);
    }
    ResampleReport& report = out.resampling;
    rows.finish(report.notes);
    if (has_time_) {
      put_in_order(report);
      if (have_own_rows()) return false;
    } else {
      for (std::size_t i = 0; i < table_.line.size(); ++i) {
        table_.t.push_back(static_cast<double>(i) * *source_.options.ts);
      }
    }
    const TableContext context{source_.file, source_.layout.header_line,
                               source_.options.required};
    refuse_doubtful(table_.signals, source_.layout.points_may_group());
    refuse_fractions(table_.signals, behind_time());
    take_out_bad(table_, context);
    for (SignalRows& signal : table_.signals) {
      check_stop(source_.options.stop);
      take_out_codes(signal, report);
      note_words(signal, report);
    }
    if (has_time_) {
      const std::string cut = plain_ ? "" : spread_cut_times(table_, known_times_);
      if (!cut.empty()) report.notes.push_back(cut);
      merge_repeats(table_, report);
    }
    check_stop(source_.options.stop);
    hold_values(table_, context, report);
    note_start(out);
    check_stop(source_.options.stop);
    resample(std::move(table_), source_.file, out);
    return true;
  }

 private:
  // Instants with a value of u or y alone are more than those with both, for either.
  [[nodiscard]] bool have_own_rows() const {
    const auto of = [this](Column column) {
      const auto found = std::ranges::find_if(
          table_.signals,
          [column](const SignalRows& signal) { return signal.column == column; });
      return found == table_.signals.end() ? nullptr : &*found;
    };
    const SignalRows* u = of(Column::u);
    const SignalRows* y = of(Column::y);
    if (u == nullptr || y == nullptr) return false;
    std::size_t both = 0;
    std::size_t u_alone = 0;
    std::size_t y_alone = 0;
    const std::vector<double>& t = table_.t;
    for (std::size_t i = 0; i < t.size();) {
      bool has_u = false;
      bool has_y = false;
      const double at = t[i];
      do {
        has_u = has_u || !std::isnan(u->values[i]);
        has_y = has_y || !std::isnan(y->values[i]);
      } while (++i < t.size() && t[i] == at);
      both += has_u && has_y;
      u_alone += has_u && !has_y;
      y_alone += has_y && !has_u;
    }
    return both < std::min(u_alone, y_alone);
  }

  // The signal whose cells may be the fractions of seconds.
  [[nodiscard]] std::optional<std::size_t> behind_time() const {
    if (!has_time_ || times_.form() == TimeForm::kNumber) return std::nullopt;
    const TimePlace& time = source_.choice.times[0];
    const auto& signals = source_.choice.signals;
    for (std::size_t i = 0; i < signals.size(); ++i) {
      if (signals[i].index == time.clock.value_or(time.column) + 1) return i;
    }
    return std::nullopt;
  }

  void reserve(std::size_t rows) {
    table_.line.reserve(rows);
    if (has_time_) times_.reserve(rows);
    for (SignalRows& signal : table_.signals) signal.values.reserve(rows);
  }

  void read_row(RowScanner& rows) {
    require_room(source_, rows, table_.line.size());
    if (has_time_) {
      if (!reader_.append_time(rows, slots_, times_)) {
        rows.reject(reader_.time_error(rows, slots_, times_.form()));
        return;
      }
      if (table_.line.empty()) {
        first_time_ = {rows.line(), rows.column(slots_.column),
                       std::string(rows.cell(slots_.column))};
      }
    }
    if (plain_ && !has_time_ && rows.is_behind_head()) {
      throw InputError(source_.file, rows.line(), 0,
                       "rows of one recording, where --ts counts them",
                       "the names of the columns once more before the row",
                       "split the recording there, or remove the line with the names");
    }
    rows.accept();
    for (std::size_t i = 0; i < table_.signals.size(); ++i) {
      SignalRows& signal = table_.signals[i];
      if (signal.is_mode) {
        const std::string_view cell = rows.cell(value_slots_[i]);
        signal.values.push_back(cell.empty() ? kNoValue : mode_code(cell));
        continue;
      }
      reader_.append(rows, value_slots_[i], signal);
      if (quality_slots_[i] != kNone) {
        signal.quality.push_back(signal.scale.add(rows.cell(quality_slots_[i])));
      }
    }
    if (rows.is_behind_head()) headed_.push_back(table_.line.size());
    table_.line.push_back(rows.line());
  }

  void put_in_order(ResampleReport& report) {
    refuse_ambiguous(times_, source_.file, first_time_);
    known_times_ = times_.take();
    refuse_doubtful_times(known_times_, source_.file, first_time_);
    TimeOrder order = workbench::put_in_order(known_times_);
    if (order.turned) turn(table_);
    for (auto* notes : {&known_times_.notes, &order.notes}) {
      for (std::string& note : *notes) report.notes.push_back(std::move(note));
    }
    if (order.step_back) join_runs(*order.step_back, report);
    table_.t = std::move(known_times_.t);
  }

  void join_runs(std::size_t step_back, ResampleReport& report) {
    std::optional<Restarts> restarts;
    if (!known_times_.dated) restarts = run_on(known_times_.t, headed_, table_);
    if (!restarts) refuse_step_back(step_back);
    report.notes.push_back(std::move(restarts->note));
    table_.between = std::move(restarts->between);
  }

  // From 0 where dates are written; seconds, epoch seconds included, stay as they are.
  void note_start(Recording& out) {
    if (table_.t.empty()) return;
    const double first = table_.t.front();
    out.start = clock_text(known_times_, first);
    out.zone = zone_written(known_times_);
    if (times_.form() == TimeForm::kNumber || first == 0) return;
    for (auto* times : {&table_.t, &table_.between}) {
      for (double& t : *times) t -= first;
    }
  }

  [[noreturn]] void refuse_step_back(std::size_t row) const {
    const std::vector<double>& t = known_times_.t;
    workbench::refuse_step_back(known_times_, times_.form(), source_.file,
                                {table_.line[row], column_of_time(row), {}}, t[row - 1],
                                t[row]);
  }

  // Counts the columns of the row once more: only its start was kept.
  [[nodiscard]] std::size_t column_of_time(std::size_t row) const {
    const std::uint32_t line = table_.line[row];
    RowScanner rows(source_.text, source_.file, source_.layout, wanted_, plain_);
    while (rows.next()) {
      if (rows.line() == line) return rows.column(slots_.column);
    }
    return 0;
  }

  const CsvSource& source_;
  bool plain_;
  ValueReader reader_;
  TimeColumn times_;
  TimeSlots slots_;
  TimeCell first_time_;
  bool has_time_ = false;
  std::vector<std::size_t> wanted_;
  std::vector<std::size_t> value_slots_;
  std::vector<std::size_t> quality_slots_;
  RowTable table_;
  std::vector<std::size_t> headed_;  // rows behind the names once more
  TimesOfRows known_times_;
};

}  // namespace

bool read_wide(const CsvSource& source, Recording& out) {
  const ResampleReport before = out.resampling;
  const bool is_read = WideReader(source).read(out);
  if (!is_read) out.resampling = before;
  return is_read;
}

ColumnChoice with_own_rows(ColumnChoice choice) {
  choice.shape = ColumnChoice::Shape::kOwnTimes;
  choice.mode.reset();
  choice.plain = false;
  choice.own_rows = true;
  for (SignalPlace& signal : choice.signals) signal.time = 0;
  return choice;
}

}  // namespace workbench
