#include "workbench/recording/formats/open_document.hpp"

#include <algorithm>
#include <charconv>

#include "workbench/recording/letters.hpp"

namespace workbench {
namespace {

std::size_t count_of(std::string_view text) {
  std::size_t count = 1;
  std::from_chars(text.data(), text.data() + text.size(), count);
  return std::max<std::size_t>(count, 1);
}

// PT14H30M00.25S as 14:30:00.25; anything else as it is.
std::string clock_of(std::string_view duration) {
  std::string out;
  if (!duration.starts_with("PT")) return std::string(duration);
  for (const char c : duration.substr(2)) {
    if (c == 'H' || c == 'M') {
      out += ':';
    } else if (is_digit(c) || c == '.' || c == ',') {
      out += c;
    } else if (c != 'S') {
      return std::string(duration);
    }
  }
  return out;
}

class Content : public XmlPart {
 public:
  void open(std::string_view name, const Attributes& attributes) override {
    if (name == "annotation") ++notes_;
    if (name == "table") {
      sheets.push_back({std::string(attributes["name"]), {}});
      row_ = 1;
    } else if (name == "table-row") {
      repeats_ = count_of(attributes["number-rows-repeated"]);
      cells_.clear();
      column_ = 0;
    } else if (name == "table-cell" || name == "covered-table-cell") {
      columns_ = count_of(attributes["number-columns-repeated"]);
      stored_ = stored_in(attributes);
      shown_.clear();
    } else if (name == "p") {
      if (!shown_.empty()) shown_ += ' ';
      in_text_ = notes_ == 0;
    } else if (in_text_ && (name == "s" || name == "tab" || name == "line-break")) {
      shown_ += ' ';
    }
  }
  void close(std::string_view name) override {
    if (name == "annotation") --notes_;
    if (name == "p") in_text_ = false;
    if (name == "table-cell" || name == "covered-table-cell") end_cell();
    if (name == "table-row") end_row();
  }
  void text(std::string_view piece) override {
    if (in_text_) shown_ += piece;
  }
  [[nodiscard]] bool goes_on() const override {
    return sheets.empty() || !sheets.back().text.is_full();
  }

  std::vector<SheetTable> sheets;

 private:
  struct Cell {
    std::size_t column;
    std::string text;
  };

  static std::string stored_in(const Attributes& attributes) {
    const std::string_view type = attributes["value-type"];
    if (type == "date") return std::string(attributes["date-value"]);
    if (type == "time") return clock_of(attributes["time-value"]);
    const bool number = type == "float" || type == "percentage" || type == "currency";
    return number ? std::string(attributes["value"]) : std::string();
  }

  // Cells repeat to the end of the sheet where they are empty, rarely where not.
  void end_cell() {
    constexpr std::size_t kMost = 256;
    const std::string& cell = stored_.empty() ? shown_ : stored_;
    if (!cell.empty()) {
      for (std::size_t i = 0; i < std::min(columns_, kMost); ++i) {
        cells_.push_back({column_ + i, cell});
      }
    }
    column_ += columns_;
  }

  void end_row() {
    constexpr std::size_t kMost = 100'000;
    if (sheets.empty()) return;
    SheetText& out = sheets.back().text;
    for (std::size_t i = 0; i < std::min(repeats_, kMost) && !cells_.empty(); ++i) {
      if (out.is_full()) return;
      out.begin_row(row_ + i);
      for (const Cell& cell : cells_) out.put(cell.column, cell.text);
      out.end_row();
    }
    row_ += repeats_;
  }

  std::vector<Cell> cells_;  // of this row
  std::string stored_;
  std::string shown_;
  std::size_t row_ = 1;
  std::size_t repeats_ = 1;
  std::size_t column_ = 0;
  std::size_t columns_ = 1;
  int notes_ = 0;
  bool in_text_ = false;
};

constexpr std::size_t kMostRows = std::size_t{1} << 20;
constexpr std::size_t kMostColumns = 16384;

}  // namespace

std::vector<SheetTable> sheets_of_open_document(const ZipParts& archive) {
  Content content;
  archive.read("content.xml", content);
  return std::move(content.sheets);
}

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
