#include "wire/candump_reader.hpp"

#include "wire/text.hpp"

namespace wire {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool is_candump(const CandumpStatus& status) {
  return status.ok() || status.error == CandumpError::kXlFrame;
}

// parse_candump() failed at `column`, behind which at most one word is left.
bool is_cut_short(std::string_view line, std::size_t column) {
  constexpr std::size_t kLongestWord = 8;  // an extended identifier, blamed at its start
  return trimmed(line).starts_with('(') && column + kLongestWord > line.size();
}

}  // namespace

CandumpReader::CandumpReader(std::string_view log)
    : rest_(slice(log, log.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0,
                  log.size())) {}

bool CandumpReader::next() {
  while (!rest_.empty()) {
    const std::size_t left = rest_.size();
    text_ = take_line(rest_);
    ++number_;
    if (trimmed(text_).empty()) continue;
    status_ = parse_candump(text_, line_);
    const bool has_end = text_.size() < left;
    if (!status_.ok() && !has_end && any_ && is_cut_short(text_, status_.column)) {
      cut_line_ = number_;
      return false;
    }
    if (!is_candump(status_)) return true;
    any_ = true;
    if (!line_.relative) return true;
    if (relative_ == Relative::kUnknown) relative_ = meaning_of_times();
    if (relative_ == Relative::kToLineBefore) {
      line_.time_ns = clock_ns_ += line_.time_ns;
    }
    return true;
  }
  return false;
}

// At the first relative time.
CandumpReader::Relative CandumpReader::meaning_of_times() const {
  std::int64_t before_ns = line_.time_ns;
  for (std::string_view rest = rest_; !rest.empty();) {
    CandumpLine line;
    const CandumpStatus status = parse_candump(take_line(rest), line);
    if (!is_candump(status) || !line.relative) continue;
    if (line.time_ns < before_ns) return Relative::kToLineBefore;
    before_ns = line.time_ns;
  }
  return Relative::kToStart;
}

const char* CandumpReader::cure() const {
  return any_ ? "remove the line, or record with candump -l"
              : "record with candump -l, or convert the log: in Python, "
                "can_logconvert FILE loop.log";
}

}  // namespace wire
