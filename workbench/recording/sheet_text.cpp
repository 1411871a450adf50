#include "workbench/recording/sheet_text.hpp"

#include <algorithm>

namespace workbench {
namespace {

constexpr std::size_t kMostRows = std::size_t{1} << 20;
constexpr std::size_t kMostColumns = 16384;

}  // namespace

void SheetText::begin_row(std::size_t row) {
  const std::size_t before = std::min(row, kMostRows);
  for (; lines_ + 1 < before; ++lines_) text_ += '\n';
  cells_ = filled_ = 0;
}

void SheetText::put(std::size_t column, std::string_view cell) {
  if (cell.empty() || column < cells_ || column >= kMostColumns) return;
  text_.append(column - (cells_ > 0 ? cells_ - 1 : 0), '\t');
  cells_ = column + 1;
  widest_ = std::max(widest_, cells_);
  ++filled_;
  for (const char c : cell) {
    text_ += c == '\t' || c == '\n' || c == '\r' ? ' ' : c == '"' ? '\'' : c;
  }
}

void SheetText::end_row() {
  if (filled_ > 1) ++rows_;
  // Cells that are empty at the end of a row are not stored.
  if (filled_ > 0) text_.append(widest_ - cells_, '\t');
  text_ += '\n';
  ++lines_;
}

bool SheetText::is_full() const {
  return text_.size() >= kMostText;
}

}  // namespace workbench
