#include "workbench/recording/cell_reader.hpp"

#include "workbench/recording/input_error.hpp"

namespace workbench {
namespace {

// ns=2;s=FIC101.OP: the semicolon in the id of an OPC UA node separates nothing.
bool is_in_node_id(std::string_view before, std::string_view behind) {
  constexpr std::string_view kNamespace = "ns=";
  return before.starts_with(kNamespace) && before.size() > kNamespace.size() &&
         before.find_first_not_of("0123456789", kNamespace.size()) ==
             std::string_view::npos &&
         behind.size() > 2 && behind[1] == '=' &&
         std::string_view("sigb").find(behind[0]) != std::string_view::npos;
}

// A cell in quotes begins in `line` and does not end there.
bool is_open(std::string_view line) {
  bool in_quotes = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] != '"') continue;
    const bool begins =
        i == 0 || std::string_view(",;\t|").find(line[i - 1]) != std::string_view::npos;
    if (in_quotes || begins) in_quotes = !in_quotes;
  }
  return in_quotes;
}

}  // namespace

std::string_view take_whole_line(std::string_view& text) {
  std::string_view line = wire::take_until(text, '\n');
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::vector<LineCell> split_line(std::string_view line, char separator) {
  std::vector<LineCell> cells;
  std::size_t at = 0;
  while (cells.size() <= kMostHeaderCells) {
    if (separator == ' ') {
      at = std::min(line.find_first_not_of(" \t", at), line.size());
      if (at == line.size() && !cells.empty()) break;
    }
    const std::size_t start = at;
    bool in_quotes = false;
    while (at < line.size() && (in_quotes || line[at] != separator ||
                                is_in_node_id(trimmed(line.substr(start, at - start)),
                                              line.substr(at + 1)))) {
      if (line[at] == '"') in_quotes = !in_quotes;
      ++at;
    }
    std::string_view raw = trimmed(line.substr(start, at - start));
    if (raw.size() >= 2 && raw.front() == '"' && raw.back() == '"') {
      raw = trimmed(raw.substr(1, raw.size() - 2));
    }
    cells.push_back({raw, start + 1});
    if (at >= line.size()) break;
    ++at;
  }
  return cells;
}

std::string_view whole_line(CellReader& reader) {
  const std::string_view first = reader.rest_of_line();
  reader.skip_rest_of_line();
  if (!is_open(first)) return first;
  CellReader ahead = reader;
  for (int i = 0; i < kMostBreaks && !ahead.at_end(); ++i) {
    ahead.next_line();
    const std::string_view next = ahead.rest_of_line();
    ahead.skip_rest_of_line();
    const std::string_view all(first.data(),
                               static_cast<std::size_t>(next.end() - first.begin()));
    if (is_open(all)) continue;
    reader = ahead;
    return all;
  }
  return first;
}

std::size_t breaks_in(std::string_view text) {
  std::size_t breaks = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool crlf = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
    breaks += is_line_end(text[i]) && !crlf;
  }
  return breaks;
}

CellReader::CellReader(std::string_view text, const std::string& file, std::size_t line)
    : file_(&file),
      begin_(text.data()),
      at_(begin_),
      end_(begin_ + text.size()),
      line_start_(begin_),
      cell_start_(begin_),
      line_(line) {}

void CellReader::next_line() {
  if (at_ < end_) {
    const bool crlf = *at_ == '\r' && at_ + 1 < end_ && at_[1] == '\n';
    at_ += crlf ? 2 : 1;
  }
  ++line_;
  line_start_ = at_;
}

std::string_view CellReader::take_cell(char separator) {
  const char blank = separator == '\t' ? ' ' : '\t';
  while (at_ < end_ && (*at_ == ' ' || *at_ == blank)) ++at_;
  cell_start_ = at_;
  if (at_ < end_ && *at_ == '"') return take_quoted_cell(separator, blank);
  const auto go_on = [&] {
    while (at_ < end_ && *at_ != separator && !is_line_end(*at_)) ++at_;
  };
  go_on();
  if (at_ < end_ && *at_ == ';' && is_in_node_id({cell_start_, at_}, {at_ + 1, end_})) {
    ++at_;
    go_on();
  }
  return trimmed({cell_start_, static_cast<std::size_t>(at_ - cell_start_)});
}

std::string_view CellReader::take_quoted_cell(char separator, char blank) {
  const auto fail = [this](const char* expected, std::string found, const char* advice) {
    throw InputError(*file_, line_, column_of(at_), expected, std::move(found), advice);
  };
  const char* close = at_ + 1;
  int breaks = 0;
  const char* last_line = line_start_;
  while (close < end_) {
    if (is_line_end(*close)) {
      if (breaks++ == kMostBreaks) break;
      if (*close == '\r' && close + 1 < end_ && close[1] == '\n') ++close;
      last_line = close + 1;
    }
    if (*close == '"') {
      if (close + 1 >= end_ || close[1] != '"') break;
      ++close;
    }
    ++close;
  }
  if (close >= end_ || *close != '"') {
    fail("a closing quote", breaks > 0 ? "none in the next lines" : "the end of the file",
         "close the quote");
  }
  const std::string_view inside(at_ + 1, static_cast<std::size_t>(close - at_ - 1));
  at_ = close + 1;
  line_ += static_cast<std::size_t>(breaks);
  line_start_ = last_line;
  while (separator != ' ' && at_ < end_ && (*at_ == ' ' || *at_ == blank)) ++at_;
  if (at_ < end_ && *at_ != separator && !is_line_end(*at_)) {
    fail("a separator after the closing quote", quoted({at_, 1}),
         "write a quote inside a value twice");
  }
  return trimmed(inside);
}

}  // namespace workbench
