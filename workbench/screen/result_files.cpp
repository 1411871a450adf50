#include "workbench/screen/result_files.hpp"

#include <sqlite3.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <variant>
#include <vector>

#include "workbench/analysis/identification_json.hpp"
#include "workbench/recording/letters.hpp"
#include "workbench/recording/listed.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/recording/text_file.hpp"
#include "workbench/screen/page.hpp"

namespace workbench {
namespace {

using Cell = std::variant<std::monostate, double, std::string>;

struct ColumnOfResult {
  const char* name;
  const char* type;
  Cell (*cell)(const ScreenedLoop&);
};

Cell number_cell(double value, bool known = true) {
  return known && std::isfinite(value) ? Cell(value) : Cell();
}

Cell text_cell(const std::string& text) {
  return text.empty() ? Cell() : Cell(text);
}

Cell of(const ident::Estimate<double>& estimate, double ident::Estimate<double>::*part) {
  return number_cell(estimate.*part, estimate.known);
}

using E = ident::Estimate<double>;
using L = ScreenedLoop;

// The columns of the CSV file and of the table `loops`.
constexpr ColumnOfResult kResultColumns[] = {
    {"loop", "TEXT", [](const L& l) { return text_cell(l.loop); }},
    {"verdict", "TEXT", [](const L& l) { return text_cell(l.verdict); }},
    {"cost", "REAL", [](const L& l) { return number_cell(l.cost, l.error.empty()); }},
    {"suspicion", "REAL",
     [](const L& l) { return number_cell(l.suspicion, l.error.empty()); }},
    {"stick_band_ascending", "REAL",
     [](const L& l) { return of(l.stick_band.ascending, &E::value); }},
    {"stick_band_ascending_low", "REAL",
     [](const L& l) { return of(l.stick_band.ascending, &E::low); }},
    {"stick_band_ascending_high", "REAL",
     [](const L& l) { return of(l.stick_band.ascending, &E::high); }},
    {"stick_band_descending", "REAL",
     [](const L& l) { return of(l.stick_band.descending, &E::value); }},
    {"stick_band_descending_low", "REAL",
     [](const L& l) { return of(l.stick_band.descending, &E::low); }},
    {"stick_band_descending_high", "REAL",
     [](const L& l) { return of(l.stick_band.descending, &E::high); }},
    {"unit", "TEXT", [](const L& l) { return text_cell(l.unit); }},
    {"detectable_band", "REAL",
     [](const L& l) { return number_cell(l.detectable_band, l.detectable_band > 0); }},
    {"nats", "REAL", [](const L& l) { return number_cell(l.nats, l.error.empty()); }},
    {"period_s", "REAL",
     [](const L& l) { return number_cell(l.period_s, l.period_s > 0); }},
    {"oscillating_share", "REAL",
     [](const L& l) { return number_cell(l.oscillating_share, l.error.empty()); }},
    {"group", "INTEGER", [](const L& l) { return number_cell(l.group, l.group > 0); }},
    {"leads", "INTEGER",
     [](const L& l) { return number_cell(l.leads ? 1 : 0, l.group > 0); }},
    {"group_is", "TEXT", [](const L& l) { return text_cell(l.group_is); }},
    {"samples", "REAL", [](const L& l) { return number_cell(l.samples, l.samples > 0); }},
    {"sample_period_s", "REAL",
     [](const L& l) { return number_cell(l.sample_period_s, l.samples > 0); }},
    {"from", "TEXT", [](const L& l) { return text_cell(l.from); }},
    {"files", "INTEGER",
     [](const L& l) { return number_cell(static_cast<double>(l.files.size())); }},
    {"reason", "TEXT", [](const L& l) { return text_cell(l.reason); }},
    {"error", "TEXT", [](const L& l) { return text_cell(l.error); }},
    {"u", "TEXT", [](const L& l) { return text_cell(l.u_tag); }},
    {"y", "TEXT", [](const L& l) { return text_cell(l.y_tag); }},
};

std::string csv_cell(const Cell& cell) {
  if (const double* value = std::get_if<double>(&cell)) return number(*value, 9);
  const std::string* text = std::get_if<std::string>(&cell);
  if (text == nullptr) return {};
  if (text->find_first_of(",\"\r\n") == std::string::npos) return *text;
  std::string out = "\"";
  for (const char c : *text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

class Database {
 public:
  explicit Database(const std::string& path) {
    sqlite3* opened = nullptr;
    const int code = sqlite3_open(path.c_str(), &opened);
    database_.reset(opened);
    if (code != SQLITE_OK) fail();
  }

  void run(const std::string& sql) {
    if (sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr) !=
        SQLITE_OK) {
      fail();
    }
  }

  [[noreturn]] void fail() const {
    throw std::runtime_error(std::string("SQLite: ") +
                             (database_ ? sqlite3_errmsg(database_.get()) : "no memory"));
  }

  [[nodiscard]] sqlite3* get() const { return database_.get(); }

 private:
  struct Close {
    void operator()(sqlite3* database) const { sqlite3_close(database); }
  };
  std::unique_ptr<sqlite3, Close> database_;
};

// INSERT of one table, row by row.
class Insert {
 public:
  Insert(Database& database, const std::string& table, std::size_t columns)
      : database_(database) {
    std::string sql = "INSERT INTO " + table + " VALUES(?";
    for (std::size_t i = 1; i < columns; ++i) sql += ",?";
    if (sqlite3_prepare_v2(database.get(), (sql + ")").c_str(), -1, &statement_,
                           nullptr) != SQLITE_OK) {
      database.fail();
    }
  }
  ~Insert() { sqlite3_finalize(statement_); }
  Insert(const Insert&) = delete;
  Insert& operator=(const Insert&) = delete;

  void row(const std::vector<Cell>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const int at = static_cast<int>(i) + 1;
      if (const double* value = std::get_if<double>(&cells[i])) {
        sqlite3_bind_double(statement_, at, *value);
      } else if (const std::string* text = std::get_if<std::string>(&cells[i])) {
        sqlite3_bind_text(statement_, at, text->data(), static_cast<int>(text->size()),
                          SQLITE_TRANSIENT);
      } else {
        sqlite3_bind_null(statement_, at);
      }
    }
    if (sqlite3_step(statement_) != SQLITE_DONE) database_.fail();
    sqlite3_reset(statement_);
  }

 private:
  Database& database_;
  sqlite3_stmt* statement_ = nullptr;
};

void fill(Database& database, const Screening& screening) {
  std::string columns;
  for (const ColumnOfResult& column : kResultColumns) {
    columns += (columns.empty() ? "\"" : ", \"") + std::string(column.name) + "\" " +
               column.type;
  }
  database.run("BEGIN; CREATE TABLE loops(" + columns +
               ");"
               "CREATE TABLE trend(loop TEXT, month TEXT, verdict TEXT, nats REAL, "
               "stick_band REAL, oscillating_share REAL);"
               "CREATE TABLE files(loop TEXT, file TEXT);"
               "CREATE TABLE unpaired(tag TEXT);");
  {
    Insert loops(database, "loops", std::size(kResultColumns));
    Insert trend(database, "trend", 6);
    Insert files(database, "files", 2);
    Insert unpaired(database, "unpaired", 1);
    for (const ScreenedLoop& loop : screening.loops) {
      std::vector<Cell> cells;
      for (const ColumnOfResult& column : kResultColumns)
        cells.push_back(column.cell(loop));
      loops.row(cells);
      for (const Stretch& s : loop.trend) {
        trend.row({loop.loop, s.name, s.verdict, number_cell(s.nats),
                   number_cell(s.stick_band), s.oscillating});
      }
      for (const std::string& file : loop.files) files.row({loop.loop, file});
    }
    for (const std::string& tag : screening.unpaired) unpaired.row({tag});
  }
  database.run("COMMIT");
}

}  // namespace

ResultKind kind_of_result(const std::string& path) {
  const std::string ending = lower_case(std::filesystem::path(path).extension().string());
  if (ending == ".html" || ending == ".htm") return ResultKind::kHtml;
  if (ending == ".jsonl" || ending == ".ndjson" || ending == ".json") {
    return ResultKind::kJsonLines;
  }
  if (ending == ".csv") return ResultKind::kCsv;
  if (ending == ".sqlite" || ending == ".sqlite3" || ending == ".db") {
    return ResultKind::kSqlite;
  }
  throw std::invalid_argument("-o " + path +
                              ": expected a name that ends with .html, .jsonl, .csv or "
                              ".sqlite, found '" +
                              ending + "'");
}

std::string csv_of(const Screening& screening) {
  std::string out = listed(kResultColumns, ",", &ColumnOfResult::name) + '\n';
  for (const ScreenedLoop& loop : screening.loops) {
    bool first = true;
    for (const ColumnOfResult& column : kResultColumns) {
      if (!first) out += ',';
      first = false;
      out += csv_cell(column.cell(loop));
    }
    out += '\n';
  }
  return out;
}

std::string json_lines_of(const Screening& screening) {
  std::string out;
  for (const ScreenedLoop& loop : screening.loops) out += json_line(json_of(loop));
  return out;
}

void write_sqlite(const Screening& screening, const std::string& path) {
  const std::string target = link_target(path);
  const std::string temporary = target + ".part" + std::to_string(getpid());
  std::remove(temporary.c_str());
  try {
    Database database(temporary);
    fill(database, screening);
  } catch (...) {
    std::remove(temporary.c_str());
    throw;
  }
  std::error_code error;
  std::filesystem::rename(temporary, target, error);
  if (error) {
    std::remove(temporary.c_str());
    throw std::runtime_error("cannot write " + path + ": " + error.message());
  }
}

void write_result(
    const Screening& screening, const std::string& path,
    const std::function<void(const std::string&, std::string_view)>& write) {
  switch (kind_of_result(path)) {
    case ResultKind::kHtml:
      return write(path, screen_page(screening));
    case ResultKind::kJsonLines:
      return write(path, json_lines_of(screening));
    case ResultKind::kCsv:
      return write(path, csv_of(screening));
    case ResultKind::kSqlite:
      return write_sqlite(screening, path);
  }
}

}  // namespace workbench
