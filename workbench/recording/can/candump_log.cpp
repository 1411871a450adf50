#include "workbench/recording/can/candump_log.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "config/dbc_storage.hpp"
#include "wire/dbc.hpp"
#include "workbench/recording/can/can_sampler.hpp"
#include "workbench/recording/can/can_series.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/signal_suggestion.hpp"
#include "workbench/recording/stopped.hpp"
#include "workbench/recording/text_encoding.hpp"
#include "workbench/recording/text_file.hpp"

namespace workbench {
namespace {

// The DBC file, and what is said of it.
class DbcFile {
 public:
  DbcFile(std::string_view text, const std::string& name)
      : name_(name), storage_(text), dbc_(storage_.content()) {
    if (!storage_.status().ok()) fail(storage_.status(), "repair the DBC file there");
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
  config::DbcStorage storage_;
  const wire::Dbc& dbc_;
};

Recording sample_log(std::string_view log, const std::string& log_name,
                     const std::vector<CandumpSignal>& signals,
                     std::optional<double> period_s, const std::stop_token& stop) {
  if (period_s && !(std::isfinite(*period_s) && *period_s > 0)) {
    throw std::invalid_argument("the sample period must be a positive number of seconds");
  }
  if (signals.empty()) throw std::invalid_argument("no signal is named");
  std::vector<CanSeries> series;
  for (const CandumpSignal& signal : signals) {
    CanSeries s;
    s.column = signal.column;
    s.reference = signal.title;
    s.signal = signal.signal;
    s.interface = signal.interface;
    series.push_back(std::move(s));
  }
  const CanLogFacts facts = read_series(log, log_name, series, stop);
  check_stop(stop);
  Recording out;
  out.name = log_name;
  sample_series(series, log_name, period_s, out);
  out.resampling.notes.push_back(
      filled("t = 0 is {0} s in the log", {number(facts.start_s, 16)}));
  if (facts.unsupported > 0) {
    out.resampling.notes.push_back(filled("{0} CAN XL lines: not supported, ignored",
                                          {std::to_string(facts.unsupported)}));
  }
  if (facts.cut_line > 0) {
    out.resampling.notes.push_back(
        filled("line {0}, the last of the log, is cut and was left out",
               {std::to_string(facts.cut_line)}));
  }
  return out;
}

// The log `path`; another kind of log is refused by its name.
std::string text_of_log(const std::string& path) {
  std::string bytes = read_text_file(path, kMostBytes);
  std::string converted;
  try {
    (void)text_of(bytes, path, converted);
  } catch (const InputError& other) {
    throw InputError(other.file, other.line, other.column, "a candump log", other.found,
                     other.advice);
  }
  return converted.empty() ? bytes : converted;  // UTF-16, as PowerShell writes
}

// Nothing where the file is not there or is no DBC file: what is wrong with the command
// comes first.
std::optional<std::vector<NamedSignal>> signals_of(const std::string& path) try {
  const std::string text = read_text_file(path, config::DbcStorage::kMaxBytes);
  const config::DbcStorage storage(text);
  if (!storage.status().ok()) return std::nullopt;
  std::vector<NamedSignal> out;
  const wire::Dbc& dbc = storage.content();
  for (const wire::DbcMessage& message : dbc.messages()) {
    for (const wire::DbcSignal& signal : dbc.signals_of(message)) {
      NamedSignal named;
      named.name =
          column_name(std::string(message.name) + '.' + std::string(signal.name));
      named.number = out.size() + 1;
      out.push_back(std::move(named));
    }
  }
  return out;
} catch (const InputError&) {
  return std::nullopt;
}

}  // namespace

Recording parse_candump_log(std::string_view log, const std::string& log_name,
                            std::string_view dbc, const std::string& dbc_name,
                            const CandumpOptions& options) {
  const DbcFile file(dbc, dbc_name);
  std::vector<CandumpSignal> signals;
  const std::string none;
  for (const Column column : kLoopColumns) {
    const std::string& reference =
        of_column(column, none, options.u, options.y, options.sp, options.x);
    if (!reference.empty()) signals.push_back({column, reference, file.find(reference)});
  }
  return sample_log(log, log_name, signals, options.period_s, options.stop);
}

Recording read_candump(const std::string& path, const std::vector<CandumpSignal>& signals,
                       std::optional<double> period_s, const std::stop_token& stop) {
  Recording recording = sample_log(text_of_log(path), path, signals, period_s, stop);
  recording.name = file_name(path);
  return recording;
}

Recording read_candump(const std::string& path, const std::string& dbc_path,
                       const CandumpOptions& options) {
  const std::string dbc = read_text_file(dbc_path, config::DbcStorage::kMaxBytes);
  Recording recording =
      parse_candump_log(text_of_log(path), path, dbc, dbc_path, options);
  recording.name = file_name(path);
  return recording;
}

std::string missing_dbc_signals(const std::string& dbc_path,
                                const std::vector<Column>& missing) {
  const std::optional<std::vector<NamedSignal>> read = signals_of(dbc_path);
  const std::vector<NamedSignal> signals = read.value_or(std::vector<NamedSignal>{});
  std::string needed;
  std::string options;
  for (const Column column : missing) {
    const std::string option = "--" + std::string(name_of(column));
    needed += (needed.empty() ? "" : " and ") + option + " MESSAGE.SIGNAL";
    const auto meant = [column](const NamedSignal& signal) {
      return signal.name.part == part_of(column);
    };
    if (std::ranges::count_if(signals, meant) != 1) continue;
    const auto one = std::ranges::find_if(signals, meant);
    options += (options.empty() ? "" : " ") + option + ' ' + one->name.text;
  }
  if (!read) return "--dbc needs " + needed;
  const std::string have =
      signals.empty() ? " has no signals" : " has the signals " + list_of(signals);
  return "--dbc needs " + needed + ": " + dbc_path + have +
         (options.empty() ? "" : "; add " + options);
}

}  // namespace workbench
