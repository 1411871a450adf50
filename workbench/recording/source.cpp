#include "workbench/recording/source.hpp"

#include <stdexcept>

#include "workbench/recording/candump_log.hpp"
#include "workbench/recording/csv.hpp"
#include "workbench/recording/text_file.hpp"

namespace workbench {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{512} << 20;

bool looks_like_candump(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return first != std::string_view::npos && text[first] == '(';
}

Recording read_log(const RecordingSource& source) {
  const CandumpOptions options{source.u, source.y, source.sp, source.x, source.ts};
  for (const Column column : source.required) {
    const std::string& reference = column == Column::u   ? source.u
                                   : column == Column::y ? source.y
                                   : column == Column::x ? source.x
                                                         : source.sp;
    if (column != Column::t && reference.empty()) {
      throw std::invalid_argument("--dbc needs --" + std::string(name_of(column)) +
                                  " MESSAGE.SIGNAL");
    }
  }
  return read_candump(source.path, source.dbc, options);
}

}  // namespace

Recording read_recording(const RecordingSource& source) {
  if (!source.dbc.empty()) return read_log(source);
  if (!(source.u + source.y + source.sp + source.x).empty()) {
    throw std::invalid_argument("signals of a CAN log need --dbc FILE");
  }
  const std::string text = read_text_file(source.path, kMaxBytes);
  if (looks_like_candump(text)) {
    throw InputError(source.path, 1, 1, "a CSV file", "a candump log",
                     "give --dbc FILE --u MESSAGE.SIGNAL --y MESSAGE.SIGNAL");
  }
  Recording recording = parse_csv(text, source.path, {source.ts, source.required});
  recording.name = file_name(source.path);
  return recording;
}

}  // namespace workbench
