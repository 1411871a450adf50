#include "workbench/recording/csv.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "workbench/recording/column_choice.hpp"
#include "workbench/recording/csv_layout.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/recording/rows/tag_streams.hpp"
#include "workbench/recording/rows/wide_rows.hpp"
#include "workbench/recording/stopped.hpp"
#include "workbench/recording/tag_file.hpp"
#include "workbench/recording/text_encoding.hpp"
#include "workbench/recording/text_file.hpp"

namespace workbench {
namespace {

// Of a file with one signal the partner is missing, not a name.
ColumnChoice chosen(const CsvLayout& layout, const std::string& name,
                    const CsvOptions& options) {
  try {
    return choose_columns(layout, name, options.names, options.required, !options.ts);
  } catch (const InputError& error) {
    const bool asked = options.names.names_signals() || options.required.size() < 2;
    const auto one = asked ? std::nullopt : tag_file(layout, name, options.names);
    if (!one) throw;
    throw InputError(error.file, error.line, 0, error.expected,
                     "one signal, " + workbench::quoted(one->tag),
                     "give the files of all signals of the loop at once");
  }
}

void note_ignored_time(const CsvLayout& layout, double ts, Recording& out) {
  const auto t = std::ranges::find_if(
      layout.columns, [](const LayoutColumn& c) { return c.name.part == Part::kTime; });
  if (t == layout.columns.end()) return;
  out.resampling.notes.push_back("column " + quoted(t->name.text) +
                                 " ignored: the sample period is given as " + number(ts) +
                                 " s");
}

// A signal a sheet, as others write a file a tag.
std::optional<std::string> joined_sheets(const std::vector<NamedSheet>& sheets,
                                         const CsvOptions& options) {
  constexpr const char* kEnding = ".sheet";  // a point in the name is none
  std::vector<NamedBytes> files;
  std::set<std::string> tags;
  for (const NamedSheet& sheet : sheets) {
    files.push_back({sheet.name + kEnding, std::string(sheet.text)});
    const auto one = tag_file(files.back().bytes, files.back().path, options);
    if (!one || !tags.insert(one->tag).second) return std::nullopt;
  }
  return table_of_tag_files(files, options);
}

}  // namespace

SheetChoice sheet_wanted(const CsvOptions& options) {
  return {options.sheet,
          [&options](std::string_view text) {
            const std::string file;
            try {
              const CsvLayout layout = layout_of(text, file, wish_of(options));
              (void)choose_columns(layout, file, options.names, options.required,
                                   !options.ts);
              return true;
            } catch (const InputError&) {
              return false;
            } catch (const std::invalid_argument&) {
              return false;
            }
          },
          [&options](const std::vector<NamedSheet>& sheets) {
            return joined_sheets(sheets, options);
          },
          {},
          false,
          options.stop};
}

Recording read_table(const CsvSource& source) {
  const std::optional<double>& ts = source.options.ts;
  Recording out;
  out.name = source.file;
  out.resampling.notes = source.layout.notes;
  out.resampling.notes.insert(out.resampling.notes.end(), source.choice.notes.begin(),
                              source.choice.notes.end());
  if (ts) note_ignored_time(source.layout, *ts, out);
  if (source.choice.shape == ColumnChoice::Shape::kWide) {
    if (!read_wide(source, out)) {
      const ColumnChoice choice = with_own_rows(source.choice);
      read_streams({source.text, source.file, source.layout, choice, source.options},
                   out);
    }
  } else {
    read_streams(source, out);
  }
  if (ts) out.period_s = *ts;
  if (source.options.names.names_signals()) out.loop.clear();
  return out;
}

namespace {

Recording parse_text(std::string_view text, const std::string& name,
                     const std::string& note, const CsvOptions& options) {
  CsvLayout layout = layout_of(text, name, wish_of(options));
  if (!note.empty()) layout.notes.push_back(note);
  return read_table({text, name, layout, chosen(layout, name, options), options});
}

}  // namespace

Recording parse_csv(std::string_view text, const std::string& name,
                    const CsvOptions& options) {
  if (options.ts && !(std::isfinite(*options.ts) && *options.ts > 0)) {
    throw std::invalid_argument("the sample period must be a positive number of seconds");
  }
  std::string converted;
  SheetChoice sheet = sheet_wanted(options);
  text = text_of(text, name, converted, sheet);
  check_stop(options.stop);
  if (!sheet.joined) return parse_text(text, name, sheet.note, options);
  CsvOptions of_joined = options;
  of_joined.names.time.clear();
  try {
    return parse_text(text, name, sheet.note, of_joined);
  } catch (const InputError& error) {
    throw InputError(error.without_line());
  }
}

Recording read_csv(const std::string& path, const CsvOptions& options) {
  Recording recording = parse_csv(read_text_file(path, kMostBytes), path, options);
  recording.name = file_name(path);
  return recording;
}

}  // namespace workbench
