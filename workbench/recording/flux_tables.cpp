#include "workbench/recording/flux_tables.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "workbench/recording/cell_reader.hpp"
#include "workbench/recording/line_table.hpp"
#include "workbench/recording/named_signal.hpp"

namespace workbench {
namespace {

constexpr std::size_t kMostTables = 10'000;

std::optional<std::size_t> named(const CsvLayout& layout, std::string_view name) {
  for (std::size_t i = 0; i < layout.columns.size(); ++i) {
    if (layout.columns[i].name.text == name) return i;
  }
  return std::nullopt;
}

class FluxTables {
 public:
  explicit FluxTables(const CsvLayout& layout) : layout_(layout) {
    for (std::size_t i = 0; i < layout.columns.size(); ++i) {
      const LayoutColumn& column = layout.columns[i];
      const bool text = column.content == Content::kText;
      if (text && column.name.part != Part::kQuality) texts_.push_back(i);
    }
  }

  // False: too many tables.
  bool add(const std::vector<LineCell>& cells, std::size_t result, std::size_t table) {
    const std::string id =
        std::string(cells[result].text) + '\n' + std::string(cells[table].text);
    const auto [at, is_new] = tables_.try_emplace(id);
    std::vector<std::string>& known = at->second;
    for (std::size_t k = 0; is_new && k < texts_.size(); ++k) {
      known.emplace_back(cells[texts_[k]].text);
    }
    for (std::size_t k = 0; k < texts_.size(); ++k) {
      if (known[k] != cells[texts_[k]].text) moving_.insert(k);
    }
    return tables_.size() <= kMostTables;
  }

  [[nodiscard]] std::vector<std::size_t> keys() const {
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < texts_.size(); ++k) {
      if (!moving_.contains(k)) order.push_back(k);
    }
    std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
      return merit(a) > merit(b);
    });
    const std::size_t most = told_apart(order);
    std::vector<std::size_t> chosen;
    for (std::size_t k : order) {
      const std::size_t before = told_apart(chosen);
      if (before == most) break;
      chosen.push_back(k);
      if (told_apart(chosen) == before) chosen.pop_back();
    }
    for (std::size_t& k : chosen) k = texts_[k];
    return chosen;
  }

 private:
  [[nodiscard]] int merit(std::size_t k) const {
    const LayoutColumn& column = layout_.columns[texts_[k]];
    if (column.name.part == Part::kTag) return 2;
    return is_signal(column_name(column.first).part) ? 1 : 0;
  }

  [[nodiscard]] std::size_t told_apart(const std::vector<std::size_t>& by) const {
    std::set<std::vector<std::string>> seen;
    for (const auto& [id, texts] : tables_) {
      std::vector<std::string> some;
      for (const std::size_t k : by) some.push_back(texts[k]);
      seen.insert(std::move(some));
    }
    return seen.size();
  }

  const CsvLayout& layout_;
  std::vector<std::size_t> texts_;  // columns
  std::set<std::size_t> moving_;    // of texts_: differ within a table
  std::map<std::string, std::vector<std::string>> tables_;
};

}  // namespace

std::vector<std::size_t> flux_keys(std::string_view rows, const std::string& file,
                                   const CsvLayout& layout) {
  const auto result = named(layout, "result");
  const auto table = named(layout, "table");
  if (!result || !table || !named(layout, "_time")) return {};
  FluxTables tables(layout);
  CellReader reader(rows, file);
  for (; !reader.at_end(); reader.next_line()) {
    const std::string_view line = whole_line(reader);
    const std::vector<LineCell> cells = split_line(line, layout.separator);
    const bool row = cells.size() >= layout.columns.size() && !line.starts_with('#') &&
                     trimmed(line) != layout.header;
    if (row && !tables.add(cells, *result, *table)) return {};
  }
  return tables.keys();
}

}  // namespace workbench
