#include "workbench/screen/split_export.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "workbench/recording/cell_reader.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/later_texts.hpp"
#include "workbench/recording/tag_stream.hpp"
#include "workbench/recording/text_file.hpp"
#include "workbench/screen/text_blocks.hpp"

namespace workbench {
namespace {

constexpr std::size_t kNoStream = static_cast<std::size_t>(-1);
constexpr std::size_t kMostTags = 100'000;
constexpr int kRowsBetweenFlushes = 64;

// A cell may have lost its quotes, which a separator inside needs.
void append(std::string& out, std::string_view cell, char separator, bool first) {
  if (!first) out += separator;
  if (cell.find(separator) == std::string_view::npos &&
      cell.find('"') == std::string_view::npos) {
    out += cell;
  } else {
    out += '"';
    out += cell;
    out += '"';
  }
}

// A row of a long table as it stands, and the tag that its keys make.
struct LongRow {
  explicit LongRow(const ColumnChoice& choice) : keys(choice.keys), cells(keys.size()) {
    for (const ColumnChoice::Value& value : choice.values) {
      last = std::max(last, value.column);
    }
  }

  // False: without a tag, or cut off before its value.
  bool take(CellReader& reader, char separator) {
    for (std::string& cell : cells) cell.clear();
    key.clear();
    text.clear();
    std::size_t column = 0;
    do {
      const std::string_view cell = reader.take_cell(separator);
      for (std::size_t i = 0; i < keys.size(); ++i) {
        if (column == keys[i]) cells[i] = cell;
      }
      append(text, cell, separator, column == 0);
      ++column;
    } while (reader.take_separator(separator));
    for (const std::string& cell : cells) add_to_tag(key, cell);
    return !key.empty() && column > last;
  }

