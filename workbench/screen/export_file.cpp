#include "workbench/screen/export_file.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "workbench/recording/csv_source.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/later_texts.hpp"
#include "workbench/recording/tag_file.hpp"
#include "workbench/recording/time_parts.hpp"
#include "workbench/screen/text_blocks.hpp"

namespace workbench {
namespace {

std::string number_of(std::size_t index) {
  return '#' + std::to_string(index + 1);
}

ColumnNames names_of(const TagLoop& loop, const ReadOptions& options) {
  ColumnNames names = options.names;
  names.u = number_of(loop.u);
  names.y = number_of(loop.y);
  if (loop.sp) names.sp = number_of(*loop.sp);
  if (loop.x) names.x = number_of(*loop.x);
  return names;
}

void sort_once(std::vector<std::size_t>& values) {
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

// The choice and the layout in columns of the narrow table: shared, then own.
void narrow(const ExportFile& file, ExportLoop& loop) {
  std::vector<std::size_t> all = file.shared;
  all.insert(all.end(), loop.own.begin(), loop.own.end());
  const auto moved = [&all](std::size_t& column) {
    column = static_cast<std::size_t>(std::ranges::find(all, column) - all.begin());
  };
  const auto moved_if = [&moved](std::optional<std::size_t>& column) {
    if (column) moved(*column);
  };
  for (TimePlace& time : loop.choice.times) {
    moved(time.column);
    moved_if(time.clock);
    moved_if(time.millis);
    for (std::size_t& part : time.parts) moved(part);
  }
  for (SignalPlace& signal : loop.choice.signals) {
    moved(signal.index);
    moved_if(signal.quality);
  }
  moved_if(loop.choice.mode);
  loop.layout.separator = file.layout.separator;
  loop.layout.header_line = file.layout.header_line;
  loop.layout.first_row_line = file.layout.first_row_line;
  loop.layout.style = file.layout.style;
  for (const std::size_t column : all) {
    loop.layout.columns.push_back(file.layout.columns[column]);
  }
}

ExportLoop loop_of(ExportFile& file, const TagLoop& tags,
                   const std::vector<NamedSignal>& candidates,
                   const ReadOptions& options) {
  ExportLoop loop;
  loop.name = tags.name;
  loop.u_tag = candidates[tags.u].name.text;
  loop.y_tag = candidates[tags.y].name.text;
  try {
    loop.choice = choose_columns(file.layout, file.path, names_of(tags, options),
                                 {Column::u, Column::y}, !options.ts);
  } catch (const std::exception& error) {
    loop.error = error.what();
    return loop;
  }
  const bool own_times = loop.choice.shape == ColumnChoice::Shape::kOwnTimes;
  std::vector<TimePlace> times;
  for (SignalPlace& signal : loop.choice.signals) {
    loop.own.push_back(signal.index);
    if (signal.quality) loop.own.push_back(*signal.quality);
    if (!own_times) continue;
    times.push_back(loop.choice.times[*signal.time]);
    signal.time = times.size() - 1;
  }
  if (loop.choice.mode) loop.own.push_back(*loop.choice.mode);
  if (own_times) {
    loop.choice.times = std::move(times);
    for (const TimePlace& time : loop.choice.times) {
      for (const std::size_t column : columns_of(time)) loop.own.push_back(column);
    }
  } else if (file.shared.empty() && !loop.choice.times.empty()) {
    file.shared = columns_of(loop.choice.times[0]);
    sort_once(file.shared);
  }
  std::erase_if(loop.own, [&file](std::size_t column) {
    return std::ranges::find(file.shared, column) != file.shared.end();
  });
  sort_once(loop.own);
  narrow(file, loop);
  return loop;
}

// Whether rows name their tags.
bool is_long(ExportFile& file, const ReadOptions& options) {
  try {
    file.choice = choose_columns(file.layout, file.path, options.names,
                                 {Column::u, Column::y}, !options.ts);
    return file.choice.shape == ColumnChoice::Shape::kLong;
  } catch (const std::exception&) {
    return false;
  }
}

// From the first lines, and from those behind where they say otherwise.
void take_layout(ExportFile& file, const ReadOptions& options) {
  const std::string first = head_of_file(file.path, kSampleLines + 50);
  file.layout = layout_of(first, file.path, wish_of(options));
  LaterTexts later(file.layout, file.path);
  TextBlocks blocks(file.path);
  std::size_t head = file.layout.first_row_line - 1;
  while (later.are_open()) {
    const std::string_view text = blocks.next();
    if (text.empty()) break;
    later.add(without_lines(text, head));
  }
  later.settle(file.layout);
}

// What the file system says of it.
ExportFile named(const std::string& path) {
  ExportFile file;
  file.path = path;
  file.loop = undated_name(path);
  std::error_code ignored;
  file.bytes = std::filesystem::file_size(path, ignored);
  if (ignored) file.bytes = 0;
  const auto modified = std::filesystem::last_write_time(path, ignored);
  if (!ignored) {
    file.modified =
        std::chrono::duration_cast<std::chrono::seconds>(modified.time_since_epoch())
            .count();
  }
  return file;
}

}  // namespace

ExportFile look_into(const std::string& path, const ReadOptions& options) {
  ExportFile file = named(path);
  try {
    take_layout(file, options);
  } catch (const InputError&) {
    return file;
  }
  const bool bare = file.layout.contract_names && options.pairs.list.empty();
  if (bare) return file;
  std::vector<NamedSignal> candidates = candidates_of(file.layout);
  const std::vector<std::size_t> parts = time_parts(file.layout);
  for (NamedSignal& candidate : candidates) {
    const std::size_t column = candidate.number - 1;
    const Content content = file.layout.columns[column].content;
    if (content == Content::kDateTime || content == Content::kDate ||
        content == Content::kClock || std::ranges::find(parts, column) != parts.end()) {
      candidate.measured = false;
    }
  }
  const bool rows_name_tags = is_long(file, options);
  if (rows_name_tags && file.choice.values.size() > 1) {
    file.kind = ExportFile::Kind::kLong;
    return file;
  }
  TagPairs pairs = pair_tags(candidates, options.pairs);
  file.doubts = std::move(pairs.doubts);
  if (pairs.loops.empty()) {
    if (const auto one = tag_file(file.layout, path, options.names)) {
      file.tag = one->tag;
    } else if (rows_name_tags) {
      file.kind = ExportFile::Kind::kLong;
    }
    return file;
  }
  for (const std::size_t i : pairs.unpaired) {
    file.unpaired.push_back(candidates[i].name.text);
  }
  if (pairs.loops.size() == 1 && file.bytes < (std::uint64_t{256} << 20)) {
    if (!pairs.loops[0].name.empty()) {
      file.loop = pairs.loops[0].name;
      file.named_by_file = false;
    }
    file.names = names_of(pairs.loops[0], options);
    return file;
  }
  file.kind = ExportFile::Kind::kWide;
  for (const TagLoop& tags : pairs.loops) {
    file.loops.push_back(loop_of(file, tags, candidates, options));
    if (file.loops.back().name.empty()) file.loops.back().name = file.loop;
  }
  return file;
}

}  // namespace workbench
