#include "workbench/recording/stream_grid.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "workbench/recording/input_error.hpp"

namespace workbench {
namespace {

constexpr double kOnTime = 0.10;  // of an interval: still this instant's sample
constexpr double kLatest = 0.1;   // of the time span before an optional signal begins

class StreamGrid {
 public:
  StreamGrid(std::vector<Stream> streams, const TableContext& context,
             ResampleReport& report)
      : streams_(std::move(streams)), context_(context), report_(report) {}

  RowTable merge() {
    if (!same_times()) {
      for (Stream& stream : streams_) drop_gaps(stream, report_);
    }
    leave_out_late();
    if (streams_.empty()) {
      throw InputError(context_.file, context_.header_line, 0, "signals with values",
                       "none in the whole file", "export the values beside their times");
    }
    return merged();
  }
  [[nodiscard]] bool on_grid() const { return on_grid_; }

 private:
  [[nodiscard]] bool same_times() const {
    return std::ranges::all_of(
        streams_, [this](const Stream& stream) { return stream.t == streams_[0].t; });
  }

  void leave_out_late() {
    double first = -HUGE_VAL;
    double last = -HUGE_VAL;
    for (const Stream& stream : streams_) {
      if (!context_.requires_it(stream.signal) || stream.t.empty()) continue;
      first = std::max(first, stream.t.front());
      last = std::max(last, stream.t.back());
    }
    std::erase_if(streams_, [&](const Stream& stream) {
      const bool late =
          stream.t.empty() || stream.t.front() > first + kLatest * (last - first);
      if (context_.requires_it(stream.signal) || !late) return false;
      report_.notes.push_back(quoted(stream.signal.name) +
                              (stream.t.empty() ? " has no value at all: taken as absent"
                                                : " begins late: left out"));
      return true;
    });
  }

  // Whether how often and how long it was recorded counts for all: what is required does;
  // where nothing is, whatever has samples.
  [[nodiscard]] bool decides(const Stream& stream) const {
    return context_.required.empty() ? stream.t.size() > 1
                                     : context_.requires_it(stream.signal);
  }

  [[nodiscard]] RowTable merged() {
    double start = -HUGE_VAL;
    double end = -HUGE_VAL;
    double first_end = HUGE_VAL;
    double period = HUGE_VAL;
    std::size_t samples = 0;
    for (const Stream& stream : streams_) {
      if (stream.t.size() < 2 && context_.requires_it(stream.signal)) {
        throw InputError(context_.file, context_.header_line, 0,
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
    if (!(start < first_end && instants >= 2 && instants <= most_instants(samples))) {
      throw InputError(context_.file, context_.header_line, 0,
                       "signals recorded over the same time, without long holes",
                       number(std::max(first_end - start, 0.0)) +
                           " s in common, samples " + number(period) + " s apart",
                       "export all tags of the loop over one stretch of time");
    }
    fill_grid(start, period, static_cast<std::size_t>(instants), table);
    return table;
  }

  void fill_grid(double start, double period, std::size_t instants, RowTable& table) {
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
        values[k] = nothing ? kNoValue : stream.signal.values[row];
        if (nothing) own[k] = true;  // not held: left without a value
        if (first) table.line[k] = stream.line[row];
      }
      if (names.size() < 200)
        names += (names.empty() ? "" : ", ") + quoted(stream.signal.name);
      stream.signal.values = std::move(values);
      table.signals.push_back(std::move(stream.signal));
    }
    const auto missing = static_cast<std::size_t>(std::ranges::count(own, false));
    report_.missing += missing;
    on_grid_ = true;
    report_.notes.push_back(names + " have times of their own: put on one grid every " +
                            number(period) + " s by zero-order hold; " +
                            counted(missing, "instant holds", "instants hold") +
                            " the values before");
  }

  std::vector<Stream> streams_;
  const TableContext& context_;
  ResampleReport& report_;
  bool on_grid_ = false;
};

}  // namespace

RowTable merged(std::vector<Stream> streams, const TableContext& context,
                ResampleReport& report, bool& on_grid) {
  StreamGrid grid(std::move(streams), context, report);
  RowTable table = grid.merge();
  on_grid = grid.on_grid();
  return table;
}

}  // namespace workbench
