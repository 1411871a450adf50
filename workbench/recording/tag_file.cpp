#include "workbench/recording/tag_file.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <regex>

#include "workbench/recording/columns/long_format.hpp"
#include "workbench/recording/csv_source.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/rows/row_scanner.hpp"
#include "workbench/recording/text_encoding.hpp"
#include "workbench/recording/text_file.hpp"
#include "workbench/recording/time_parts.hpp"

namespace workbench {
namespace {

const std::string kAnd = " + ";

// The other names are tags, of which a file has one.
CsvLayout layout_of_one(std::string_view text, const std::string& path,
                        const CsvOptions& options) {
  CsvOptions own;
  own.names.time = options.names.time;
  own.decimal = options.decimal;
  return layout_of(text, path, wish_of(own));
}

// The only column of numbers that is no time; one that counts the rows is none either.
// None where another one has the name of a signal and cells that nobody reads.
std::optional<std::size_t> only_numbers(const CsvLayout& layout,
                                        const ColumnNames& names) {
  std::vector<std::size_t> found;
  const std::vector<std::size_t> parts = time_parts(layout);
  for (std::size_t i = 0; i < layout.columns.size(); ++i) {
    if (std::ranges::find(parts, i) != parts.end()) continue;
    const LayoutColumn& column = layout.columns[i];
    const Part part = column.name.part;
    if (is_signal(part) && column.content == Content::kText) return std::nullopt;
    const bool named_time =
        part == Part::kTime || part == Part::kMillis || column.name.text == names.time;
    if (is_measured(column) && column.content == Content::kNumber && !named_time &&
        part != Part::kQuality) {
      found.push_back(i);
    }
  }
  if (found.size() > 1) {
    std::erase_if(found, [&layout](std::size_t i) { return layout.columns[i].counts; });
  }
  if (found.size() != 1) return std::nullopt;
  return found.front();
}

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() || !column_name(name).unit.empty() ? name
                                                         : name + " [" + unit + ']';
}

// What the file calls its signal, or is called itself.
std::string tag_named(const ColumnName& inside, const std::string& path) {
  const std::string outside = undated_name(path);
  const bool says_part = is_signal(inside.part);
  const bool says_nothing = inside.part == Part::kValue || inside.key.empty();
  if (says_part || (!says_nothing && !is_signal(column_name(outside).part))) {
    return inside.text;
  }
  return with_unit(outside, inside.unit);
}

std::string name_of_time(const LayoutColumn& column, const TimePlace& place) {
  if (place.seconds_only) return "Time [s]";
  return column.name.part == Part::kTime ? column.name.text
                                         : with_unit("Time", column.name.unit);
}

// Of columns_of() its time, by which the columns are known again.
std::vector<std::string> names_of_times(const TagFile& file) {
  constexpr std::array<const char*, kDateParts> kParts = {"Year", "Month",  "Day",
                                                          "Hour", "Minute", "Second"};
  const std::size_t count = file.time.parts.size();
  const auto* const first =
      kParts.begin() + (parts_have_date(count) ? 0 : kDateParts - kClockParts);
  std::vector<std::string> out(first, first + count);
  const bool alone = !out.empty() && file.time.parts.front() == file.time.column;
  if (file.time.clock) out.insert(out.begin(), "Clock");
  if (!alone) out.insert(out.begin(), file.time_name);
  const bool micros = file.time.millis_s < 1e-3;
  if (file.time.millis) out.emplace_back(micros ? "us" : "Milliseconds");
  return out;
}

class TableWriter {
 public:
  void add(const NamedBytes& named, const CsvOptions& options) {
    const std::string& path = named.path;
    std::string converted;
    const std::string_view text = text_of(named.bytes, path, converted);
    const CsvLayout layout = layout_of_one(text, path, options);
    const std::optional<TagFile> file = tag_file(layout, path, options.names);
    if (!file) {
      throw InputError(path, layout.header_line, 1, "one signal beside its times",
                       "none, or several",
                       "open recordings of one loop one after the other");
    }
    if (separator_ == 0) begin(layout, *file);
    take_rows(text, path, layout, *file);
  }

  std::string finish() { return std::move(out_); }

 private:
  void begin(const CsvLayout& layout, const TagFile& first) {
    separator_ = layout.separator == ' ' ? '\t' : layout.separator;
    time_columns_ = columns_of(first.time).size();
    out_ = "Tag";
    for (const std::string& name : names_of_times(first)) cell(name);
    cell("Value");
    cell("Quality");
    out_ += '\n';
  }

