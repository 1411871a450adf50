#include "workbench/recording/workbook.hpp"

#include <charconv>
#include <cmath>
#include <map>
#include <utility>

#include "workbench/recording/filled.hpp"
#include "workbench/recording/formats/open_document.hpp"
#include "workbench/recording/formats/zip_parts.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/listed.hpp"
#include "workbench/recording/sheet_date.hpp"

namespace workbench {
namespace {

constexpr std::size_t kTableRows = 20;  // that make a sheet a table

InputError too_long(const std::string& file) {
  return InputError(file, 0, 0, "a sheet of at most 512 MiB of text", "a longer one",
                    "split the recording");
}

struct SheetPlace {
  std::string name;
  std::string id;
};

class WorkbookPart : public XmlPart {
 public:
  void open(std::string_view name, const Attributes& attributes) override {
    if (name == "workbookPr") {
      const std::string_view from = attributes["date1904"];
      from_1904 = from == "1" || from == "true";
    } else if (name == "sheet" &&
               attributes["state"].find("idden") == std::string::npos) {
      sheets.push_back(
          {std::string(attributes["name"]), std::string(attributes.prefixed("id"))});
    }
  }
  bool from_1904 = false;
  std::vector<SheetPlace> sheets;
};

// Where the parts are, by the ids that the workbook calls them.
class Relations : public XmlPart {
 public:
  void open(std::string_view name, const Attributes& attributes) override {
    if (name == "Relationship") {
      targets_[std::string(attributes["Id"])] = attributes["Target"];
    }
  }
  [[nodiscard]] std::string path_of(const std::string& id) const {
    const auto found = targets_.find(id);
    if (found == targets_.end()) return {};
    return found->second.starts_with('/') ? found->second.substr(1)
                                          : "xl/" + found->second;
  }

 private:
  std::map<std::string, std::string> targets_;
};

// Which styles of cells show a number as a date.
class Styles : public XmlPart {
 public:
  void open(std::string_view name, const Attributes& attributes) override {
    if (name == "cellXfs") in_cells_ = true;
    int format = 0;
    const std::string_view id = attributes["numFmtId"];
    std::from_chars(id.data(), id.data() + id.size(), format);
    if (name == "numFmt") {
      codes_[format] = date_of_code(attributes["formatCode"]);
    } else if (name == "xf" && in_cells_) {
      const auto code = codes_.find(format);
      kinds_.push_back(code == codes_.end() ? built_in_date(format) : code->second);
    }
  }
  void close(std::string_view name) override {
    if (name == "cellXfs") in_cells_ = false;
  }
  [[nodiscard]] SheetDate of(std::size_t style) const {
    return style < kinds_.size() ? kinds_[style] : SheetDate::kNone;
  }

 private:
  std::map<int, SheetDate> codes_;
  std::vector<SheetDate> kinds_;
  bool in_cells_ = false;
};

// The words that cells share; those that tell how to speak one are left out.
class SharedWords : public XmlPart {
 public:
  void open(std::string_view name, const Attributes& /*attributes*/) override {
    if (name == "si") words.emplace_back();
    if (name == "rPh") spoken_ = true;
    in_text_ = name == "t" && !spoken_;
  }
  void close(std::string_view name) override {
    if (name == "rPh") spoken_ = false;
    in_text_ = false;
  }
  void text(std::string_view piece) override {
    size_ += piece.size();
    if (in_text_ && !words.empty()) words.back() += piece;
  }
  [[nodiscard]] bool goes_on() const override { return size_ < SheetText::kMostText; }

  std::vector<std::string> words;

 private:
  std::size_t size_ = 0;
  bool in_text_ = false;
  bool spoken_ = false;
};

template <class Number>
Number number_of(std::string_view text, Number otherwise) {
  Number value = otherwise;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  return read.ec == std::errc{} ? value : otherwise;
}

// Column of a cell called AB12, from 0.
std::optional<std::size_t> column_of(std::string_view cell) {
  std::size_t column = 0;
  std::size_t letters = 0;
  while (letters < cell.size() && cell[letters] >= 'A' && cell[letters] <= 'Z') {
    column = 26 * column + static_cast<std::size_t>(cell[letters] - 'A') + 1;
    if (++letters > 3) return std::nullopt;
  }
  if (letters == 0) return std::nullopt;
  return column - 1;
}

class Sheet : public XmlPart {
 public:
  Sheet(const SharedWords& words, const Styles& styles, bool from_1904)
      : words_(words), styles_(styles), from_1904_(from_1904) {}

  void open(std::string_view name, const Attributes& attributes) override {
    if (name == "row") {
      out.begin_row(number_of(attributes["r"], out.lines() + 1));
      next_ = 0;
    } else if (name == "c") {
      column_ = column_of(attributes["r"]).value_or(next_);
      type_ = attributes["t"];
      style_ = number_of(attributes["s"], std::size_t{0});
      value_.clear();
    }
    in_value_ = name == "v" || name == "t";
  }
  void close(std::string_view name) override {
    in_value_ = false;
    if (name == "c") end_cell();
    if (name == "row") out.end_row();
  }
  void text(std::string_view piece) override {
    if (in_value_) value_ += piece;
  }
  [[nodiscard]] bool goes_on() const override { return !out.is_full(); }

