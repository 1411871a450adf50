#include "workbench/recording/formats/named_rows.hpp"

#include <algorithm>

#include "workbench/recording/cell_reader.hpp"

namespace workbench {
namespace {

void append_plain(std::string_view text, std::string& out) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\' && i + 1 < text.size() && text[i + 1] == '"') continue;
    if (text[i] != '"') out += text[i] == '\t' ? ' ' : text[i];
  }
}

}  // namespace

std::string_view take_line(std::string_view& text) {
  return trimmed(wire::take_line(text));
}

std::size_t NamedRows::column_of(std::string_view name) {
  if (likely_ < names_.size() && names_[likely_] == name) return likely_;
  const auto found = std::ranges::find(names_, name);
  const auto column = static_cast<std::size_t>(found - names_.begin());
  if (found == names_.end()) {
    full_ = full_ || names_.size() >= kMostNames;
    if (!full_) names_.push_back(name);
  }
  return column;
}

void NamedRows::put(std::string_view name, std::string_view value) {
  const std::size_t column = column_of(name);
  if (column >= names_.size()) return;
  likely_ = column + 1;
  const std::size_t begin = ends_.empty() ? 0 : ends_.back();
  for (std::size_t i = begin; i < cells_.size(); ++i) {
    if (cells_[i].column == column) return;
  }
  cells_.push_back({column, value});
}

void NamedRows::end_row() {
  likely_ = 0;
  if (cells_.size() > (ends_.empty() ? 0 : ends_.back())) ends_.push_back(cells_.size());
}

std::string NamedRows::text() const {
  std::string out;
  std::vector<std::string_view> row(names_);
  std::size_t begin = 0;
  const auto append_row = [&out, &row] {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) out += '\t';
      append_plain(row[i], out);
    }
    out += '\n';
  };
  append_row();
  for (const std::size_t end : ends_) {
    std::ranges::fill(row, std::string_view());
    for (std::size_t i = begin; i < end; ++i) row[cells_[i].column] = cells_[i].value;
    append_row();
    begin = end;
  }
  return out;
}

}  // namespace workbench