  void take_rows(std::string_view text, const std::string& path, const CsvLayout& layout,
                 const TagFile& file) {
    std::vector<std::size_t> wanted = columns_of(file.time);
    const std::size_t value = wanted.size();
    if (value != time_columns_) {
      throw InputError(path, layout.header_line, 1,
                       "times in as many columns as in the first file, " +
                           std::to_string(time_columns_),
                       std::to_string(value), "export the times of all files alike");
    }
    wanted.push_back(file.value);
    if (file.quality) wanted.push_back(*file.quality);
    RowScanner rows(text, path, layout, wanted, false);
    std::size_t end_of_values = out_.size();  // behind them a footer may stand
    while (rows.next()) {
      rows.accept();
      cell_alone(file.tag);
      for (std::size_t i = 0; i < wanted.size(); ++i) cell(rows.cell(i));
      if (!file.quality) cell("");
      out_ += '\n';
      if (!rows.cell(value).empty()) end_of_values = out_.size();
    }
    out_.resize(end_of_values);
  }

  void cell(std::string_view text) {
    out_ += separator_;
    cell_alone(text);
  }

  void cell_alone(std::string_view text) {
    if (text.find(separator_) == std::string_view::npos) {
      out_ += text;
      return;
    }
    out_ += '"';
    out_ += text;
    out_ += '"';
  }

  std::string out_;
  char separator_ = 0;
  std::size_t time_columns_ = 0;
};

}  // namespace

std::optional<TagFile> tag_file(const CsvLayout& layout, const std::string& path,
                                const ColumnNames& names) {
  const std::optional<std::size_t> value = only_numbers(layout, names);
  if (!value) return std::nullopt;
  TagFile out;
  try {
    ColumnNames wanted;
    wanted.time = names.time;
    wanted.y = '#' + std::to_string(*value + 1);
    const ColumnChoice choice =
        choose_columns(layout, path, wanted, {Column::y}, /*time_needed=*/true);
    if (choice.times.size() != 1) return std::nullopt;
    out.time = choice.times.front();
    out.time_name = name_of_time(layout.columns[out.time.column], out.time);
    if (choice.shape == ColumnChoice::Shape::kLong) {
      const LayoutColumn& tags = layout.columns[choice.keys.front()];
      const ColumnChoice::Value& only = choice.values.front();
      if (choice.keys.size() > 1 || only.column != *value || !tags.rests() ||
          tags.changes_later) {
        return std::nullopt;
      }
      out.quality = only.quality;
      out.tag = with_unit(tag_named(column_name(tags.first), path),
                          layout.columns[*value].name.unit);
    } else {
      out.quality = choice.signals.front().quality;
      out.tag = tag_named(layout.columns[*value].name, path);
    }
  } catch (const std::exception&) {
    return std::nullopt;
  }
  out.value = *value;
  return out;
}

std::optional<TagFile> tag_file(std::string_view bytes, const std::string& path,
                                const CsvOptions& options) {
  try {
    std::string converted;
    const std::string_view text = text_of(bytes, path, converted);
    return tag_file(layout_of_one(text, path, options), path, options.names);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

bool are_tag_files(const std::vector<std::string>& paths, const CsvOptions& options) {
  return paths.size() > 1 &&
         std::ranges::all_of(paths, [&options](const std::string& path) {
           try {
             return tag_file(read_text_file(path, kMostBytes), path, options).has_value();
           } catch (const InputError&) {
             return false;
           }
         });
}

std::string table_of_tag_files(const std::vector<NamedBytes>& files,
                               const CsvOptions& options) {
  TableWriter table;
  for (const NamedBytes& file : files) table.add(file, options);
  return table.finish();
}

std::string name_of_files(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : kAnd) + name;
  return out;
}

std::vector<std::string> files_in(const std::string& name) {
  std::vector<std::string> out;
  std::size_t from = 0;
  for (std::size_t at; (at = name.find(kAnd, from)) != std::string::npos;
       from = at + kAnd.size()) {
    out.push_back(name.substr(from, at - from));
  }
  out.push_back(name.substr(from));
  const bool files = std::ranges::all_of(out, [](const std::string& one) {
    return std::filesystem::path(one).has_extension();
  });
  return files ? out : std::vector<std::string>{name};
}

std::string undated_name(const std::string& path) {
  std::string name = std::filesystem::path(path).stem().string();
  // A date, with or without a time of day; then a running number.
  static const std::regex date(
      R"(^(.+?)[-_ .](\d{4}-\d{2}(-\d{2})?|\d{4}_\d{2}(_\d{2})?|\d{8}|20\d{4})([-_tT ]\d{2,6}([-:]\d{2}){0,2})?$)");
  static const std::regex number(R"(^(.*\d.*)[-_ ](\d{1,2})$)");
  std::smatch match;
  if (std::regex_match(name, match, date)) return match[1];
  if (std::regex_match(name, match, number)) return match[1];
  return name;
}

}  // namespace workbench
