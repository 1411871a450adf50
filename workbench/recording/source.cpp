#include "workbench/recording/source.hpp"

#include <stdexcept>

#include "config/gateway.hpp"
#include "workbench/recording/can/candump_log.hpp"
#include "workbench/recording/csv.hpp"
#include "workbench/recording/rest_before.hpp"
#include "workbench/recording/tag_file.hpp"
#include "workbench/recording/text_file.hpp"
#include "workbench/recording/within_row.hpp"

namespace workbench {

namespace {

bool looks_like_candump(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return first != std::string_view::npos && first + 1 < text.size() &&
         text[first] == '(' && text[first + 1] >= '0' && text[first + 1] <= '9';
}

Recording read_log(const RecordingSource& source) {
  const ColumnNames& names = source.names;
  const CandumpOptions options{names.u, names.y,   names.sp,
                               names.x, source.ts, source.stop};
  std::vector<Column> missing;
  for (const Column column : source.required) {
    if (column != Column::t && names.of(column).empty()) missing.push_back(column);
  }
  if (!missing.empty()) {
    throw std::invalid_argument(missing_dbc_signals(source.dbc, missing));
  }
  return read_candump(source.path, source.dbc, options);
}

const config::Loop& loop_of(const config::Gateway& gateway, std::optional<int> id) {
  std::string ids;
  for (const config::Loop& loop : gateway.loops) {
    if (id ? loop.id == *id : gateway.loops.size() == 1) return loop;
    ids += (ids.empty() ? "" : ", ") + std::to_string(loop.id);
  }
  throw std::invalid_argument(
      (id ? "--loop " + std::to_string(*id) + ": " : std::string("--loop is needed: ")) +
      gateway.file + " has the loops " + ids);
}

Recording read_configured_log(const RecordingSource& source) {
  if (!source.dbc.empty() || source.names.names_signals()) {
    throw std::invalid_argument("--config already names the signals; drop the others");
  }
  const config::Gateway gateway = config::read_gateway(source.config);
  const config::Loop& loop = loop_of(gateway, source.loop);
  std::vector<CandumpSignal> signals;
  const auto add = [&](Column column, const config::Source& from) {
    if (from.kind != config::SourceKind::kCan) {
      throw InputError(gateway.file, static_cast<std::size_t>(from.place.line), 0,
                       from.place.key + " from CAN", "an analog input",
                       "only CAN signals are in a candump log");
    }
    CandumpSignal signal{column, from.description, from.signal};
    signal.signal.signal.minimum = from.has_range ? from.minimum : 0;
    signal.signal.signal.maximum = from.has_range ? from.maximum : 0;
    signal.interface = name_in_log(gateway.buses[from.bus]);
    signals.push_back(std::move(signal));
  };
  add(Column::u, loop.u);
  add(Column::y, loop.y);
  if (loop.sp) add(Column::sp, *loop.sp);
  return read_candump(source.path, signals, source.ts.value_or(loop.sample_period_s),
                      source.stop);
}

// Files of one signal each, as one recording.
Recording read_tag_files(const RecordingSource& source) {
  std::vector<std::string> paths{source.path};
  paths.insert(paths.end(), source.beside.begin(), source.beside.end());
  std::vector<NamedBytes> files;
  std::vector<std::string> names;
  for (const std::string& path : paths) {
    files.push_back({path, read_text_file(path, kMostBytes)});
    names.push_back(file_name(path));
  }
  const std::string name = name_of_files(names);
  CsvOptions options = source;
  const std::string table = table_of_tag_files(files, options);
  options.names.time.clear();
  try {
    return parse_csv(table, name, options);
  } catch (const InputError& error) {
    throw InputError(error.without_line());
  }
}

Recording read_as_it_is(const RecordingSource& source) {
  const bool from_can = !source.config.empty() || !source.dbc.empty();
  if (from_can && (!source.names.time.empty() || !source.names.loads.empty() ||
                   source.date_order || source.decimal || !source.sheet.empty())) {
    throw std::invalid_argument(
        "--time, --load, --date-order, --decimal and --sheet are for CSV files and "
        "workbooks");
  }
  if (!source.config.empty()) return read_configured_log(source);
  if (source.loop) throw std::invalid_argument("--loop goes with --config");
  if (!source.dbc.empty()) return read_log(source);
  if (!source.beside.empty()) return read_tag_files(source);
  const std::string text = read_text_file(source.path, kMostBytes);
  if (looks_like_candump(text)) {
    if (source.names.names_signals()) {
      throw std::invalid_argument("signals of a CAN log need --dbc FILE");
    }
    throw InputError(source.path, 1, 1, "a CSV file", "a candump log",
                     "give --config FILE, or --dbc FILE --u MESSAGE.SIGNAL --y "
                     "MESSAGE.SIGNAL");
  }
  Recording recording = parse_csv(text, source.path, source);
  recording.name = file_name(source.path);
  return recording;
}

}  // namespace

std::vector<RecordingSource> sources_of(const RecordingSource& like,
                                        const std::vector<std::string>& paths) {
  std::vector<RecordingSource> out;
  const bool from_can = !like.config.empty() || !like.dbc.empty();
  if (!from_can && are_tag_files(paths, like)) {
    out.push_back(like);
    out.back().path = paths.front();
    out.back().beside.assign(paths.begin() + 1, paths.end());
    return out;
  }
  for (const std::string& path : paths) {
    out.push_back(like);
    out.back().path = path;
  }
  return out;
}

Recording read_recording(const RecordingSource& source) {
  Recording recording = read_as_it_is(source);
  if (source.u_before) put_rest_before(recording, *source.u_before);
  note_within_row(recording);
  return recording;
}

std::optional<std::array<double, 2>> configured_span(const RecordingSource& source) {
  if (source.config.empty()) return std::nullopt;
  const config::Gateway gateway = config::read_gateway(source.config);
  return loop_of(gateway, source.loop).span;
}

}  // namespace workbench
