#include "workbench/recording/workbook.hpp"

#include <expat.h>
#include <zip.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "workbench/recording/input_error.hpp"
#include "workbench/recording/sheet_date.hpp"

namespace workbench {
namespace {

constexpr std::size_t kMostText = std::size_t{512} << 20;
constexpr std::size_t kMostRows = std::size_t{1} << 20;  // of a sheet
constexpr std::size_t kMostColumns = 16384;              // of a sheet
constexpr std::size_t kTableRows = 20;                   // that make a sheet a table
constexpr std::string_view kSaveSheet =
    "open it in Excel or LibreOffice and save the sheet as \"CSV UTF-8\"";

InputError damaged(const std::string& file, const std::string& found) {
  return {file, 0, 0, "an Excel workbook (xlsx)", found, std::string(kSaveSheet)};
}

std::string_view local_name(std::string_view name) {
  const std::size_t colon = name.rfind(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

// An element's attributes, by their local names.
class Attributes {
 public:
  explicit Attributes(const XML_Char** pairs) : pairs_(pairs) {}
  [[nodiscard]] std::string_view operator[](std::string_view name) const {
    for (const XML_Char** at = pairs_; *at != nullptr; at += 2) {
      if (local_name(*at) == name) return at[1];
    }
    return {};
  }
  // For r:id beside an id of the same element.
  [[nodiscard]] std::string_view prefixed(std::string_view name) const {
    for (const XML_Char** at = pairs_; *at != nullptr; at += 2) {
      const std::string_view whole = *at;
      if (local_name(whole) == name && whole.size() > name.size()) return at[1];
    }
    return {};
  }

 private:
  const XML_Char** pairs_;
};

// What takes the elements of one part of the workbook.
class Part {
 public:
  Part() = default;
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;
  virtual ~Part() = default;
  virtual void open(std::string_view name, const Attributes& attributes) = 0;
  virtual void close(std::string_view /*name*/) {}
  virtual void text(std::string_view /*piece*/) {}
  // False: nothing more is wanted.
  [[nodiscard]] virtual bool goes_on() const { return true; }
};

class Archive {
 public:
  Archive(std::string_view bytes, const std::string& file) : file_(file) {
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* source =
        zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
    zip_t* opened =
        source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error);
    if (opened == nullptr) {
      if (source != nullptr) zip_source_free(source);
      zip_error_fini(&error);
      throw damaged(file, "an archive that ends early or is damaged");
    }
    zip_error_fini(&error);
    archive_.reset(opened);
  }

  [[nodiscard]] bool has(const std::string& name) const {
    return zip_name_locate(archive_.get(), name.c_str(), ZIP_FL_NOCASE) >= 0;
  }

  // Hands the part to `to`; one that is not there has nothing in it.
  void read(const std::string& name, Part& to) const {
    if (!has(name)) return;
    const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> from(
        zip_fopen(archive_.get(), name.c_str(), ZIP_FL_NOCASE), &zip_fclose);
    const std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser(
        XML_ParserCreate(nullptr), &XML_ParserFree);
    if (!from || !parser) throw damaged(file_, "an unreadable part " + name);
    XML_SetUserData(parser.get(), &to);
    XML_SetElementHandler(
        parser.get(),
        [](void* part, const XML_Char* element, const XML_Char** attributes) {
          static_cast<Part*>(part)->open(local_name(element), Attributes(attributes));
        },
        [](void* part, const XML_Char* element) {
          static_cast<Part*>(part)->close(local_name(element));
        });
    XML_SetCharacterDataHandler(
        parser.get(), [](void* part, const XML_Char* piece, int size) {
          static_cast<Part*>(part)->text({piece, static_cast<std::size_t>(size)});
        });
    std::array<char, std::size_t{1} << 16> block{};
    while (to.goes_on()) {
      const zip_int64_t got = zip_fread(from.get(), block.data(), block.size());
      const bool parsed =
          got >= 0 && XML_Parse(parser.get(), block.data(), static_cast<int>(got),
                                static_cast<int>(got == 0)) == XML_STATUS_OK;
      if (!parsed) throw damaged(file_, "a damaged part " + name);
      if (got == 0) return;
    }
  }

 private:
  struct Discard {
    void operator()(zip_t* archive) const { zip_discard(archive); }
  };
  const std::string& file_;
  std::unique_ptr<zip_t, Discard> archive_;
};

struct SheetPlace {
  std::string name;
  std::string id;
};

class WorkbookPart : public Part {
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
class Relations : public Part {
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
class Styles : public Part {
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
class SharedWords : public Part {
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
  [[nodiscard]] bool goes_on() const override { return size_ < kMostText; }

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

class Sheet : public Part {
 public:
  Sheet(const SharedWords& words, const Styles& styles, bool from_1904)
      : words_(words), styles_(styles), from_1904_(from_1904) {}

  void open(std::string_view name, const Attributes& attributes) override {
    if (name == "row") {
      const std::size_t row = number_of(attributes["r"], lines_ + 1);
      while (lines_ + 1 < row && lines_ + 1 < kMostRows) end_line();
      cells_ = filled_ = 0;
    } else if (name == "c") {
      column_ = column_of(attributes["r"]).value_or(cells_);
      type_ = attributes["t"];
      style_ = number_of(attributes["s"], std::size_t{0});
      value_.clear();
    }
    in_value_ = name == "v" || name == "t";
  }
  void close(std::string_view name) override {
    in_value_ = false;
    if (name == "c") end_cell();
    if (name == "row") {
      if (filled_ > 1) ++rows;
      // Cells that are empty at the end of a row are not stored.
      if (filled_ > 0) out.append(widest_ - cells_, '\t');
      end_line();
    }
  }
  void text(std::string_view piece) override {
    if (in_value_) value_ += piece;
  }
  [[nodiscard]] bool goes_on() const override { return out.size() < kMostText; }

  std::string out;
  std::size_t rows = 0;  // with two cells or more

 private:
  void end_line() {
    out += '\n';
    ++lines_;
  }

  void end_cell() {
    if (value_.empty() || column_ < cells_ || column_ >= kMostColumns) return;
    out.append(column_ - (cells_ > 0 ? cells_ - 1 : 0), '\t');
    cells_ = column_ + 1;
    widest_ = std::max(widest_, cells_);
    ++filled_;
    const bool number = type_.empty() || type_ == "n";
    const SheetDate date = number ? styles_.of(style_) : SheetDate::kNone;
    if (date != SheetDate::kNone) {
      const double days = number_of(value_, std::nan(""));
      out += std::isnan(days) ? value_ : sheet_date(days, date, from_1904_);
    } else if (type_ == "s") {
      const std::size_t index = number_of(value_, words_.words.size());
      if (index < words_.words.size()) append_word(words_.words[index]);
    } else {
      append_word(value_);
    }
  }

  // On one line, without what separates or quotes cells.
  void append_word(std::string_view word) {
    for (const char c : word) {
      out += c == '\t' || c == '\n' || c == '\r' ? ' ' : c == '"' ? '\'' : c;
    }
  }

  const SharedWords& words_;
  const Styles& styles_;
  bool from_1904_;
  std::string type_;
  std::string value_;
  std::size_t style_ = 0;
  std::size_t column_ = 0;
  std::size_t cells_ = 0;   // of this row, up to the last written
  std::size_t widest_ = 0;  // of the rows so far
  std::size_t filled_ = 0;  // of this row
  std::size_t lines_ = 0;
  bool in_value_ = false;
};

}  // namespace

bool is_zip(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04");
}

std::string workbook_text(std::string_view bytes, const std::string& file) {
  const Archive archive(bytes, file);
  if (!archive.has("xl/workbook.xml")) {
    if (!archive.has("content.xml") && !archive.has("xl/workbook.bin")) {
      throw InputError(file, 0, 0, "an Excel workbook (xlsx)", "a zip archive",
                       "unpack it, and open the file in it");
    }
    throw damaged(file, "a spreadsheet of another kind");
  }
  WorkbookPart workbook;
  Relations relations;
  Styles styles;
  SharedWords words;
  archive.read("xl/workbook.xml", workbook);
  archive.read("xl/_rels/workbook.xml.rels", relations);
  archive.read("xl/styles.xml", styles);
  archive.read("xl/sharedStrings.xml", words);

  std::string text;
  std::size_t most = 0;
  std::string tables;
  std::size_t count = 0;
  for (const SheetPlace& place : workbook.sheets) {
    Sheet sheet(words, styles, workbook.from_1904);
    archive.read(relations.path_of(place.id), sheet);
    if (!sheet.goes_on() || !words.goes_on()) {
      throw InputError(file, 0, 0, "a sheet of at most 512 MiB of text", "a longer one",
                       "split the recording");
    }
    if (sheet.rows >= kTableRows) {
      tables += (count++ > 0 ? ", " : "") + quoted(place.name);
    }
    if (sheet.rows > most) {
      most = sheet.rows;
      text = std::move(sheet.out);
    }
  }
  if (count > 1) {
    throw InputError(file, 0, 0, "one sheet with rows",
                     std::to_string(count) + ": " + tables,
                     "remove or hide the others, or save the one as \"CSV UTF-8\"");
  }
  if (most == 0) throw damaged(file, "no sheet with cells");
  return text;
}

}  // namespace workbench