  SheetText out;

 private:
  void end_cell() {
    if (value_.empty()) return;
    next_ = column_ + 1;
    const bool number = type_.empty() || type_ == "n";
    const SheetDate date = number ? styles_.of(style_) : SheetDate::kNone;
    if (date != SheetDate::kNone) {
      const double days = number_of(value_, std::nan(""));
      out.put(column_, std::isnan(days) ? value_ : sheet_date(days, date, from_1904_));
    } else if (type_ == "s") {
      const std::size_t index = number_of(value_, words_.words.size());
      if (index < words_.words.size()) out.put(column_, words_.words[index]);
    } else {
      out.put(column_, value_);
    }
  }

  const SharedWords& words_;
  const Styles& styles_;
  bool from_1904_;
  std::string type_;
  std::string value_;
  std::size_t style_ = 0;
  std::size_t column_ = 0;
  std::size_t next_ = 0;  // behind the last filled cell
  bool in_value_ = false;
};

std::vector<SheetTable> sheets_of_excel(const ZipParts& archive,
                                        const std::string& file) {
  WorkbookPart workbook;
  Relations relations;
  Styles styles;
  SharedWords words;
  archive.read("xl/workbook.xml", workbook);
  archive.read("xl/_rels/workbook.xml.rels", relations);
  archive.read("xl/styles.xml", styles);
  archive.read("xl/sharedStrings.xml", words);
  if (!words.goes_on()) throw too_long(file);
  std::vector<SheetTable> out;
  for (const SheetPlace& place : workbook.sheets) {
    Sheet sheet(words, styles, workbook.from_1904);
    archive.read(relations.path_of(place.id), sheet);
    out.push_back({place.name, std::move(sheet.out)});
  }
  return out;
}

std::string names_of(const std::vector<SheetTable*>& sheets) {
  return listed(sheets, ", ",
                [](const SheetTable* sheet) { return quoted(sheet->name); });
}

std::optional<std::string> joined_text(const std::vector<SheetTable*>& tables,
                                       SheetChoice& choice) {
  if (!choice.name.empty() || !choice.join) return std::nullopt;
  std::vector<NamedSheet> sheets;
  for (const SheetTable* table : tables) {
    sheets.push_back({table->name, table->text.text()});
  }
  std::optional<std::string> out = choice.join(sheets);
  choice.joined = out.has_value();
  if (out) {
    choice.note =
        filled("a signal a sheet, joined by their times: {0}", {names_of(tables)});
  }
  return out;
}

// Of several tables the one that is named, or alone has the columns; or all as one.
std::string chosen_of(std::vector<SheetTable*> tables, const std::string& file,
                      SheetChoice& choice) {
  const std::string all = names_of(tables);
  const std::vector<SheetTable*> of_all = tables;
  std::erase_if(tables, [&choice](const SheetTable* sheet) {
    return !choice.name.empty() ? sheet->name != choice.name
                                : choice.fits && !choice.fits(sheet->text.text());
  });
  if (tables.size() == 1) {
    choice.note = "sheet " + quoted(tables[0]->name) + " taken of " + all;
    return tables[0]->text.take();
  }
  if (tables.empty()) {
    if (std::optional<std::string> text = joined_text(of_all, choice)) return *text;
  }
  if (!choice.name.empty()) {
    throw InputError(file, 0, 0, "a sheet " + quoted(choice.name), "the sheets " + all,
                     "name one of them with --sheet");
  }
  throw InputError(file, 0, 0, "one sheet with the columns",
                   tables.empty() ? "none of " + all : "several: " + names_of(tables),
                   "name the sheet with --sheet, or remove the others");
}

}  // namespace

bool is_zip(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04");
}

std::string workbook_text(std::string_view bytes, const std::string& file,
                          SheetChoice& choice) {
  const ZipParts archive(bytes, file, choice.stop);
  const bool excel = archive.has("xl/workbook.xml");
  if (!excel && !archive.has("content.xml")) {
    if (archive.has("xl/workbook.bin")) {
      throw archive.refusal("a spreadsheet of another kind");
    }
    throw InputError(file, 0, 0, "an Excel or OpenDocument workbook (xlsx, ods)",
                     "a zip archive", "unpack it, and open the file in it");
  }
  std::vector<SheetTable> sheets =
      excel ? sheets_of_excel(archive, file) : sheets_of_open_document(archive);
  std::vector<SheetTable*> tables;
  SheetTable* longest = nullptr;
  for (SheetTable& sheet : sheets) {
    if (sheet.text.is_full()) throw too_long(file);
    const bool named = !choice.name.empty() && sheet.text.rows() > 0;
    if (named || sheet.text.rows() >= kTableRows) tables.push_back(&sheet);
    if (sheet.text.rows() > (longest == nullptr ? 0 : longest->text.rows())) {
      longest = &sheet;
    }
  }
  if (longest == nullptr) throw archive.refusal("no sheet with cells");
  return tables.size() > 1 || !choice.name.empty() ? chosen_of(tables, file, choice)
                                                   : longest->text.take();
}

}  // namespace workbench