  const std::vector<std::size_t>& keys;
  std::vector<std::string> cells;  // of the keys
  std::size_t last = 0;            // column of a value
  std::string key;
  std::string text;
};

}  // namespace

SplitExport::SplitExport(ExportFile file, const ReadOptions& options,
                         const std::string& scratch)
    : file_(std::move(file)), options_(options), spill_(scratch) {}

bool SplitExport::split(const std::vector<bool>& wanted, const Watch& watch) {
  const bool whole = file_.kind == ExportFile::Kind::kLong ? split_long(watch)
                                                           : split_wide(wanted, watch);
  spill_.finish();
  return whole;
}

template <class TakeRow>
bool SplitExport::each_row(const Watch& watch, int between_flushes, TakeRow take_row) {
  TextBlocks blocks(file_.path);
  std::size_t head = file_.layout.first_row_line - 1;
  std::size_t line = file_.layout.first_row_line;
  int rows = 0;
  for (std::string_view text = blocks.next(); !text.empty(); text = blocks.next()) {
    text = without_lines(text, head);
    CellReader reader(text, file_.path, line);
    while (!reader.at_end()) {
      const bool heads = heads_again(reader.rest_of_line(), file_.layout.header);
      if (heads) reader.skip_rest_of_line();
      take_row(reader, heads);
      reader.next_line();
      if (++rows % between_flushes == 0) spill_.flush_full();
    }
    line = reader.line();
    if (watch && !watch(blocks.bytes_read(), blocks.size())) return false;
  }
  return true;
}

bool SplitExport::split_wide(const std::vector<bool>& wanted, const Watch& watch) {
  const std::size_t columns = file_.layout.columns.size();
  const char separator = file_.layout.separator;
  std::vector<std::vector<std::size_t>> streams_of(columns);
  const std::size_t shared = spill_.add_stream();
  for (const std::size_t column : file_.shared) streams_of[column].push_back(shared);
  stream_of_loop_.assign(file_.loops.size(), kNoStream);
  for (std::size_t loop = 0; loop < file_.loops.size(); ++loop) {
    if (!file_.loops[loop].error.empty()) continue;
    if (!wanted.empty() && !wanted[loop]) continue;
    stream_of_loop_[loop] = spill_.add_stream();
    for (const std::size_t column : file_.loops[loop].own) {
      streams_of[column].push_back(stream_of_loop_[loop]);
    }
  }
  std::vector<unsigned char> begun(spill_.streams(), 0);  // this line has a cell
  return each_row(watch, kRowsBetweenFlushes, [&](CellReader& reader, bool heads) {
    std::size_t cells = 0;
    std::size_t filled = 0;
    while (!heads) {
      const std::string_view cell = reader.take_cell(separator);
      if (cells < columns) {
        for (const std::size_t stream : streams_of[cells]) {
          append(spill_.buffer(stream), cell, separator, begun[stream] == 0);
          begun[stream] = 1;
        }
      }
      ++cells;
      if (!cell.empty()) filled = cells;
      if (!reader.take_separator(separator)) break;
    }
    for (std::size_t stream = 0; stream < spill_.streams(); ++stream) {
      std::string& buffer = spill_.buffer(stream);
      // One cell too many here as well: the reader of the loop refuses it by line.
      if (filled > columns) append(buffer, "?", separator, begun[stream] == 0);
      buffer += '\n';
      begun[stream] = 0;
    }
  });
}

bool SplitExport::split_long(const Watch& watch) {
  const char separator = file_.layout.separator;
  std::unordered_map<std::string, std::size_t> stream_of;
  std::vector<NamedSignal> tags;
  LongRow row(file_.choice);
  const auto take_row = [&](CellReader& reader, bool heads) {
    if (heads || !row.take(reader, separator)) return;
    const auto [at, is_new] = stream_of.try_emplace(row.key, stream_of.size());
    if (is_new) {
      if (tags.size() >= kMostTags) {
        throw InputError(file_.path, reader.line(), 0, "at most 100000 tags", "more",
                         "export fewer tags a file");
      }
      add_tags(row.key, file_.choice, file_.layout, 1, tags);
      (void)spill_.add_stream();
    }
    spill_.buffer(at->second) += row.text + '\n';
  };
  if (!each_row(watch, kRowsBetweenFlushes * 64, take_row)) return false;
  pair_streams(tags);
  return true;
}

void SplitExport::pair_streams(const std::vector<NamedSignal>& tags) {
  const TagPairs pairs = pair_tags(tags, options_.pairs);
  for (const TagLoop& found : pairs.loops) {
    ExportLoop loop;
    loop.name = found.name.empty() ? file_.loop : found.name;
    loop.u_tag = tags[found.u].name.text;
    loop.y_tag = tags[found.y].name.text;
    loop.choice = file_.choice;
    loop.layout = file_.layout;
    loop.layout.first_row_offset = 0;
    file_.loops.push_back(std::move(loop));
    tag_streams_.push_back(
        {found.u, found.y, found.sp.value_or(kNoStream), found.x.value_or(kNoStream)});
  }
  file_.doubts = pairs.doubts;
  for (const std::size_t i : pairs.unpaired) {
    file_.unpaired.push_back(tags[i].name.text);
  }
}

// The rows of a loop in a wide file: the shared cells, then its own.
std::string SplitExport::joined(std::size_t loop) const {
  const std::string shared = spill_.text(0);
  const std::string own = spill_.text(stream_of_loop_[loop]);
  if (file_.shared.empty()) return own;
  std::string out;
  out.reserve(shared.size() + own.size());
  std::size_t a = 0;
  std::size_t b = 0;
  while (a < shared.size() && b < own.size()) {
    const std::size_t a_end = shared.find('\n', a);
    const std::size_t b_end = own.find('\n', b);
    out.append(shared, a, a_end - a);
    // A line without own cells is a footer, or too short: it stays so.
    if (b_end > b) out += file_.layout.separator;
    out.append(own, b, b_end - b);
    out += '\n';
    a = a_end + 1;
    b = b_end + 1;
  }
  return out;
}

Recording SplitExport::recording(std::size_t loop) const {
  const ExportLoop& at = file_.loops[loop];
  if (!at.error.empty()) throw std::runtime_error(at.error);
  CsvOptions options;
  options.ts = options_.ts;
  options.date_order = options_.date_order;
  std::string text;
  const bool rows_in_order = file_.kind == ExportFile::Kind::kWide;
  if (rows_in_order) {
    text = joined(loop);
  } else {
    std::array<std::string*, 4> names{&options.names.u, &options.names.y,
                                      &options.names.sp, &options.names.x};
    const std::size_t values = at.choice.values.size();
    std::vector<std::size_t> streams;  // in the order of their rows
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::size_t tag = tag_streams_[loop][i];
      if (tag == kNoStream) continue;
      auto known = std::ranges::find(streams, tag / values);
      if (known == streams.end()) {
        text += spill_.text(tag / values);
        known = streams.insert(streams.end(), tag / values);
      }
      const auto before = static_cast<std::size_t>(known - streams.begin());
      *names[i] = '#' + std::to_string(before * values + tag % values + 1);
    }
  }
  try {
    Recording recording = read_table({text, file_.path, at.layout, at.choice, options});
    recording.name = file_name(file_.path);
    return recording;
  } catch (const InputError& error) {
    // Columns, in a long format lines too, are those of the file no more.
    throw InputError(error.file, rows_in_order ? error.line : 0, 0,
                     error.expected + " for " + at.name, error.found, error.advice);
  }
}

}  // namespace workbench
